/* The expression graph on expressions written out: one node for one value, limits, errors. */
#include "unit/check.h"

#include <stdlib.h>

#include "expression/graph_node.h"

static void equal_expressions_are_one_node(void **unused)
{
    (void)unused;
    ttc_graph *g = ttc_graph_create();
    ttc_id x = ttc_symbol(g, 0), y = ttc_symbol(g, 1), z = ttc_symbol(g, 2), two = ttc_integer(g, 2);
    assert_int_equal(ttc_add(g, x, y), ttc_add(g, y, x));
    assert_int_equal(ttc_add(g, ttc_add(g, x, y), z), ttc_add(g, x, ttc_add(g, y, z)));
    assert_int_equal(ttc_multiply(g, ttc_multiply(g, x, y), z), ttc_multiply(g, x, ttc_multiply(g, z, y)));
    assert_int_equal(ttc_add(g, x, x), ttc_multiply(g, two, x));
    assert_int_equal(ttc_subtract(g, ttc_add(g, x, y), y), x);
    ttc_id sum = ttc_add(g, x, y), twice = ttc_multiply(g, two, sum);
    assert_int_equal(twice, ttc_add(g, ttc_multiply(g, two, x), ttc_multiply(g, two, y)));
    assert_int_equal(ttc_divide(g, twice, sum), two);
    assert_int_equal(ttc_divide(g, ttc_subtract(g, x, y), ttc_subtract(g, y, x)), ttc_integer(g, -1));
    assert_int_equal(ttc_power(g, ttc_power(g, sum, 3), -1), ttc_power(g, sum, -3));
    assert_int_equal(ttc_power(g, sum, 0), ttc_integer(g, 1));
    assert_int_equal(ttc_multiply(g, ttc_integer(g, 0), ttc_power(g, sum, 5)), ttc_integer(g, 0));
    ttc_graph_destroy(g);
}

static void operands_may_be_one_and_the_same(void **unused)
{
    (void)unused;
    ttc_graph *g = ttc_graph_create();
    ttc_id x = ttc_symbol(g, 0), y = ttc_symbol(g, 1);
    ttc_id sum = ttc_add(g, ttc_multiply(g, ttc_integer(g, 3), x), ttc_add(g, y, ttc_integer(g, 5)));
    assert_int_equal(ttc_subtract(g, sum, sum), ttc_integer(g, 0));
    assert_int_equal(ttc_divide(g, sum, sum), ttc_integer(g, 1));
    assert_int_equal(ttc_multiply(g, sum, sum), ttc_power(g, sum, 2));
    assert_int_equal(ttc_add(g, sum, sum), ttc_multiply(g, ttc_integer(g, 2), sum));
    assert_int_equal(ttc_scale(g, sum, ttc_coefficient(g, sum)), ttc_multiply(g, ttc_integer(g, 5), sum));
    ttc_id product = ttc_multiply(g, ttc_integer(g, 7), ttc_multiply(g, x, y));
    assert_int_equal(ttc_scale(g, product, ttc_coefficient(g, product)), ttc_multiply(g, ttc_integer(g, 7), product));
    assert_int_equal(ttc_scale(g, sum, ttc_part_at(g, sum, 0).coefficient), ttc_multiply(g, ttc_integer(g, 3), sum));
    ttc_graph_destroy(g);
}

/* `x` with a square, one level deeper at each step. */
static ttc_id nest(ttc_graph *g, int levels)
{
    ttc_id id = ttc_symbol(g, 0);
    for (int i = 0; i < levels && id != TTC_NONE; i++) id = ttc_add(g, ttc_power(g, id, 2), ttc_integer(g, 1));
    return id;
}

static ttc_id itself(void *graph, uint32_t symbol) { return ttc_symbol(graph, symbol); }

