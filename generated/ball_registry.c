/* Written by ttc; do not edit. */
#include "kernel_ball.h"

extern const jlt_ball_table jlt_balls_chaplygin_sleigh_general;
extern const jlt_ball_table jlt_balls_lorenz_general;
extern const jlt_ball_table jlt_balls_lotka_volterra_general;
extern const jlt_ball_table jlt_balls_nose_hoover_general;
extern const jlt_ball_table jlt_balls_restricted_three_body_general;
extern const jlt_ball_table jlt_balls_roessler_general;
extern const jlt_ball_table jlt_balls_routh_sphere_general;
extern const jlt_ball_table jlt_balls_routh_sphere_general_in_regular;
extern const jlt_ball_table jlt_balls_spherical_top_general;
extern const jlt_ball_table jlt_balls_spherical_top_general_on_level_G;
extern const jlt_ball_table jlt_balls_spherical_top_general_on_level_G_omega3;
extern const jlt_ball_table jlt_balls_spherical_top_general_in_regular;
extern const jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_G;
extern const jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_G_omega3;
extern const jlt_ball_table jlt_balls_spherical_top_balanced_general;
extern const jlt_ball_table jlt_balls_spherical_top_balanced_general_in_regular;
extern const jlt_ball_table jlt_balls_spherical_top_full_general;
extern const jlt_ball_table jlt_balls_spherical_top_level_general;
extern const jlt_ball_table jlt_balls_spherical_top_level_general_in_regular;
extern const jlt_ball_table jlt_balls_spherical_top_plane_general;
extern const jlt_ball_table jlt_balls_spherical_top_plane_general_in_regular;
extern const jlt_ball_table jlt_balls_spherical_top_track_general;
extern const jlt_ball_table jlt_balls_spherical_top_track_general_in_regular;
extern const jlt_ball_table jlt_balls_toda_general;

const jlt_ball_table *const jlt_ball_registry[] = {
    &jlt_balls_chaplygin_sleigh_general,
    &jlt_balls_lorenz_general,
    &jlt_balls_lotka_volterra_general,
    &jlt_balls_nose_hoover_general,
    &jlt_balls_restricted_three_body_general,
    &jlt_balls_roessler_general,
    &jlt_balls_routh_sphere_general,
    &jlt_balls_routh_sphere_general_in_regular,
    &jlt_balls_spherical_top_general,
    &jlt_balls_spherical_top_general_on_level_G,
    &jlt_balls_spherical_top_general_on_level_G_omega3,
    &jlt_balls_spherical_top_general_in_regular,
    &jlt_balls_spherical_top_general_in_regular_on_level_G,
    &jlt_balls_spherical_top_general_in_regular_on_level_G_omega3,
    &jlt_balls_spherical_top_balanced_general,
    &jlt_balls_spherical_top_balanced_general_in_regular,
    &jlt_balls_spherical_top_full_general,
    &jlt_balls_spherical_top_level_general,
    &jlt_balls_spherical_top_level_general_in_regular,
    &jlt_balls_spherical_top_plane_general,
    &jlt_balls_spherical_top_plane_general_in_regular,
    &jlt_balls_spherical_top_track_general,
    &jlt_balls_spherical_top_track_general_in_regular,
    &jlt_balls_toda_general,
};

const unsigned jlt_ball_registry_count = 24;

void jlt_ball_rational(arb_t out, const char *digits, slong prec)
{
    fmpq_t q;
    fmpq_init(q);
    if (fmpq_set_str(q, digits, 10) == 0) arb_set_fmpq(out, q, prec);
    else arb_indeterminate(out);
    fmpq_clear(q);
}
