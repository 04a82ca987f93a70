/* The expression graph against direct exact arithmetic: random expressions are built twice, as nodes and as rational
 * numbers (with their derivatives) at random points, by rules that share no code with the graph. Nothing is rounded. */
#include "unit/check.h"

#include "base/random.h"
#include "expression/graph.h"

enum { SYMBOLS = 4, TRIALS = 400 };

typedef struct {
    ttc_id id;
    fmpq_t value, slope; /* slope: along the direction of the point */
} twin;

typedef struct {
    fmpq_t at[SYMBOLS], direction[SYMBOLS];
} point;

static uint64_t random_state;

static unsigned draw(unsigned bound)
{
    return (unsigned)(ttc_random_bits(&random_state) % bound);
}

static void draw_rational(fmpq_t q) { fmpq_set_si(q, (long)draw(19) - 9, 1 + draw(7)); }

static void point_init(point *p)
{
    for (int i = 0; i < SYMBOLS; i++) {
        fmpq_init(p->at[i]);
        fmpq_init(p->direction[i]);
        draw_rational(p->at[i]);
        draw_rational(p->direction[i]);
    }
}

static void point_clear(point *p)
{
    for (int i = 0; i < SYMBOLS; i++) {
        fmpq_clear(p->at[i]);
        fmpq_clear(p->direction[i]);
    }
}

static void twin_init(twin *t)
{
    t->id = TTC_NONE;
    fmpq_init(t->value);
    fmpq_init(t->slope);
}

static void twin_clear(twin *t)
{
    fmpq_clear(t->value);
    fmpq_clear(t->slope);
}

/* t = a (op) b by the rules of school; false where the value does not exist. */
static int combine(ttc_graph *graph, twin *t, const twin *a, const twin *b, unsigned operation)
{
    fmpq_t u;
    fmpq_init(u);
    int defined = 1;
    switch (operation) {
    case 0:
        t->id = ttc_add(graph, a->id, b->id);
        fmpq_add(t->value, a->value, b->value);
        fmpq_add(t->slope, a->slope, b->slope);
        break;
    case 1:
        t->id = ttc_subtract(graph, a->id, b->id);
        fmpq_sub(t->value, a->value, b->value);
        fmpq_sub(t->slope, a->slope, b->slope);
        break;
    case 2:
        t->id = ttc_multiply(graph, a->id, b->id);
        fmpq_mul(t->value, a->value, b->value);
        fmpq_mul(t->slope, a->slope, b->value);
        fmpq_mul(u, a->value, b->slope);
        fmpq_add(t->slope, t->slope, u);
        break;
    default:
        if (fmpq_is_zero(b->value)) {
            defined = 0;
            break;
        }
        t->id = ttc_divide(graph, a->id, b->id);
        fmpq_div(t->value, a->value, b->value);
        fmpq_mul(u, t->value, b->slope);
        fmpq_sub(t->slope, a->slope, u);
        fmpq_div(t->slope, t->slope, b->value);
        break;
    }
    fmpq_clear(u);
    return defined;
}

/* A random expression; its nesting is bounded by `depth`. */
static int grow(ttc_graph *graph, twin *t, const point *p, unsigned depth)
{
    unsigned choice = depth == 0 ? draw(2) : draw(6);
    if (choice == 0) {
        draw_rational(t->value);
        fmpq_zero(t->slope);
        t->id = ttc_number(graph, t->value);
        return 1;
    }
    if (choice == 1) {
        unsigned s = draw(SYMBOLS);
        fmpq_set(t->value, p->at[s]);
        fmpq_set(t->slope, p->direction[s]);
        t->id = ttc_symbol(graph, s);
        return 1;
    }
    twin a, b;
    twin_init(&a);
    twin_init(&b);
    int defined = grow(graph, &a, p, depth - 1) && grow(graph, &b, p, depth - 1) && combine(graph, t, &a, &b, choice - 2);
    twin_clear(&a);
    twin_clear(&b);
    return defined;
}

