/* Written by ttc; do not edit. */
#include "registry.h"

extern const jlt_descriptor jlt_kernels_chaplygin_sleigh_general;
extern const jlt_descriptor jlt_kernels_chaplygin_sleigh_balanced;
extern const jlt_descriptor jlt_kernels_lorenz_general;
extern const jlt_descriptor jlt_kernels_lotka_volterra_general;
extern const jlt_descriptor jlt_kernels_nose_hoover_general;
extern const jlt_descriptor jlt_kernels_restricted_three_body_general;
extern const jlt_descriptor jlt_kernels_roessler_general;
extern const jlt_descriptor jlt_kernels_routh_sphere_general;
extern const jlt_descriptor jlt_kernels_routh_sphere_general_in_regular;
extern const jlt_descriptor jlt_kernels_routh_sphere_balanced;
extern const jlt_descriptor jlt_kernels_routh_sphere_balanced_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_general;
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G;
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G_omega3;
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G;
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G_omega3;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G_omega3;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G_omega3;
extern const jlt_descriptor jlt_kernels_spherical_top_rod;
extern const jlt_descriptor jlt_kernels_spherical_top_rod_on_level_G;
extern const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular_on_level_G;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G_omega3;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G_omega3;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_general;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_general_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_moments;
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_moments_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_full_general;
extern const jlt_descriptor jlt_kernels_spherical_top_level_general;
extern const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced;
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_level_rod;
extern const jlt_descriptor jlt_kernels_spherical_top_level_rod_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_plane_general;
extern const jlt_descriptor jlt_kernels_spherical_top_plane_general_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_plane_equal_moments;
extern const jlt_descriptor jlt_kernels_spherical_top_plane_equal_moments_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_track_general;
extern const jlt_descriptor jlt_kernels_spherical_top_track_general_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_track_balanced;
extern const jlt_descriptor jlt_kernels_spherical_top_track_balanced_in_regular;
extern const jlt_descriptor jlt_kernels_spherical_top_track_rod;
extern const jlt_descriptor jlt_kernels_spherical_top_track_rod_in_regular;
extern const jlt_descriptor jlt_kernels_toda_general;

const jlt_descriptor *const jlt_registry[] = {
    &jlt_kernels_chaplygin_sleigh_general,
    &jlt_kernels_chaplygin_sleigh_balanced,
    &jlt_kernels_lorenz_general,
    &jlt_kernels_lotka_volterra_general,
    &jlt_kernels_nose_hoover_general,
    &jlt_kernels_restricted_three_body_general,
    &jlt_kernels_roessler_general,
    &jlt_kernels_routh_sphere_general,
    &jlt_kernels_routh_sphere_general_in_regular,
    &jlt_kernels_routh_sphere_balanced,
    &jlt_kernels_routh_sphere_balanced_in_regular,
    &jlt_kernels_spherical_top_general,
    &jlt_kernels_spherical_top_general_on_level_G,
    &jlt_kernels_spherical_top_general_on_level_G_omega3,
    &jlt_kernels_spherical_top_general_in_regular,
    &jlt_kernels_spherical_top_general_in_regular_on_level_G,
    &jlt_kernels_spherical_top_general_in_regular_on_level_G_omega3,
    &jlt_kernels_spherical_top_balanced,
    &jlt_kernels_spherical_top_balanced_on_level_G,
    &jlt_kernels_spherical_top_balanced_on_level_G_omega3,
    &jlt_kernels_spherical_top_balanced_in_regular,
    &jlt_kernels_spherical_top_balanced_in_regular_on_level_G,
    &jlt_kernels_spherical_top_balanced_in_regular_on_level_G_omega3,
    &jlt_kernels_spherical_top_rod,
    &jlt_kernels_spherical_top_rod_on_level_G,
    &jlt_kernels_spherical_top_rod_in_regular,
    &jlt_kernels_spherical_top_rod_in_regular_on_level_G,
    &jlt_kernels_spherical_top_balanced_equal,
    &jlt_kernels_spherical_top_balanced_equal_on_level_G,
    &jlt_kernels_spherical_top_balanced_equal_on_level_G_omega3,
    &jlt_kernels_spherical_top_balanced_equal_in_regular,
    &jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G,
    &jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G_omega3,
    &jlt_kernels_spherical_top_balanced_general,
    &jlt_kernels_spherical_top_balanced_general_in_regular,
    &jlt_kernels_spherical_top_balanced_equal_moments,
    &jlt_kernels_spherical_top_balanced_equal_moments_in_regular,
    &jlt_kernels_spherical_top_full_general,
    &jlt_kernels_spherical_top_level_general,
    &jlt_kernels_spherical_top_level_general_in_regular,
    &jlt_kernels_spherical_top_level_balanced,
    &jlt_kernels_spherical_top_level_balanced_in_regular,
    &jlt_kernels_spherical_top_level_rod,
    &jlt_kernels_spherical_top_level_rod_in_regular,
    &jlt_kernels_spherical_top_plane_general,
    &jlt_kernels_spherical_top_plane_general_in_regular,
    &jlt_kernels_spherical_top_plane_equal_moments,
    &jlt_kernels_spherical_top_plane_equal_moments_in_regular,
    &jlt_kernels_spherical_top_track_general,
    &jlt_kernels_spherical_top_track_general_in_regular,
    &jlt_kernels_spherical_top_track_balanced,
    &jlt_kernels_spherical_top_track_balanced_in_regular,
    &jlt_kernels_spherical_top_track_rod,
    &jlt_kernels_spherical_top_track_rod_in_regular,
    &jlt_kernels_toda_general,
};

const unsigned jlt_registry_count = 55;

const unsigned jlt_registry_entry_size = sizeof(jlt_descriptor);
