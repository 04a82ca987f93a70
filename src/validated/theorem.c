#include "validated/theorem.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const jlt_reversor *jlt_theorem_reversor(const jlt_descriptor *descriptor)
{
    for (unsigned i = 0; i < descriptor->reversor_count; i++) {
        const jlt_claim *claim = &descriptor->claims[descriptor->reversors[i].claim];
        if (claim->verdict == JLT_PROVED && claim->condition[0] == '\0') return &descriptor->reversors[i];
    }
    return NULL;
}

static void write_ball(FILE *out, const json_t *ball)
{
    if (json_is_string(ball)) fputs(json_string_value(ball), out);
    else fprintf(out, "%s +- %s", json_string_value(json_object_get(ball, "middle")),
                 json_string_value(json_object_get(ball, "radius")));
}

static void write_named(FILE *out, const json_t *values, const char *between)
{
    const char *name;
    json_t *value;
    bool first = true;

    json_object_foreach((json_t *)(uintptr_t)values, name, value) {
        fprintf(out, "%s%s = ", first ? "" : between, name);
        write_ball(out, value);
        first = false;
    }
}

static bool has_radius(const json_t *values)
{
    const char *name;
    json_t *value;

    json_object_foreach((json_t *)(uintptr_t)values, name, value)
        if (json_is_object(value)) return true;
    return false;
}

static void write_setting(FILE *out, const jlt_descriptor *d, const json_t *given)
{
    const json_t *section = json_object_get(given, "section"), *levels = json_object_get(given, "levels");

    fprintf(out, "Take the equations of the table %s (%s; SHA-256 %s) with ", d->model, d->title, d->sha256);
    write_named(out, json_object_get(given, "parameters"), ", ");
    fputc('.', out);
    if (json_object_size(levels) > 0) {
        fputs(" Levels: ", out);
        write_named(out, levels, ", ");
        fputc('.', out);
    }
    fprintf(out, " Section: %s = %s, crossed %s.", json_string_value(json_object_get(section, "state")),
            json_string_value(json_object_get(section, "value")),
            json_integer_value(json_object_get(section, "direction")) > 0 ? "upwards" : "downwards");
    if (has_radius(json_object_get(given, "parameters")) || has_radius(levels))
        fputs(" What follows holds for each value that a parameter or level has within its radius, with "
              "balls that hold for all of them.", out);
}

static void write_orbit(FILE *out, const json_t *given, const json_t *shown)
{
    fputs("Through the box ", out);
    write_named(out, json_object_get(given, "box"), ", ");
    fputs(" of the section there is exactly one orbit on these levels that is back at its point after a time near ", out);
    fputs(json_string_value(json_object_get(given, "instant")), out);
    fputs(". That point is ", out);
    write_named(out, json_object_get(shown, "orbit"), ", ");
    fputs(", the time T = ", out);
    write_ball(out, json_object_get(shown, "period"));
    fputc('.', out);
}

static void write_multipliers(FILE *out, const json_t *shown)
{
    const json_t *multipliers = json_object_get(shown, "multipliers");

    fputs("On the levels, det DP = exp(integral of div f over the orbit) = ", out);
    write_ball(out, json_object_get(shown, "determinant"));
    fputs(", trace DP = ", out);
    write_ball(out, json_object_get(shown, "trace"));
    for (size_t i = 0; i < json_array_size(multipliers); i++) {
        const json_t *value = json_array_get(multipliers, i);
        fprintf(out, "; multiplier (");
        write_ball(out, json_object_get(value, "re"));
        fputs(") + i (", out);
        write_ball(out, json_object_get(value, "im"));
        fputc(')', out);
    }
    fputc('.', out);
}

static void write_conditions(FILE *out, const jlt_descriptor *d, const json_t *shown)
{
    const char *name;
    json_t *bound;
    bool first = true;

    json_object_foreach(json_object_get(shown, "conditions"), name, bound) {
        const char *meaning = "";
        for (unsigned i = 0; i < d->valid_count; i++)
            if (strcmp(d->valids[i].name, name) == 0) meaning = d->valids[i].meaning;
        if (json_string_value(bound)[0] == '-')
            fprintf(out, "%sOf the condition %s (%s) it is not shown that it holds.", first ? "" : " ", name, meaning);
        else fprintf(out, "%sThe condition %s (%s) holds all along the orbit: its quantity is above %s.",
                     first ? "" : " ", name, meaning, json_string_value(bound));
        first = false;
    }
}

static void write_image(FILE *out, const jlt_descriptor *d)
{
    const jlt_reversor *reversor = jlt_theorem_reversor(d);
    bool first = true;

    if (reversor == NULL) return;
    fputs("The image of the orbit under the reversor ", out);
    for (unsigned i = 0; i < d->state_count; i++) {
        if (reversor->signs[i] > 0) continue;
        fprintf(out, "%s%s -> -%s", first ? "" : ", ", d->states[i].name, d->states[i].name);
        first = false;
    }
    fputs(", time reversed, is another periodic orbit, which has the inverse multipliers on the images of the levels: "
          "it repels.", out);
}

static bool add(json_t *words, FILE **out, char **text)
{
    const bool closed = fclose(*out) == 0;
    const bool added = closed && ((*text)[0] == '\0' || json_array_append_new(words, json_string(*text)) == 0);

    free(*text);
    *text = NULL;
    *out = NULL;
    return added;
}

typedef struct {
    const jlt_descriptor *descriptor;
    const json_t *given, *shown;
} subject;

static void sentence(FILE *out, const subject *s, unsigned which)
{
    switch (which) {
    case 0: write_setting(out, s->descriptor, s->given); break;
    case 1: write_orbit(out, s->given, s->shown); break;
    case 2: write_multipliers(out, s->shown); break;
    case 3: write_conditions(out, s->descriptor, s->shown); break;
    case 4:
        fputs("All multipliers lie inside the unit circle, |mu| < 1: the orbit attracts, exponentially and with asymptotic phase, "
              "what begins near it on its levels, and so do its continuations on all levels nearby.", out); break;
    case 5: write_image(out, s->descriptor); break;
    default:
        fputs("Hence no measure that has a continuous positive density is invariant under this flow, nor one that has a density "
              "positive almost everywhere near the orbit and is finite there: a neighbourhood, made up of these basins, shrinks "
              "under the flow to the cycles alone, a set of measure zero.", out); break;
    }
}

json_t *jlt_theorem_words(const char *kind, const jlt_descriptor *descriptor, const json_t *given, const json_t *shown)
{
    const subject s = { descriptor, given, shown };
    const unsigned count = strcmp(kind, "sink") == 0 ? 7 : 4;
    json_t *words = json_array();

    for (unsigned i = 0; words != NULL && i < count; i++) {
        char *text = NULL;
        size_t size = 0;
        FILE *out = open_memstream(&text, &size);
        if (out != NULL) sentence(out, &s, i);
        if (out == NULL || !add(words, &out, &text)) {
            json_decref(words);
            words = NULL;
        }
    }
    return words;
}