/* Value of a node, from its parts. False where a factor of negative power vanishes. */
static int evaluate(const ttc_graph *graph, ttc_id id, const point *p, fmpq_t value)
{
    fmpq_t part_value;
    int defined = 1;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) {
        fmpq_set(value, p->at[ttc_symbol_of(graph, id)]);
        return 1;
    }
    fmpq_init(part_value);
    fmpq_set(value, ttc_coefficient(graph, id));
    for (size_t i = 0; defined && i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        defined = evaluate(graph, part.id, p, part_value) && !(part.exponent < 0 && fmpq_is_zero(part_value));
        if (!defined) break;
        if (ttc_kind_of(graph, id) == TTC_SUM) {
            fmpq_addmul(value, part_value, part.coefficient);
        } else {
            fmpq_pow_si(part_value, part_value, part.exponent);
            fmpq_mul(value, value, part_value);
        }
    }
    fmpq_clear(part_value);
    return defined;
}

static void every_node_is_in_normal_form(const ttc_graph *graph)
{
    for (ttc_id id = 1; id <= ttc_graph_size(graph); id++) {
        ttc_kind kind = ttc_kind_of(graph, id);
        size_t count = ttc_part_count(graph, id);
        if (kind == TTC_NUMBER || kind == TTC_SYMBOL) {
            assert_int_equal(count, 0);
            continue;
        }
        assert_true(count >= 1);
        if (kind == TTC_PRODUCT) assert_false(fmpq_is_zero(ttc_coefficient(graph, id)));
        if (kind == TTC_SUM && count == 1) assert_false(fmpq_is_zero(ttc_coefficient(graph, id)));
        for (size_t i = 0; i < count; i++) {
            ttc_part part = ttc_part_at(graph, id, i);
            ttc_kind inner = ttc_kind_of(graph, part.id);
            assert_true(part.id < id);
            if (i > 0) assert_true(ttc_part_at(graph, id, i - 1).id < part.id);
            if (kind == TTC_PRODUCT) {
                assert_true(inner == TTC_SYMBOL || inner == TTC_SUM);
                assert_int_not_equal(part.exponent, 0);
                if (count == 1 && part.exponent == 1) {
                    assert_int_equal(inner, TTC_SYMBOL); /* a number times a sum is spread over the sum */
                    assert_false(fmpq_is_one(ttc_coefficient(graph, id)));
                }
            } else {
                assert_true(inner == TTC_SYMBOL || inner == TTC_PRODUCT);
                assert_false(fmpq_is_zero(part.coefficient));
                if (inner == TTC_PRODUCT) assert_true(fmpq_is_one(ttc_coefficient(graph, part.id)));
            }
        }
    }
}

static void nodes_have_the_value_of_what_they_were_built_from(void **unused)
{
    (void)unused;
    random_state = 1;
    int compared = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        ttc_graph *graph = ttc_graph_create();
        point p;
        twin t;
        fmpq_t value;
        assert_non_null(graph);
        point_init(&p);
        twin_init(&t);
        fmpq_init(value);
        if (grow(graph, &t, &p, 6) && t.id != TTC_NONE && evaluate(graph, t.id, &p, value)) {
            assert_true(fmpq_equal(value, t.value));
            compared++;
        }
        every_node_is_in_normal_form(graph);
        fmpq_clear(value);
        twin_clear(&t);
        point_clear(&p);
        ttc_graph_destroy(graph);
    }
    assert_true(compared > TRIALS / 2);
}

typedef struct {
    ttc_graph *graph;
    const point *p;
} setting;

static ttc_id direction_of(void *context, uint32_t symbol)
{
    const setting *s = context;
    return ttc_number(s->graph, s->p->direction[symbol]);
}

