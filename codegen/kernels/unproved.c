/* Finds the kernels that rest on claims without a proof. Relies on the order of a report: the table's claims in its order, then
 * the derived ones (those of records, and of the domain) by kind and name. */
#include "kernels/unproved.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

static void add_kernels(ttc_text *text, ttc_kernel_kind first, ttc_kernel_kind second)
{
    ttc_text_format(text, "%s%s, %s", text->length > 0 ? ", " : "", ttc_kernel_name(first), ttc_kernel_name(second));
}

static void kernels_of_claim(ttc_text *text, const ttc_kernels *k, uint32_t number)
{
    const ttc_claim *claim = k->field->model->claims + number;
    uint32_t family = ttc_claim_speaks_of_family(claim->kind) ? claim->family : number;
    if (k->field->elimination != NULL && k->field->elimination->integral == number) ttc_text_add(text, "all kernels");
    else if (ttc_array_has(k->integrals, k->integral_count, number))
        add_kernels(text, TTC_KERNEL_INTEGRAL_VALUES, TTC_KERNEL_INTEGRAL_GRADIENTS);
    else if (ttc_array_has(k->measures, k->measure_count, number))
        add_kernels(text, TTC_KERNEL_MEASURE_VALUES, TTC_KERNEL_MEASURE_DIVERGENCES);
    else if (ttc_array_has(k->families, k->family_count, family)) ttc_text_add(text, "equilibria");
    else if (claim->kind == TTC_CLAIM_SECTION && ttc_field_is_general(k->field))
        ttc_text_add(text, "sections");
}

/* Whether all kernels rest on a derived claim: that of the field's own variant, time or elimination; or, as all kernels share the
 * prepared values, any of roots, logarithms and quantities beside the equations. */
static bool field_needs(const ttc_field *field, const ttc_proof *proof)
{
    static const char *const of_all[] = { "root", "log", "observe", "valid", "tier" };
    const char *name = NULL;
    for (size_t i = 0; i < sizeof of_all / sizeof *of_all; i++)
        if (strcmp(proof->kind, of_all[i]) == 0) return true;
    if (strcmp(proof->kind, "variant") == 0 && field->variant != NULL) name = field->variant->name;
    if (strcmp(proof->kind, "time") == 0 && field->time != NULL) name = field->time->name;
    if (strcmp(proof->kind, "eliminate") == 0 && field->elimination != NULL) name = field->elimination->name;
    return name != NULL && strcmp(name, proof->name) == 0;
}

void ttc_unproved_kernels(ttc_text *text, const ttc_kernels *kernels, const ttc_proof_report *report, size_t proof)
{
    const ttc_field *field = kernels->field;
    if (proof < field->model->claim_count) kernels_of_claim(text, kernels, (uint32_t)proof);
    else if (field_needs(field, report->proofs + proof)) ttc_text_add(text, "all kernels");
}

static bool mark(ttc_kernels *k, const ttc_proof_report *report)
{
    ttc_text names = { 0 };
    for (size_t i = 0; i < report->proof_count; i++) {
        const ttc_proof *proof = report->proofs + i;
        ttc_text kernels = { 0 };
        if (strcmp(ttc_proof_status_name(proof->status), "proved") == 0) continue;
        ttc_unproved_kernels(&kernels, k, report, i);
        if (kernels.length > 0) ttc_text_format(&names, "%s%s %s", names.length > 0 ? ", " : "", proof->kind, proof->name);
        names.failed |= kernels.failed;
        ttc_text_clear(&kernels);
    }
    bool ok = !names.failed;
    free(k->unproved);
    k->unproved = ok ? names.bytes : NULL;
    if (!ok) ttc_text_clear(&names);
    return ok;
}

bool ttc_catalogue_mark_unproved(ttc_catalogue *catalogue, const ttc_proof_report *report)
{
    for (size_t i = 0; i < catalogue->count; i++)
        if (catalogue->fields[i].kernels != NULL && !mark(catalogue->fields[i].kernels, report)) return false;
    return true;
}
