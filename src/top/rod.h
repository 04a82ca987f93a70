/** The limiting case I3 = 0 by quadratures (section 4.2 of the paper).
 *
 *  With c = G^2/(I1 R^2), D = I1 + m a3^2 s^2 and P(gamma3) = 2 s^2 (E2 - m g a3 gamma3) - c, the tilt obeys D gamma3'^2 = P.
 *  Between its turning points low and high, P = (gamma3 - low)(high - gamma3) Q with Q = 2 E2 - 2 m g a3 (gamma3 + low + high),
 *  and the substitution gamma3 = mid - half cos u, mid = (low + high)/2, half = (high - low)/2, removes the singularities at the
 *  turning points:
 *      dt = sqrt(D/Q) du,      dpsi = -G/(I1 R s^2) dt,      (v_nu, v_tau) = sqrt(2 E1/m) (cos psi, sin psi).
 *  The turning points are stored as their distances from the poles, so that 1/s^2 keeps its digits where an orbit passes
 *  close to a pole. Q is linear, and found from P = -c at both poles: a sum of positive terms, as E2 - m g a3 gamma3 is at
 *  the start. Near the start, which may be a double root of P, P is expanded about the start, where it is D (s omega_tau)^2.
 *  Orbits with G = 0 run through the poles and are refused. Only this form of the equations is written here; coefficients,
 *  integrals and states are values of kernels, and tables with equations of another form are refused. */
#ifndef JLT_TOP_ROD_H
#define JLT_TOP_ROD_H

#include "top/counterpart.h"

typedef struct {
    jlt_counterpart counterpart;
    jlt_top top;
    double E1, E2, G;
    double weight, barrier; /* m g a3; c */
    double inertia_pole, inertia_equator; /* D at s = 0, D at s = 1 */
    double turning;         /* G/(I1 R) */
    double start, kinetic;  /* gamma3 and E2 - m g a3 gamma3 at the start, */
    double force, slope, bend; /* P, P' and P''/2 there */
    double below, above;    /* 1 + low, 1 - high: distances of the turning points from the poles */
    double half;            /* (high - low)/2 */
    double period;          /* of gamma3, and if E1 = 0 of all states */
    double turn;            /* change of psi over a period, in radians */
    double speed;           /* sqrt(2 E1/m) */
    double side;            /* 1, -1: the lower or upper turning point is nearer to the start */
    double psi;             /* at that turning point */
    double elapsed;         /* time from there to the start, at most half a period in modulus */
} jlt_rod;

/* The name of the built-in table whose equations the quadratures solve. */
extern const char jlt_rod_table[];

/** Compute turning points, period and turn of the orbit of `model` with params, shape (param_count,), through x, shape
 *  (state_count,), by its counterpart with respect to jlt_rod_table.
 *  Errors: ARG, I3 != 0; UNSUPPORTED, no proved reduction to that table; DOMAIN, G = 0 or x outside the model; NONFINITE, x, or
 *  its energies overflow; NO_CONVERGENCE. */
JLT_CHECKED jlt_status jlt_rod_open(jlt_rod *out, const jlt_descriptor *model, const double *params, const double *x);

/** The rotation number: turns of (v_nu, v_tau) per period of gamma3. */
double jlt_rod_rotation(const jlt_rod *rod);

/** The model's state x, shape (state_count,), at time t after the start, of either sign. Cost: a few quadratures.
 *  Errors: NONFINITE, t; NO_CONVERGENCE. */
JLT_CHECKED jlt_status jlt_rod_at(jlt_rod *rod, double *x, double t);

/** Whether the model's table has a record that leads to the table whose equations the quadratures solve. Proofs are not checked. */
bool jlt_rod_is_known(const jlt_descriptor *model);

/* A one-line description of the quadratures, for lists of tiers. */
extern const char jlt_rod_meaning[];

/** Why the quadratures do not apply to the orbit of such a model from x, shape (state_count,), with params, shape (param_count,),
 *  in words; NULL if they apply. x NULL: any start. Out: *broken: if an unproved claim is the reason, that claim, else NULL. */
const char *jlt_rod_refuses(const jlt_claim **broken, const jlt_descriptor *model, const double *params, const double *x);

#endif
