/* Writes the file table.c of a model, which its descriptors share: the table itself, its claims with their verdicts, the list of
 * descriptors. */
#include "emit/emit.h"

#include "prove/section_chart.h"

#include <stdio.h>
#include <string.h>

/* An array of characters: a conforming compiler need not accept so long a string literal. */
static void add_table(ttc_text *text, const ttc_model *model)
{
    ttc_text_add(text, "[] = {");
    for (const char *c = model->text; *c != '\0'; c++) {
        if (c == model->text || c[-1] == '\n') ttc_text_add(text, "\n    ");
        if (*c == '\n') ttc_text_add(text, "'\\n',");
        else if (*c == '\'' || *c == '\\') ttc_text_format(text, "'\\%c',", *c);
        else if ((unsigned char)*c < 32 || (unsigned char)*c > 126) ttc_text_format(text, "'\\%03o',", (unsigned)(unsigned char)*c);
        else ttc_text_format(text, "'%c',", *c);
    }
    ttc_text_add(text, "\n    '\\0'\n};\n");
}

static void add_name(ttc_text *text, const char *name)
{
    if (name == NULL) ttc_text_add(text, ", NULL");
    else ttc_text_format(text, ", \"%s\"", name);
}

/* SHA-256 of a claim's target, its file, and the names that ttc_emit_renamed and ttc_emit_widened find, in quotation marks; NULL
 * where there is none. */
static void add_target(ttc_text *text, const ttc_catalogue *catalogue, const ttc_claim *claim)
{
    const ttc_model *model = catalogue->model;
    const ttc_kernels *general = catalogue->count > 0 ? catalogue->fields[0].kernels : NULL;
    ttc_diagnostics *ignored = claim != NULL && claim->target != NULL ? ttc_diagnostics_create() : NULL;
    ttc_model *target = ignored == NULL ? NULL : ttc_resolve_beside(NULL, model, claim->target, ignored);
    if (target == NULL) {
        ttc_text_add(text, "NULL, NULL");
    } else {
        ttc_text_format(text, "\"%s\", \"", target->sha256);
        ttc_text_add_escaped(text, claim->target);
        ttc_text_add(text, "\"");
    }
    add_name(text, target == NULL ? NULL : ttc_emit_renamed(model, claim, target));
    add_name(text, target == NULL || general == NULL ? NULL : ttc_emit_widened(general, claim, target));
    ttc_model_destroy(target);
    ttc_diagnostics_destroy(ignored);
}

/* Add why a claim is not proved: a screen of terms would hide the rest of the message that it stands in. */
static void add_reason(ttc_text *text, const char *reason)
{
    char shown[300];

    snprintf(shown, sizeof shown, "%s", reason);
    ttc_text_add_escaped(text, shown);
    if (strlen(reason) >= sizeof shown) ttc_text_add(text, " ... (ttc prove shows more)");
}

static void add_claims(ttc_text *text, const ttc_catalogue *catalogue, const ttc_proof_report *report)
{
    static const char *const verdicts[] = { "JLT_PROVED", "JLT_REFUTED", "JLT_UNSETTLED" };
    const ttc_model *model = catalogue->model;
    ttc_field *field = NULL; /* conditions are written with its names */
    for (size_t i = catalogue->count; i-- > 0;)
        if (catalogue->fields[i].kernels != NULL) field = catalogue->fields[i].kernels->field;
    ttc_text_format(text, "\nconst jlt_claim jlt_claims_%s[] = {\n", model->name);
    for (size_t i = 0; i < report->proof_count; i++) {
        const ttc_proof *proof = report->proofs + i;
        const ttc_claim *claim = i < model->claim_count ? model->claims + i : NULL;
        ttc_text_format(text, "    { \"%s\", \"%s\", \"", proof->kind, proof->name);
        if (claim != NULL && field != NULL) ttc_emit_condition(text, field, &claim->when);
        for (size_t k = 0; claim != NULL && claim->target != NULL && k < claim->modulo_count; k++)
            ttc_text_format(text, "%s%s = 0", k + claim->when.count > 0 ? ", " : "", model->claims[claim->modulo[k]].name);
        ttc_text_format(text, "\", %s, \"", verdicts[proof->status]);
        if (proof->status != TTC_PROVED && proof->remainder != NULL) add_reason(text, proof->remainder);
        ttc_text_add(text, "\", ");
        add_target(text, catalogue, claim);
        ttc_text_add(text, " },\n");
    }
    ttc_text_add(text, "    { NULL, NULL, NULL, JLT_UNSETTLED, NULL, NULL, NULL, NULL, NULL }\n};\n");
}

static void add_family(ttc_text *text, const ttc_catalogue *catalogue)
{
    ttc_text list = { 0 };
    ttc_text_add(text, "\n");
    for (size_t i = 0; i < catalogue->count; i++) {
        if (catalogue->fields[i].kernels == NULL) continue;
        ttc_text name = { 0 };
        ttc_text_format(&name, "jlt_kernels_%s_", catalogue->model->name);
        ttc_emit_stem(&name, catalogue->fields[i].kernels->field);
        ttc_text_format(text, "extern const jlt_descriptor %s;\n", ttc_text_string(&name));
        ttc_text_format(&list, "    &%s,\n", ttc_text_string(&name));
        list.failed |= name.failed;
        ttc_text_clear(&name);
    }
    ttc_text_format(text, "\nconst jlt_descriptor *const jlt_family_%s[] = {\n%s    NULL\n};\n", catalogue->model->name,
                    ttc_text_string(&list));
    text->failed |= list.failed;
    ttc_text_clear(&list);
}

/* Tables of coordinates, under the numbers of their sections' claims: section c of a_b is not section b_c of a. */
static void add_charts(ttc_text *text, const ttc_model *model)
{
    char reason[256];
    for (size_t i = 0; i < model->section_count; i++) {
        ttc_model *chart = ttc_section_chart(model, model->sections + i, ttc_resolve_beside, NULL, reason, sizeof reason);
        if (chart == NULL) continue;
        ttc_text_format(text, "\nconst char jlt_chart_%s_%u", model->name, (unsigned)model->sections[i].claim);
        add_table(text, chart);
        ttc_model_destroy(chart);
    }
}

void ttc_emit_model_names(ttc_text *text, const ttc_model *model)
{
    for (size_t i = 0; i < model->section_count; i++)
        ttc_text_format(text, "extern const char jlt_chart_%s_%u[];\n", model->name, (unsigned)model->sections[i].claim);
    ttc_text_format(text, "extern const char jlt_table_%s[];\nextern const jlt_claim jlt_claims_%s[];\n"
                          "extern const jlt_descriptor *const jlt_family_%s[];\n", model->name, model->name, model->name);
}

void ttc_emit_model(ttc_text *text, const ttc_catalogue *catalogue, const ttc_proof_report *report)
{
    const ttc_model *model = catalogue->model;
    ttc_text_format(text,
                    "/* %s: its table byte for byte (SHA-256 %s), what is proved of it, its descriptors. Written by ttc %s; do "
                    "not edit. */\n#include \"kernel_abi.h\"\n\n",
                    model->name, model->sha256, JLT_VERSION);
    ttc_emit_model_names(text, model);
    ttc_text_add(text, "\n");
    ttc_text_format(text, "const char jlt_table_%s", model->name);
    add_table(text, model);
    add_charts(text, model);
    add_claims(text, catalogue, report);
    add_family(text, catalogue);
}
