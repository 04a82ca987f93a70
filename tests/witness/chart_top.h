/** An independent chart, typed by hand from the paper, to compare with the chart that comes from the tables: the section omega_tau
 *  = 0 of the spherical top on levels of energy and of Jellett's integral (Kilin & Ivanova 2023, section 5), in the paper's
 *  coordinates q = (eta, gamma3).
 *
 *  States are those of the model spherical_top_level in its regular time: (gamma3, v_nu, omega_tau, v_tau, s). With
 *      K = I1 R^2 s^2 + I3 b^2,   Theta = m K + I1 I3,   b = a3 + R gamma3,   W^2 = (2 (E - m g a3 gamma3) - G^2/K)/m
 *  the energy on the section is an ellipse, m v_nu^2 + (Theta/K) v_tau^2 = m W^2, and eta is its angle:
 *      v_nu = W sin eta,   v_tau = W sqrt(m K/Theta) cos eta.
 *  This is the paper's eta = arg(sqrt(Theta (Theta - I1 I3)) (omega3 + m G b/(Theta - I1 I3)) + i m I1 R s v_nu), because Theta -
 *  I1 I3 = m K and K omega3 + b G = I1 R s v_tau. In terms of v_tau no division by a small number occurs unless I3 b = 0 at a pole.
 *
 *  The reversor (v_nu, omega_tau, t) -> -(v_nu, omega_tau, t) acts as eta -> -eta and keeps the direction of crossing. */
#ifndef JLT_TESTS_CHART_TOP_H
#define JLT_TESTS_CHART_TOP_H

#include "dynamics/chart.h"

enum { JLT_CHART_TOP_GAMMA3, JLT_CHART_TOP_V_NU, JLT_CHART_TOP_OMEGA_TAU, JLT_CHART_TOP_V_TAU, JLT_CHART_TOP_S };

typedef struct {
    jlt_chart base;
    double m, R, g, I1, I3, a3; /* parameters of the model */
    double E, G;                /* levels */
} jlt_chart_top;

/** Fill a chart; parameters as in the model's table (not checked here). */
void jlt_chart_top_init(jlt_chart_top *out, double m, double R, double g, double I1, double I3, double a3, double E,
                        double G);

/** The widest interval of gamma3 in which the levels have states with omega_tau = 0, found by a scan of 4096 points and bisection.
 *  Returns false if there is none. */
bool jlt_chart_top_interval(const jlt_chart_top *self, double *low, double *high);

/** W^2 at gamma3: negative where the levels have no state with omega_tau = 0. */
double jlt_chart_top_speed2(const jlt_chart_top *self, double gamma3);

/** omega_n and omega3 of a state: omega_n = (R s G + I3 b v_tau)/K, omega3 = (I1 R s v_tau - b G)/K. NaN at a pole with I3 b = 0,
 *  where K vanishes and the state does not determine them. */
void jlt_chart_top_rotation(const jlt_chart_top *self, double *omega_n, double *omega3, const double *x);

/** Energy of a state, from the same formula as the chart. */
double jlt_chart_top_energy(const jlt_chart_top *self, const double *x);

/** The state of the model from reduced velocities; v_tau = b omega_n + R s omega3. */
void jlt_chart_top_state(const jlt_chart_top *self, double *x, double gamma3, double v_nu, double omega_tau,
                         double omega_n, double omega3);

#endif
