/* The text of a witness: rational coordinates exactly, others as expressions in roots, or by digits. */
#include "algebra/witness.h"

#include <flint/fmpq_mpoly.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    ttc_witness *point;
    FILE *stream;
    fmpq_mpoly_ctx_t context;
    unsigned char *used, *written; /* by variable: a root that the text uses; one that the text has defined */
} description;

/* Substitute the rational values of the point into a polynomial. */
static void put_in(description *d, fmpq_mpoly_t out, const fmpz_mpoly_t polynomial)
{
    const fmpz_mpoly_ctx_struct *context = d->point->ring->context;
    slong count = (slong)d->point->ring->variable_count;
    ulong *exponents = calloc((size_t)count + 1, sizeof *exponents);
    fmpq_t value, factor;
    fmpq_init(value);
    fmpq_init(factor);
    fmpq_mpoly_zero(out, d->context);
    for (slong i = 0; exponents != NULL && i < fmpz_mpoly_length(polynomial, context); i++) {
        fmpq_one(value);
        fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(value), polynomial, i, context);
        for (slong v = 0; v < count; v++) {
            exponents[v] = fmpz_mpoly_get_term_var_exp_ui(polynomial, i, v, context);
            if (exponents[v] == 0 || !ttc_witness_coordinate(factor, d->point, v)) continue;
            fmpq_pow_si(factor, factor, (slong)exponents[v]);
            fmpq_mul(value, value, factor);
            exponents[v] = 0;
        }
        fmpq_mpoly_push_term_fmpq_ui(out, value, exponents, d->context);
    }
    fmpq_mpoly_sort_terms(out, d->context);
    fmpq_mpoly_combine_like_terms(out, d->context);
    fmpq_clear(factor);
    fmpq_clear(value);
    free(exponents);
}

/* Mark the roots of a polynomial as used. Returns false if it has variables that are no roots, such as angles. */
static bool note_roots(description *d, const fmpq_mpoly_t polynomial)
{
    bool roots_alone = true;
    for (slong v = 0; v < (slong)d->point->ring->variable_count; v++) {
        if (fmpq_mpoly_degree_si(polynomial, v, d->context) < 1) continue;
        if (ttc_ring_generator(d->point->ring, v) != NULL) d->used[v] = 1;
        else roots_alone = false;
    }
    return roots_alone;
}

static void write_digits(description *d, const ttc_ratio *ratio)
{
    enum { PRECISION = 128, DIGITS = 17 };
    arb_t ball;
    arb_init(ball);
    ttc_witness_enclose(ball, d->point, ratio, PRECISION);
    char *digits = arb_get_str(ball, DIGITS, ARB_STR_NO_RADIUS);
    fprintf(d->stream, "%s%s", arb_contains_zero(ball) ? "0" : digits, arb_is_int(ball) ? "" : "...");
    flint_free(digits);
    arb_clear(ball);
}

static void write_ratio(description *d, const ttc_ratio *ratio)
{
    fmpq_mpoly_t top, bottom;
    fmpq_t value;
    fmpq_mpoly_init(top, d->context);
    fmpq_mpoly_init(bottom, d->context);
    fmpq_init(value);
    put_in(d, top, ratio->numerator);
    put_in(d, bottom, ratio->denominator);
    if (fmpq_mpoly_is_fmpq(bottom, d->context) && !fmpq_mpoly_is_zero(bottom, d->context)) {
        fmpq_mpoly_get_fmpq(value, bottom, d->context);
        fmpq_mpoly_scalar_div_fmpq(top, top, value, d->context);
        fmpq_mpoly_one(bottom, d->context);
    }
    char *above = fmpq_mpoly_get_str_pretty(top, d->point->ring->names, d->context);
    char *below = fmpq_mpoly_get_str_pretty(bottom, d->point->ring->names, d->context);
    if (!note_roots(d, top) || !note_roots(d, bottom)) write_digits(d, ratio);
    else if (fmpq_mpoly_is_one(bottom, d->context)) fputs(above, d->stream);
    else fprintf(d->stream, "(%s)/(%s)", above, below);
    flint_free(below);
    flint_free(above);
    fmpq_clear(value);
    fmpq_mpoly_clear(bottom, d->context);
    fmpq_mpoly_clear(top, d->context);
}

/* Write the definitions of all used roots, and of roots that these use in turn. */
static void explain_roots(description *d)
{
    const ttc_ring *ring = d->point->ring;
    for (bool again = true; again;) {
        again = false;
        for (size_t i = 0; i < ring->generator_count; i++) {
            slong v = ring->generators[i].variable;
            if (!d->used[v] || d->written[v]) continue;
            d->written[v] = 1;
            again = true;
            bool negative = !ring->generators[i].positive && (d->point->negative >> i & 1);
            fprintf(d->stream, "%s%s = %ssqrt(", ftell(d->stream) > 0 ? ", " : "", ring->names[v], negative ? "-" : "");
            write_ratio(d, &ring->generators[i].square);
            fputc(')', d->stream);
        }
    }
}

/* Returns true if the symbol's variable is itself an irrational root, bound by a level; it is then defined with the other roots. */
static bool is_root_itself(description *d, uint32_t symbol)
{
    slong variable = ttc_valuation_variable(d->point->valuation, symbol);
    fmpq_t value;
    fmpq_init(value);
    bool irrational = variable >= 0 && ttc_ring_generator(d->point->ring, variable) != NULL &&
                      !ttc_witness_coordinate(value, d->point, variable);
    if (irrational) d->used[variable] = 1;
    fmpq_clear(value);
    return irrational;
}

static void write_coordinates(description *d)
{
    const ttc_model *model = ttc_valuation_model(d->point->valuation);
    ttc_ratio value;
    ttc_ratio_init(d->point->ring, &value);
    for (uint32_t i = 0; i < model->symbol_count && d->point->ring->status == TTC_RING_OK; i++) {
        ttc_symbol_kind kind = model->symbols[i].kind;
        if (kind != TTC_PARAM && kind != TTC_STATE && kind != TTC_LEVEL) continue;
        ttc_evaluate(d->point->valuation, &value, model->symbols[i].node);
        if (is_root_itself(d, i)) continue;
        fprintf(d->stream, "%s%s = ", ftell(d->stream) > 0 ? ", " : "", model->symbols[i].name);
        write_ratio(d, &value);
    }
    for (uint32_t i = (uint32_t)model->symbol_count; i < model->symbol_count + TTC_SPARE_SYMBOLS; i++) {
        const char *name = ttc_valuation_name_of(d->point->valuation, i);
        if (name == NULL) continue;
        ttc_ratio_set_variable(d->point->ring, &value, ttc_valuation_variable(d->point->valuation, i));
        fprintf(d->stream, "%s%s = ", ftell(d->stream) > 0 ? ", " : "", name);
        write_ratio(d, &value);
    }
    ttc_ratio_clear(d->point->ring, &value);
}

char *ttc_witness_text(ttc_witness *point)
{
    char *text = NULL;
    size_t size = 0, count = point->ring->variable_count;
    description d = { .point = point, .used = calloc(count + 1, 1), .written = calloc(count + 1, 1) };
    if (d.used != NULL && d.written != NULL) d.stream = open_memstream(&text, &size);
    if (d.stream != NULL) {
        fmpq_mpoly_ctx_init(d.context, (slong)count, ORD_DEGLEX);
        write_coordinates(&d);
        explain_roots(&d);
        fmpq_mpoly_ctx_clear(d.context);
        if (fclose(d.stream) != 0) {
            free(text);
            text = NULL;
        }
    }
    free(d.written);
    free(d.used);
    return text;
}
