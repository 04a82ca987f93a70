/* What a prover must not fall for: each test is a classical way of proving something false. */
#include "prove_text.h"

#define PLANE "model plane\nparam a\nparam c > 0\nstate x\nstate y\neq x = y\neq y = -x\n"

static void a_denominator_that_vanishes_under_when_is_an_error(void **state)
{
    (void)state;
    const char *table = PLANE "equal division : x*a/(a*y) = x/y when a = 0\n"
                              "equal inverse : (x^2 - 1)/(a - c) = (x - 1)*(x + 1)/(a - c) when a = c\n"
                              "integral level = (x^2 + y^2)/(a + 1) when a = -1\n";
    expect(table, "equal", "inverse", TTC_UNSETTLED, "denominator");
    expect(table, "integral", "level", TTC_UNSETTLED, "denominator");
}

static void a_denominator_that_vanishes_on_the_zero_level_is_an_error(void **state)
{
    (void)state;
    const char *table = PLANE "integral H = x^2 + y^2 - c\n"
                              "equal divided : (x^4 - (c - y^2)^2)/(x^2 + y^2 - c) = 2*x^2 modulo H\n";
    expect(table, "equal", "divided", TTC_UNSETTLED, "denominator");
}

/* On x y = 0 the claim x = 0 holds on one line only; on (x - y)(x + 2 y) = 0 likewise. */
static void every_factor_of_a_zero_level_counts(void **state)
{
    (void)state;
    const char *table =
        "model cross\nstate x\nstate y\neq x = x\neq y = y\ninvariant cross = x*y\ninvariant lines = (x - y)*(x + 2*y)\n"
        "equal one_line : x = 0 modulo cross\nequal both : x^2*y^3 = 0 modulo cross\n"
        "equal other_line : x = -2*y modulo lines\nequal both_lines : x^2 = 2*y^2 - x*y modulo lines\n";
    expect(table, "equal", "one_line", TTC_REFUTED, "= x");
    expect(table, "equal", "both", TTC_PROVED, NULL);
    expect(table, "equal", "other_line", TTC_REFUTED, NULL);
    expect(table, "equal", "both_lines", TTC_PROVED, NULL);
}

#define REST "eq u = 0*u\neq w = 0*w\neq z = 0*z\n"

/* u = -b/a, w = -b z/a leaves out a = b = 0, where u z = w is false: there the claim is to fail. */
static void a_component_on_which_the_solved_form_degenerates_is_not_overlooked(void **state)
{
    (void)state;
    expect("model hidden\nstate a\nstate b\nstate u\nstate w\nstate z\neq a = a\neq b = b\n" REST
           "invariant h1 = a*u + b\ninvariant h2 = a*w + b*z\nequal generic : u*z = w modulo h1, h2\n",
           "equal", "generic", TTC_REFUTED, "u*z-w");
    expect("model hidden\nstate a\nstate b\nstate c\nstate u\nstate w\nstate z\neq a = a\neq b = b\neq c = 0*c\n" REST
           "invariant h1 = a*u + b*c\ninvariant h2 = a*w + b*z\nequal generic : u*z = w*c modulo h1, h2\n",
           "equal", "generic", TTC_REFUTED, "u*z");
}

/* On the circle, (x - 1) z + y w = 0 contains the line x = 1, y = 0, where y z = (x + 1) w says w = 0. */
static void a_component_of_a_level_over_a_quadratic_is_not_overlooked(void **state)
{
    (void)state;
    const char *table = "model circle\nstate x\nstate y\nstate z\nstate w\neq x = 0*x\neq y = 0*y\neq z = 0*z\neq w = 0*w\n"
                        "integral norm = x^2 + y^2 - 1\ninvariant h = (x - 1)*z + y*w\n"
                        "equal generic : y*z = (x + 1)*w modulo norm, h\n";
    expect(table, "equal", "generic", TTC_REFUTED, "x = 1, y = 0");
}

static void a_zero_level_that_is_empty_proves_nothing(void **state)
{
    (void)state;
    const char *table = "model nothing\nstate x\nparam c > 0\nroot r = sqrt(1 + x^2)\neq x = x\ninvariant K = r\n"
                        "equal absurd : x = 1 modulo K\n";
    expect(table, "equal", "absurd", TTC_UNSETTLED, "empty");
}

