/* Checks a way to another table, at one point for which it is meant: it leads into the other's domain, and the record back gives
 * the point. The embedding of a smaller table must also move as the model says, there and at a point of that table's domain, to
 * which the way leads back. */
#include "challenge/check.h"
#include "prove/way_table.h"

#include <string.h>

/* Whether `where` holds, which it does not where the claim divides by zero, whatever cancels. */
static bool holds(const ttc_check *check, ttc_probe *probe, const ttc_way *way)
{
    if (way->where.count > 0 && ttc_domain_divides_by_zero(probe, check->model, TTC_DIVIDES_CLAIM, way->claim, SIZE_MAX))
        return false;
    for (size_t i = 0; i < way->where.count; i++) {
        arb_srcptr value = ttc_probe_at(probe, way->where.items[i].expression);
        if (value == NULL || !arb_is_positive(value)) return false;
    }
    return true;
}

/* The states and roots that the record back gives at the image are those of the point. */
static void check_back(ttc_check *check, ttc_probe *point, const ttc_claim *back)
{
    const ttc_model *model = check->model;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const ttc_id given = ttc_given_for(back, entry->name);
        if (given != TTC_NONE && (entry->kind == TTC_STATE || entry->kind == TTC_ROOT))
            ttc_check_same(check, ttc_probe_at(check->target_probe, given), ttc_probe_at(point, entry->node),
                           "where the way leads is elsewhere, in", entry->name);
    }
}

/* d(embedding)/dt along the smaller table's field is the model's field. */
static void check_motion(ttc_check *check, ttc_probe *point, const ttc_claim *back)
{
    const ttc_model *model = check->model, *target = check->target;
    arb_t rate;
    arb_init(rate);
    ttc_probe_seed_states(check->target_probe);
    for (size_t i = 0; i < model->state_count; i++) {
        const char *name = model->symbols[model->states[i]].name;
        arb_srcptr jet = ttc_probe_at(check->target_probe, ttc_given_for(back, name)), speed = NULL;
        bool known = jet != NULL;
        arb_zero(rate);
        for (size_t k = 0; known && k < target->state_count; k++) {
            if (arb_is_zero(jet + 1 + k)) continue;
            speed = ttc_probe_at(check->target_probe, ttc_model_field(target, k));
            known = speed != NULL;
            if (known) arb_addmul(rate, jet + 1 + k, speed, ttc_probe_precision(check->probe));
        }
        ttc_check_same(check, known ? rate : NULL, ttc_probe_at(point, ttc_model_field(model, i)),
                       "the embedding does not move as the model says, in", name);
    }
    arb_clear(rate);
}

/* The image lies on the zero levels of the reduction back, and given roots are the other table's. */
static void check_lifted(ttc_check *check, const ttc_way *way, const ttc_claim *back)
{
    const ttc_model *target = check->target;
    ttc_check_divides(check, check->target_probe, target, TTC_DIVIDES_CLAIM, (uint32_t)(back - target->claims), SIZE_MAX,
                      "a denominator is zero at the lift in", back->name);
    for (size_t i = 0; i < back->modulo_count; i++) {
        const ttc_claim *level = target->claims + back->modulo[i];
        ttc_check_divides(check, check->target_probe, target, TTC_DIVIDES_CLAIM, back->modulo[i], SIZE_MAX,
                          "a denominator is zero at the lift in", level->name);
        arb_srcptr value = ttc_probe_at(check->target_probe, level->expression);
        if (value == NULL) ttc_check_undefined(check);
        else ttc_check_zero(check, value, "the lift is off the zero level of", level->name);
    }
    for (size_t k = 0; k < way->image.count; k++) {
        uint32_t root;
        if (!ttc_model_find_symbol(target, way->image.names[k], &root) || target->symbols[root].kind != TTC_ROOT) continue;
        ttc_check_same(check, ttc_probe_at(check->probe, check->claim->entries[2 * k]),
                       ttc_probe_at(check->target_probe, target->symbols[root].node), "lifted root - root of the lift:",
                       target->symbols[root].name);
    }
}

static bool is_given(const ttc_image *image, const char *name)
{
    bool given = ttc_image_name(image, name) < image->count;
    for (size_t i = 0; i < image->level_count; i++) given = given || strcmp(image->levels[i], name) == 0;
    return given;
}

/* A parameter of the model at a point of the smaller table. One that this does not determine may have any value: that of the point
 * here. */
static arb_srcptr embedded_param(ttc_check *check, const ttc_way *way, const ttc_claim *back, uint32_t param)
{
    const char *name = check->model->symbols[param].name;
    const ttc_id given = ttc_given_for(back, name);
    const uint32_t named = ttc_param_of(check->target, name);
    const bool is_shared = named != UINT32_MAX && !is_given(&way->image, name);
    if (is_shared || (named != UINT32_MAX && given == TTC_NONE)) return ttc_probe_value(check->target_probe, named);
    if (given != TTC_NONE && ttc_kind_of(check->target->graph, given) != TTC_NUMBER)
        return ttc_probe_at(check->target_probe, given);
    return ttc_probe_value(check->probe, param);
}

