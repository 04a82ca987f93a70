/* Finds what gives the parameters of a claim's target: parameters of this table with their names, or others. */
#include "emit/emit.h"

#include "prove/image.h"
#include "prove/way_table.h"

#include <stdlib.h>

enum { OWN, PARAMS, LEVEL, OTHER_LEVEL }; /* jlt_source */

/* Whether an integral has this name but is another quantity. */
static bool is_other_integral(const ttc_model *model, const char *name, ttc_id value, bool is_root)
{
    uint32_t claim;
    return ttc_model_find_claim(model, name, &claim) && model->claims[claim].kind == TTC_CLAIM_INTEGRAL &&
           (is_root || ttc_model_expand(model, model->claims[claim].expression) != ttc_model_expand(model, value));
}

int ttc_emit_source(const ttc_model *model, const char *name, ttc_id value, bool is_root)
{
    const uint32_t own = ttc_param_of(model, name);
    unsigned char *support;
    bool has_states = false;

    if (own != UINT32_MAX && !is_root && value == model->symbols[own].node) return OWN;
    support = ttc_model_support(model, &value, 1);
    if (support == NULL) return -1;
    for (size_t i = 0; i < model->state_count; i++) has_states |= support[model->states[i]] != 0;
    free(support);
    if (!has_states) return PARAMS;
    return own != UINT32_MAX || is_other_integral(model, name, value, is_root) ? OTHER_LEVEL : LEVEL;
}

const char *ttc_emit_renamed(const ttc_model *model, const ttc_claim *claim, const ttc_model *target)
{
    for (size_t i = 0; claim->kind == TTC_CLAIM_REDUCTION && i < target->param_count; i++) {
        const char *name = target->symbols[target->params[i]].name;
        const ttc_id given = ttc_given_for(claim, name);
        const int source = given != TTC_NONE ? ttc_emit_source(model, name, given, false) : OWN;
        if (source == PARAMS || source == OTHER_LEVEL) return name;
    }
    return NULL;
}
