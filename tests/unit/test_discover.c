/* The parts of a discovery: symmetries, sectors, ranks, and functions of parameters from values in a prime field. */
#include "parsed_model.h"

#include "discover/dependence.h"
#include "discover/null_space.h"

/* A top in a frame of its own: r is the root of what moves; k has weight 2. */
static const char swinging[] = "model t\nparam k > 0\nparam l != 0\nstate x in (-1, 1)\nstate v\nstate w\nroot r = sqrt(1 - x^2)\n"
                               "eq x = r*v\neq v = -x*w^2/r - k*l*r\neq w = x*v*w/r\n";

static ttc_flow *flow_of(const ttc_model *model)
{
    const char *why = NULL;
    ttc_flow *flow = ttc_flow_create(model, NULL, &why);
    if (flow == NULL) print_error("%s\n", why);
    assert_non_null(flow);
    return flow;
}

/* Oracle: by hand. Backwards: v and w; v alone (r stays). Forwards: w alone; r and v together. */
static void sign_changes_are_those_of_the_motion(void **unused)
{
    (void)unused;
    ttc_model *model = parse(swinging);
    ttc_flow *flow = flow_of(model);
    ttc_sign_changes changes;
    ttc_sign_changes_find(&changes, flow);
    assert_int_equal(flow->count, 4); /* x, v, w, r */
    assert_int_equal(changes.count, 3);
    assert_true(changes.last_is_backwards);
    for (size_t i = 0; i + 1 < changes.count; i++) /* forwards: w, or r with v, or all three */
        assert_true(changes.changes[i] == 4 || changes.changes[i] == 10 || changes.changes[i] == 14);
    assert_int_equal(changes.changes[2] & 1, 0);
    ttc_flow_destroy(flow);
    ttc_model_destroy(model);
}

/* Oracle: velocities have weight 1 and gravity 2; x and its root none. */
static void weights_are_those_without_the_force(void **unused)
{
    (void)unused;
    ttc_model *model = parse(swinging);
    ttc_flow *flow = flow_of(model);
    ttc_grading grading;
    ttc_grading_find(&grading, flow);
    assert_non_null(grading.weights);
    const long expected[] = { 0, 1, 1, 0 };
    for (size_t i = 0; i < 4; i++) assert_int_equal(grading.weights[i], expected[i]);
    assert_true(grading.parameter == flow->parameters[0] || grading.parameter == flow->parameters[1]);
    ttc_grading_clear(&grading);
    ttc_flow_destroy(flow);
    ttc_model_destroy(model);
}

/* Oracle: the list itself; monomials of degree <= d in three variables, and those times the root. */
static void blocks_are_as_large_as_was_said(void **unused)
{
    (void)unused;
    ttc_model *model = parse(swinging);
    ttc_flow *flow = flow_of(model);
    ttc_sign_changes changes;
    ttc_grading grading;
    ttc_sign_changes_find(&changes, flow);
    ttc_grading_find(&grading, flow);
    for (int graded = 0; graded < 2; graded++)
        for (int degree = 1; degree < 7; degree++) {
            const size_t d = (size_t)degree;
            double total, largest;
            ttc_ansatz ansatz;
            ttc_ansatz_measure(&total, &largest, flow, degree, &changes, changes.count, graded ? &grading : NULL);
            ttc_ansatz_create(&ansatz, flow, degree, &changes, changes.count, graded ? &grading : NULL);
            assert_int_equal(ansatz.total, (d + 3) * (d + 2) * (d + 1) / 6 + (d + 2) * (d + 1) * d / 6);
            assert_true(total == (double)ansatz.total && largest == (double)ansatz.largest);
            ttc_ansatz_clear(&ansatz);
        }
    ttc_grading_clear(&grading);
    ttc_flow_destroy(flow);
    ttc_model_destroy(model);
}

/* Oracle: energy v^2/2 + w^2/2 - k l x and area r w, and what they make up to degree 4: 1, A, A^2, E, E A, E^2 with deg A = deg E
 * = 2. */
static void ranks_leave_known_integrals(void **unused)
{
    (void)unused;
    ttc_model *model = parse(swinging);
    ttc_flow *flow = flow_of(model);
    uint64_t source = 7;
    slong bound = 0;
    ttc_sign_changes changes;
    ttc_ansatz ansatz;
    ulong *values = flint_calloc(flow->ring->variable_count, sizeof *values);
    ttc_sign_changes_find(&changes, flow);
    ttc_flow_draw_parameters(flow, values, -1, &source);
    ttc_ansatz_create(&ansatz, flow, 4, &changes, changes.count, NULL);
    for (size_t b = 0; b < ansatz.sector_count; b++) {
        nmod_mat_t null;
        const slong of_block = ttc_null_space_bound(flow, &ansatz.sectors[b], (ttc_twist){ NULL, 0 }, values, &source);
        assert_int_equal(ttc_null_space(null, flow, &ansatz.sectors[b], (ttc_twist){ NULL, 0 }, values, &source), of_block);
        nmod_mat_clear(null);
        bound += of_block;
    }
    assert_int_equal(bound, 6);
    ttc_ansatz_clear(&ansatz);
    flint_free(values);
    ttc_flow_destroy(flow);
    ttc_model_destroy(model);
}

/* (3 k^2 - l)/(2 l (k + 5)), and 7/3. */
static bool sample(void *context, ulong *out, ulong *parameters)
{
    const ttc_flow *flow = context;
    const nmod_t mod = flow->mod;
    const ulong k = parameters[flow->parameters[0]], l = parameters[flow->parameters[1]];
    const ulong above = nmod_sub(nmod_mul(3, nmod_mul(k, k, mod), mod), l, mod);
    const ulong below = nmod_mul(nmod_mul(2, l, mod), nmod_add(k, 5, mod), mod);
    if (below == 0) return false;
    out[0] = nmod_div(above, below, mod);
    out[1] = nmod_div(7, 3, mod);
    return true;
}

static void functions_of_parameters_are_found_from_values(void **unused)
{
    (void)unused;
    ttc_model *model = parse(swinging);
    ttc_flow *flow = flow_of(model);
    uint64_t source = 3;
    ttc_ratio found[2];
    for (size_t i = 0; i < 2; i++) ttc_ratio_init(flow->ring, &found[i]);
    assert_true(ttc_dependence_find(found, 2, flow, sample, flow, &source));
    char *text = ttc_ratio_text(flow->ring, &found[0]);
    assert_string_equal(text, "(3*k^2-l)/(2*k*l+10*l)");
    free(text);
    text = ttc_ratio_text(flow->ring, &found[1]);
    assert_string_equal(text, "(7)/(3)");
    free(text);
    for (size_t i = 0; i < 2; i++) ttc_ratio_clear(flow->ring, &found[i]);
    ttc_flow_destroy(flow);
    ttc_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sign_changes_are_those_of_the_motion), cmocka_unit_test(weights_are_those_without_the_force),
        cmocka_unit_test(blocks_are_as_large_as_was_said),      cmocka_unit_test(ranks_leave_known_integrals),
        cmocka_unit_test(functions_of_parameters_are_found_from_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
