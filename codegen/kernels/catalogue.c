#include "kernels/catalogue.h"

#include <stdlib.h>

/* plain: the entry without its time. Where that divides by zero there are no states to begin with, even if a factor of the time, or
 * a root that it lifts, hides the zero. */
static bool make_kernels(ttc_catalogue_entry *entry, const ttc_catalogue_entry *plain, const ttc_model *model, ttc_effort effort)
{
    ttc_field *field = NULL;
    entry->status = plain->status == TTC_FIELD_DIVIDES_BY_ZERO
                        ? TTC_FIELD_DIVIDES_BY_ZERO
                        : ttc_field_create(&field, model, entry->variant, entry->time, entry->elimination);
    if (entry->status == TTC_FIELD_DIVIDES_BY_ZERO) return true;
    if (entry->status != TTC_FIELD_OK) return false;
    entry->kernels = ttc_kernels_create(field, effort);
    return entry->kernels != NULL;
}

ttc_place ttc_catalogue_place(const ttc_catalogue_entry *entry, const ttc_model *model)
{
    if (entry->elimination != NULL) return entry->elimination->place;
    if (entry->time != NULL) return entry->time->place;
    if (entry->variant != NULL) return entry->variant->place;
    return model->equation_count > 0 ? model->equations[0].place : (ttc_place){ 1, 1 };
}

static const char *reason_of(const ttc_model *model, const ttc_catalogue_entry *entry)
{
    if (entry->status == TTC_FIELD_DIVIDES_BY_ZERO) return "the equations divide by what is zero everywhere";
    ttc_graph_status error = ttc_graph_error(model->graph);
    return error != TTC_GRAPH_OK ? ttc_graph_status_text(error) : "memory is out, or a number is divided by zero";
}

/* Whether the graph knows of no other reason. */
static bool lacks_memory(const ttc_model *model, const ttc_catalogue_entry *entry)
{
    const ttc_graph_status error = ttc_graph_error(model->graph);
    return entry->status != TTC_FIELD_DIVIDES_BY_ZERO && (error == TTC_GRAPH_OK || error == TTC_GRAPH_NO_MEMORY);
}

/* Comes after all fields are made: this adds nodes to the graph, on whose ids the programs of other fields depend. */
static bool complete(ttc_catalogue *catalogue, ttc_effort effort)
{
    for (size_t i = 0; i < catalogue->count; i++)
        if (catalogue->fields[i].kernels != NULL && !ttc_kernels_keep_digits(catalogue->fields[i].kernels, effort)) return false;
    for (size_t i = 0; i < catalogue->count; i++)
        if (catalogue->fields[i].kernels != NULL) ttc_kernels_keep_families(catalogue->fields[i].kernels);
    return true;
}

bool ttc_catalogue_create(ttc_catalogue *catalogue, const ttc_model *model, ttc_catalogue_extent extent, ttc_effort effort)
{
    size_t eliminations = extent == TTC_WITHOUT_ELIMINATIONS ? 0 : model->elimination_count;
    size_t most = (model->variant_count + 1) * (model->time_count + 1) * (eliminations + 1);
    *catalogue = (ttc_catalogue){ .model = model, .fields = calloc(most, sizeof *catalogue->fields) };
    if (catalogue->fields == NULL) {
        catalogue->failure = "memory is out";
        catalogue->memory_is_out = true;
        return false;
    }
    for (size_t v = 0; v <= model->variant_count; v++)
        for (size_t t = 0; t <= model->time_count; t++)
            for (size_t e = 0; e <= eliminations; e++) {
                ttc_catalogue_entry *entry = catalogue->fields + catalogue->count++;
                entry->variant = v == 0 ? NULL : model->variants + v - 1;
                entry->time = t == 0 ? NULL : model->times + t - 1;
                entry->elimination = e == 0 ? NULL : model->eliminations + e - 1;
                const bool is_made = make_kernels(entry, entry - t * (eliminations + 1), model, effort);
                if (is_made && (entry->kernels != NULL || catalogue->count > 1)) continue;
                ttc_catalogue failed = { .failed_at = ttc_catalogue_place(entry, model), .failure = reason_of(model, entry),
                                         .memory_is_out = lacks_memory(model, entry) };
                ttc_catalogue_clear(catalogue);
                *catalogue = failed;
                return false;
            }
    if (complete(catalogue, effort)) return true;
    ttc_catalogue failed = { .failed_at = ttc_catalogue_place(&catalogue->fields[0], model),
                             .failure = reason_of(model, &catalogue->fields[0]),
                             .memory_is_out = lacks_memory(model, &catalogue->fields[0]) };
    ttc_catalogue_clear(catalogue);
    *catalogue = failed;
    return false;
}

void ttc_catalogue_clear(ttc_catalogue *catalogue)
{
    for (size_t i = 0; i < catalogue->count; i++) ttc_kernels_destroy(catalogue->fields[i].kernels);
    free(catalogue->fields);
    *catalogue = (ttc_catalogue){ 0 };
}
