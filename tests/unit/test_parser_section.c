/* Records about sections: what the model then holds, and what is refused, by its message. */
#include "parsed_model.h"

#define OSCILLATOR "model t\nparam k > 0\nstate x in (-1, 1)\nstate p\neq x = p\neq p = -k*x\nintegral E = p^2/2 + k*x^2/2\n" \
                   "integral F = p when k = 0\nroot s = sqrt(1 - x^2)\nlet twice = 2*p\n"
#define POINTS "model q\nparam E\nstate a\nstate b\nangle c s = cos(a) sin(a)\n"

static void poles_are_ends_of_intervals(void **unused)
{
    (void)unused;
    ttc_model *model = parse(OSCILLATOR "pole x \"as far as it goes\"\n");
    assert_int_equal(model->pole_count, 1);
    assert_int_equal(model->poles[0].state, symbol(model, "x"));
    assert_string_equal(model->poles[0].meaning, "as far as it goes");
    ttc_model_destroy(model);
    refuses(OSCILLATOR, "pole p", "no interval with rational ends");
    refuses(OSCILLATOR, "pole k", "is not a state");
    refuses(OSCILLATOR, "pole x\npole x", "twice");
    refuses("model t\nparam h > 0\nstate x in (0, h)\neq x = 1\n", "pole x", "no interval with rational ends");
    refuses("model t\nstate x in (0, pi)\neq x = 1\n", "pole x", "no interval with rational ends");
}

static void a_section_keeps_what_its_record_says(void **unused)
{
    (void)unused;
    ttc_model *model = parse(OSCILLATOR "section cut : by q.tt at x = 1/2 with a = atan2(p, twice), E = E, b = p + x\n"
                                        "  beside twice, p ending x\n");
    assert_int_equal(model->section_count, 1);
    const ttc_section *section = model->sections;
    const ttc_claim *claim = model->claims + section->claim;
    assert_int_equal(claim->kind, TTC_CLAIM_SECTION);
    assert_string_equal(claim->name, "cut");
    assert_string_equal(claim->target, "q.tt");
    assert_int_equal(claim->when.items[0].symbol, symbol(model, "x"));
    prints(model, claim->when.items[0].expression, "1/2");
    assert_int_equal(section->image.count, 2);
    assert_string_equal(section->image.names[0], "a");
    assert_int_equal(section->image.forms[0], TTC_GIVEN_ANGLE);
    assert_int_equal(section->image.forms[1], TTC_GIVEN_PLAIN);
    prints(model, claim->entries[0], "p");
    prints(model, claim->entries[1], "twice");
    prints(model, claim->entries[2], "x + p");
    prints(model, claim->entries[3], "1");
    assert_int_equal(section->image.level_count, 1);
    assert_string_equal(section->image.levels[0], "E");
    assert_string_equal(model->claims[claim->members[0]].name, "E");
    assert_int_equal(section->beside_count, 2);
    assert_int_equal(section->beside[1], symbol(model, "p"));
    assert_int_equal(section->ending_count, 1);
    ttc_model_destroy(model);
}

static void sections_that_say_nothing_are_refused(void **unused)
{
    (void)unused;
    refuses(OSCILLATOR, "section cut : by q at x = 0 with a = p", "not the name of a table");
    refuses(OSCILLATOR, "section cut : by q.tt at k = 0 with a = p", "cannot be set here");
    refuses(OSCILLATOR, "section cut : by q.tt at x = p with a = p", "which is a number there");
    refuses(OSCILLATOR, "section cut : by q.tt at x = 0, p = 0 with a = p", "expected one state");
    refuses(OSCILLATOR, "section cut : by q.tt at x = 0 with a = p, a = x", "set twice");
    refuses(OSCILLATOR, "section cut : by q.tt at x = 0 with a = p, b = H", "unknown claim 'H'");
    refuses(OSCILLATOR, "section cut : by q.tt at x = 0 with a = p, b = F", "under a condition");
    refuses(OSCILLATOR, "section cut : by q.tt at x = 0 with a = atan2(p)", "','");
    refuses(OSCILLATOR, "section cut : by q.tt at x = 0 with a = p beside k", "cannot be shown");
    refuses(OSCILLATOR, "section cut : by q.tt at x = 0 with a = p beside p, p", "shown twice");
    refuses(OSCILLATOR, "section E : by q.tt at x = 0 with a = p", "claimed twice");
}

static void a_table_of_coordinates_has_a_lift_and_no_equations(void **unused)
{
    (void)unused;
    ttc_model *model = parse(POINTS "lift into t.tt with x = b, p = E*c\nstart here : b = 1/2, a = -3\nturns b - E \"below\"\n");
    assert_int_equal(model->equation_count, 0);
    assert_string_equal(model->lift.file, "t.tt");
    assert_int_equal(model->lift.bindings.count, 2);
    assert_string_equal(model->lift.names[1], "p");
    prints(model, model->lift.bindings.items[1].expression, "E*c");
    assert_int_equal(model->start_count, 1);
    prints(model, model->starts[0].point[0], "-3");
    prints(model, model->starts[0].point[1], "1/2");
    prints(model, model->turn, "-E + b");
    assert_string_equal(model->turn_meaning, "below");
    ttc_model_destroy(model);
    const char *table = POINTS "lift into t.tt with x = b\n";
    refuses(table, "eq a = b", "not both");
    refuses(table, "lift into t.tt with x = b", "a second lift");
    refuses(table, "time u : 1 + b^2", "asks for no kernels");
    refuses(table, "reversor a -> -a", "nothing moves in it");
    refuses(table, "start here : a = 1", "has no 'b'");
    refuses(table, "start here : a = 1, b = E", "not a number");
    refuses(table, "start here : a = 1, a = 2, b = 1", "set twice");
    refuses(table, "start here : a = 1, b = 1\nstart here : a = 2, b = 1", "a second start");
    refuses(table, "start here : a = 1, b = 1\nstate c", "a state below the start 'here'");
    refuses(table, "turns b", "a text in quotes");
    refuses(table, "turns b \"so\"\nturns a \"so\"", "a second 'turns'");
    refuses(POINTS, "", "has no equation");
    refuses(OSCILLATOR, "start here : x = 0, p = 1", "belong to a table of coordinates");
}

static void words_of_sections_remain_free_as_names(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nparam pole\nparam at\nparam beside\nstate section\nstate lift\nstate start\nstate turns\n"
                             "let ending = pole*section\neq section = at*lift\neq lift = ending\neq start = turns\neq turns = "
                             "start*beside\n"
                             "let atan2 = pole*start\nobserve atan2\n");
    prints(model, ttc_model_field(model, 1), "ending");
    ttc_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(poles_are_ends_of_intervals),
        cmocka_unit_test(a_section_keeps_what_its_record_says),
        cmocka_unit_test(sections_that_say_nothing_are_refused),
        cmocka_unit_test(a_table_of_coordinates_has_a_lift_and_no_equations),
        cmocka_unit_test(words_of_sections_remain_free_as_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
