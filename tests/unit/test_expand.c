/* What becomes of a model's expressions when definitions are opened or differentiated, by the text of the result. */
#include "parsed_model.h"

static void expansion_opens_lets_and_nothing_else(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nparam a\nstate x\nroot s = sqrt(1 + x^2)\nlet k = a*x\nlet q = k^2 + s\neq x = q*k\n");
    prints(model, ttc_model_expand(model, ttc_model_field(model, 0)), "a*x*(s + a^2*x^2)");
    assert_true(ttc_model_depends(model, ttc_model_field(model, 0), symbol(model, "a")));
    assert_true(ttc_model_depends(model, model->symbols[symbol(model, "q")].node, symbol(model, "s")));
    assert_false(ttc_model_depends(model, model->symbols[symbol(model, "k")].node, symbol(model, "s")));
    ttc_model_destroy(model);
}

/* By hand: s' = x/s; (cos 2x)' = -2 sin 2x; k' = 2 x; the lets themselves stay in the factors. */
static void partial_derivatives_go_through_definitions(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nparam a\nstate x\nroot s = sqrt(1 + x^2)\nangle c d = cos(2*x) sin(2*x)\nlet k = x^2 + a\n"
                             "eq x = a\nequal one : s = 0\nequal two : c = 0\nequal three : d = 0\nequal four : k^2 = 0\n"
                             "equal five : k*s = 0\n");
    uint32_t x = symbol(model, "x");
    prints(model, ttc_model_partial(model, model->claims[0].expression, x), "x/s");
    prints(model, ttc_model_partial(model, model->claims[1].expression, x), "-2*d");
    prints(model, ttc_model_partial(model, model->claims[2].expression, x), "2*c");
    prints(model, ttc_model_partial(model, model->claims[3].expression, x), "4*x*k");
    prints(model, ttc_model_partial(model, model->claims[4].expression, x), "x*k/s + 2*x*s");
    prints(model, ttc_model_partial(model, model->claims[4].expression, symbol(model, "a")), "s");
    ttc_model_destroy(model);
}

static void a_state_named_by_a_let_of_itself_has_slope_one(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nstate x\nlet y = x\nlet z = y\neq x = z^3\n");
    prints(model, ttc_model_partial(model, ttc_model_field(model, 0), symbol(model, "x")), "3*z^2");
    prints(model, ttc_model_expand(model, ttc_model_field(model, 0)), "x^3");
    ttc_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(expansion_opens_lets_and_nothing_else),
        cmocka_unit_test(partial_derivatives_go_through_definitions),
        cmocka_unit_test(a_state_named_by_a_let_of_itself_has_slope_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