static void a_root_whose_radicand_becomes_a_square_has_the_positive_sign(void **state)
{
    (void)state;
    const char *table = "model square\nparam c > 0\nparam a\nstate x\nroot r = sqrt(c^2 + a*x)\nroot q = sqrt(x^2 + a)\neq x = 1\n"
                        "equal positive : r = c when a = 0\nequal negative : r = -c when a = 0\n"
                        "equal either : q^2 = x^2 when a = 0\nequal unsigned : q = x when a = 0\n";
    expect(table, "equal", "positive", TTC_PROVED, NULL);
    expect(table, "equal", "negative", TTC_REFUTED, "2*c");
    expect(table, "equal", "either", TTC_PROVED, NULL);
    expect(table, "equal", "unsigned", TTC_REFUTED, "-2*x");
}

/* sqrt(2) sqrt(3) = sqrt(6); without noticing, r s - t would be called nonzero, and 1/(r s - t) defined. */
static void dependent_roots_are_not_taken_for_independent(void **state)
{
    (void)state;
    const char *table = "model roots\nparam c > 0\nparam d > 0\nstate x\nroot r = sqrt(c)\nroot s = sqrt(d)\nroot t = sqrt(c*d)\n"
                        "root w = sqrt(4*c)\neq x = 1\nequal product : r*s = t\nequal double : w = 2*r\n"
                        "equal inverse : x/(r*s - t) = x/(r*s - t)*x\nequal rational : 1/(r + s) = (r - s)/(c - d)\n"
                        "equal not_rational : 1/(r + s) = (r + s)/(c - d)\n";
    expect(table, "equal", "product", TTC_PROVED, NULL);
    expect(table, "equal", "double", TTC_PROVED, NULL);
    expect(table, "equal", "inverse", TTC_UNSETTLED, "denominator");
    expect(table, "equal", "rational", TTC_PROVED, NULL);
    expect(table, "equal", "not_rational", TTC_REFUTED, NULL);
}

/* (p + r)^2 under a root of its own is p + r; the root of r, or of 1 + r, is new. */
static void nested_roots_are_recognized_exactly(void **state)
{
    (void)state;
    const char *table = "model nested\nparam p > 0\nstate x\nroot r = sqrt(1 + x^2)\nroot t = sqrt(p^2 + 1 + x^2 + 2*p*r)\n"
                        "root u = sqrt(r)\nroot w = sqrt(1 + r)\neq x = r\nequal known : t = p + r\nequal wrong : t = r - p\n"
                        "equal fourth : u^4 = 1 + x^2\nequal fresh : w = 1 + u\nequal inverse : 1/(w - u) = w + u\n"
                        "rate slope : u = x/(2*u)\n";
    expect(table, "equal", "known", TTC_PROVED, NULL);
    expect(table, "equal", "wrong", TTC_REFUTED, "2*p");
    expect(table, "equal", "fourth", TTC_PROVED, NULL);
    expect(table, "equal", "fresh", TTC_REFUTED, NULL);
    expect(table, "equal", "inverse", TTC_PROVED, NULL);
    expect(table, "rate", "slope", TTC_PROVED, NULL);
}

static void a_root_that_vanishes_or_is_imaginary_is_an_error(void **state)
{
    (void)state;
    const char *table =
        "model imaginary\nparam a\nstate x in (-1, 1)\nstate y\nroot s = sqrt(1 - x^2)\nroot r = sqrt(a)\neq x = s*y\neq y = -x\n"
        "equal zero : r*y = 0 when a = 0\nequal negative : r^2 = -1 when a = -1\n"
        "equilibria pole : x = 1, y = 0\nequilibria beyond : x = 2, y = 0\n";
    expect(table, "equal", "zero", TTC_UNSETTLED, "root");
    expect(table, "equal", "negative", TTC_UNSETTLED, "zero or negative");
    expect(table, "equilibria", "pole", TTC_REFUTED, "interval");
    expect(table, "equilibria", "beyond", TTC_REFUTED, "interval");
    expect("model never\nstate x\nroot r = sqrt(-1 - x^2)\neq x = r\n", "root", "r", TTC_REFUTED, "-x^2-1");
}

static void conditions_outside_the_domain_are_errors(void **state)
{
    (void)state;
    expect(PLANE "equal empty : x = y when c = -1\n", "equal", "empty", TTC_UNSETTLED, "domain");
}

