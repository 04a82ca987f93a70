/* Checks a way to another table, at one point for which it is meant: it leads into the other's domain, and the record back gives
 * the point. The embedding of a smaller table must also move as the model says. */
#include "challenge/check.h"
#include "prove/way_table.h"

static const ttc_way *way_of(const ttc_check *check)
{
    size_t i = 0;
    while (check->model->claims + check->model->ways[i].claim != check->claim) i++;
    return check->model->ways + i;
}

static bool holds(ttc_check *check, const ttc_way *way)
{
    for (size_t i = 0; i < way->where.count; i++) {
        arb_srcptr value = ttc_probe_at(check->probe, way->where.items[i].expression);
        if (value == NULL || !arb_is_positive(value)) return false;
    }
    return true;
}

/* The states and roots that the record back gives at the image are those of the point. */
static void check_back(ttc_check *check, const ttc_claim *back)
{
    const ttc_model *model = check->model;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = model->symbols + i;
        const ttc_id given = ttc_given_for(back, entry->name);
        if (given != TTC_NONE && (entry->kind == TTC_STATE || entry->kind == TTC_ROOT))
            ttc_check_same(check, ttc_probe_at(check->target_probe, given), ttc_probe_at(check->probe, entry->node),
                           "where the way leads is elsewhere, in", entry->name);
    }
}

/* d(embedding)/dt along the smaller table's field is the model's field. */
static void check_motion(ttc_check *check, const ttc_claim *back)
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
        ttc_check_same(check, known ? rate : NULL, ttc_probe_at(check->probe, ttc_model_field(model, i)),
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

void ttc_check_way(ttc_check *check)
{
    char text[256];
    uint32_t back;
    const ttc_way *way = way_of(check);
    if (check->target == NULL || !ttc_way_fits(check->model, way, check->target, &back, text, sizeof text) ||
        !holds(check, way) || !ttc_check_set_image(check, &way->image)) {
        ttc_check_undefined(check);
        return;
    }
    switch (ttc_domain_locate_image(check->target_probe, check->target, text, sizeof text)) {
    case TTC_OUTSIDE: ttc_check_violate(check, "the way leaves the domain:", text); return;
    case TTC_UNCLEAR: ttc_check_undefined(check); return;
    case TTC_INSIDE: break;
    }
    if (check->claim->kind == TTC_CLAIM_LIFT) check_lifted(check, way, check->target->claims + back);
    check_back(check, check->target->claims + back);
    if (check->claim->kind == TTC_CLAIM_DESCENT) check_motion(check, check->target->claims + back);
}
