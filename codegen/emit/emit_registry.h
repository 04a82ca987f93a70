/** Lists over all models: registries, manifest and operation counts. */
#ifndef TTC_EMIT_REGISTRY_H
#define TTC_EMIT_REGISTRY_H

#include "kernels/plan.h"
#include "base/text.h"

void ttc_emit_registry_header(ttc_text *text);
void ttc_emit_registry(ttc_text *text, const ttc_plan *plans, size_t count);
void ttc_emit_ball_registry(ttc_text *text, const ttc_plan *plans, size_t count);
void ttc_emit_manifest(ttc_text *text, const ttc_plan *plans, size_t count);
void ttc_emit_counts(ttc_text *text, const ttc_plan *plans, size_t count);

#endif
