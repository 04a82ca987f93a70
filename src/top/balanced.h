/** The balanced sphere (a3 = 0): the surface M^2 and its fixed points.
 *
 *  On a level of E, G and F0 the motion is a flow on the surface M^2, with the coordinates gamma3 and psi and the sign of v_slip
 *  (the tables spherical_top_balanced and spherical_top_plane): the horizontal angular momentum about the contact point has the
 *  constant length M, and makes the angle psi with the moving axes. Coordinates, states and integrals are those of the tables;
 *  these files rely on the following relations between them:
 *  - On a level, E = a F0 + b G^2 + c M^2 (the identity two_energies).
 *  - On the family of equilibria `spin`, where v_nu and omega3 alone are not 0, G = G_w omega3, and E and F0 are
 *    E_v v_nu^2 + E_w omega3^2 and F_v v_nu^2 + F_w omega3^2. E_w and F_w are linear in gamma3^2, and G_w is linear in gamma3: so
 *    for G != 0 all fixed points have the same gamma3^2, and there are at most four, one for each sign of gamma3 and of v_nu.
 *  - No fixed point is a saddle: the product of the two eigenvalues that integrals do not force to be 0 is not negative. Fixed
 *    points with gamma3 v_nu > 0 attract. */
#ifndef JLT_TOP_BALANCED_H
#define JLT_TOP_BALANCED_H

#include "top/top.h"

typedef struct {
    double E, G, F0;
    double M; /* >= 0 */
} jlt_balanced_levels;

/* The name of the built-in table whose motion is the flow on M^2. */
extern const char jlt_balanced_table[];

/** Whether the built-in tables prove what these functions rely on; else levels are NaN. Out: *broken as for jlt_top_serves. Whether
 *  they have the relations above, jlt_balanced_form_holds tells. */
bool jlt_balanced_serves(const jlt_claim **broken);

/** The levels E, G, F0 and M of a state x, shape (JLT_TOP_STATES,). */
void jlt_balanced_levels_of(jlt_balanced_levels *out, const jlt_top *top, const double *x);

/** The factors a, b and c of F0, G^2 and M^2 in E. */
void jlt_balanced_shares(double *of_F0, double *of_G, double *of_M, const jlt_top *top);

/** Compute levels->M from E, G, F0, which are set by the caller. Errors: EMPTY, no state has these levels of E, G and F0. */
JLT_CHECKED jlt_status jlt_balanced_complete(jlt_balanced_levels *levels, const jlt_top *top);

/** v_slip >= 0 at (gamma3, psi) on the levels; NaN if M^2 has no point there. */
double jlt_balanced_slip(const jlt_top *top, const jlt_balanced_levels *levels, double gamma3, double s, double psi);

/** (gamma3, v_slip, psi) of a state, and the state at such coordinates. s, passed separately, keeps its digits near a pole. */
void jlt_balanced_from_state(const jlt_top *top, double *gamma3, double *v_slip, double *psi, const double *x);
void jlt_balanced_to_state(const jlt_top *top, const jlt_balanced_levels *levels, double *x, double gamma3, double s,
                           double v_slip, double psi);

/** Initial state number `number` of a sequence spread evenly over M^2, alternating between the signs of v_slip. Returns false if
 *  the surface has no point there, or the state is too close to a pole. */
bool jlt_balanced_start(const jlt_top *top, const jlt_balanced_levels *levels, double *x, size_t number);

typedef enum { JLT_FIXED_REPELLING, JLT_FIXED_CENTRE, JLT_FIXED_ATTRACTING } jlt_fixed_kind;

typedef struct {
    double x[JLT_TOP_STATES];
    double psi, v_slip;
    double trace, determinant;     /* sum and product of the two eigenvalues that integrals do not force to be 0 */
    double re[2], im[2];           /* these eigenvalues */
    jlt_fixed_kind kind;
    int focus;                     /* whether they are a complex pair */
} jlt_fixed_point;

/** The isolated fixed points on a level; *count <= 4. A v_nu^2 or omega3^2 that is 0 within the rounding of the levels is taken as
 *  0. Errors: UNSUPPORTED, G = 0 with omega3 = 0 (the fixed points fill a curve), or I3 = 0. */
JLT_CHECKED jlt_status jlt_balanced_fixed_points(jlt_fixed_point out[4], unsigned *count, const jlt_top *top,
                                                 const jlt_balanced_levels *levels);

/** The isolated fixed points on the levels of a state x, shape (JLT_TOP_STATES,), that is a fixed point itself: x exactly, and its
 *  images under changes of sign. Returns false if x is no isolated fixed point, or I3 = 0. */
bool jlt_balanced_fixed_like(jlt_fixed_point out[4], unsigned *count, const jlt_top *top, const double *x);

#endif
