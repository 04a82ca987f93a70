/* What the equations of AUTO-07p share: it asks for functions that these questions do not use, of boundary values, integrals and
 * objectives. */
#include "auto_f2c.h"
#include <math.h>

int bcnd(integer ndim, const doublereal *par, const integer *icp, integer nbc, const doublereal *u0, const doublereal *u1,
         integer ijac, doublereal *fb, doublereal *dbc)
{
    return 0;
}

int icnd(integer ndim, const doublereal *par, const integer *icp, integer nint, const doublereal *u, const doublereal *uold,
    const doublereal *udot, const doublereal *upold, integer ijac, doublereal *fi, doublereal *dint)
{
    return 0;
}

int fopt(integer ndim, const doublereal *u, const integer *icp, const doublereal *par, integer ijac, doublereal *fs,
         doublereal *dfdu, doublereal *dfdp)
{
    return 0;
}

/* Orbits are read from a file. */
int stpnt(integer ndim, doublereal t, doublereal *u, doublereal *par)
{
    return 0;
}
