/* Reversors and symmetries: affine maps of the states, with coefficients in parameters. */
#include "prove_text.h"

#define TOP "model top\nparam a\nparam b != 0\nparam k > 0\nstate x\nstate y\nstate z\neq x = y*z\neq y = x*z\neq z = x*y\n"

static void reversors_may_permute_and_mix_states(void **state)
{
    (void)state;
    expect(TOP "reversor x -> -y, y -> -x, z -> -z\n", "reversor", "reversor", TTC_PROVED, NULL);
    expect(TOP "reversor x -> y, y -> x, z -> -z\n", "reversor", "reversor", TTC_PROVED, NULL);
    expect(TOP "reversor x -> y, y -> x\n", "reversor", "reversor", TTC_REFUTED, "f(Sx) + S f(x) in x");
    expect("model mixed\nparam a\nstate x\nstate y\neq x = 1 + a*y\neq y = 2\n"
           "reversor x -> -x + a*y^1, y -> y\n", "reversor", "reversor", TTC_REFUTED, NULL);
    expect("model tilted\nparam k != 0\nstate x\nstate y\neq x = (x + k*y)^2 + x\neq y = (x + k*y)^2/k - y\n"
           "reversor x -> -k*y, y -> -x/k\n", "reversor", "reversor", TTC_PROVED, NULL);
}

static void a_reversor_is_an_involution(void **state)
{
    (void)state;
    expect(TOP "reversor x -> y, y -> z, z -> x\n", "reversor", "reversor", TTC_REFUTED, "S(S(x)) - x");
    expect("model still\nstate x\nstate y\neq x = 1\neq y = 0*y\nreversor x -> -x, y -> 2*y\n", "reversor", "reversor", TTC_REFUTED,
           "S(S(y)) - y = 3*y");
}

static void symmetries_need_an_inverse_and_nothing_more(void **state)
{
    (void)state;
    const char *table = TOP "symmetry x -> y, y -> z, z -> x\nsymmetry signs : x -> -x, z -> -z\nsymmetry one : x -> -x\n"
                            "symmetry flat : x -> y, z -> x\nsymmetry still : z -> z\n";
    expect(table, "symmetry", "symmetry", TTC_PROVED, NULL);
    expect(table, "symmetry", "signs", TTC_PROVED, NULL);
    expect(table, "symmetry", "one", TTC_REFUTED, "f(Sx) - S f(x)");
    expect(table, "symmetry", "flat", TTC_REFUTED, "determinant");
    expect(table, "symmetry", "still", TTC_UNSETTLED, "says nothing");
    const char *linear = "model linear\nparam a\nparam b != 0\nparam c >= 0\nparam d >= 0\nparam k > 0\nstate x\nstate y\n"
                         "eq x = -y\neq y = x\nsymmetry any : x -> a*x, y -> a*y\nsymmetry scaled : x -> b*x, y -> b*y\n"
                         "symmetry turned : x -> a*x - k*y, y -> k*x + a*y\nsymmetry both : x -> (c + d)*x, y -> (c + d)*y\n"
                         "symmetry more : x -> (c + k)*x, y -> (c + k)*y\nsymmetry set : x -> a*x, y -> a*y when a = 3\n";
    expect(linear, "symmetry", "any", TTC_REFUTED, "a = 0");
    expect(linear, "symmetry", "scaled", TTC_PROVED, NULL);
    expect(linear, "symmetry", "turned", TTC_PROVED, NULL);
    expect(linear, "symmetry", "both", TTC_REFUTED, "c = 0, d = 0");
    expect(linear, "symmetry", "more", TTC_PROVED, NULL);
    expect(linear, "symmetry", "set", TTC_PROVED, NULL);
}

static void a_map_is_affine_and_keeps_intervals(void **state)
{
    (void)state;
    const char *table = "model bounded\nparam l\nstate x in (-1, 1)\nstate y in (-1, 1)\nstate z in (0, inf)\nstate w in (-l, l)\n"
                        "angle c s = cos(x) sin(x)\neq x = 0*x\neq y = 0*y\neq z = 0*z\neq w = 0*w\n"
                        "symmetry bent : x -> x + y^2\nsymmetry round : x -> s\nsymmetry swap : x -> -y, y -> x\n"
                        "symmetry out : z -> -z\nsymmetry other : x -> z, z -> x\nsymmetry mirror : w -> -w\n";
    expect(table, "symmetry", "bent", TTC_REFUTED, "interval");
    expect(table, "symmetry", "round", TTC_UNSETTLED, NULL);
    expect(table, "symmetry", "swap", TTC_PROVED, NULL);
    expect(table, "symmetry", "out", TTC_REFUTED, "interval");
    expect(table, "symmetry", "other", TTC_REFUTED, "interval");
    expect(table, "symmetry", "mirror", TTC_PROVED, NULL);
    const char *two_to_one = "model punctured\nstate x\nstate y\ndomain apart : x^2 + y^2 > 0\neq x = 0\neq y = 0\n"
                             "symmetry square : x -> x^2 - y^2, y -> 2*x*y\n";
    expect(two_to_one, "symmetry", "square", TTC_UNSETTLED, "not affine"); /* its determinant is 4 (x^2 + y^2) */
}

