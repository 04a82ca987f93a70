#include "validated/elliptic.h"

#include "validated/cycle_map.h"
#include "validated/taylor_map.h"

void jlt_elliptic_result_init(jlt_elliptic_result *result)
{
    result->verdict = JLT_ELLIPTIC_OTHER;
    jlt_normal_form_init(&result->form);
}

void jlt_elliptic_result_clear(jlt_elliptic_result *result)
{
    jlt_normal_form_clear(&result->form);
}

/* Whether the linear part of the Taylor map is consistent with the cycle computed from sets: equal traces, determinant 1. */
static bool agrees(arb_srcptr map, const arb_t trace, slong bits)
{
    bool same;
    JLT_SCOPED(arb, value);

    arb_add(value, map + 1, map + JLT_TAYLOR_MAP_TERMS + 2, bits);
    same = arb_overlaps(value, trace);
    arb_mul(value, map + 1, map + JLT_TAYLOR_MAP_TERMS + 2, bits);
    arb_submul(value, map + 2, map + JLT_TAYLOR_MAP_TERMS + 1, bits);
    same = same && arb_contains_si(value, 1);
    return same;
}

/* Whether zero is excluded even by a ball of twice the radius, as it is when the certificate has rounded the ball. */
static bool excludes_zero(const arb_t a)
{
    JLT_SCOPED(arb, wide);

    arb_set(wide, a);
    mag_mul_2exp_si(arb_radref(wide), arb_radref(wide), 1);
    return !arb_contains_zero(wide);
}

jlt_status jlt_elliptic_prove(jlt_cycle *of, jlt_elliptic_result *result, const jlt_cycle_result *cycle, jlt_symmetry_type type,
                              arb_srcptr instants, const unsigned *kept)
{
    const slong bits = jlt_step_bits(of->step);
    JLT_SCOPED_VECTOR(arb, map, 2 * JLT_TAYLOR_MAP_TERMS);

    result->verdict = JLT_ELLIPTIC_OTHER;
    if (type != JLT_SYMMETRY_ELLIPTIC) return JLT_OK;
    result->verdict = JLT_ELLIPTIC_RESONANT;
    if (arb_contains_si(cycle->trace, 0) || arb_contains_si(cycle->trace, -1)) return JLT_OK;
    JLT_PASS(jlt_taylor_map_compute(of, map, cycle, instants, kept));
    jlt_normal_form_compute(&result->form, map, cycle->trace, bits);
    result->verdict = JLT_ELLIPTIC_CONTRADICTED;
    if (!agrees(map, cycle->trace, bits) || !arb_contains_zero(result->form.growth)) return JLT_OK;
    result->verdict = excludes_zero(result->form.twist) ? JLT_ELLIPTIC_PROVED : JLT_ELLIPTIC_UNTWISTED;
    return JLT_OK;
}
