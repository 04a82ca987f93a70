/** Writes lists over all models: registry, manifest and operation counts. */
#ifndef TTC_EMIT_REGISTRY_H
#define TTC_EMIT_REGISTRY_H

#include "kernels/catalogue.h"
#include "base/text.h"

/* Manifest and counts, columns separated by tabs: the titles, then the rows of each model. */
void ttc_emit_manifest_titles(ttc_text *text);
void ttc_emit_manifest_rows(ttc_text *text, const ttc_catalogue *catalogue);
void ttc_emit_counts_titles(ttc_text *text);
void ttc_emit_counts_rows(ttc_text *text, const ttc_catalogue *catalogue);

/* registry.c: the descriptors of all fields that a manifest lists. */
void ttc_emit_registry(ttc_text *text, const char *manifest);

/* Append a model's rows from an older list, whose first column names the model. Returns their number. */
size_t ttc_copy_rows(ttc_text *text, const char *list, const char *model);

/* Whether an older manifest says that a model's files were written from this very table. */
bool ttc_manifest_has(const char *manifest, const ttc_model *model);

#endif
