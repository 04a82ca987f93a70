/** The spherical top: its parameters, its five reduced states, and integrals from the built-in tables.
 *
 *  All numbers are values of kernels of the built-in tables, in the time in which s = sqrt(1 - gamma3^2) is a state; a value whose
 *  record is missing in its table is NaN. States, shape (JLT_TOP_STATES,), are those of system (3.2) of Kilin & Ivanova, Rus. J.
 *  Nonlin. Dyn. 19(4), 2023: gamma3 dimensionless, v_nu in m/s, angular velocities in rad/s.
 *
 *  At a pole sigma = gamma3 = +-1 the rates across the set of equilibria (integrate/pole.h) are
 *      -sigma omega_tau      and      (I1 sigma omega_tau - m b v_nu)/(I1 + m b^2),      b = a3 + sigma R,
 *  so that orbits end there where sigma omega_tau > 0 and I1 sigma omega_tau < m b v_nu. */
#ifndef JLT_TOP_TOP_H
#define JLT_TOP_TOP_H

#include <stdbool.h>

#include "core/status.h"
#include "kernel_abi.h"

/* The model that is used if none is named. */
#define JLT_DEFAULT_MODEL "spherical_top"

typedef struct {
    double m, R, g, a3, I1, I3; /* [kg], [m], [m/s^2], [m], [kg m^2], [kg m^2], as defined in the table */
} jlt_top;

enum { JLT_TOP_GAMMA3, JLT_TOP_V_NU, JLT_TOP_OMEGA_TAU, JLT_TOP_OMEGA_N, JLT_TOP_OMEGA3, JLT_TOP_STATES };

/** Read the parameters by their names in the descriptor; those that the model does not have become 0.
 *  Errors: ARG, m, R or I1 is missing. */
JLT_CHECKED jlt_status jlt_top_read(jlt_top *out, const jlt_descriptor *descriptor, const double *params);

/** Write the parameters by their names: params, shape (param_count,); NaN for those that a top does not have. */
void jlt_top_write(double *params, const jlt_descriptor *descriptor, const jlt_top *top);

/* sqrt(1 - gamma3^2), computed by factors; 0 if |gamma3| > 1. */
double jlt_top_sine(double gamma3);

/** The value at x, shape (JLT_TOP_STATES,), of the integral `name` of JLT_DEFAULT_MODEL in a variant (NULL: the general field);
 *  NaN if it does not exist. Cost: preparing parameters, and one kernel. */
double jlt_top_integral(const jlt_top *top, const char *variant, const char *name, const double *x);

/** Compute the rates of the states at x, both of shape (JLT_TOP_STATES,), by JLT_DEFAULT_MODEL in a variant. Returns false if there
 *  is no such field. */
bool jlt_top_rates(const jlt_top *top, const char *variant, double *rates, const double *x);

/** The way from JLT_DEFAULT_MODEL to the table of this name, both in the time in which s is a state; NULL if there is none. */
const jlt_way *jlt_top_way(const char *model);

/** States at which the form of an edited table is compared with one that is known. They are in general position, so that a term
 *  which vanishes where two velocities are equal or opposite is seen; velocities are at most 1. */
enum { JLT_TOP_SAMPLES = 3 };
extern const double jlt_top_samples[JLT_TOP_SAMPLES][JLT_TOP_STATES];

/** Whether a value is the wanted one within rounding of terms of this size; false if one of them is NaN. */
bool jlt_top_agrees(double value, double wanted, double size);

/** Whether JLT_DEFAULT_MODEL makes this claim and it is proved. Out: *broken: the claim if made but unproved, else NULL. */
bool jlt_top_claims(const jlt_claim **broken, const char *kind, const char *name);

/** Whether the way to the table `model` exists and is proved, and so are the integrals `names`, a list that ends with NULL. Out:
 *  *broken: the unproved claim, or NULL if a record is missing. */
bool jlt_top_serves(const jlt_claim **broken, const char *model, const char *const *names);

/** Map x, shape (JLT_TOP_STATES,), along a way: y, shape (way->coordinate_count,), in which an angle without a value is 0; other,
 *  shape (way->param_count,), the parameters there. */
void jlt_top_look(const jlt_way *way, double *y, double *other, const jlt_top *top, const double *x);

/** Map y, shape (way->state_count,), which ends with s, of the table that the way leads to, back to x, shape (JLT_TOP_STATES,).
 *  other: the parameters of that table. */
void jlt_top_return(const jlt_way *way, double *x, const double *y, const double *other);

/* Velocity of the centre of mass along tau, by the constraint: v_tau = (a3 + R gamma3) omega_n + R s omega3. */
double jlt_top_v_tau(const jlt_top *top, const double *x);

/* Integrals (3.3): the energy E, and Jellett's G = (I omega, r) = I1 R s omega_n - I3 (a3 + R gamma3) omega3. */
double jlt_top_energy(const jlt_top *top, const double *x);
double jlt_top_jellett(const jlt_top *top, const double *x);

#endif
