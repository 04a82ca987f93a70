#include "validated/theorem_sentence.h"

#include "kernel/descriptor.h"

#include <stdbool.h>
#include <stdint.h>

static void write_box(FILE *out, const json_t *box)
{
    const char *name, *between = "";
    json_t *value;

    json_object_foreach((json_t *)(uintptr_t)box, name, value) {
        fprintf(out, "%s%s ", between, name);
        if (json_is_object(value))
            fprintf(out, "in [%s, %s]", jlt_theorem_text_of(value, "low"), jlt_theorem_text_of(value, "high"));
        else fprintf(out, "= %s", jlt_theorem_text(value));
        between = ", ";
    }
}

void jlt_theorem_family_setting(FILE *out, const jlt_theorem_subject *s)
{
    const jlt_descriptor *d = s->descriptor;
    const json_t *given = s->given;
    const jlt_claim *claim = jlt_descriptor_claim(d, "equilibria", jlt_theorem_text_of(given, "family"));
    const json_t *claims = json_object_get(s->shown, "claims");
    const char *name, *between = "";
    json_t *value;

    fprintf(out, "Take the equations of the table %s (%s%sSHA-256 %s) and its family of equilibria %s", d->model, d->title,
            d->title[0] != '\0' ? "; " : "", d->sha256, jlt_theorem_text_of(given, "family"));
    if (claim != NULL && claim->condition[0] != '\0') fprintf(out, ", where %s", claim->condition);
    fputs(", with all values ", out);
    write_box(out, json_object_get(given, "box"));
    fputs(" in the table's domain at which the family is defined, such as ", out);
    json_object_foreach(json_object_get(s->shown, "point"), name, value) {
        fprintf(out, "%s%s = %s", between, name, jlt_theorem_text(value));
        between = ", ";
    }
    fputs(". Each is an equilibrium. This rests on proved claims of the table: ", out);
    for (size_t i = 0; i < json_array_size(claims); i++)
        fprintf(out, "%s%s", i == 0 ? "" : ", ", jlt_theorem_text(json_array_get(claims, i)));
    fputc('.', out);
}

void jlt_theorem_family_trace(FILE *out, const jlt_theorem_subject *s)
{
    const json_t *trace = json_object_get(s->shown, "trace");
    const char *low = jlt_theorem_text_of(trace, "low"), *high = jlt_theorem_text_of(trace, "high");
    const bool is_negative = low[0] == '-';

    fprintf(out, "At each of them the trace of the linearization, div f, lies between %s and %s: it is %s.", low, high,
            is_negative ? "negative" : "positive");
    if (!is_negative) fputs(" So an eigenvalue has a positive real part: each of them is unstable.", out);
}

void jlt_theorem_family_measure(FILE *out, const jlt_theorem_subject *s)
{
    (void)s;
    fputs(
        "Hence, whichever of these equilibria is x, no measure is invariant under the flow at its parameters that has a density "
        "rho which near x is continuous and positive, nor one which there lies between two positive numbers: rho(phi_t y) det "
        "Dphi_t(y) = rho(y) would hold for almost every y near x. A continuous rho gives rho(x) det Dphi_t(x) = rho(x) as y goes "
        "to x, but det Dphi_t(x) = exp(t div f(x)), which is not 1 where t is not 0; and it goes to 0 or to infinity with t, "
        "against the bounds.",
        out);
}
