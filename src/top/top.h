/** The spherical top: parameters, five reduced states, and integrals from its built-in tables.
 *
 *  Numbers come from kernels of the tables built in, in the time in which s = sqrt(1 - gamma3^2) is a state of its own; a value
 *  whose record was taken out of its table is NaN. States, shape (JLT_TOP_STATES,), are those of system (3.2) of Kilin & Ivanova,
 *  Rus. J. Nonlin. Dyn. 19(4), 2023: gamma3 without unit, v_nu in m/s, angular velocities in rad/s.
 *
 *  At a pole sigma = gamma3 = +-1 the rates across the set of equilibria (integrate/pole.h) are
 *      -sigma omega_tau      and      (I1 sigma omega_tau - m b v_nu)/(I1 + m b^2),      b = a3 + sigma R,
 *  so that orbits end there where sigma omega_tau > 0 and I1 sigma omega_tau < m b v_nu. */
#ifndef JLT_TOP_TOP_H
#define JLT_TOP_TOP_H

#include <stdbool.h>

#include "core/status.h"
#include "kernel_abi.h"

/* The model that is meant where none is named. */
#define JLT_DEFAULT_MODEL "spherical_top"

typedef struct {
    double m, R, g, a3, I1, I3; /* [kg], [m], [m/s^2], [m], [kg m^2], [kg m^2], with the meanings of the table */
} jlt_top;

enum { JLT_TOP_GAMMA3, JLT_TOP_V_NU, JLT_TOP_OMEGA_TAU, JLT_TOP_OMEGA_N, JLT_TOP_OMEGA3, JLT_TOP_STATES };

/** Parameters by their names in the descriptor; those the model does not have become 0.
 *  Errors: ARG, m, R or I1 is missing. */
JLT_CHECKED jlt_status jlt_top_read(jlt_top *out, const jlt_descriptor *descriptor, const double *params);

/** The same the other way round: params, shape (param_count,); NaN for those that a top has not. */
void jlt_top_write(double *params, const jlt_descriptor *descriptor, const jlt_top *top);

/** Whether a model has the top's states, in this order, and its parameters. */
bool jlt_top_is_known(const jlt_descriptor *model);

/* sqrt(1 - gamma3^2), by factors. */
double jlt_top_sine(double gamma3);

/** The value at x, shape (JLT_TOP_STATES,), of an integral that JLT_DEFAULT_MODEL has by this name in this variant, NULL for the
 *  general field. Cost: one kernel, and what is prepared for it. */
double jlt_top_integral(const jlt_top *top, const char *variant, const char *name, const double *x);

/** The way from JLT_DEFAULT_MODEL to the table of this name, each in the time of s; NULL without one. */
const jlt_way *jlt_top_way(const char *model);

/** Whether a claim of JLT_DEFAULT_MODEL is there and proved. Out: *broken: it, where it is there and not proved, else NULL. */
bool jlt_top_claims(const jlt_claim **broken, const char *kind, const char *name);

/** Whether that way is there and is proved, and so are the integrals `names`, which a NULL ends. Out: *broken: the claim that is
 *  not proved, NULL where a record is missing. */
bool jlt_top_serves(const jlt_claim **broken, const char *model, const char *const *names);

/** Where it leads from x, shape (JLT_TOP_STATES,): y, shape (way->coordinate_count,), an angle being 0 where it has no value;
 *  other, shape (way->param_count,), the parameters there. */
void jlt_top_look(const jlt_way *way, double *y, double *other, const jlt_top *top, const double *x);

/** x, shape (JLT_TOP_STATES,), at y, shape (way->state_count,), which ends with s, of the table that the way leads to. */
void jlt_top_return(const jlt_way *way, double *x, const double *y, const double *other);

/* Velocity of the centre of mass along tau, by the constraint: v_tau = (a3 + R gamma3) omega_n + R s omega3. */
double jlt_top_v_tau(const jlt_top *top, const double *x);

/* Integrals (3.3): the energy E, and Jellett's G = (I omega, r) = I1 R s omega_n - I3 (a3 + R gamma3) omega3. */
double jlt_top_energy(const jlt_top *top, const double *x);
double jlt_top_jellett(const jlt_top *top, const double *x);

#endif
