/** The limiting case I3 = 0 by quadratures (section 4.2 of the paper).
 *
 *  With c = G^2/(I1 R^2), D = I1 + m a3^2 s^2 and P(gamma3) = 2 s^2 (E2 - m g a3 gamma3) - c, the tilt obeys
 *  D gamma3'^2 = P. Between its turning points low and high, P = (gamma3 - low)(high - gamma3) Q with
 *  Q = 2 E2 - 2 m g a3 (gamma3 + low + high), and gamma3 = mid - half cos u turns this into the regular
 *      dt = sqrt(D/Q) du,      dpsi = -G/(I1 R s^2) dt,      (v_nu, v_tau) = sqrt(2 E1/m) (cos psi, sin psi):
 *  the end points are no longer singular. The turning points are kept as their distances from the poles, so that 1/s^2 keeps
 *  its digits where an orbit passes close to one; about the start, which may be a double root, P is expanded from there, where
 *  it is D (s omega_tau)^2. G = 0 runs through the poles and is refused. That form of the equations is what
 *  is known here; its coefficients, the integrals and the states are values of kernels. */
#ifndef JLT_TOP_ROD_H
#define JLT_TOP_ROD_H

#include "top/counterpart.h"

typedef struct {
    jlt_counterpart counterpart;
    jlt_top top;
    double E1, E2, G;
    double weight, barrier; /* m g a3; c */
    double inertia_pole, inertia_equator; /* D at s = 0 and at s = 1 */
    double turning;         /* G/(I1 R) */
    double start, force, slope, bend; /* gamma3 there; P, P', P''/2 */
    double below, above;    /* 1 + low, 1 - high: distances of the turning points from the poles */
    double half;            /* (high - low)/2 */
    double period;          /* of gamma3 and of all states on E1 = 0 */
    double turn;            /* of psi over a period, in radians */
    double speed;           /* sqrt(2 E1/m) */
    double psi;             /* at the lower turning point */
    double elapsed;         /* from there to the start, within half a period */
} jlt_rod;

/* The table built in whose equations the quadratures solve. */
extern const char jlt_rod_table[];

/** Turning points, period and turn of the orbit of `model` with params, shape (param_count,), through x, shape (state_count,):
 *  of the top that it is by its reduction to spherical_top_level.
 *  Errors: ARG, I3 != 0; UNSUPPORTED, no proved reduction leads there; DOMAIN, G = 0 or x outside the model; NONFINITE, x, or its
 *  energies overflow; NO_CONVERGENCE. */
JLT_CHECKED jlt_status jlt_rod_open(jlt_rod *out, const jlt_descriptor *model, const double *params, const double *x);

/** The rotation number: turns of (v_nu, v_tau) a period of gamma3. */
double jlt_rod_rotation(const jlt_rod *rod);

/** The model's state at time t since x, any sign. Cost: a few quadratures over the part of the period that was passed.
 *  Errors: NONFINITE, t; NO_CONVERGENCE. */
JLT_CHECKED jlt_status jlt_rod_at(jlt_rod *rod, double *x, double t);

/** Whether quadratures may serve for this model: its table has a record that leads to the table whose equations they solve. */
bool jlt_rod_is_known(const jlt_descriptor *model);

/* What quadratures are, in a line for lists of tiers. */
extern const char jlt_rod_meaning[];

/** Why quadratures do not serve for the orbit of such a model from x, shape (state_count,), with params, shape (param_count,), in
 *  words; NULL when they do. x NULL: any start. Out: *broken: the claim that is not proved, where that is the reason, else NULL. */
const char *jlt_rod_refuses(const jlt_claim **broken, const jlt_descriptor *model, const double *params, const double *x);

#endif