/* Move a probe of the model to what is embedded from the target's point. Returns false if something has no value. */
static bool embed(ttc_check *check, const ttc_way *way, const ttc_claim *back, ttc_probe *embedded)
{
    const ttc_model *model = check->model;
    ttc_probe_begin(embedded, ttc_probe_precision(check->probe));
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_kind kind = model->symbols[i].kind;
        if (kind != TTC_PARAM && kind != TTC_STATE) continue;
        arb_srcptr value = kind == TTC_PARAM ? embedded_param(check, way, back, i)
                                             : ttc_probe_at(check->target_probe, ttc_given_for(back, model->symbols[i].name));
        if (value == NULL) return false;
        ttc_probe_set(embedded, i, value);
    }
    return true;
}

/* From the embedded point the way leads back to states and parameters. */
static void check_returned(ttc_check *check, const ttc_way *way, ttc_probe *embedded)
{
    const ttc_model *model = check->model, *target = check->target;
    arb_t own;
    arb_init(own);
    if (way->where.count == 0)
        ttc_check_divides(check, embedded, model, TTC_DIVIDES_CLAIM, way->claim, SIZE_MAX,
                          "a denominator is zero at an embedded point in", check->claim->name);
    for (size_t i = 0; i < way->image.level_count; i++)
        ttc_check_divides(check, embedded, model, TTC_DIVIDES_CLAIM, check->claim->members[i], SIZE_MAX,
                          "a denominator is zero at an embedded point in", model->claims[check->claim->members[i]].name);
    for (size_t i = 0; i < target->state_count; i++) ttc_check_return(check, embedded, &way->image, i, true);
    for (size_t i = 0; i < target->param_count; i++) {
        bool is_root;
        const ttc_id id = ttc_image_param(model, check->claim, &way->image, target, i, &is_root);
        arb_set(own, ttc_probe_value(check->target_probe, target->params[i]));
        if (is_root) arb_mul(own, own, own, ttc_probe_precision(check->probe));
        ttc_check_same(check, ttc_probe_at(embedded, id), own, "the way back leads elsewhere in",
                       target->symbols[target->params[i]].name);
    }
    arb_clear(own);
}

/* At a random point of the smaller table. What has no value, or is not told, says nothing of the point here. */
static void check_table(ttc_check *check, const ttc_way *way, const ttc_claim *back)
{
    char fault[256];
    ttc_probe *embedded = ttc_probe_create(check->model);
    if (embedded != NULL && ttc_check_draw_target(check)) {
        ttc_check_divides(check, check->target_probe, check->target, TTC_DIVIDES_CLAIM, (uint32_t)(back - check->target->claims),
                          SIZE_MAX, "a denominator is zero in", back->name);
        if (embed(check, way, back, embedded)) {
            if (ttc_domain_locate_image(embedded, check->model, fault, sizeof fault) == TTC_OUTSIDE)
                ttc_check_violate(check, "the embedding leaves the domain:", fault);
            check_back(check, embedded, back);
            check_motion(check, embedded, back);
            ttc_check_observations(check, embedded);
            if (holds(check, embedded, way)) check_returned(check, way, embedded);
        }
        if (check->outcome != TTC_VIOLATED) check->outcome = TTC_HOLDS;
    }
    ttc_probe_destroy(embedded);
}

void ttc_check_way(ttc_check *check)
{
    char text[256];
    uint32_t back;
    const ttc_way *way = ttc_way_of(check->model, check->claim);
    if (check->target == NULL || !ttc_way_fits(check->model, way, check->target, &back, text, sizeof text) ||
        !holds(check, check->probe, way) || !ttc_check_set_image(check, &way->image)) {
        ttc_check_undefined(check);
        return;
    }
    switch (ttc_domain_locate_image(check->target_probe, check->target, text, sizeof text)) {
    case TTC_OUTSIDE: ttc_check_violate(check, "the way leaves the domain:", text); return;
    case TTC_UNCLEAR: ttc_check_undefined(check); return;
    case TTC_INSIDE: break;
    }
    if (check->claim->kind == TTC_CLAIM_LIFT) check_lifted(check, way, check->target->claims + back);
    check_back(check, check->probe, check->target->claims + back);
    if (check->claim->kind != TTC_CLAIM_DESCENT) return;
    check_motion(check, check->probe, check->target->claims + back);
    if (check->outcome == TTC_HOLDS && check->claim->when.count == 0) check_table(check, way, check->target->claims + back);
}