static void an_obstruction_needs_equilibria_in_the_domain_and_a_trace_that_is_not_zero(void **state)
{
    (void)state;
    const char *table = "model damped\nparam k >= 0\nstate x\nstate v\nroot q = sqrt(x^2 + 1)\neq x = v\neq v =\n - x\n - k*v\n"
                        "equilibria rest : x = 0, v = 0\nobstructs rest\n"
                        "equilibria free : x = 0, v = 0 when k = 0\nobstructs free\n"
                        "equilibria moving : x = 0\nobstructs moving\n"
                        "equilibria hidden_zero : x = 0, v = 0\ntrace hidden_zero = -k*q^2 + k*x^2\n";
    expect(table, "obstructs", "rest", TTC_PROVED, "k = ");
    expect(table, "obstructs", "free", TTC_REFUTED, "nothing is obstructed");
    expect(table, "obstructs", "moving", TTC_REFUTED, "dx/dt");
    expect(table, "trace", "hidden_zero", TTC_PROVED, NULL);
    /* A family on which one state would have to leave its interval. */
    expect("model bounded\nstate x in (0, 1)\nstate y in (0, 1)\neq x = (y - 2 - x)*x\neq y = 0*y\n"
           "equilibria none : y = x + 2\nobstructs none\n",
           "obstructs", "none", TTC_UNSETTLED, "outside its domain");
}

/* The trace (s^2 + x^2 - 1) k is zero, though no polynomial identity says so before s^2 is replaced. */
static void a_trace_that_is_zero_only_modulo_the_root_obstructs_nothing(void **state)
{
    (void)state;
    const char *table = "model disguised\nparam k > 0\nstate x in (-1, 1)\nstate y\nroot s = sqrt(1 - x^2)\n"
                        "eq x = 0*x\neq y = k*(s^2 + x^2 - 1)*y\nequilibria all : y = 0\nobstructs all\n";
    expect(table, "obstructs", "all", TTC_REFUTED, "nothing is obstructed");
}

static void a_characteristic_polynomial_is_fixed_up_to_a_factor_free_of_lambda(void **state)
{
    (void)state;
    const char *head = "model spring\nparam k > 0\nstate x\nstate v\neq x = v\neq v = -k*x\nequilibria rest : x = 0, v = 0\n";
    static const struct {
        const char *polynomial;
        ttc_proof_status status;
    } cases[] = {
        { "lambda^2 + k", TTC_PROVED },           { "3*k*(lambda^2 + k)/(k + 1)", TTC_PROVED },
        { "lambda*(lambda^2 + k)", TTC_REFUTED }, { "(lambda^2 + k)/lambda", TTC_REFUTED },
        { "0*lambda", TTC_REFUTED },              { "lambda^2 - k", TTC_REFUTED },
        { "k", TTC_REFUTED },                     { "(k - k)*(lambda^2 + k)", TTC_REFUTED },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char table[1024];
        snprintf(table, sizeof table, "%scharpoly rest = %s\n", head, cases[i].polynomial);
        expect(table, "charpoly", "rest", cases[i].status, NULL);
    }
    /* What is no polynomial for parameters in general is refuted where it is none, and not at a = 0. */
    const char *quotient = "model quotient\nparam a\ndefault a = 0\nstate x\nstate v\neq x = v\neq v = -x\n"
                           "equilibria rest : x = 0, v = 0\ncharpoly rest = lambda^2 + 1 + a/(lambda + 1)\n";
    expect(quotient, "charpoly", "rest", TTC_REFUTED, "a = -1");
}

/* 1/x has its zero level at infinity; x/(1+y) keeps x = 0 although its cofactor has a denominator; y = 0 is left. */
static void an_invariant_has_a_cofactor_without_pole_on_its_level(void **state)
{
    (void)state;
    const char *table = "model cofactor\nstate x\nstate y\neq x = x/(1 + y)\neq y = y + x\n"
                        "invariant plane = x\ninvariant scaled = x/(1 + y)\ninvariant square = x^2\n"
                        "invariant left = y\ninvariant product = x*y\n";
    expect(table, "invariant", "plane", TTC_PROVED, NULL);
    expect(table, "invariant", "scaled", TTC_PROVED, NULL);
    expect(table, "invariant", "square", TTC_PROVED, NULL);
    expect(table, "invariant", "left", TTC_REFUTED, "= x");
    expect(table, "invariant", "product", TTC_REFUTED, NULL);
    expect("model pole\nstate x\nstate y\neq x = 1/x\neq y = y\ninvariant wall = x\n", "invariant", "wall", TTC_UNSETTLED,
           "denominator");
}

