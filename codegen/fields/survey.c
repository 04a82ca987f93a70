#include "fields/survey.h"

#include <stdlib.h>

bool ttc_survey_init(ttc_survey *out, const ttc_field *field)
{
    const size_t size = ttc_graph_size(field->graph) + 1;
    *out = (ttc_survey){ field, size, calloc(size, 1), calloc(size, 1), calloc(size, 1) };
    return out->seen != NULL && out->denominator != NULL && out->root != NULL;
}

void ttc_survey_clear(ttc_survey *survey)
{
    free(survey->seen);
    free(survey->denominator);
    free(survey->root);
}

void ttc_survey_add(ttc_survey *survey, ttc_id id)
{
    const ttc_graph *graph = survey->field->graph;
    if (survey->seen[id]) return;
    survey->seen[id] = 1;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) {
        const ttc_field_symbol *symbol = survey->field->symbols + ttc_symbol_of(graph, id);
        survey->root[id] = symbol->role == TTC_ROLE_ROOT;
        if (symbol->role >= TTC_ROLE_UNIT) ttc_survey_add(survey, symbol->definition);
    }
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        if (ttc_kind_of(graph, id) == TTC_PRODUCT && part.exponent < 0) survey->denominator[part.id] = 1;
        ttc_survey_add(survey, part.id);
    }
}
