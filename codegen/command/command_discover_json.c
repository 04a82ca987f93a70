#include "command/command_discover_json.h"

#include "command/command.h"

#include <stdlib.h>
#include <string.h>

json_t *ttc_command_discover_json(const ttc_discovery *d, const char *path, const char *sha256, const char *when)
{
    json_t *quantities = json_array();
    for (size_t i = 0; i < d->flow->count; i++)
        json_array_append_new(quantities, json_string(d->flow->ring->names[d->flow->variables[i]]));
    return json_pack("{s:o, s:b, s:s, s:s, s:s?, s:i, s:o, s:I, s:[], s:[], s:[], s:[], s:I, s:[]}", "file",
                     ttc_command_string(path), "ok", 1, "model", d->flow->model->name, "sha256", sha256, "when", when, "degree",
                     d->degree, "quantities", quantities, "prime", (json_int_t)d->flow->mod.n, "known", "claims", "settled",
                     "unproved", "unlifted", (json_int_t)0, "remarks");
}

void ttc_command_discover_add_problem(json_t *problems, const char *path, const char *message)
{
    json_array_append_new(problems, json_pack("{s:s, s:o, s:i, s:i, s:o}", "severity", "error", "file", ttc_command_string(path),
                                              "line", 0, "column", 0, "message", ttc_command_string(message)));
}

/* Without the line feed at the end. */
static json_t *line_of(const char *text)
{
    const size_t length = strlen(text);
    return json_stringn(text, length > 0 && text[length - 1] == '\n' ? length - 1 : length);
}

/* The last record is the claim; others, such as roots, are used in it. */
static const char *last_record(const char *text)
{
    const char *last = text;
    for (const char *c = text; *c != '\0'; c++)
        if (*c == '\n' && c[1] != ' ' && c[1] != '\0') last = c + 1;
    return last;
}

void ttc_command_discover_add_claim(json_t *out, const char *text)
{
    const char *record = last_record(text);
    const size_t kind = strcspn(record, " ");
    const char *name = record + kind + strspn(record + kind, " ");
    json_t *claim = json_object();
    json_object_set_new(claim, "kind", json_stringn(record, kind));
    json_object_set_new(claim, "name", json_stringn(name, strcspn(name, " ")));
    json_object_set_new(claim, "text", line_of(text));
    json_array_append_new(json_object_get(out, "claims"), claim);
}

void ttc_command_discover_add_unproved(json_t *out, const char *text, const char *reason)
{
    json_array_append_new(json_object_get(out, "unproved"), json_pack("{s:o, s:s}", "text", line_of(text), "reason", reason));
}

void ttc_command_discover_add_remark(json_t *out, const char *text)
{
    json_array_append_new(json_object_get(out, "remarks"), line_of(text + (strncmp(text, "# ", 2) == 0 ? 2 : 0)));
}

void ttc_command_discover_add_settled(json_t *out, const ttc_discovery_settled *settled)
{
    json_t *entry = json_pack("{s:s, s:s, s:i, s:b}", "seek", settled->seek, "form", settled->form, "degree", settled->degree,
                              "complete", (int)settled->complete);
    if (settled->monomials > 0) {
        json_object_set_new(entry, "monomials", json_integer((json_int_t)settled->monomials));
        json_object_set_new(entry, "rank", json_integer((json_int_t)settled->rank));
    }
    json_array_append_new(json_object_get(out, "settled"), entry);
}