static void claims_that_say_nothing_are_errors(void **state)
{
    (void)state;
    const char *table = PLANE "integral constant = 3*a\ninvariant zero = x - x\nmeasure nothing = a - a\n"
                              "equilibria rest : x = 0, y = 0\nintegral H = x^2 + y^2\nleftnull rest : H\n"
                              "integral twice = 2*x^2 + 2*y^2\nequal on_both : x^2 + y^2 = 0 modulo H, twice\n";
    expect(table, "integral", "constant", TTC_UNSETTLED, "constant");
    expect(table, "invariant", "zero", TTC_UNSETTLED, "says nothing");
    expect(table, "measure", "nothing", TTC_UNSETTLED, "the density nothing is zero");
    expect("model part\nparam w\ndomain apart : w^2 > 0\nroot r = sqrt(w^2)\nstate x\neq x = 0*x\nmeasure half = r - w\n",
           "measure", "half", TTC_UNSETTLED, "the density half is zero on a whole part of the domain, as at w = 1");
    expect(table, "leftnull", "rest", TTC_UNSETTLED, "gradient");
    expect(table, "equal", "on_both", TTC_PROVED, "x = 0, y = 0");
}

/* x' = y, y' = x^2: y -> -y reverses, x -> -x does not; z -> -z alone must map the whole field. */
static void an_integral_that_is_constant_on_split_levels_is_proved_with_a_note(void **state)
{
    static const char table[] = "model m\nstate x\nstate y\nstate z\neq x = -y*z\neq y = x*z\neq z = 0\n"
                                "invariant circle = (x^2 + y^2 - 1)^2 + z^2\nintegral square = x^2 + y^2 modulo circle\n"
                                "integral place = x modulo circle\n";
    (void)state;
    expect(table, "integral", "square", TTC_PROVED, "constant on each part of its level, whatever the motion");
    expect(table, "integral", "place", TTC_PROVED, "x = 0"); /* moves with the state, and rests, as z = 0 */
}

static void a_reversor_must_hold_in_every_equation(void **state)
{
    (void)state;
    const char *head = "model reversed\nstate x\nstate y\nroot r = sqrt(1 + x^2)\neq x = y*r\neq y = x^2*r\n";
    char table[1024];
    snprintf(table, sizeof table, "%sreversor y -> -y\n", head);
    expect(table, "reversor", "reversor", TTC_PROVED, NULL);
    snprintf(table, sizeof table, "%sreversor x -> -x\n", head);
    expect(table, "reversor", "reversor", TTC_REFUTED, "f(Sx)");
}

/* r is odd-looking, but r(-x) = sqrt(1 + x) is another function: taking it for r would prove this reversor. */
static void a_reversor_maps_roots_by_their_radicands(void **state)
{
    (void)state;
    expect("model shifted\nstate x\nstate y\nroot r = sqrt(1 - x)\neq x = y\neq y = r\nreversor y -> -y\n", "reversor",
           "reversor", TTC_PROVED, NULL);
    expect("model shifted\nstate x\nstate y\nroot r = sqrt(1 - x)\neq x = r\neq y = y*x\nreversor x -> -x\n", "reversor",
           "reversor", TTC_REFUTED, NULL);
}

static void angles_obey_their_circle_and_nothing_else(void **state)
{
    (void)state;
    const char *table = "model pendulum\nparam k > 0\nstate q\nstate p\nangle c s = cos(q) sin(q)\neq q = p\neq p = -k*s\n"
                        "integral H = p^2/2 - k*c\nintegral wrong = p^2/2 + k*c\nequal circle : c^2 + s^2 = 1\n"
                        "equal not : c^2 - s^2 = 1\nreversor q -> -q\nequilibria down : q = 0, p = 0\n"
                        "charpoly down = lambda^2 + k\nmeasure volume = 1\n";
    expect(table, "integral", "H", TTC_PROVED, NULL);
    expect(table, "integral", "wrong", TTC_REFUTED, "p*s");
    expect(table, "equal", "circle", TTC_PROVED, NULL);
    expect(table, "equal", "not", TTC_REFUTED, NULL);
    expect(table, "reversor", "reversor", TTC_PROVED, NULL);
    expect(table, "equilibria", "down", TTC_PROVED, NULL);
    expect(table, "charpoly", "down", TTC_PROVED, NULL);
}

