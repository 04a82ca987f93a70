/* Which products of variables a ring takes for squares, whatever the number of its variables. */
#include "unit/check.h"

#include "algebra/ratio.h"

#include <stdbool.h>

enum { MOST = 40 };

/* The root of x_i x_j in a ring of n variables, the last of which is free for it: squared again. It is one of the variables
 * before it only where i = j. */
static void check_pair(slong n, slong i, slong j)
{
    const char *names[MOST];
    bool positive[MOST];
    for (slong v = 0; v < n; v++) {
        names[v] = "x";
        positive[v] = true;
    }
    ttc_ring *ring = ttc_ring_create((size_t)n, (size_t)n, names, positive);
    assert_non_null(ring);
    ttc_ratio product, root;
    ttc_ratio_init(ring, &product);
    ttc_ratio_init(ring, &root);
    ttc_ratio_set_variable(ring, &product, i);
    ttc_ratio_set_variable(ring, &root, j);
    ttc_ratio_multiply(ring, &product, &product, &root);
    ttc_ring_root(ring, &root, &product, n - 1, true);
    assert_int_equal(ring->status, TTC_RING_OK);
    assert_int_equal(ring->generator_count, i == j ? 0 : 1);
    ttc_ratio_multiply(ring, &root, &root, &root);
    assert_true(ttc_ratio_equal(ring, &root, &product));
    ttc_ratio_clear(ring, &root);
    ttc_ratio_clear(ring, &product);
    ttc_ring_destroy(ring);
}

static void a_product_of_two_variables_is_no_square(void **unused)
{
    (void)unused;
    for (slong n = 3; n <= MOST; n++)
        for (slong i = 0; i < n - 1; i++)
            for (slong j = i; j < n - 1; j++) check_pair(n, i, j);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(a_product_of_two_variables_is_no_square) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
