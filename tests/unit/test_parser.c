/* Each rule of the grammar, by what the model then holds; expressions by the text of their node. */
#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/sha256.h"
#include "parsed_model.h"

static const ttc_claim *claim(const ttc_model *model, const char *name)
{
    uint32_t found;
    assert_true(ttc_model_find_claim(model, name, &found));
    return model->claims + found;
}

/* `let e = SOURCE` over a, b (parameters) and x, y (states) */
static void reads(const char *source, const char *expected)
{
    char text[4096];
    snprintf(text, sizeof text, "model t\nparam a\nparam b\nstate x\nstate y\neq x = a\neq y = b\nlet e = %s\n", source);
    ttc_model *model = parse(text);
    prints(model, model->symbols[symbol(model, "e")].definition, expected);

    /* what is printed is read as the same node */
    char again[8192];
    snprintf(again, sizeof again, "%slet f = %s\n", text, expected);
    ttc_model *twin = parse(again);
    assert_int_equal(twin->symbols[symbol(twin, "e")].definition, twin->symbols[symbol(twin, "f")].definition);
    ttc_model_destroy(twin);
    ttc_model_destroy(model);
}

static void numbers_are_exact(void **unused)
{
    (void)unused;
    reads("2", "2");
    reads("0.51", "51/100");
    reads("1/3", "1/3");
    reads("1e-3", "1/1000");
    reads("2.5E+2", "250");
    reads("0.10", "1/10");
    reads("1/3 + 1/6", "1/2");
    reads("000", "0");
    reads("0.1 + 0.2 - 0.3", "0");
    reads("1e3*1e-3", "1");
    reads("-2/4", "-1/2");
}

static void operators_bind_as_in_the_grammar(void **unused)
{
    (void)unused;
    reads("a + b*x^2", "a + b*x^2");
    reads("-x^2", "-x^2");
    reads("(-x)^2", "x^2");
    reads("-2*x + 3", "-2*x + 3");
    reads("a/b/x", "a/(b*x)");
    reads("a/b*x", "a*x/b");
    reads("a - b - x", "a - b - x");
    reads("a - (b - x)", "a - b + x");
    reads("2^3*a", "8*a");
    reads("a^-2", "1/a^2");
    reads("a^(-2)", "1/a^2");
    reads("a^+2", "a^2");
    reads("a^0", "1");
    reads("2*(a + b)*3", "6*a + 6*b");
    reads("(a + b)^2/(a + b)", "a + b");
    reads("x*(a + b)/(2*y)", "x*(a + b)/(2*y)");
    reads("a*b - b*a", "0");
    reads("+ a", "a");
    reads("x^64", "x^64");
    reads("(((((x)))))", "x");
    reads("1/(a - b) + 1/(b - a)", "0");
    for (const char *const *line = (const char *const[]){ "let e = 2*(3 a)", "let e = (a + 1)(a - 1)", "let e = a^2 3", NULL };
         *line != NULL; line++)
        refuses("model t\nparam a\nstate x\neq x = a\n", *line, "(expected an operator before it, such as *, or");
}

static void records_may_be_indented_and_continued(void **unused)
{
    (void)unused;
    ttc_model *model = parse("# a comment first\n\n  model t   # comment\n\tparam a # [kg]\n"
                             "state x\n\neq x =\n    + a\n\n    # between terms\n    - a*\n      x\nintegral E = x\n when\n  a\n  "
                             "=\n  0\n");
    assert_string_equal(model->name, "t");
    assert_int_equal(model->equations[0].term_count, 2);
    prints(model, model->equations[0].terms[0].expression, "a");
    prints(model, model->equations[0].terms[1].expression, "-a*x");
    prints(model, model->equations[0].sum, "a - a*x");
    assert_int_equal(model->equations[0].terms[1].place.line, 11);
    assert_int_equal(model->equations[0].terms[1].place.column, 5);
    assert_int_equal(model->claims[0].when.count, 1);
    ttc_model_destroy(model);
}