static void derivatives_equal_those_of_dual_numbers(void **unused)
{
    (void)unused;
    random_state = 2;
    int compared = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        ttc_graph *graph = ttc_graph_create();
        point p;
        twin t;
        fmpq_t value;
        assert_non_null(graph);
        point_init(&p);
        twin_init(&t);
        fmpq_init(value);
        setting s = { graph, &p };
        if (grow(graph, &t, &p, 5) && t.id != TTC_NONE) {
            ttc_id slope = ttc_derivative(graph, t.id, direction_of, &s);
            assert_int_not_equal(slope, TTC_NONE);
            if (evaluate(graph, slope, &p, value)) {
                assert_true(fmpq_equal(value, t.slope));
                compared++;
            }
        }
        fmpq_clear(value);
        twin_clear(&t);
        point_clear(&p);
        ttc_graph_destroy(graph);
    }
    assert_true(compared > TRIALS / 2);
}

typedef struct {
    ttc_id replacement[SYMBOLS];
} table;

static ttc_id replacement_of(void *context, uint32_t symbol) { return ((const table *)context)->replacement[symbol]; }

static void substitution_is_composition(void **unused)
{
    (void)unused;
    random_state = 3;
    int compared = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        ttc_graph *graph = ttc_graph_create();
        point p, images;
        twin t, inner[SYMBOLS];
        fmpq_t value;
        table replacements;
        int defined = 1;
        assert_non_null(graph);
        point_init(&p);
        point_init(&images);
        twin_init(&t);
        fmpq_init(value);
        for (int i = 0; i < SYMBOLS; i++) {
            twin_init(inner + i);
            defined = grow(graph, inner + i, &p, 2) && defined && inner[i].id != TTC_NONE;
            fmpq_set(images.at[i], inner[i].value);
            replacements.replacement[i] = inner[i].id;
        }
        if (defined && grow(graph, &t, &images, 4) && t.id != TTC_NONE) {
            ttc_id composed = ttc_substitute(graph, t.id, replacement_of, &replacements);
            if (composed != TTC_NONE && evaluate(graph, composed, &p, value)) {
                assert_true(fmpq_equal(value, t.value));
                compared++;
            }
        }
        for (int i = 0; i < SYMBOLS; i++) twin_clear(inner + i);
        fmpq_clear(value);
        twin_clear(&t);
        point_clear(&images);
        point_clear(&p);
        ttc_graph_destroy(graph);
    }
    assert_true(compared > TRIALS / 3);
}

static void sums_and_products_at_once_equal_those_step_by_step(void **unused)
{
    (void)unused;
    random_state = 4;
    for (int trial = 0; trial < TRIALS; trial++) {
        ttc_graph *g = ttc_graph_create();
        point p;
        twin t[5];
        ttc_id ids[5], sum = ttc_integer(g, 0), product = ttc_integer(g, 1);
        long exponents[5];
        fmpq weights[5];
        int usable = 1;
        point_init(&p);
        for (int i = 0; i < 5; i++) {
            twin_init(t + i);
            usable = grow(g, t + i, &p, 2) && usable && t[i].id != TTC_NONE && !ttc_is_number(g, t[i].id, 0);
            ids[i] = t[i].id;
            exponents[i] = (long)draw(5) - 2;
            fmpq_init(weights + i);
            draw_rational(weights + i);
        }
        for (int i = 0; usable && i < 5; i++) {
            sum = ttc_add(g, sum, ttc_scale(g, ids[i], weights + i));
            product = ttc_multiply(g, product, ttc_power(g, ids[i], exponents[i]));
        }
        if (usable) {
            assert_int_equal(ttc_sum(g, ids, weights, 5), sum);
            assert_int_equal(ttc_product(g, ids, exponents, 5), product);
        }
        for (int i = 0; i < 5; i++) {
            twin_clear(t + i);
            fmpq_clear(weights + i);
        }
        point_clear(&p);
        ttc_graph_destroy(g);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_have_the_value_of_what_they_were_built_from),
        cmocka_unit_test(derivatives_equal_those_of_dual_numbers),
        cmocka_unit_test(substitution_is_composition),
        cmocka_unit_test(sums_and_products_at_once_equal_those_step_by_step),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
