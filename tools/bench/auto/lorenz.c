/* Lorenz's system for AUTO-07p: PAR(1) = rho. Periodic orbits along rho, derivatives by hand. */
#include "equations.h"

int func(integer ndim, const doublereal *u, const integer *icp, const doublereal *par, integer ijac, doublereal *f,
         doublereal *dfdu, doublereal *dfdp)
{
    const double sigma = 10, beta = 8.0/3.0, rho = par[0], x = u[0], y = u[1], z = u[2];
    f[0] = sigma*(y - x);
    f[1] = x*(rho - z) - y;
    f[2] = x*y - beta*z;
    if (ijac == 0) return 0;
    const double by_state[9] = { -sigma, rho - z, y, sigma, -1, x, 0, -x, -beta };
    for (int i = 0; i < 9; i++) dfdu[i] = by_state[i];
    if (ijac == 1) return 0;
    dfdp[1] = x;
    return 0;
}

int pvls(integer ndim, const doublereal *u, doublereal *par)
{
    return 0;
}
