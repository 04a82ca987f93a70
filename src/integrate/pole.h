/** The end of an orbit at a pole, in regularised time.
 *
 *  With dt = s dtau and the root s lifted to a state, the pole s = 0 is an invariant set, reached as tau -> infinity, and on
 *  it lie equilibria. An orbit that ends there decays onto one of them: s as exp(-mu tau) with mu = -s'/s, the other
 *  transverse states (omega_n for the spherical top) at rates of their own. The Jacobian at the equilibrium has the
 *  eigenvalue 0 along the set of equilibria and the rates across it; orbits nearby end there exactly when all the latter
 *  are negative. For (3.2) of Kilin & Ivanova (2023), with sigma = gamma3 = +-1, they are
 *      -sigma omega_tau      and      (I1 sigma omega_tau - m b v_nu)/(I1 + m b^2),
 *  hence the condition sigma omega_tau > 0, I1 sigma omega_tau < m b v_nu. A near miss has a positive one and leaves.
 *
 *  What is left of the way: with kappa the slowest rate, |x_i(infinity) - x_i| <= |x_i'|/kappa (1 + O(distance)), and
 *  t_end - t = integral of s dtau = s/mu (1 + O(distance)). States that move at second order in the distance (v_nu,
 *  omega_tau, omega3) are then far below rounding when those of first order are at it. */
#ifndef JLT_INTEGRATE_POLE_H
#define JLT_INTEGRATE_POLE_H

#include "integrate/method.h"

typedef struct {
    bool ends;         /* attracted, and what is left of the way is below `left` for every state */
    double mu, kappa;  /* decay rates in tau: of the root, and the slowest of all */
    double t_end;      /* when ends */
} jlt_pole_verdict;

/** Judge the stepper's current point. Cheap (no evaluation) unless the root is below 1e-6 and all rates are small.
 *  left: relative to max(|x_i|, scale_i), e.g. 1e-14. Errors: NO_CONVERGENCE (eigenvalues). */
JLT_CHECKED jlt_status jlt_pole_judge(jlt_pole_verdict *out, const jlt_stepper *stepper, double left);

#endif