/* On cos(q) = 0 the sine is 1 or -1; with a cosine that is free there, its square would not be 1. */
static void a_sine_follows_its_cosine_onto_a_zero_level(void **state)
{
    (void)state;
    const char *table = "model pendulum\nstate q\nstate p\nangle c s = cos(q) sin(q)\neq q = 0\neq p = -s\ninvariant K = c\n"
                        "equal side : s^2 = 1 modulo K\nequal one_side : s = 1 modulo K\nequal nowhere : s = 2 modulo K\n";
    expect(table, "equal", "side", TTC_PROVED, NULL);
    expect(table, "equal", "one_side", TTC_REFUTED, "= -2");
    expect(table, "equal", "nowhere", TTC_REFUTED, NULL);
}

static void a_reduction_answers_for_every_state_and_root_of_its_target(void **state)
{
    (void)state;
    const char *head = "model double_sleigh\nparam m > 0\nparam I > 0\nparam a\nstate v\nstate w\nstate phase\n"
                       "eq v = a*w^2\neq w = -m*a*v*w/(I + m*a^2)\neq phase = w\n";
    static const struct {
        const char *with;
        ttc_proof_status status;
        const char *reason;
    } cases[] = {
        { "v = v, w = w", TTC_PROVED, NULL },
        { "v = v, w = -w", TTC_PROVED, NULL },
        { "v = w, w = v", TTC_REFUTED, "chain rule" },
        { "v = 2*v, w = 2*w", TTC_REFUTED, "chain rule" },
        { "v = v", TTC_UNSETTLED, "no image" },
        { "v = v, w = w, u = w", TTC_UNSETTLED, "names nothing" },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char table[1024];
        snprintf(table, sizeof table, "%sreduction forget : onto chaplygin_sleigh.tt with %s\n", head, cases[i].with);
        expect(table, "reduction", "forget", cases[i].status, cases[i].reason);
    }
    char table[1024];
    snprintf(table, sizeof table, "%sreduction forget : onto nowhere.tt with v = v\n", head);
    expect(table, "reduction", "forget", TTC_UNSETTLED, "could not be read");
}

static void variants_times_and_eliminations_are_held_to_the_field(void **state)
{
    (void)state;
    const char *table = "model derived\nparam a != 0\nparam c\nstate x\nstate y\nroot s = sqrt(1 + x^2)\neq x = y/c\neq y = -x/c\n"
                        "variant broken : c = 0\nvariant fine : c = 2\ntime backward : -s\ntime forward : s lifting s\n"
                        "integral L = a*x^2 + a*y^2\n";
    expect(table, "variant", "broken", TTC_UNSETTLED, "denominator");
    expect(table, "variant", "fine", TTC_PROVED, NULL);
    expect(table, "time", "backward", TTC_REFUTED, "dt/dtau");
    expect(table, "time", "forward", TTC_PROVED, NULL);
    const char *levels = "model levels\nparam k > 0\nstate x\nstate y\nstate z\neq x = y\neq y = -x\neq z = 2*x*y\n"
                         "integral P = k*z - k*x^2\nintegral false_P = k*z + k*x^2\n"
                         "eliminate good : z by P = level\neliminate bad : z by false_P = other_level\n";
    expect(levels, "eliminate", "good", TTC_PROVED, NULL);
    expect(levels, "eliminate", "bad", TTC_REFUTED, "rate of the solution");
}

static void append_factors(char *text, size_t size, const char *symbol, int count)
{
    for (int i = 1; i <= count; i++) {
        const size_t used = strlen(text);
        snprintf(text + used, size - used, "%s(%s - %d)", i > 1 ? "*" : "", symbol, i);
    }
}

/* A level of n linear factors in x, then one of m in y and perhaps z w - 1. One case for the start; on each of n two for its level
 * met and the next begun; on each of m two again, five for z w = 1, of which three find that z = 0 has no points:
 * 1 + n (2 + 2 m), or 1 + n (2 + 2 m + 5). */
