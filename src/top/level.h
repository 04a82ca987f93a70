/** The spherical top on a level of Jellett's integral G: the states of spherical_top_level in its regular time, and the five of (3.2).
 *  With K = I1 R^2 s^2 + I3 b^2, b = a3 + R gamma3,
 *      v_tau = b omega_n + R s omega3,   omega_n = (R s G + I3 b v_tau)/K,   omega3 = (I1 R s v_tau - b G)/K. */
#ifndef JLT_TOP_LEVEL_H
#define JLT_TOP_LEVEL_H

#include "kernel/units.h"
#include "top/top.h"

enum { JLT_LEVEL_GAMMA3, JLT_LEVEL_V_NU, JLT_LEVEL_OMEGA_TAU, JLT_LEVEL_V_TAU, JLT_LEVEL_S, JLT_LEVEL_STATES };

/** omega_n and omega3 of a state, shape (JLT_LEVEL_STATES,). NaN at a pole with I3 b = 0, where K vanishes and the state does not tell
 *  them. */
void jlt_level_rotation(const jlt_top *top, double G, double *omega_n, double *omega3, const double *y);

/** The state y, shape (JLT_LEVEL_STATES,), from the five x. */
void jlt_level_state(const jlt_top *top, double *y, const double *x);

/** Units in which R is in [1, 2), m too, and (E + m g |a3|)/m, half the square of the largest velocity of the centre of mass, in
 *  [1, 4); without that energy all is at rest, and time is counted in seconds. */
jlt_units jlt_level_units(const jlt_top *top, double E);

#endif
