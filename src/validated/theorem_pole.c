#include "validated/theorem_sentence.h"

#include <string.h>

void jlt_theorem_pole_setting(FILE *out, const jlt_theorem_subject *s)
{
    const jlt_descriptor *d = s->descriptor;

    fprintf(out, "Take the equations of the table %s (%s%sSHA-256 %s)", d->model, d->title, d->title[0] != '\0' ? "; " : "",
            d->sha256);
    if (d->param_count > 0) fputs(" with ", out);
    jlt_theorem_text_named(out, json_object_get(s->given, "parameters"));
    fputs(", and the states ", out);
    jlt_theorem_text_named(out, json_object_get(s->given, "box"));
    fputs(". What follows holds for each value that a parameter or a state has within its radius.", out);
}

static const char *meaning_of(const jlt_descriptor *d, const char *state)
{
    for (unsigned i = 0; i < d->pole_count; i++)
        if (strcmp(d->states[d->poles[i].state].name, state) == 0) return d->poles[i].meaning;
    return "";
}

void jlt_theorem_pole_end(FILE *out, const jlt_theorem_subject *s)
{
    const char *pole = jlt_theorem_text_of(s->given, "pole"), *meaning = meaning_of(s->descriptor, pole);

    fprintf(out, "Every motion that begins at one of these states ends at the pole %s = %s", pole,
            jlt_theorem_text_of(s->shown, "end"));
    if (meaning[0] != '\0') fprintf(out, " (%s)", meaning);
    fputs(": it comes there, and not before, after a finite time ", out);
    jlt_theorem_text_ball(out, json_object_get(s->shown, "time"));
    fprintf(out, ". This rests on a proved claim of the table: %s.",
            jlt_theorem_text(json_array_get(json_object_get(s->shown, "claims"), 0)));
}

void jlt_theorem_pole_limits(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *vanish = json_object_get(s->shown, "vanish"), *limit = json_object_get(s->shown, "limit");
    const size_t count = json_array_size(vanish);

    for (size_t i = 0; i < count; i++) fprintf(out, i == 0 ? "There %s" : ", %s", jlt_theorem_text(json_array_get(vanish, i)));
    if (count > 0) fprintf(out, " %s zero.", count > 1 ? "are" : "is");
    if (json_object_size(limit) == 0) return;
    fprintf(out, "%s come to ", count > 0 ? " The other states" : "The states");
    jlt_theorem_text_named(out, limit);
    fputc('.', out);
}
