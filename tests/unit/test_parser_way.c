/* Records about tables that serve in place of each other: what the model then holds, and what is refused, by its message. */
#include "parsed_model.h"

#define OSCILLATOR "model t\nparam k > 0\nparam a\nstate x\nstate p\neq x = p\neq p = -k*x\nintegral E = p^2/2 + k*x^2/2\n" \
                   "integral F = p when k = 0\nlet twice = 2*p\n"

static void a_tier_keeps_its_conditions_as_they_are_written(void **unused)
{
    (void)unused;
    ttc_model *model = parse(OSCILLATOR "tier small while x^2   - 1 > 0, # a remark\n  2*p + 3\n  > 0 \"small one\"\n");
    assert_string_equal(model->tier.name, "small");
    assert_string_equal(model->tier.meaning, "small one");
    assert_int_equal(model->tier.conditions.count, 2);
    assert_string_equal(model->tier.conditions.items[0].text, "x^2 - 1 > 0");
    assert_string_equal(model->tier.conditions.items[1].text, "2*p + 3 > 0");
    prints(model, model->tier.conditions.items[0].expression, "x^2 - 1");
    assert_int_equal(model->tier.place.column, 6);
    ttc_model_destroy(model);
    model = parse(OSCILLATOR "tier small \"without conditions\"\n");
    assert_int_equal(model->tier.conditions.count, 0);
    ttc_model_destroy(model);
    refuses(OSCILLATOR, "tier small", "expected a text in quotes");
    refuses(OSCILLATOR, "tier small while x > 1 \"x\"", "coordinates are good while an expression is > 0");
    refuses(OSCILLATOR, "tier small while \"x\"", "unexpected text");
    refuses(OSCILLATOR, "tier small \"x\"\ntier large \"y\"", "a second tier (first in line 11)");
    refuses("model q\nstate b\nlift into t.tt with x = b\n", "tier points \"x\"", "no tier");
}

/* What a tier divides by excludes no points from the domain. */
static void divisors_of_a_tier_are_its_own(void **unused)
{
    (void)unused;
    ttc_model *model = parse(OSCILLATOR "tier small while 1/x - 1/p^2 > 0 \"small\"\n");
    assert_int_equal(model->divisor_count, 2);
    for (size_t i = 0; i < model->divisor_count; i++) assert_int_equal(model->divisors[i].role, TTC_DIVIDES_TIER);
    ttc_model_destroy(model);
}

static void a_reduction_by_a_table_keeps_what_its_record_says(void **unused)
{
    (void)unused;
    ttc_model *model = parse(OSCILLATOR "reduction down : by s.tt with q = atan2(p, twice), A = sqrt(p^2 + 1), E = E, b = p/x\n"
                                        "  when a = 0, k = 2 where x > 0, twice - 1 > 0\n");
    assert_int_equal(model->way_count, 1);
    const ttc_way *way = model->ways;
    const ttc_claim *claim = model->claims + way->claim;
    assert_int_equal(claim->kind, TTC_CLAIM_DESCENT);
    assert_string_equal(ttc_claim_kind_name(claim->kind), "reduction");
    assert_string_equal(claim->name, "down");
    assert_string_equal(claim->target, "s.tt");
    assert_int_equal(way->image.count, 3);
    assert_string_equal(way->image.names[1], "A");
    assert_int_equal(way->image.forms[0], TTC_GIVEN_ANGLE);
    assert_int_equal(way->image.forms[1], TTC_GIVEN_ROOT);
    assert_int_equal(way->image.forms[2], TTC_GIVEN_PLAIN);
    prints(model, claim->entries[1], "twice");
    prints(model, claim->entries[2], "p^2 + 1");
    prints(model, claim->entries[3], "1");
    assert_int_equal(way->image.level_count, 1);
    assert_string_equal(way->image.levels[0], "E");
    assert_string_equal(model->claims[claim->members[0]].name, "E");
    assert_int_equal(claim->when.count, 2);
    assert_int_equal(claim->when.items[1].symbol, symbol(model, "k"));
    assert_int_equal(way->where.count, 2);
    assert_string_equal(way->where.items[1].text, "twice - 1 > 0");
    assert_int_equal(model->divisors[0].role, TTC_DIVIDES_CLAIM);
    assert_int_equal(model->divisors[0].owner, way->claim);
    ttc_model_destroy(model);
    /* An integral may also stand last, before either clause. */
    model = parse(OSCILLATOR "reduction one : by s.tt with E = E when a = 0\nreduction two : by s.tt with E = E where x > 0\n");
    assert_int_equal(model->ways[0].image.level_count + model->ways[1].image.level_count, 2);
    ttc_model_destroy(model);
}

static void a_lift_with_a_name_leads_into_a_larger_table(void **unused)
{
    (void)unused;
    ttc_model *model = parse(OSCILLATOR "lift up : into b.tt with x = x, p = p, r = 0 where k - 1 > 0\n");
    assert_int_equal(model->way_count, 1);
    assert_null(model->lift.file);
    assert_int_equal(model->claims[model->ways->claim].kind, TTC_CLAIM_LIFT);
    assert_string_equal(model->ways->image.names[2], "r");
    assert_string_equal(model->ways->where.items[0].text, "k - 1 > 0");
    ttc_model_destroy(model);
}

/* The words are names elsewhere. */
static void words_of_ways_are_free_elsewhere(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nparam where\nparam tier\nstate lift\nstate while\n"
                             "eq lift = where*while\neq while = tier\n");
    assert_int_equal(model->way_count, 0);
    ttc_model_destroy(model);
}

static void ways_that_say_nothing_are_refused(void **unused)
{
    (void)unused;
    refuses(OSCILLATOR, "reduction down : by s with q = p", "not the name of a table");
    refuses(OSCILLATOR, "reduction down : by s.tt", "'with' after the table");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = p, q = x", "set twice");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = p, H = H", "unknown claim 'H'");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = p, F = F", "under a condition");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = atan2(p)", "','");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = sqrt(p, x)", "')' after the argument");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = sqrt(p)*x", "the end of the record");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = p when x = 0", "cannot be set here");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = p where x", "'>'");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = p where x > k", "a way serves where an expression is > 0");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = p where x > 0 when k = 1", "the end of the record");
    refuses(OSCILLATOR, "reduction down : by s.tt with q = p when k = a, a = k", "a circle");
    refuses(OSCILLATOR, "reduction E : by s.tt with q = p", "claimed twice");
    refuses(OSCILLATOR, "lift up : by b.tt with x = x", "'into'");
    refuses(OSCILLATOR, "lift up : into b.tt with x = atan2(x, p)", "names stand for quantities, not for functions");
    refuses(OSCILLATOR, "lift up : into b.tt with x = sqrt(x)", "'sqrt' is a keyword");
    refuses(OSCILLATOR, "lift up : into b.tt with x = x when k = 1", "the end of the record");
    refuses(OSCILLATOR, "lift up : into b.tt with x = H", "unknown name 'H'");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tier_keeps_its_conditions_as_they_are_written),
        cmocka_unit_test(divisors_of_a_tier_are_its_own),
        cmocka_unit_test(a_reduction_by_a_table_keeps_what_its_record_says),
        cmocka_unit_test(a_lift_with_a_name_leads_into_a_larger_table),
        cmocka_unit_test(words_of_ways_are_free_elsewhere),
        cmocka_unit_test(ways_that_say_nothing_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
