/* What a kernel's comment says of its divisors and roots, word by word for small tables: the oracle is what can vanish in
 * them. */
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(divisors_that_may_vanish_are_named_and_others_are_not),
        cmocka_unit_test(roots_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