static void quantities_keep_what_their_records_say(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\ntitle \"A\" \"B\"\nsource \"C*/D\"\n"
                             "param p > 0 [m/s^2] \"meaning\"\nparam q >= 0\nparam r != 0 \"only\"\nparam n\n"
                             "state x in (-1, q/2) [1]\nstate y in (0, inf)\nstate z in (-inf, +inf)\n"
                             "root s = sqrt(1 - x^2)\nangle c d = cos(2*y) sin(y*2)\nlet l = s*c\n"
                             "eq y = l + d\neq x = p\neq z = r*n\ndefault p = 2/5, q = 0\n");
    assert_string_equal(model->title, "A B");
    assert_string_equal(model->source, "C*/D");
    const ttc_symbol_entry *p = model->symbols + symbol(model, "p");
    assert_int_equal(p->kind, TTC_PARAM);
    assert_int_equal(p->sign, TTC_POSITIVE);
    assert_string_equal(p->unit, "m/s^2");
    assert_string_equal(p->meaning, "meaning");
    prints(model, p->value, "2/5");
    assert_int_equal(model->symbols[symbol(model, "q")].sign, TTC_NONNEGATIVE);
    assert_int_equal(model->symbols[symbol(model, "r")].sign, TTC_NONZERO);
    assert_null(model->symbols[symbol(model, "r")].unit);
    assert_int_equal(model->symbols[symbol(model, "n")].sign, TTC_ANY_SIGN);
    assert_int_equal(model->symbols[symbol(model, "n")].value, TTC_NONE);
    assert_int_equal(model->param_count, 4);
    assert_int_equal(model->state_count, 3);
    const ttc_symbol_entry *x = model->symbols + symbol(model, "x"), *y = model->symbols + symbol(model, "y");
    prints(model, x->low, "-1");
    prints(model, x->high, "q/2");
    prints(model, y->low, "0");
    assert_int_equal(y->high, TTC_NONE);
    assert_int_equal(model->symbols[symbol(model, "z")].low, TTC_NONE);
    prints(model, model->symbols[symbol(model, "s")].definition, "-x^2 + 1");
    assert_int_equal(model->symbols[symbol(model, "c")].partner, symbol(model, "d"));
    assert_int_equal(model->symbols[symbol(model, "d")].kind, TTC_SINE);
    prints(model, model->symbols[symbol(model, "d")].definition, "2*y");
    /* equations stand in the order of states */
    assert_int_equal(model->equation_count, 3);
    for (size_t i = 0; i < 3; i++) assert_int_equal(model->equations[i].state, model->states[i]);
    prints(model, ttc_model_field(model, 1), "d + l");
    ttc_model_destroy(model);
}

static void kernels_of_their_own(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nparam a\nparam b\nstate x\nstate y\nroot s = sqrt(1 + x^2)\nlet k = a*x\nlet q = k + y\n"
                             "eq x = s\neq y = q*b\n"
                             "variant one : a = 2*b\ntime slow : s lifting s\n"
                             "eliminate chart : y by E = level\nintegral E = k*q + b*x + k\n"
                             "eliminate again : y by E = level\nequal e : y = level\n");
    assert_int_equal(model->variant_count, 1);
    assert_int_equal(model->variants[0].bindings.items[0].symbol, symbol(model, "a"));
    prints(model, model->variants[0].bindings.items[0].expression, "2*b");
    prints(model, model->times[0].factor, "s");
    assert_int_equal(model->times[0].lifted[0], symbol(model, "s"));
    const ttc_elimination *chart = model->eliminations;
    assert_int_equal(chart->state, symbol(model, "y"));
    assert_string_equal(model->claims[chart->integral].name, "E");
    assert_int_equal(chart->level, symbol(model, "level"));
    assert_int_equal(model->eliminations[1].level, chart->level);
    assert_int_equal(model->symbols[chart->level].kind, TTC_LEVEL);
    prints(model, chart->solution, "-(k - level + b*x + k^2)/k"); /* lets without y stay; q = k + y is opened */
    ttc_model_destroy(model);
}

