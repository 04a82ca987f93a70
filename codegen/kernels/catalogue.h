/** The catalogue of a model: every field that its table asks for, with its kernels. */
#ifndef TTC_CATALOGUE_H
#define TTC_CATALOGUE_H

#include "kernels/kernels.h"

typedef struct {
    const ttc_variant *variant;
    const ttc_time *time;
    const ttc_elimination *elimination;
    ttc_kernels *kernels;    /* NULL: skipped */
    ttc_field_status status; /* why it was skipped */
} ttc_catalogue_entry;

typedef struct {
    const ttc_model *model;
    ttc_catalogue_entry *fields; /* general first; the variant varies slowest, the elimination fastest */
    size_t count;
    ttc_place failed_at;     /* after a failure: the record that asks for the failed field */
    const char *failure;     /* after a failure: the reason */
    bool memory_is_out;      /* after a failure: whether this is the reason, as far as is known */
} ttc_catalogue;

typedef enum { TTC_ALL_FIELDS, TTC_WITHOUT_ELIMINATIONS } ttc_catalogue_extent;

/** Make the fields of all combinations of a variant, a time and an elimination, or none of each. A field that divides by zero
 *  identically is skipped, and so it is in every time. Returns false if the general field does so, when memory is out, or when an
 *  expression outgrows the graph; only failed_at, failure and memory_is_out are then set. */
bool ttc_catalogue_create(ttc_catalogue *catalogue, const ttc_model *model, ttc_catalogue_extent extent, ttc_effort effort);
/* The record that asks for a field: its elimination, its time, its variant, or the first equation. */
ttc_place ttc_catalogue_place(const ttc_catalogue_entry *entry, const ttc_model *model);

void ttc_catalogue_clear(ttc_catalogue *catalogue); /* legal on a zeroed catalogue */

#endif
