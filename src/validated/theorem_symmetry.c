#include "validated/theorem_sentence.h"

#include <stdbool.h>
#include <string.h>

static const struct {
    const char *type, *words;
} verdicts[] = {
    { "elliptic", "It is elliptic: |trace DP| < 2, so that the multipliers are exp(+- 2 pi i rho) on the unit circle, with the "
                  "rotation number rho = arccos(trace DP/2)/(2 pi) = " },
    { "hyperbolic", "It is hyperbolic: trace DP > 2, so that one multiplier is above 1, and the other one its inverse" },
    { "inverse hyperbolic", "It is inverse hyperbolic: trace DP < -2, so that one multiplier is below -1, and the other one its "
                            "inverse" },
    { "not settled", "Whether it is elliptic or hyperbolic is not settled: |trace DP| may be 2" },
};

void jlt_theorem_symmetry_write(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *symmetry = json_object_get(s->shown, "symmetry");
    const json_t *flipped = json_object_get(symmetry, "reversor"), *rotation = json_object_get(symmetry, "rotation");
    const bool many = json_array_size(json_object_get(s->given, "legs")) > 1;

    fputs("The orbit is its own mirror image under the reversor ", out);
    jlt_theorem_text_flips(out, flipped);
    fprintf(out, ", which maps the section%s: its image passes through the same box%s after the same time%s. So DP%s is "
                 "conjugate to its inverse, and det DP = 1 exactly. ",
            json_object_size(json_object_get(s->given, "levels")) > 0 ? " and the levels to themselves" : " to itself",
            many ? "es" : "", many ? "s" : "", jlt_theorem_text_levels(s, " on the levels"));
    for (size_t i = 0; i < sizeof verdicts / sizeof *verdicts; i++)
        if (strcmp(verdicts[i].type, jlt_theorem_text_of(symmetry, "type")) == 0) fputs(verdicts[i].words, out);
    if (rotation != NULL) jlt_theorem_text_ball(out, rotation);
    fputc('.', out);
}

void jlt_theorem_symmetry_write_twist(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *twist = json_object_get(s->shown, "twist");
    const char *on_levels = jlt_theorem_text_levels(s, " on its levels");

    fprintf(out, "No multiplier is a root of unity of order 1 to 4. So by an analytic change of coordinates the return map%s is "
            "z -> z exp(i (2 pi rho + beta |z|^2)) + O(|z|^4), where |z| is to first order the amplitude of ",
            jlt_theorem_text_levels(s, " on these levels"));
    fputs(jlt_theorem_text_of(twist, "coordinate"), out);
    fputs(", with beta = ", out);
    jlt_theorem_text_ball(out, json_object_get(twist, "coefficient"));
    fprintf(out, ", which is not 0. Hence, by the theorem on invariant curves of reversible analytic maps (J. Moser, Stable and "
            "Random Motions, 1973; M. B. Sevryuk, Reversible Systems, 1986), the orbit is surrounded%s by invariant tori, as "
            "closely as one wishes, with quasi-periodic motion on them. They fill a part of each neighbourhood on the section that "
            "tends to all of it as the neighbourhood shrinks. What begins between two of them remains there: the orbit is "
            "stable%s.", on_levels, on_levels);
}
