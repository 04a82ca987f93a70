#include "command/kept.h"

#include "base/source.h"
#include "command/command.h"
#include "command/command_guard.h"
#include "emit/emit.h"
#include "emit/emit_registry.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* A file of the folder; NULL if there is none, or it cannot be read. */
static char *read_file(const char *folder, const char *name)
{
    ttc_text path = { 0 };
    size_t length = 0;
    ttc_text_format(&path, "%s/%s", folder, name);
    ttc_diagnostics *ignored = ttc_diagnostics_create();
    char *text = path.failed || ignored == NULL ? NULL : ttc_source_read(ttc_text_string(&path), &length, ignored);
    ttc_diagnostics_destroy(ignored);
    ttc_text_clear(&path);
    return text;
}

void ttc_kept_read(ttc_kept *kept, const char *folder)
{
    *kept = (ttc_kept){ read_file(folder, "manifest.tsv"), read_file(folder, "counts.tsv") };
}

void ttc_kept_clear(ttc_kept *kept)
{
    free(kept->manifest);
    free(kept->counts);
    *kept = (ttc_kept){ 0 };
}

/* Whether the verdicts in the folder would be found again: they name every table that the model's claims lead to by the digest that
 * it has now, and the system ended none of their proofs. */
static bool has_verdicts(const char *folder, const ttc_model *model)
{
    ttc_text name = { 0 };
    ttc_text_format(&name, "%s/table.c", model->name);
    char *claims = name.failed ? NULL : read_file(folder, ttc_text_string(&name));
    bool has = claims != NULL && strstr(claims, TTC_GUARD_BY_SYSTEM) == NULL;
    for (size_t i = 0; i < model->claim_count && has; i++) {
        if (model->claims[i].target == NULL) continue;
        ttc_diagnostics *ignored = ttc_diagnostics_create();
        ttc_model *target = ignored == NULL ? NULL : ttc_resolve_beside(NULL, model, model->claims[i].target, ignored);
        has = target != NULL && strstr(claims, target->sha256) != NULL;
        ttc_model_destroy(target);
        ttc_diagnostics_destroy(ignored);
    }
    free(claims);
    ttc_text_clear(&name);
    return has;
}

/* Whether the folder has MODEL/NAMEEXTENSION. */
static bool has_file(const char *folder, const char *model, const char *name, const char *extension)
{
    ttc_text path = { 0 };
    ttc_text_format(&path, "%s/%s/%s%s", folder, model, name, extension);
    const bool has = !path.failed && access(ttc_text_string(&path), R_OK) == 0;
    ttc_text_clear(&path);
    return has;
}

/* Whether the folder has the files of all fields in the model's rows of the manifest, and those of the model as a whole. */
static bool has_files(const ttc_kept *kept, const char *folder, const char *model)
{
    ttc_text rows = { 0 };
    ttc_copy_rows(&rows, kept->manifest, model);
    bool has = !rows.failed && has_file(folder, model, model, "_ball.c");
    for (unsigned isa = 0; isa < TTC_ISA_COUNT && has; isa++) has = has_file(folder, model, "batch_", ttc_isa_files[isa]);
    for (char *row = rows.bytes; has && row != NULL && *row != '\0';) {
        char *end = row + strcspn(row, "\n"), *next = *end == '\n' ? end + 1 : end;
        *end = '\0';
        char *slash = strrchr(row, '/'), *dot = strrchr(row, '.'); /* MODEL/STEM.c; "none: ..." has neither */
        row = next;
        if (slash == NULL || dot == NULL) continue;
        *dot = '\0';
        has = has_file(folder, model, slash + 1, ".c") && has_file(folder, model, slash + 1, "_lanes.inc");
    }
    ttc_text_clear(&rows);
    return has;
}

bool ttc_kept_has(const ttc_kept *kept, const char *folder, const ttc_model *model)
{
    return kept->manifest != NULL && kept->counts != NULL && ttc_manifest_has(kept->manifest, model) &&
           has_files(kept, folder, model->name) && has_verdicts(folder, model);
}
