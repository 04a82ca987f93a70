/* Roessler's system for AUTO-07p: PAR(1) = c. Periodic orbits along c, derivatives by hand. */
#include "equations.h"

int func(integer ndim, const doublereal *u, const integer *icp, const doublereal *par, integer ijac, doublereal *f,
         doublereal *dfdu, doublereal *dfdp)
{
    const double a = 0.2, b = 0.2, c = par[0], x = u[0], y = u[1], z = u[2];
    f[0] = -y - z;
    f[1] = x + a*y;
    f[2] = b + z*(x - c);
    if (ijac == 0) return 0;
    const double by_state[9] = { 0, 1, z, -1, a, 0, -1, 0, x - c };
    for (int i = 0; i < 9; i++) dfdu[i] = by_state[i];
    if (ijac == 1) return 0;
    dfdp[2] = -z;
    return 0;
}

int pvls(integer ndim, const doublereal *u, doublereal *par)
{
    return 0;
}