static void every_kind_of_claim(void **unused)
{
    (void)unused;
    ttc_model *model = parse(
        "model t\nparam a\nparam b\nstate x\nstate y\neq x = a*y\neq y = b*x\n"
        "integral E = x^2 when a = 0, y = x modulo K\ninvariant K = x - y\nmeasure rho = 1 modulo K\n"
        "reversor x -> -x, y -> -y\n"
        "equilibria f : x = 2*a, y = 0 when b = x\n"
        "  trace f = 0\n  charpoly f = lambda^2 - a*b\n  obstructs f\n  matrix f = 0, a;\n    b, 0\n  leftnull f : E, H\n"
        "integral H = b*x^2 - a*y^2\nequal same : E + K = rho\nrate growth : x + y = a*y when b = 0\n"
        "reduction r : onto other.tt with u = x/y, v = 2 when a = 1 modulo H, K\n"
        "reduction s : onto \"the-other.tt\" with u = x\n");
    const ttc_claim *e = claim(model, "E");
    assert_int_equal(e->kind, TTC_CLAIM_INTEGRAL);
    assert_int_equal(e->when.count, 2);
    assert_int_equal(e->when.items[1].symbol, symbol(model, "y"));
    assert_int_equal(e->modulo_count, 1);
    assert_string_equal(model->claims[e->modulo[0]].name, "K");
    assert_int_equal(claim(model, "K")->kind, TTC_CLAIM_INVARIANT);
    assert_int_equal(claim(model, "rho")->kind, TTC_CLAIM_MEASURE);

    const ttc_claim *reversor = claim(model, "reversor");
    assert_int_equal(reversor->bindings.count, 2);
    prints(model, reversor->bindings.items[0].expression, "-x");

    const ttc_claim *f = claim(model, "f");
    assert_int_equal(f->kind, TTC_CLAIM_EQUILIBRIA);
    assert_int_equal(f->bindings.count, 2);
    prints(model, f->bindings.items[0].expression, "2*a");
    prints(model, f->when.items[0].expression, "x");
    for (ttc_claim_kind kind = TTC_CLAIM_TRACE; kind <= TTC_CLAIM_LEFT_NULL; kind++) {
        const ttc_claim *about = f + 1 + (kind - TTC_CLAIM_TRACE);
        ttc_claim_kind order[] = { TTC_CLAIM_TRACE, TTC_CLAIM_CHARPOLY, TTC_CLAIM_OBSTRUCTS, TTC_CLAIM_MATRIX,
                                   TTC_CLAIM_LEFT_NULL };
        assert_int_equal(about->kind, order[kind - TTC_CLAIM_TRACE]);
        assert_ptr_equal(model->claims + about->family, f);
    }
    const ttc_claim *matrix = f + 4;
    assert_int_equal(matrix->entry_count, 4);
    prints(model, matrix->entries[1], "a");
    prints(model, matrix->entries[2], "b");
    assert_int_equal(f[5].member_count, 2);
    assert_string_equal(model->claims[f[5].members[1]].name, "H");
    assert_int_equal(model->symbols[0].kind, TTC_LAMBDA);
    assert_true(ttc_depends(model->graph, f[2].expression, 0));

    const ttc_claim *same = claim(model, "same"); /* a claim's name stands for its expression */
    prints(model, same->expression, "x - y + x^2");
    prints(model, same->other, "1");
    const ttc_claim *growth = claim(model, "growth");
    assert_int_equal(growth->kind, TTC_CLAIM_RATE);
    prints(model, growth->expression, "x + y");
    prints(model, growth->other, "a*y");
    assert_int_equal(growth->when.count, 1);
    const ttc_claim *r = claim(model, "r");
    assert_string_equal(r->target, "other.tt");
    assert_string_equal(r->target_names[1], "v");
    prints(model, r->bindings.items[0].expression, "x/y");
    assert_int_equal(r->modulo_count, 2);
    assert_string_equal(claim(model, "s")->target, "the-other.tt");
    ttc_model_destroy(model);
}

static void maps_send_all_states_at_once(void **unused)
{
    (void)unused;
    ttc_model *model = parse(
        "model t\nparam a\nstate x\nstate y\neq x = a*y\neq y = x\nreversor x -> y + a, y -> x - a when a = 0\n"
        "symmetry x -> -x, y -> -y\nsymmetry turn : x -> y,\n    y -> -x\n");
    const ttc_claim *turn = claim(model, "turn");
    prints(model, claim(model, "reversor")->bindings.items[0].expression, "a + y");
    assert_int_equal(claim(model, "reversor")->when.count, 1);
    assert_int_equal(claim(model, "symmetry")->kind, TTC_CLAIM_SYMMETRY);
    assert_int_equal(turn->kind, TTC_CLAIM_SYMMETRY);
    assert_int_equal(turn->bindings.count, 2);
    prints(model, turn->bindings.items[1].expression, "-x");
    assert_int_equal(turn->place.line, 9);
    ttc_model_destroy(model);
}

static void exponentials_logarithms_and_pi(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nstate x in (-pi, 2*pi)\nexp e = exp(-x^2/2)\nlog l = log(1 + e)\neq x = l*pi\n");
    const ttc_symbol_entry *e = model->symbols + symbol(model, "e"), *l = model->symbols + symbol(model, "l");
    assert_int_equal(e->kind, TTC_EXP);
    assert_int_equal(l->kind, TTC_LOG);
    assert_int_equal(model->symbols[symbol(model, "pi")].kind, TTC_PI);
    prints(model, model->symbols[symbol(model, "x")].high, "2*pi");
    prints(model, e->definition, "-x^2/2");
    prints(model, ttc_model_partial(model, e->node, symbol(model, "x")), "-x*e");
    prints(model, ttc_model_partial(model, l->node, symbol(model, "x")), "-x*e/(e + 1)");
    assert_int_equal(model->param_count, 0);
    ttc_model_destroy(model);
}

