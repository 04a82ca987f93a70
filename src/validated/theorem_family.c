#include "validated/theorem_family.h"

#include "kernel/descriptor.h"

#include <stdbool.h>
#include <stdint.h>

static const char *or_unknown(const json_t *value)
{
    const char *text = json_string_value(value);

    return text == NULL ? "?" : text;
}

static const char *text_of(const json_t *object, const char *key)
{
    return or_unknown(json_object_get(object, key));
}

static void write_box(FILE *out, const json_t *box)
{
    const char *name, *between = "";
    json_t *value;

    json_object_foreach((json_t *)(uintptr_t)box, name, value) {
        if (json_is_object(value)) fprintf(out, "%s%s in [%s, %s]", between, name, text_of(value, "low"), text_of(value, "high"));
        else fprintf(out, "%s%s = %s", between, name, text_of(box, name));
        between = ", ";
    }
}

void jlt_theorem_family_setting(FILE *out, const jlt_descriptor *d, const json_t *given, const json_t *shown)
{
    const jlt_claim *claim = jlt_descriptor_claim(d, "equilibria", text_of(given, "family"));
    const json_t *claims = json_object_get(shown, "claims");
    const char *name, *between = "";
    json_t *value;

    fprintf(out, "Take the equations of the table %s (%s%sSHA-256 %s) and its family of equilibria %s", d->model, d->title,
            d->title[0] != '\0' ? "; " : "", d->sha256, text_of(given, "family"));
    if (claim != NULL && claim->condition[0] != '\0') fprintf(out, ", where %s", claim->condition);
    fputs(", with all values ", out);
    write_box(out, json_object_get(given, "box"));
    fputs(" in the table's domain at which the family is defined, such as ", out);
    json_object_foreach((json_t *)(uintptr_t)json_object_get(shown, "point"), name, value) {
        fprintf(out, "%s%s = %s", between, name, text_of(json_object_get(shown, "point"), name));
        between = ", ";
    }
    fputs(". Each is an equilibrium. This rests on proved claims of the table: ", out);
    for (size_t i = 0; i < json_array_size(claims); i++)
        fprintf(out, "%s%s", i == 0 ? "" : ", ", or_unknown(json_array_get(claims, i)));
    fputc('.', out);
}

void jlt_theorem_family_trace(FILE *out, const json_t *shown)
{
    const json_t *trace = json_object_get(shown, "trace");
    const bool is_negative = text_of(trace, "low")[0] == '-';

    fprintf(out, "At each of them the trace of the linearization, div f, lies between %s and %s: it is %s.", text_of(trace, "low"),
            text_of(trace, "high"), is_negative ? "negative" : "positive");
    if (!is_negative) fputs(" So an eigenvalue has a positive real part: each of them is unstable.", out);
}

void jlt_theorem_family_measure(FILE *out)
{
    fputs(
        "Hence, whichever of these equilibria is x, no measure is invariant under the flow at its parameters that has a density "
        "rho which near x is continuous and positive, nor one which there lies between two positive numbers: rho(phi_t y) det "
        "Dphi_t(y) = rho(y) would hold for almost every y near x. A continuous rho gives rho(x) det Dphi_t(x) = rho(x) as y goes "
        "to x, but det Dphi_t(x) = exp(t div f(x)), which is not 1 where t is not 0; and it goes to 0 or to infinity with t, "
        "against the bounds.",
        out);
}