/* r(Sx), e(Sx) and c(Sx) are other functions than r, e, c: taking them for the same would prove the wrong ones. */
static void functions_are_mapped_by_their_definitions(void **state)
{
    (void)state;
    const char *table = "model functions\nstate x\nstate y\nroot r = sqrt(1 + x^2 + 2*y^2)\nroot q = sqrt(1 + y^2 + 2*x^2)\n"
                        "exp e = exp(x)\nexp f = exp(-y)\nangle c s = cos(x + y) sin(x + y)\n"
                        "eq x = e + r + c\neq y = 1/f + q + c\nsymmetry swap : x -> y, y -> x\nreversor x -> -y, y -> -x\n"
                        "symmetry mirror : x -> -x, y -> -y\n";
    expect(table, "symmetry", "swap", TTC_PROVED, NULL);
    expect(table, "reversor", "reversor", TTC_REFUTED, NULL);
    expect(table, "symmetry", "mirror", TTC_REFUTED, NULL);
    const char *plain = "model plain\nstate x\nstate y\nexp e = exp(x)\nexp f = exp(-y)\nangle c s = cos(x + y) sin(x + y)\n"
                        "log l = log(1 + x^2*y^2)\neq x = e + c + l\neq y = 1/f + c + l\nsymmetry swap : x -> y, y -> x\n"
                        "reversor x -> -y, y -> -x\nsymmetry mirror : x -> -x, y -> -y\n";
    expect(plain, "symmetry", "swap", TTC_PROVED, NULL);
    expect(plain, "reversor", "reversor", TTC_REFUTED, NULL);
    expect(plain, "symmetry", "mirror", TTC_REFUTED, NULL);
}

/* Forwards phi grows out of no condition here, backwards it does out of most. */
static void a_period_leads_back_into_the_domain(void **state)
{
    (void)state;
    static const struct {
        const char *record;
        ttc_proof_status verdict;
    } tables[] = {
        { "log l = log(phi + 10)\n", TTC_REFUTED },         { "root r = sqrt(phi + 10)\n", TTC_REFUTED },
        { "domain d : phi + 10 > 0\n", TTC_REFUTED },       { "root r = sqrt(phi^2 + 10)\n", TTC_PROVED },
        { "log l = log(3 + s)\n", TTC_PROVED },             { "domain d : 2*c + s > 0\n", TTC_PROVED },
        { "domain d : x + s*phi^2 > 0\n", TTC_REFUTED },    { "root r = sqrt(x^2 + 2 - c)\n", TTC_PROVED },
    };
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
        char table[512];
        snprintf(table, sizeof table, "model turning\nstate x\nstate phi\nangle c s = cos(phi) sin(phi)\n%seq x = c - x\n"
                                      "eq phi = -1\nperiodic phi = 2*pi\n", tables[i].record);
        expect(table, "periodic", "phi", tables[i].verdict, NULL);
    }
}

/* A density that grows along phi as z contracts is one of the plane alone: on the cylinder all orbits go to the circle z = 0. */
static void a_density_of_an_angle_has_one_value(void **state)
{
    (void)state;
    const char *table = "model contracting\nparam a\nstate phi\nstate z\nangle c s = cos(phi) sin(phi)\nexp e = exp(a*phi)\n"
                        "eq phi = 1\neq z = -a*z\nperiodic phi = 2*pi\nmeasure grown = e\nmeasure still = e when a = 0\n"
                        "measure waves = (2 + s)/(2 + s) when a = 0\n";
    expect(table, "measure", "grown", TTC_PROVED, "not shown to be the same a period on");
    expect(table, "measure", "still", TTC_PROVED, "positive and smooth on the domain");
    expect(table, "measure", "waves", TTC_PROVED, "positive and smooth on the domain");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reversors_may_permute_and_mix_states),
        cmocka_unit_test(a_reversor_is_an_involution),
        cmocka_unit_test(symmetries_need_an_inverse_and_nothing_more),
        cmocka_unit_test(a_map_is_affine_and_keeps_intervals),
        cmocka_unit_test(functions_are_mapped_by_their_definitions),
        cmocka_unit_test(a_period_leads_back_into_the_domain),
        cmocka_unit_test(a_density_of_an_angle_has_one_value),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
