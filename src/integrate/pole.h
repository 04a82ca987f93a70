/** The end of an orbit at a pole, in regularised time.
 *
 *  With dt = w dtau, where w is s times a factor that is not zero there, and the root s lifted to a state, the pole s = 0 is an
 *  invariant set, reached as tau -> infinity, and on it lie equilibria. An orbit that ends there decays onto one of them: s as
 *  exp(-mu tau) with mu = -s'/s, the other transverse states at rates of their own. The Jacobian at the equilibrium has the
 *  eigenvalue 0 along the set of equilibria and the rates across it; orbits nearby end there exactly when all the latter
 *  are negative. A near miss has a positive one and leaves.
 *
 *  t_end - t = integral of w dtau = w/mu up to the order that jlt_approach neglects, and the orbit is at its end when that is
 *  below the tolerance. The remaining displacement itself may never get so small: where the rates differ much, an explicit method
 *  steps at its limit of stability and holds the fast states at some tens of tolerances. */
#ifndef JLT_INTEGRATE_POLE_H
#define JLT_INTEGRATE_POLE_H

#include "integrate/approach.h"

typedef struct {
    bool ends;         /* the orbit is attracted, and the remaining displacement is known to the tolerance */
    double mu;         /* decay rate of the root, in tau, > 0 */
    double t_end;      /* when ends */
    jlt_approach approach; /* when ends */
    unsigned near;     /* points near the pole so far; 0 at the start of an orbit */
} jlt_pole_verdict;

/** Judge the stepper's current point. Cost: none unless the root is below 1e-8 and all rates, relative to jlt_approach_size, below
 *  1e-6 or ten tolerances; then, at the first such point and every eighth after it, a Jacobian and its eigenvalues. Errors:
 *  NO_CONVERGENCE (eigenvalues). */
JLT_CHECKED jlt_status jlt_pole_judge(jlt_pole_verdict *out, const jlt_stepper *stepper);

#endif
