/** Writes lists over all models: registry, manifest and operation counts. */
#ifndef TTC_EMIT_REGISTRY_H
#define TTC_EMIT_REGISTRY_H

#include "kernels/catalogue.h"
#include "base/text.h"

/* Manifest and operation counts, as lines of columns separated by tabs: the titles, and the rows of one model. */
void ttc_emit_manifest_titles(ttc_text *text);
void ttc_emit_manifest_rows(ttc_text *text, const ttc_catalogue *catalogue);
void ttc_emit_counts_titles(ttc_text *text);
void ttc_emit_counts_rows(ttc_text *text, const ttc_catalogue *catalogue);

/* registry.c: the descriptors of all fields that a manifest lists. */
void ttc_emit_registry(ttc_text *text, const char *manifest);

/* Append the rows of a model from an older list, whose first column names the model. Returns the number of rows. */
size_t ttc_copy_rows(ttc_text *text, const char *list, const char *model);

/* Whether an older manifest says that the model's files were written from this very table: equal SHA-256 in all its rows. */
bool ttc_manifest_has(const char *manifest, const ttc_model *model);

#endif
