#include "challenge/subject.h"

#include "prove/observed.h"

#include <string.h>

/* An identity that fails somewhere fails almost everywhere, if it speaks of an open set of points. */
static const struct {
    ttc_claim_kind kind;
    ttc_checker checker;
    bool is_identity;
} claim_checkers[] = {
    { TTC_CLAIM_INTEGRAL, ttc_check_integral, true },     { TTC_CLAIM_INVARIANT, ttc_check_invariant, false },
    { TTC_CLAIM_RATE, ttc_check_rate_claim, true },       { TTC_CLAIM_MEASURE, ttc_check_measure, true },
    { TTC_CLAIM_REVERSOR, ttc_check_reversor, false },    { TTC_CLAIM_EQUAL, ttc_check_equal, true },
    { TTC_CLAIM_POSITIVE, ttc_check_positive_claim, false }, { TTC_CLAIM_EQUILIBRIA, ttc_check_equilibria, false },
    { TTC_CLAIM_TRACE, ttc_check_trace, true },           { TTC_CLAIM_CHARPOLY, ttc_check_charpoly, false },
    { TTC_CLAIM_MATRIX, ttc_check_matrix, true },         { TTC_CLAIM_LEFT_NULL, ttc_check_left_null, true },
    { TTC_CLAIM_OBSTRUCTS, ttc_check_obstructs, false },  { TTC_CLAIM_REDUCTION, ttc_check_reduction, false },
    { TTC_CLAIM_SYMMETRY, ttc_check_symmetry, false },    { TTC_CLAIM_EMBEDDING, ttc_check_reduction, false },
    { TTC_CLAIM_PERIODIC, ttc_check_period, false },      { TTC_CLAIM_SECTION, ttc_check_section, false },
    { TTC_CLAIM_DESCENT, ttc_check_way, false },          { TTC_CLAIM_LIFT, ttc_check_way, false },
};

static void bind(ttc_situation *situation, const ttc_bindings *list)
{
    if (list->count > 0) situation->bound[situation->bound_count++] = list;
}

/* Returns false if there are more levels than can be solved for. */
static bool add_level(ttc_situation *situation, ttc_id id)
{
    if (situation->level_count == TTC_PROBE_SPARE) return false;
    situation->levels[situation->level_count++] = id;
    return true;
}

static bool use_claim(ttc_subject *subject, const ttc_model *model, uint32_t index)
{
    const ttc_claim *claim = &model->claims[index];
    ttc_situation *situation = &subject->situation;
    subject->claim = claim;
    subject->index = index;
    if (claim->kind != TTC_CLAIM_SECTION) { /* whose way back has a value wherever it is crossed */
        situation->role = TTC_DIVIDES_CLAIM;
        situation->owner = index;
    }
    for (size_t i = 0; i < sizeof claim_checkers / sizeof *claim_checkers; i++)
        if (claim_checkers[i].kind == claim->kind) {
            subject->checker = claim_checkers[i].checker;
            subject->fails_on_open_set = claim_checkers[i].is_identity && claim->modulo_count == 0;
        }
    subject->refuted_by_witness = claim->kind == TTC_CLAIM_OBSTRUCTS;
    bind(situation, &claim->when);
    if (claim->kind == TTC_CLAIM_EQUILIBRIA) {
        bind(situation, &claim->bindings);
        situation->family = claim->bindings;
    } else if (ttc_claim_speaks_of_family(claim->kind)) {
        bind(situation, &model->claims[claim->family].when);
        bind(situation, &model->claims[claim->family].bindings);
    }
    for (size_t i = 0; i < claim->modulo_count; i++)
        if (!add_level(situation, model->claims[claim->modulo[i]].expression)) return false;
    if (claim->kind == TTC_CLAIM_INVARIANT && !add_level(situation, claim->expression)) return false;
    return subject->checker != NULL;
}

static bool find_claim(ttc_subject *subject, const ttc_model *model, const char *kind, const char *name, ttc_place place)
{
    for (uint32_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *claim = &model->claims[i];
        if (strcmp(ttc_claim_kind_name(claim->kind), kind) == 0 && strcmp(claim->name, name) == 0
            && claim->place.line == place.line && claim->place.column == place.column)
            return use_claim(subject, model, i);
    }
    return false;
}

static bool use_derived(ttc_subject *subject, ttc_checker checker, ttc_divisor_role role, uint32_t index)
{
    subject->situation.role = role;
    subject->situation.owner = index;
    subject->checker = checker;
    subject->index = index;
    return true;
}

static bool find_derived(ttc_subject *subject, const ttc_model *model, const char *kind, const char *name)
{
    const bool root = strcmp(kind, "root") == 0;
    if (root || strcmp(kind, "log") == 0) {
        for (uint32_t i = 0; i < model->symbol_count; i++)
            if (model->symbols[i].kind == (root ? TTC_ROOT : TTC_LOG) && strcmp(model->symbols[i].name, name) == 0) {
                subject->situation.own_root = i;
                return use_derived(subject, ttc_check_root, TTC_DIVIDES_FIELD, i);
            }
    } else if (strcmp(kind, "variant") == 0) {
        for (uint32_t i = 0; i < model->variant_count; i++)
            if (strcmp(model->variants[i].name, name) == 0)
                return use_derived(subject, ttc_check_variant, TTC_DIVIDES_VARIANT, i);
    } else if (strcmp(kind, "time") == 0) {
        for (uint32_t i = 0; i < model->time_count; i++)
            if (strcmp(model->times[i].name, name) == 0)
                return use_derived(subject, ttc_check_time, TTC_DIVIDES_TIME, i);
    } else if (strcmp(kind, "eliminate") == 0) {
        for (uint32_t i = 0; i < model->elimination_count; i++)
            if (strcmp(model->eliminations[i].name, name) == 0)
                return use_derived(subject, ttc_check_elimination, TTC_DIVIDES_FIELD, i);
    } else if (strcmp(kind, "pole") == 0) {
        for (uint32_t i = 0; i < model->pole_count; i++)
            if (strcmp(model->symbols[model->poles[i].state].name, name) == 0)
                return use_derived(subject, ttc_check_pole, TTC_DIVIDES_FIELD, i);
    }
    const size_t observed = ttc_observed_count(model);
    for (uint32_t i = 0; i < observed; i++) {
        ttc_observed record;
        ttc_observed_get(model, i, &record);
        if (strcmp(record.kind, kind) == 0 && strcmp(record.name, name) == 0)
            return use_derived(subject, ttc_check_observed, TTC_DIVIDES_FIELD, i);
    }
    return false;
}

bool ttc_subject_find(ttc_subject *subject, const ttc_model *model, const char *kind, const char *name, ttc_place place)
{
    *subject = (ttc_subject){ .situation = { .model = model, .own_root = UINT32_MAX } };
    return find_claim(subject, model, kind, name, place) || find_derived(subject, model, kind, name);
}
