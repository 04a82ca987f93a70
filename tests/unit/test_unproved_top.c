/* What src/top knows of the paper's tables rests on claims that they make, all of which are proved: here the library is told that
 * one of them is not, and must refuse. */
#include "unit/check.h"

#include "kernel/descriptor.h"
#include "kernel/way.h"
#include "top/balanced_form.h"
#include "top/rod.h"

typedef struct {
    const char *kind, *name;
} claim_name;

static claim_name refuted;
static const char *led_to; /* the table that no way is proved to lead to */
static const char *other;  /* the integral that is another one: the tables have other equations, of which all is proved */
static bool turns_faster;  /* the rate of v_nu is another one */
static bool only_apart;    /* the integral and the rate are other ones only where omega_n and omega3 differ */

const jlt_claim *__real_jlt_descriptor_claim(const jlt_descriptor *of, const char *kind, const char *name);
const jlt_claim *__wrap_jlt_descriptor_claim(const jlt_descriptor *of, const char *kind, const char *name);
bool __real_jlt_way_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_way *way, const jlt_descriptor *target);
bool __wrap_jlt_way_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_way *way, const jlt_descriptor *target);

const jlt_claim *__wrap_jlt_descriptor_claim(const jlt_descriptor *of, const char *kind, const char *name)
{
    static jlt_claim altered;
    const jlt_claim *claim = __real_jlt_descriptor_claim(of, kind, name);

    if (claim == NULL || refuted.kind == NULL || strcmp(kind, refuted.kind) != 0 || strcmp(name, refuted.name) != 0) return claim;
    altered = *claim;
    altered.verdict = JLT_REFUTED;
    return &altered;
}

bool __wrap_jlt_way_holds(const jlt_claim **broken, const jlt_descriptor *from, const jlt_way *way, const jlt_descriptor *target)
{
    static const jlt_claim altered = { .kind = "reduction", .name = "sample", .verdict = JLT_REFUTED };

    if (led_to == NULL || strcmp(way->model, led_to) != 0) return __real_jlt_way_holds(broken, from, way, target);
    *broken = &altered;
    return false;
}

double __real_jlt_top_integral(const jlt_top *top, const char *variant, const char *name, const double *x);
double __wrap_jlt_top_integral(const jlt_top *top, const char *variant, const char *name, const double *x);
bool __real_jlt_top_rates(const jlt_top *top, const char *variant, double *rates, const double *x);
bool __wrap_jlt_top_rates(const jlt_top *top, const char *variant, double *rates, const double *x);

static double apart(const double *x) { return x[JLT_TOP_OMEGA_TAU] * (x[JLT_TOP_OMEGA_N] - x[JLT_TOP_OMEGA3]); }

/* Another one has a spring in gamma3 as well; a rotor on the axis adds such a term to G. */
double __wrap_jlt_top_integral(const jlt_top *top, const char *variant, const char *name, const double *x)
{
    const double value = __real_jlt_top_integral(top, variant, name, x), gamma3 = x[JLT_TOP_GAMMA3];

    return other != NULL && strcmp(name, other) == 0 ? value + (only_apart ? apart(x) : gamma3 * gamma3) / 8 : value;
}

bool __wrap_jlt_top_rates(const jlt_top *top, const char *variant, double *rates, const double *x)
{
    const bool found = __real_jlt_top_rates(top, variant, rates, x);

    if (turns_faster) rates[JLT_TOP_V_NU] += only_apart ? apart(x) / 8 : rates[JLT_TOP_V_NU] / 16;
    return found;
}

/* Why quadratures refuse the paper's rod, I3 = 0; NULL: they serve. */
static const char *rod_refuses(const jlt_claim **broken)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    double params[JLT_WAY_VALUES_MAX];
    size_t axial;

    assert_non_null(model);
    for (unsigned i = 0; i < model->param_count; i++) params[i] = 1;
    assert_true(jlt_descriptor_param(model, "I3", &axial));
    params[axial] = 0;
    return jlt_rod_refuses(broken, model, params, NULL);
}

static void all_serve_where_claims_are_proved(void **unused)
{
    const jlt_claim *broken;

    (void)unused;
    refuted = (claim_name){ NULL, NULL };
    led_to = NULL;
    assert_null(rod_refuses(&broken));
    assert_true(jlt_balanced_serves(&broken));
    assert_null(broken);
}

static void quadratures_need_their_integrals_and_the_level(void **unused)
{
    static const char *const names[] = { "E1", "E2", "G" };
    const jlt_claim *broken;

    (void)unused;
    led_to = NULL;
    for (unsigned i = 0; i < 3; i++) {
        refuted = (claim_name){ "integral", names[i] };
        assert_non_null(rod_refuses(&broken));
        assert_non_null(broken);
        assert_string_equal(broken->name, names[i]);
    }
    refuted = (claim_name){ NULL, NULL };
    led_to = "spherical_top_level";
    assert_non_null(rod_refuses(&broken));
    assert_non_null(broken);
    assert_string_equal(broken->kind, "reduction");
}

static void quadratures_need_the_equations_that_they_solve(void **unused)
{
    static const char *const names[] = { "E1", "E2", "G" };
    const jlt_claim *broken;

    (void)unused;
    refuted = (claim_name){ NULL, NULL };
    led_to = NULL;
    for (unsigned where = 0; where < 2; where++) {
        only_apart = where == 1;
        for (unsigned i = 0; i < 3; i++) {
            other = names[i];
            assert_non_null(rod_refuses(&broken));
            assert_null(broken);
        }
        other = NULL;
        turns_faster = true;
        assert_non_null(rod_refuses(&broken));
        assert_null(broken);
        turns_faster = false;
    }
    only_apart = false;
}

static void the_surface_needs_integrals_reductions_and_its_fixed_points(void **unused)
{
    static const claim_name needed[] = { { "integral", "E" }, { "integral", "G" }, { "integral", "F0" }, { "trace", "spin" },
                                         { "charpoly", "spin" } };
    static const char *const tables[] = { "spherical_top_balanced", "spherical_top_plane" };
    const jlt_claim *broken;

    (void)unused;
    led_to = NULL;
    for (unsigned i = 0; i < sizeof needed / sizeof *needed; i++) {
        refuted = needed[i];
        assert_false(jlt_balanced_serves(&broken));
        assert_non_null(broken);
        assert_string_equal(broken->kind, needed[i].kind);
        assert_string_equal(broken->name, needed[i].name);
    }
    refuted = (claim_name){ NULL, NULL };
    for (unsigned i = 0; i < 2; i++) {
        led_to = tables[i];
        assert_false(jlt_balanced_serves(&broken));
        assert_non_null(broken);
        assert_string_equal(broken->kind, "reduction");
    }
}

static void the_surface_needs_the_relations_between_its_levels(void **unused)
{
    static const char *const names[] = { "E", "F0" };
    const jlt_top top = { .m = 1, .R = 1, .g = 1, .I1 = 2. / 5, .I3 = 1. / 4 };

    (void)unused;
    assert_true(jlt_balanced_form_holds(&top));
    for (unsigned i = 0; i < 4; i++) {
        other = names[i % 2];
        only_apart = i >= 2;
        assert_false(jlt_balanced_form_holds(&top));
    }
    other = NULL;
    only_apart = false;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_serve_where_claims_are_proved),
        cmocka_unit_test(quadratures_need_their_integrals_and_the_level),
        cmocka_unit_test(quadratures_need_the_equations_that_they_solve),
        cmocka_unit_test(the_surface_needs_integrals_reductions_and_its_fixed_points),
        cmocka_unit_test(the_surface_needs_the_relations_between_its_levels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
