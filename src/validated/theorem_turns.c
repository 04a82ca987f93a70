#include "validated/theorem_sentence.h"

#include "read/model.h"

#include <stdlib.h>
#include <string.h>

static json_int_t turns_of(const json_t *legs, size_t leg, const char *state)
{
    return json_integer_value(json_object_get(json_object_get(json_array_get(legs, leg), "turns"), state));
}

static json_int_t sum_of(const json_t *legs, const char *state)
{
    json_int_t sum = 0;

    for (size_t i = 0; i < json_array_size(legs); i++) sum += turns_of(legs, i, state);
    return sum;
}

static bool turns(const json_t *legs, const char *state)
{
    for (size_t i = 0; i < json_array_size(legs); i++)
        if (turns_of(legs, i, state) != 0) return true;
    return false;
}

static unsigned count_turning(const json_t *legs, const jlt_descriptor *d)
{
    unsigned count = 0;

    for (unsigned s = 0; s < d->state_count; s++) count += turns(legs, d->states[s].name);
    return count;
}

bool jlt_theorem_turns_any(const json_t *legs, const jlt_descriptor *descriptor)
{
    return count_turning(legs, descriptor) > 0;
}

/* Write the period of a state as in the table, such as "2*pi". */
static void write_period(FILE *out, const ttc_model *model, unsigned state)
{
    const ttc_symbol_entry *entry = model == NULL ? NULL : &model->symbols[model->states[state]];
    const fmpq *number = entry == NULL || entry->period == TTC_NONE ? NULL : ttc_coefficient(model->graph, entry->period);
    char *text;

    if (number == NULL) fputs("?", out);
    else if (entry->in_pi && fmpq_is_one(number)) fputs("pi", out);
    else {
        text = fmpq_get_str(NULL, 10, number);
        fprintf(out, "%s%s", text, entry->in_pi ? "*pi" : "");
        flint_free(text);
    }
}

/* The separator before part number `part` of a list with `count` parts. */
static const char *before(unsigned part, unsigned count)
{
    return part == 0 ? "" : part + 1 < count ? ", " : " and ";
}

void jlt_theorem_turns_write_all(FILE *out, const json_t *legs, const jlt_descriptor *d)
{
    ttc_model *model = ttc_model_again(d->table, d->model);
    unsigned count = 0, part = 0;

    for (unsigned s = 0; s < d->state_count; s++) count += sum_of(legs, d->states[s].name) != 0;
    for (unsigned s = 0; s < d->state_count; s++) {
        const json_int_t sum = sum_of(legs, d->states[s].name);
        if (sum == 0) continue;
        fprintf(out, "%s%s%s by %" JSON_INTEGER_FORMAT " %s of ", part == 0 ? ", but for " : before(part, count), d->states[s].name,
                part == 0 ? " having grown" : "", sum, sum == 1 || sum == -1 ? "period" : "periods");
        write_period(out, model, s);
        part++;
    }
    if (count > 0) fputc(',', out);
    ttc_model_destroy(model);
}

static bool are_alike(const json_t *legs)
{
    const json_t *first = json_object_get(json_array_get(legs, 0), "turns");

    for (size_t i = 1; i < json_array_size(legs); i++)
        if (!json_equal(first, json_object_get(json_array_get(legs, i), "turns"))) return false;
    return true;
}

void jlt_theorem_turns_write_legs(FILE *out, const json_t *legs, const jlt_descriptor *d)
{
    const bool alike = are_alike(legs);
    const char *between = " but for these periods: ";

    for (size_t i = 0; i < (alike ? 1 : json_array_size(legs)); i++) {
        bool any = false;
        for (unsigned s = 0; s < d->state_count; s++) {
            const json_int_t count = turns_of(legs, i, d->states[s].name);
            if (count == 0) continue;
            fprintf(out, "%s%s %" JSON_INTEGER_FORMAT, any ? " and " : between, d->states[s].name, count);
            any = true;
        }
        if (!any) continue;
        if (alike) fputs(" at the end of each leg", out);
        else fprintf(out, " at the end of leg %zu", i + 1);
        between = ", ";
    }
}

void jlt_theorem_turns_write_sense(FILE *out, const json_t *legs, const jlt_descriptor *d)
{
    const unsigned count = count_turning(legs, d);
    unsigned part = 0;

    if (count == 0) return;
    fprintf(out, " Whether orbits through %s close with other numbers of periods is not said. The table is proved not to see whole "
                 "periods of ", json_array_size(legs) > 1 ? "these boxes" : "this box");
    for (unsigned s = 0; s < d->state_count; s++)
        if (turns(legs, d->states[s].name)) fprintf(out, "%s%s", before(part++, count), d->states[s].name);
    fputs(": in what follows points that differ by them are one, and densities have them as well.", out);
}

void jlt_theorem_turns_write_density(FILE *out, const char *first, const json_t *legs, const jlt_descriptor *d, const char *last)
{
    const unsigned count = count_turning(legs, d);
    ttc_model *model = count > 0 ? ttc_model_again(d->table, d->model) : NULL;
    unsigned part = 0;

    if (count > 0) fprintf(out, "%swith the period%s ", first, count > 1 ? "s" : "");
    for (unsigned s = 0; s < d->state_count; s++) {
        if (!turns(legs, d->states[s].name)) continue;
        fputs(before(part++, count), out);
        write_period(out, model, s);
        fprintf(out, " in %s", d->states[s].name);
    }
    if (count > 0) fputs(last, out);
    ttc_model_destroy(model);
}