static void errors_are_told_first_and_until_cleared(void **unused)
{
    (void)unused;
    ttc_graph *g = ttc_graph_create();
    ttc_id x = ttc_symbol(g, 0), zero = ttc_integer(g, 0), two = ttc_integer(g, 2);
    assert_int_equal(ttc_divide(g, x, ttc_subtract(g, x, x)), TTC_NONE);
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_DIVISION_BY_ZERO);
    assert_int_equal(ttc_power(g, x, TTC_POWER_LIMIT + 1), TTC_NONE);
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_DIVISION_BY_ZERO);
    ttc_graph_clear_error(g);
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_OK);

    assert_int_equal(ttc_power(g, ttc_power(g, x, TTC_POWER_LIMIT), 2), TTC_NONE);
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_EXPONENT);
    ttc_graph_clear_error(g);

    ttc_id large = ttc_power(g, ttc_power(g, two, 64), 63);
    assert_int_not_equal(large, TTC_NONE);
    assert_int_equal(ttc_power(g, large, 64), TTC_NONE);
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_COEFFICIENT);
    ttc_graph_clear_error(g);
    ttc_id small = ttc_divide(g, x, ttc_add(g, large, ttc_integer(g, 1)));
    ttc_id more = ttc_add(g, ttc_symbol(g, 1), ttc_divide(g, x, large));
    assert_int_not_equal(more, TTC_NONE);
    assert_int_equal(ttc_add(g, small, more), TTC_NONE); /* the common denominator is too large */
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_COEFFICIENT);
    ttc_graph_clear_error(g);

    assert_int_not_equal(nest(g, TTC_DEPTH_LIMIT / 2 - 1), TTC_NONE);
    assert_int_equal(nest(g, TTC_DEPTH_LIMIT), TTC_NONE);
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_DEPTH);
    ttc_graph_clear_error(g);

    assert_int_equal(ttc_add(g, TTC_NONE, x), TTC_NONE);
    assert_int_equal(ttc_multiply(g, x, TTC_NONE), TTC_NONE);
    assert_int_equal(ttc_scale(g, TTC_NONE, ttc_coefficient(g, two)), TTC_NONE);
    assert_int_equal(ttc_substitute(g, TTC_NONE, itself, g), TTC_NONE);
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_OK); /* the error was told where it arose */
    assert_int_equal(ttc_divide(g, zero, two), zero);
    ttc_graph_destroy(g);
    ttc_graph_destroy(NULL);
}

static void a_sum_has_a_bounded_number_of_terms(void **unused)
{
    (void)unused;
    ttc_graph *g = ttc_graph_create();
    ttc_id *ids = malloc((TTC_PART_LIMIT + 1) * sizeof *ids);
    assert_non_null(ids);
    for (uint32_t i = 0; i <= TTC_PART_LIMIT; i++) ids[i] = ttc_symbol(g, i);
    assert_int_not_equal(ttc_sum(g, ids, NULL, TTC_PART_LIMIT), TTC_NONE);
    assert_int_equal(ttc_sum(g, ids, NULL, TTC_PART_LIMIT + 1), TTC_NONE);
    assert_int_equal(ttc_graph_error(g), TTC_GRAPH_TOO_LARGE);
    free(ids);
    ttc_graph_destroy(g);
}

static void dependence_is_reachability(void **unused)
{
    (void)unused;
    ttc_graph *g = ttc_graph_create();
    ttc_id x = ttc_symbol(g, 0), y = ttc_symbol(g, 1);
    ttc_id id = ttc_divide(g, ttc_integer(g, 1), ttc_add(g, ttc_power(g, x, 2), ttc_integer(g, 1)));
    assert_true(ttc_depends(g, id, 0));
    assert_false(ttc_depends(g, id, 1));
    assert_false(ttc_depends(g, ttc_subtract(g, ttc_add(g, x, y), y), 1));
    ttc_graph_destroy(g);
}

/* Nodes are found at once, in a small graph and in one that has grown: with as many buckets as nodes, chains of good hashes are
 * shorter than 16, but for a chance of 1e-8. */
static void nodes_spread_over_their_buckets(void **unused)
{
    (void)unused;
    ttc_graph *g = ttc_graph_create();
    ttc_id x = ttc_symbol(g, 0), y = ttc_symbol(g, 1);
    for (int size = 0, checked = 0; checked < 2; size++) {
        ttc_multiply(g, ttc_integer(g, size + 2), ttc_add(g, ttc_power(g, x, size % 200 + 1), ttc_power(g, y, size / 200 + 1)));
        if (size != 300 && size != 5000) continue;
        size_t longest = 0;
        for (size_t i = 0; i < g->bucket_count; i++) {
            size_t length = 0;
            for (ttc_id id = g->buckets[i]; id != TTC_NONE; id = g->nodes[id]->next) length++;
            if (length > longest) longest = length;
        }
        assert_true(g->count > (size_t)size && longest < 16);
        checked++;
    }
    ttc_graph_destroy(g);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_expressions_are_one_node),
        cmocka_unit_test(operands_may_be_one_and_the_same),
        cmocka_unit_test(errors_are_told_first_and_until_cleared),
        cmocka_unit_test(a_sum_has_a_bounded_number_of_terms),
        cmocka_unit_test(dependence_is_reachability),
        cmocka_unit_test(nodes_spread_over_their_buckets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
