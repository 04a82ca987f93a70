#include "emit/emit_registry.h"

#include "emit/emit.h"

#include <string.h>

/* Columns of one row, as pointers into the list and lengths. */
typedef struct {
    const char *model, *hash, *file;
    int model_length, hash_length, file_length;
} row;

/* Read the row at *line, and advance *line. Returns false at the end. Missing columns are empty. */
static bool next_row(const char **line, row *out)
{
    const char *columns[6] = { 0 };
    int lengths[6] = { 0 };
    const char *at = *line;
    if (*at == '\0') return false;
    size_t length = strcspn(at, "\n");
    const char *end = at + length;
    for (int i = 0; i < 6 && at <= end; i++) {
        const char *tab = memchr(at, '\t', (size_t)(end - at));
        const char *stop = tab == NULL ? end : tab;
        columns[i] = at;
        lengths[i] = (int)(stop - at);
        at = stop + 1;
    }
    *out = (row){ columns[0], columns[4], columns[5], lengths[0], lengths[4], lengths[5] };
    *line = *end == '\0' ? end : end + 1;
    return true;
}

/* MODEL_STEM of a row MODEL/STEM.c. Returns false for a field without a file. */
static bool add_name(ttc_text *name, const row *r)
{
    int stem = r->file_length - r->model_length - 3;
    if (stem <= 0 || r->file[r->model_length] != '/' || strncmp(r->file, "none:", 5) == 0) return false;
    ttc_text_format(name, "%.*s_%.*s", r->model_length, r->model, stem, r->file + r->model_length + 1);
    return true;
}

static void add_list(ttc_text *text, const char *manifest)
{
    ttc_text entries = { 0 };
    size_t number = 0;
    row r;
    for (bool title = true; next_row(&manifest, &r); title = false) {
        ttc_text name = { 0 };
        if (title || !add_name(&name, &r)) continue;
        ttc_text_format(text, "extern const jlt_descriptor jlt_kernels_%s;\n", ttc_text_string(&name));
        ttc_text_format(&entries, "    &jlt_kernels_%s,\n", ttc_text_string(&name));
        text->failed |= name.failed;
        ttc_text_clear(&name);
        number++;
    }
    ttc_text_format(text, "\nconst jlt_descriptor *const jlt_registry[] = {\n%s};\n\nconst unsigned jlt_registry_count = %zu;\n",
                    ttc_text_string(&entries), number);
    text->failed |= entries.failed;
    ttc_text_clear(&entries);
}

static bool is_named(const row *r, const char *model)
{
    return (size_t)r->model_length == strlen(model) && memcmp(r->model, model, (size_t)r->model_length) == 0;
}

size_t ttc_copy_rows(ttc_text *text, const char *list, const char *model)
{
    size_t count = 0;
    row r;
    for (const char *line = list, *start = line; next_row(&line, &r); start = line) {
        if (!is_named(&r, model)) continue;
        ttc_text_add_bytes(text, start, (size_t)(line - start));
        count++;
    }
    return count;
}

bool ttc_manifest_has(const char *manifest, const ttc_model *model)
{
    size_t count = 0;
    row r;
    while (next_row(&manifest, &r)) {
        if (!is_named(&r, model->name)) continue;
        if ((size_t)r.hash_length != strlen(model->sha256)
            || memcmp(r.hash, model->sha256, (size_t)r.hash_length) != 0)
            return false;
        count++;
    }
    return count > 0;
}

void ttc_emit_registry(ttc_text *text, const char *manifest)
{
    ttc_text_add(text, "/* Written by ttc; do not edit. */\n#include \"registry.h\"\n\n");
    add_list(text, manifest);
    ttc_text_add(text, "\nconst unsigned jlt_registry_entry_size = sizeof(jlt_descriptor) + sizeof(jlt_kernel_batch);\n");
}

static const char *name_or_dash(const char *name) { return name == NULL ? "-" : name; }

static void add_key(ttc_text *text, const ttc_catalogue *catalogue, const ttc_catalogue_entry *entry)
{
    ttc_text_format(text, "%s\t%s\t%s\t%s", catalogue->model->name,
                    name_or_dash(entry->variant == NULL ? NULL : entry->variant->name),
                    name_or_dash(entry->time == NULL ? NULL : entry->time->name),
                    name_or_dash(entry->elimination == NULL ? NULL : entry->elimination->name));
}

void ttc_emit_manifest_titles(ttc_text *text) { ttc_text_add(text, "model\tvariant\ttime\telimination\tsha256\tfile\n"); }

void ttc_emit_manifest_rows(ttc_text *text, const ttc_catalogue *catalogue)
{
    for (size_t k = 0; k < catalogue->count; k++) {
        const ttc_catalogue_entry *entry = catalogue->fields + k;
        add_key(text, catalogue, entry);
        ttc_text_format(text, "\t%s\t", catalogue->model->sha256);
        if (entry->kernels == NULL) {
            ttc_text_add(text, "none: divides by zero identically\n");
            continue;
        }
        ttc_text_format(text, "%s/", catalogue->model->name);
        ttc_emit_stem(text, entry->kernels->field);
        ttc_text_add(text, ".c\n");
    }
}

static void add_counts(ttc_text *text, ttc_count c)
{
    ttc_text_format(text, "\t%u\t%u\t%u\t%u\t%u\t%u\t%u\t%u\t%u", ttc_count_flops(c), c.add, c.multiply, c.fma, c.divide,
                    c.root, c.elementary, c.depth, c.live);
}

void ttc_emit_counts_titles(ttc_text *text)
{
    static const char *const columns[] = { "flops", "add", "mul", "fma", "div", "sqrt", "elementary", "depth", "live" };
    ttc_text_add(text, "model\tvariant\ttime\telimination\tkernel");
    for (int side = 0; side < 2; side++)
        for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
            ttc_text_format(text, "\t%s%s", side == 0 ? "" : "naive_", columns[i]);
    ttc_text_add(text, "\n");
}

void ttc_emit_counts_rows(ttc_text *text, const ttc_catalogue *catalogue)
{
    for (size_t k = 0; k < catalogue->count; k++)
        for (int kind = 0; catalogue->fields[k].kernels != NULL && kind < TTC_KERNEL_KINDS; kind++) {
            const ttc_kernel *kernel = catalogue->fields[k].kernels->kernels + kind;
            if (kernel->count == 0) continue;
            add_key(text, catalogue, catalogue->fields + k);
            ttc_text_format(text, "\t%s", ttc_kernel_name((ttc_kernel_kind)kind));
            add_counts(text, ttc_program_count(kernel->optimized));
            add_counts(text, ttc_program_count(kernel->naive));
            ttc_text_add(text, "\n");
        }
}
