#include "validated/theorem_sentence.h"

#include <stdint.h>

const char *jlt_theorem_text(const json_t *value)
{
    const char *text = json_string_value(value);

    return text == NULL ? "?" : text;
}

const char *jlt_theorem_text_of(const json_t *object, const char *key)
{
    return jlt_theorem_text(json_object_get(object, key));
}

void jlt_theorem_text_ball(FILE *out, const json_t *ball)
{
    if (json_is_string(ball)) fputs(json_string_value(ball), out);
    else fprintf(out, "%s +- %s", jlt_theorem_text_of(ball, "middle"), jlt_theorem_text_of(ball, "radius"));
}

void jlt_theorem_text_named(FILE *out, const json_t *values)
{
    const char *name, *between = "";
    json_t *value;

    json_object_foreach((json_t *)(uintptr_t)values, name, value) {
        fprintf(out, "%s%s = ", between, name);
        jlt_theorem_text_ball(out, value);
        between = ", ";
    }
}

void jlt_theorem_text_flips(FILE *out, const json_t *flipped)
{
    for (size_t i = 0; i < json_array_size(flipped); i++) {
        const char *name = jlt_theorem_text(json_array_get(flipped, i));
        fprintf(out, "%s%s -> -%s", i == 0 ? "" : ", ", name, name);
    }
}

const char *jlt_theorem_text_levels(const jlt_theorem_subject *subject, const char *words)
{
    return json_object_size(json_object_get(subject->given, "levels")) > 0 ? words : "";
}
