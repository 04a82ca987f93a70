/* (5.1) on the level G = -0.56 for AUTO-07p, in gamma3, v_nu, omega_tau, v_tau; m = R = g = 1, derivatives by differences. Orbits
 * of one energy are isolated, all of them a family: PAR(1), a damping that stays 0, unfolds it. PAR(2) is the energy. */
#include "equations.h"

static const double I = 1.0/3.0, a3 = 0.51, G = -0.56;

typedef struct {
    double s, b, n, three;
} bodily;

/* omega_n and omega3 from the level of G and v_tau. */
static bodily spins(const double *u)
{
    const double s = sqrt((1 - u[0])*(1 + u[0])), b = a3 + u[0], K = I*(s*s + b*b);
    return (bodily){ s, b, (s*G + I*b*u[3])/K, (I*s*u[3] - b*G)/K };
}

int func(integer ndim, const doublereal *u, const integer *icp, const doublereal *par, integer ijac, doublereal *f,
         doublereal *dfdu, doublereal *dfdp)
{
    const bodily x = spins(u);
    const double s = x.s, n = x.n, v = u[1], w = u[2], e = 1 + a3*u[0];
    const double theta = I*(s*s + x.b*x.b) + I*I, D = I + a3*a3*s*s, V = e*w + v;
    f[0] = s*w;
    f[1] = n*u[3]/s;
    f[2] = (a3*s*s*(a3*u[0]*w*w - 1) - n*(I*u[0]*n + I*s*x.three))/D/s + par[0]*w;
    f[3] = -n*v/s + I*(I*n*V/s + x.three*w*a3*I)/theta;
    return 0;
}

int pvls(integer ndim, const doublereal *u, doublereal *par)
{
    double start[4];
    for (int i = 0; i < 4; i++) start[i] = getp("BV0", i + 1, u);
    const bodily x = spins(start);
    const double v = start[1], w = start[2];
    par[1] = (v*v + (I + a3*a3*x.s*x.s)*w*w + I*x.n*x.n + I*x.three*x.three + start[3]*start[3])/2 + a3*start[0];
    return 0;
}