static void expect_of_factors(int n, int m, const char *last, ttc_proof_status status, const char *reason)
{
    char table[2048] =
        "model many\nstate x\nstate y\nstate z\nstate w\neq x = 0*x\neq y = 0*y\neq z = 0*z\neq w = 0*w\ninvariant K = ";
    append_factors(table, sizeof table, "x", n);
    strcat(table, "\ninvariant L = ");
    append_factors(table, sizeof table, "y", m);
    strcat(table, last);
    strcat(table, "\nequal all : z = z modulo K, L\n");
    expect(table, "equal", "all", status, reason);
}

/* 1 + 7 (2 + 2*33 + 5) = 512 and 1 + 16 (2 + 2*15) = 513. */
static void a_claim_may_fall_into_512_cases_and_no_more(void **state)
{
    (void)state;
    expect_of_factors(7, 33, "*(z*w - 1)", TTC_PROVED, NULL);
    expect_of_factors(16, 15, "", TTC_UNSETTLED, "more than 512 cases");
}

static void a_bound_that_is_passed_is_named(void **state)
{
    (void)state;
    char nested[8192], roots[4096] = "model roots\nstate x\neq x = 1\n", sum[1024] = "";
    for (int i = 0; i < 33; i++) {
        if (i == 17)
            snprintf(nested, sizeof nested, "%sroot q = sqrt(r0 + r1)\npositive all : 1 - 5*x%s + q*r16\n", roots, sum);
        const size_t used = strlen(roots), added = strlen(sum);
        snprintf(roots + used, sizeof roots - used, "root r%d = sqrt(%d + x^2)\n", i, i + 2);
        snprintf(sum + added, sizeof sum - added, " + r%d", i);
    }
    const size_t used = strlen(roots);
    snprintf(roots + used, sizeof roots - used, "positive all : 1 - 5*x%s\n", sum);
    expect(roots, "positive", "all", TTC_UNSETTLED, "the limit of 32 roots");
    expect(nested, "positive", "all", TTC_UNSETTLED, "or of 16 with nested roots");
    expect("model multiples\nstate x\nexp e = exp(x)\nexp f = exp(65*x)\neq x = 1\nequal power : f = e^64*e\n", "equal", "power",
           TTC_UNSETTLED, "the limit of 64 multiples");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_denominator_that_vanishes_under_when_is_an_error),
        cmocka_unit_test(a_denominator_that_vanishes_on_the_zero_level_is_an_error),
        cmocka_unit_test(every_factor_of_a_zero_level_counts),
        cmocka_unit_test(a_component_on_which_the_solved_form_degenerates_is_not_overlooked),
        cmocka_unit_test(a_component_of_a_level_over_a_quadratic_is_not_overlooked),
        cmocka_unit_test(a_zero_level_that_is_empty_proves_nothing),
        cmocka_unit_test(a_root_whose_radicand_becomes_a_square_has_the_positive_sign),
        cmocka_unit_test(dependent_roots_are_not_taken_for_independent),
        cmocka_unit_test(nested_roots_are_recognized_exactly),
        cmocka_unit_test(a_root_that_vanishes_or_is_imaginary_is_an_error),
        cmocka_unit_test(conditions_outside_the_domain_are_errors),
        cmocka_unit_test(an_obstruction_needs_equilibria_in_the_domain_and_a_trace_that_is_not_zero),
        cmocka_unit_test(a_trace_that_is_zero_only_modulo_the_root_obstructs_nothing),
        cmocka_unit_test(a_characteristic_polynomial_is_fixed_up_to_a_factor_free_of_lambda),
        cmocka_unit_test(an_invariant_has_a_cofactor_without_pole_on_its_level),
        cmocka_unit_test(claims_that_say_nothing_are_errors),
        cmocka_unit_test(an_integral_that_is_constant_on_split_levels_is_proved_with_a_note),
        cmocka_unit_test(a_reversor_must_hold_in_every_equation),
        cmocka_unit_test(a_reversor_maps_roots_by_their_radicands),
        cmocka_unit_test(angles_obey_their_circle_and_nothing_else),
        cmocka_unit_test(a_sine_follows_its_cosine_onto_a_zero_level),
        cmocka_unit_test(a_reduction_answers_for_every_state_and_root_of_its_target),
        cmocka_unit_test(variants_times_and_eliminations_are_held_to_the_field),
        cmocka_unit_test(a_claim_may_fall_into_512_cases_and_no_more),
        cmocka_unit_test(a_bound_that_is_passed_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
