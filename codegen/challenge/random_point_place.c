/* Places a random point: sets its numbers, meets its levels, locates it in the domain. */
#include "challenge/random_point.h"

/* Returns true if no factor of a divisor can be zero. The root in question counts as its radicand; other factors without a value,
 * which need that root, count as nonzero. */
static bool is_not_zero(ttc_probe *probe, const ttc_situation *situation, ttc_id id)
{
    const ttc_graph *graph = situation->model->graph;
    const ttc_kind kind = ttc_kind_of(graph, id);
    for (size_t i = 0; kind == TTC_PRODUCT && i < ttc_part_count(graph, id); i++)
        if (!is_not_zero(probe, situation, ttc_part_at(graph, id, i).id)) return false;
    if (kind == TTC_PRODUCT) return true;
    if (kind == TTC_SYMBOL && ttc_symbol_of(graph, id) == situation->own_root)
        id = situation->model->symbols[situation->own_root].definition;
    arb_srcptr value = ttc_probe_at(probe, id);
    return value == NULL ? situation->own_root != UINT32_MAX : !arb_contains_zero(value);
}

static bool depends_on_family(const ttc_situation *situation, ttc_id id)
{
    bool depends = false;
    for (size_t i = 0; i < situation->family.count && !depends; i++)
        depends = ttc_model_depends(situation->model, id, situation->family.items[i].symbol);
    return depends;
}

/* The divisors, as written, of the claim, the field and the definitions in use. but_family: those of the family's states do
 * not count. */
static bool divisors_are_not_zero(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation,
                                  bool but_family)
{
    const ttc_model *model = situation->model;
    for (size_t i = 0; i < model->divisor_count; i++) {
        const ttc_divisor *divisor = &model->divisors[i];
        const ttc_id id = divisor->divisor;
        const bool used = divisor->role == TTC_DIVIDES_FIELD
                          || (divisor->role == TTC_DIVIDES_SYMBOL && point->used[divisor->owner])
                          || ttc_situation_has_record(situation, divisor->role, divisor->owner);
        if (used && !(but_family && depends_on_family(situation, id)) && !is_not_zero(probe, situation, id)) return false;
    }
    return true;
}

ttc_place_in_domain ttc_random_point_place(ttc_probe *probe, const ttc_random_point *point, const ttc_situation *situation,
                                           long precision, char *fault, size_t fault_size)
{
    bool set = point->level_count == 0 ? ttc_random_point_set(probe, point, situation, precision, NULL)
                                           : ttc_level_meet(probe, point, situation, precision);
    fault[0] = '\0';
    if (!set) return TTC_OUTSIDE;
    ttc_probe_seed_states(probe);
    ttc_place_in_domain place = ttc_domain_locate(probe, situation->model, &situation->family, situation->own_root, fault,
                                                  fault_size);
    const bool has_fault = fault[0] != '\0';
    if ((place != TTC_INSIDE && !has_fault) || divisors_are_not_zero(probe, point, situation, has_fault)) return place;
    fault[0] = '\0';
    return TTC_OUTSIDE;
}