/* Tables written before these words had a meaning stay what they were. */
static void later_words_may_be_names_of_the_table(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nparam exp\nparam log > 0\nlet pi = exp + 2\nstate symmetry\n"
                             "eq symmetry = exp*log\n    + pi*symmetry\n    - exp\n    + log\nintegral S = symmetry - log\n"
                             "  when exp = 1,\n  log = 2\n");
    assert_int_equal(model->symbols[symbol(model, "exp")].kind, TTC_PARAM);
    assert_int_equal(model->symbols[symbol(model, "pi")].kind, TTC_LET);
    assert_int_equal(model->equations[0].term_count, 4);
    assert_int_equal(claim(model, "S")->when.count, 2);
    ttc_model_destroy(model);
}

static void lambda_may_be_a_name_of_the_table(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nparam lambda\nstate x\neq x = lambda*x\nequilibria f : x = 0\n  charpoly f = lambda - 1\n");
    uint32_t own = symbol(model, "lambda");
    assert_int_equal(model->symbols[own].kind, TTC_PARAM);
    assert_true(ttc_depends(model->graph, ttc_model_field(model, 0), own));
    assert_false(ttc_depends(model->graph, model->claims[1].expression, own));
    assert_true(ttc_depends(model->graph, model->claims[1].expression, 0));
    ttc_model_destroy(model);
}

static void words_of_later_records_remain_free_as_names(void **unused)
{
    (void)unused;
    ttc_model *model = parse("model t\nparam rate\nparam matrix\nparam with\nstate onto\nstate modulo\n"
                             "eq onto = with\n  + matrix\n  - \n  rate*modulo\n  - rate - matrix*2\neq modulo = rate\n"
                             "integral leftnull = onto when rate = 0 modulo reduction\ninvariant reduction = modulo - onto\n"
                             "rate speed : modulo = rate\nequilibria f : onto = 0\nmatrix f = 0, 0; 0, 0\n");
    prints(model, ttc_model_field(model, 0), "-rate - matrix + with - rate*modulo");
    ttc_model_destroy(model);
}

/* FIPS 180-4 examples, and a length on each side of the padding's edge. */
static void sha256_equals_published_digests(void **unused)
{
    (void)unused;
    char digest[65], text[120];
    ttc_sha256(digest, "", 0);
    assert_string_equal(digest, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    ttc_sha256(digest, "abc", 3);
    assert_string_equal(digest, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    ttc_sha256(digest, "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 56);
    assert_string_equal(digest, "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    memset(text, 'a', sizeof text);
    ttc_sha256(digest, text, 55);
    assert_string_equal(digest, "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
    ttc_sha256(digest, text, 64);
    assert_string_equal(digest, "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
}

static void a_model_read_from_a_file_is_that_of_its_text(void **unused)
{
    (void)unused;
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_read(JLT_SOURCE_DIR "/codegen/models/chaplygin_sleigh.tt", diagnostics);
    assert_non_null(model);
    assert_int_equal(ttc_warning_count(diagnostics), 0);
    assert_string_equal(model->name, "chaplygin_sleigh");
    char digest[65];
    ttc_sha256(digest, model->text, strlen(model->text));
    assert_string_equal(model->sha256, digest);
    uint32_t v = symbol(model, "v"), w = symbol(model, "w");
    prints(model, ttc_model_partial(model, ttc_model_field(model, 0), w), "2*a*w");
    prints(model, ttc_model_partial(model, ttc_model_field(model, 1), v), "-m*a*w/(I + m*a^2)");
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_are_exact),
        cmocka_unit_test(operators_bind_as_in_the_grammar),
        cmocka_unit_test(records_may_be_indented_and_continued),
        cmocka_unit_test(quantities_keep_what_their_records_say),
        cmocka_unit_test(kernels_of_their_own),
        cmocka_unit_test(every_kind_of_claim),
        cmocka_unit_test(lambda_may_be_a_name_of_the_table),
        cmocka_unit_test(maps_send_all_states_at_once),
        cmocka_unit_test(exponentials_logarithms_and_pi),
        cmocka_unit_test(later_words_may_be_names_of_the_table),
        cmocka_unit_test(words_of_later_records_remain_free_as_names),
        cmocka_unit_test(sha256_equals_published_digests),
        cmocka_unit_test(a_model_read_from_a_file_is_that_of_its_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
