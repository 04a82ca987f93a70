/** The spherical top as scenes speak of it: parameters by name, the five reduced states, and what follows from them.
 *
 *  Everything is read off system (3.2) of Kilin & Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023; equation numbers are the
 *  paper's. The field itself comes from generated kernels only.
 *
 *  At a pole sigma = gamma3 = +-1 the rates across the set of equilibria (integrate/pole.h) are
 *      -sigma omega_tau      and      (I1 sigma omega_tau - m b v_nu)/(I1 + m b^2),
 *  so that orbits end there where sigma omega_tau > 0 and I1 sigma omega_tau < m b v_nu. */
#ifndef JLT_TOP_TOP_H
#define JLT_TOP_TOP_H

#include "core/status.h"
#include "kernel_abi.h"

/* The model that is meant where none is named. */
#define JLT_DEFAULT_MODEL "spherical_top"

typedef struct {
    double m, R, g, a3, I1, I3;
} jlt_top;

enum { JLT_TOP_GAMMA3, JLT_TOP_V_NU, JLT_TOP_OMEGA_TAU, JLT_TOP_OMEGA_N, JLT_TOP_OMEGA3, JLT_TOP_STATES };

/** Parameters by their names in the descriptor; those the model does not have become 0.
 *  Errors: ARG, m, R or I1 is missing. */
JLT_CHECKED jlt_status jlt_top_read(jlt_top *out, const jlt_descriptor *descriptor, const double *params);

/* sqrt(1 - gamma3^2), by factors. */
double jlt_top_sine(double gamma3);

/* Velocity of the centre of mass along tau, by the constraint: b omega_n + R s omega3. */
double jlt_top_v_tau(const jlt_top *top, const double *x);

/* Integrals (3.3). */
double jlt_top_energy(const jlt_top *top, const double *x);
double jlt_top_jellett(const jlt_top *top, const double *x);

#endif
