/* Checks a section and its coordinates at one state of the section, and at one point of its chart. The way back from the state
 * leads to a point of the chart. The lift of either point lies in the section, the domain and the levels, and leads back to the
 * point; that of the first is the state itself where both cross in the same direction. */
#include "challenge/check.h"
#include "prove/section_chart.h"

typedef struct {
    ttc_check *check;
    const ttc_section *section;
    ttc_probe *lifted; /* a probe of the model, at the lift */
    long precision;
} section_check;

/* The value of a parameter of the chart. */
static arb_srcptr param_of(const section_check *s, const char *name)
{
    return ttc_probe_value(s->check->target_probe, ttc_param_of(s->check->target, name));
}

/* Set s->lifted to the lift of the chart's point. Returns false if that has no value. */
static bool set_lifted(section_check *s)
{
    const ttc_model *model = s->check->model;
    ttc_probe_begin(s->lifted, s->precision);
    for (size_t i = 0; i < model->param_count; i++)
        ttc_probe_set(s->lifted, model->params[i], param_of(s, model->symbols[model->params[i]].name));
    for (size_t i = 0; i < model->state_count; i++) {
        const ttc_id lift = ttc_chart_lift(s->check->target, model->symbols[model->states[i]].name);
        arb_srcptr value = ttc_probe_at(s->check->target_probe, lift);
        if (value == NULL) return false;
        ttc_probe_set(s->lifted, model->states[i], value);
    }
    return true;
}

/* The lift lies on the section and the levels, and lifted roots are roots there. */
static void check_lift(section_check *s)
{
    const ttc_model *model = s->check->model;
    const ttc_claim *claim = s->check->claim;
    const ttc_binding *at = claim->when.items;
    ttc_check_same(s->check, ttc_probe_value(s->lifted, at->symbol), ttc_probe_at(s->lifted, at->expression),
                   "off the section by its lift:",
               model->symbols[at->symbol].name);
    for (size_t i = 0; i < claim->member_count; i++) {
        const ttc_claim *integral = model->claims + claim->members[i];
        ttc_check_same(s->check, ttc_probe_at(s->lifted, integral->expression), param_of(s, s->section->image.levels[i]),
                       "off its level by its lift:", integral->name);
    }
    for (size_t i = 0; i < model->symbol_count; i++) {
        const ttc_id lift = model->symbols[i].kind == TTC_ROOT ? ttc_chart_lift(s->check->target, model->symbols[i].name)
                                                               : TTC_NONE;
        if (lift != TTC_NONE)
            ttc_check_same(s->check, ttc_probe_at(s->check->target_probe, lift),
                           ttc_probe_at(s->lifted, model->symbols[i].node),
                       "lifted root - root of the lift:", model->symbols[i].name);
    }
}

/* The sign of the rate of the section's state; 0 if not known, or zero. */
static int direction(const section_check *s, ttc_probe *probe)
{
    const ttc_model *model = s->check->model;
    size_t i = 0;
    while (model->states[i] != s->check->claim->when.items[0].symbol) i++;
    arb_srcptr rate = ttc_probe_at(probe, ttc_model_field(model, i));
    return rate == NULL ? 0 : arb_is_positive(rate) ? 1 : arb_is_negative(rate) ? -1 : 0;
}

/* Nothing is zero, at a probe of the model, that the way back or a level divides by. */
static void check_divisors(section_check *s, ttc_probe *probe, const char *what)
{
    const ttc_model *model = s->check->model;
    ttc_check_divides(s->check, probe, model, TTC_DIVIDES_CLAIM, s->section->claim, s->section->shown_uses, what,
                      "the way back");
    for (size_t i = 0; i < s->check->claim->member_count; i++)
        ttc_check_divides(s->check, probe, model, TTC_DIVIDES_CLAIM, s->check->claim->members[i], SIZE_MAX, what,
                          model->claims[s->check->claim->members[i]].name);
}

/* At the chart's point. */
static void check_chart(section_check *s)
{
    char fault[256];
    ttc_check_divides(s->check, s->check->target_probe, s->check->target, TTC_DIVIDES_LIFT, 0, SIZE_MAX,
                      "a denominator is zero in", "the lift");
    if (!set_lifted(s)) {
        ttc_check_undefined(s->check);
        return;
    }
    if (ttc_domain_locate_image(s->lifted, s->check->model, fault, sizeof fault) == TTC_OUTSIDE)
        ttc_check_violate(s->check, "the lift leaves the domain:", fault);
    check_divisors(s, s->lifted, "a denominator is zero at the lift in");
    check_lift(s);
    for (size_t i = 0; i < s->check->target->state_count; i++) ttc_check_return(s->check, s->lifted, &s->section->image, i, false);
}

static void check_state(section_check *s)
{
    const ttc_model *model = s->check->model;
    char fault[256];
    const int crossing = direction(s, s->check->probe);
    if (crossing != 0) check_divisors(s, s->check->probe, "a denominator is zero where the section is crossed, in");
    if (crossing == 0 || !ttc_check_set_image(s->check, &s->section->image)) {
        ttc_check_undefined(s->check);
        return;
    }
    const ttc_place_in_domain place = ttc_domain_locate_image(s->check->target_probe, s->check->target, fault, sizeof fault);
    if (place == TTC_OUTSIDE) ttc_check_violate(s->check, "a crossing outside of the coordinates:", fault);
    else if (place == TTC_UNCLEAR) ttc_check_undefined(s->check);
    if (s->check->outcome != TTC_HOLDS) return;
    check_chart(s);
    for (size_t i = 0; i < model->state_count && direction(s, s->lifted) == crossing; i++)
        ttc_check_same(s->check, ttc_probe_value(s->lifted, model->states[i]),
                       ttc_probe_value(s->check->probe, model->states[i]),
                       "the lift of where the way back leads is another state in", model->symbols[model->states[i]].name);
}

void ttc_check_section(ttc_check *check)
{
    char reason[8];
    section_check s = { .check = check, .section = ttc_section_of(check->model, check->claim),
                        .precision = ttc_probe_precision(check->probe) };
    if (check->target != NULL && ttc_section_fits(check->model, s.section, check->target, reason, sizeof reason))
        s.lifted = ttc_probe_create(check->model);
    if (s.lifted == NULL) ttc_check_undefined(check);
    else check_state(&s);
    if (check->outcome == TTC_HOLDS && ttc_check_draw_target(check)) check_chart(&s);
    ttc_probe_destroy(s.lifted);
}
