/* What a kernel's comment says of its divisors, roots and functions, word by word for small tables: the oracle is what can vanish
 * in them. */
#include "unit/check.h"

#include "emit/emit.h"
#include "kernels/catalogue.h"

typedef struct {
    const char *table, *losses; /* of its rhs */
} example;

static void expect_losses(const char *table, const char *losses)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(table, strlen(table), "sample.tt", diagnostics);
    ttc_catalogue plan;
    ttc_text text = { 0 };

    assert_non_null(model);
    assert_true(ttc_catalogue_create(&plan, model, TTC_ALL_FIELDS, TTC_EFFORT_QUICK));
    ttc_emit_losses(&text, plan.fields[0].kernels, TTC_KERNEL_RHS);
    /* What follows of sums has its own tests. */
    const char *said = ttc_text_string(&text), *sums = strstr(said, TTC_LOSS_SEPARATOR "digits are lost");
    assert_int_equal(sums == NULL ? strlen(said) : (size_t)(sums - said), strlen(losses));
    assert_memory_equal(said, losses, strlen(losses));
    ttc_text_clear(&text);
    ttc_catalogue_clear(&plan);
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
}

/* A positive constant keeps a sum of terms that are never negative from zero, and nothing else does. */
static void divisors_that_may_vanish_are_named_and_others_are_not(void **unused)
{
    static const example examples[] = {
        { "model t\nparam p > 0\nparam q\nstate x\neq x = 1/(p + q^2 + x^2)\n", "" },
        { "model t\nstate x\neq x = 1/(1 + x^2)\n", "" },
        { "model t\nstate x in (1, 2)\neq x = 1/x\n", "" },
        { "model t\nparam p >= 0\nstate x\neq x = 1/(p + x^2)\n", "divides by p + x^2, small only where all of p and x^2 are" },
        { "model t\nparam p > 0\nstate x\nstate y\neq x = 1/(x^2 + y^2 + p*y^4)\neq y = 1\n",
          "divides by x^2 + y^2 + p*y^4, small only where all of x^2, y^2 and p*y^4 are" },
        { "model t\nstate x in (0, 1)\neq x = 1/x\n",
          "divides by x: values and rounding errors grow without bound where it vanishes" },
        { "model t\nstate x\nstate y\neq x = 1/(x^2 + y)\neq y = 1\n",
          "divides by y + x^2: values and rounding errors grow without bound where it vanishes" },
        { "model t\nparam p > 0\nstate x\neq x = 1/(p - x^2)\n",
          "divides by p - x^2: values and rounding errors grow without bound where it vanishes" },
    };

    (void)unused;
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) expect_losses(examples[i].table, examples[i].losses);
}

static void roots_are_named(void **unused)
{
    (void)unused;
    expect_losses("model t\nstate x in (-1, 1)\nroot s = sqrt(1 - x^2)\neq x = s\n",
                  "takes s = sqrt(1 - x^2): rounding errors of the states grow without bound where it vanishes");
}

/* log(1 + u) is u for small u, of which 1 + u has lost digits, also if u is a parameter. Of what is not rounded none are lost. */
static void functions_of_rounded_arguments_are_named(void **unused)
{
    static const char end[] = " of a rounded argument: digits are lost near its zeros, or where an exponent is large";
    static const example examples[] = {
        { "model t\nstate x\nlog l = log(1 + x^2)\neq x = l\n", "takes log(x*x + 1)" },
        { "model t\nparam p > 0\nstate x\nlog l = log(1 + p)\neq x = l*x\n", "takes l" },
        { "model t\nparam p > 0\nstate x\nlog l = log(p)\nexp e = exp(2*p)\neq x = e*l*x\n", "" },
        { "model t\nparam p\nstate x\nstate y\nexp e = exp(3*p)\nangle c s = cos(x + y) sin(x + y)\neq x = e*c\neq y = 3*e*s\n",
          "takes e, cos(x + y), sin(x + y)" },
        { "model t\nstate x\nstate y\nexp e = exp(x + y)\nexp f = exp(x - y)\nangle c s = cos(x + y) sin(x + y)\n"
          "log l = log(2 + x^2)\neq x = e*f\neq y = c*s*l\n",
          "takes exp(x + y), exp(x - y), cos(x + y), sin(x + y), log(x*x + 2)" },
    };

    (void)unused;
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        char losses[256];
        snprintf(losses, sizeof losses, "%s%s", examples[i].losses, *examples[i].losses == '\0' ? "" : end);
        expect_losses(examples[i].table, losses);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(divisors_that_may_vanish_are_named_and_others_are_not),
        cmocka_unit_test(roots_are_named),
        cmocka_unit_test(functions_of_rounded_arguments_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
