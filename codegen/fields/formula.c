/* Writing constants and expressions, as C or as formulas for readers.
 * mpfr.h must precede FLINT's headers: FLINT 3 declares fmpq_get_mpfr only if it is included before. */
#include <mpfr.h>

#include "fields/formula.h"

#include <math.h>
#include <stdlib.h>

static bool is_exact_integer(const fmpz_t n) { return fmpz_bits(n) <= 53; }

static void add_integer(ttc_text *text, const fmpz_t n, const char *suffix)
{
    char *digits = fmpz_get_str(NULL, 10, n);
    text->failed |= digits == NULL;
    if (digits != NULL) ttc_text_format(text, "%s%s", digits, suffix);
    flint_free(digits);
}

static double rounded(const fmpq_t value)
{
    mpfr_t number;
    mpfr_init2(number, 53);
    fmpq_get_mpfr(number, value, MPFR_RNDN);
    double d = mpfr_get_d(number, MPFR_RNDN);
    mpfr_clear(number);
    return d;
}

bool ttc_constant_fits(const fmpq_t value) { return fmpq_is_zero(value) || isnormal(rounded(value)); }

void ttc_emit_constant(ttc_text *text, const fmpq_t value)
{
    const fmpz *up = fmpq_numref(value), *down = fmpq_denref(value);
    if (is_exact_integer(up) && is_exact_integer(down)) {
        bool bracket = !fmpz_is_one(down) || fmpz_sgn(up) < 0;
        if (bracket) ttc_text_add(text, "(");
        add_integer(text, up, ".0");
        if (!fmpz_is_one(down)) {
            ttc_text_add(text, " / ");
            add_integer(text, down, ".0");
        }
        if (bracket) ttc_text_add(text, ")");
        return;
    }
    double d = rounded(value);
    text->failed |= !isnormal(d);
    ttc_text_format(text, d < 0 ? "(%a)" : "%a", d);
}

typedef struct {
    ttc_text *text;
    const ttc_graph *graph;
    ttc_symbol_writer symbol;
    void *context;
    bool is_code;
} writer;

static void write_expression(const writer *w, ttc_id id);

static void write_number(const writer *w, const fmpq *value)
{
    if (w->is_code) {
        ttc_emit_constant(w->text, value);
        return;
    }
    add_integer(w->text, fmpq_numref(value), "");
    if (fmpz_is_one(fmpq_denref(value))) return;
    ttc_text_add(w->text, "/");
    add_integer(w->text, fmpq_denref(value), "");
}

static void write_base(const writer *w, ttc_id id)
{
    bool bracket = ttc_kind_of(w->graph, id) != TTC_SYMBOL;
    if (bracket) ttc_text_add(w->text, "(");
    write_expression(w, id);
    if (bracket) ttc_text_add(w->text, ")");
}

/* base^exponent, exponent > 0 */
static void write_power(const writer *w, ttc_id base, int32_t exponent)
{
    if (!w->is_code) {
        write_base(w, base);
        if (exponent > 1) ttc_text_format(w->text, "^%d", (int)exponent);
        return;
    }
    for (int32_t e = 0; e < exponent; e++) {
        if (e > 0) ttc_text_add(w->text, "*");
        write_base(w, base);
    }
}

/* scale * product, scale > 0 */
static void write_product(const writer *w, ttc_id id, const fmpq *scale)
{
    size_t down = 0;
    bool started = !fmpq_is_one(scale);
    if (started) write_number(w, scale);
    for (size_t i = 0; i < ttc_part_count(w->graph, id); i++) {
        ttc_part part = ttc_part_at(w->graph, id, i);
        if (part.exponent < 0) {
            down += (size_t)(part.exponent < -1 && w->is_code ? 2 : 1);
            continue;
        }
        if (started) ttc_text_add(w->text, "*");
        write_power(w, part.id, part.exponent);
        started = true;
    }
    if (down == 0) return;
    if (!started) ttc_text_add(w->text, w->is_code ? "1.0" : "1");
    ttc_text_add(w->text, "/");
    if (down > 1) ttc_text_add(w->text, "(");
    started = false;
    for (size_t i = 0; i < ttc_part_count(w->graph, id); i++) {
        ttc_part part = ttc_part_at(w->graph, id, i);
        if (part.exponent > 0) continue;
        if (started) ttc_text_add(w->text, "*");
        write_power(w, part.id, -part.exponent);
        started = true;
    }
    if (down > 1) ttc_text_add(w->text, ")");
}

static void write_term(const writer *w, ttc_id id, const fmpq *coefficient, bool is_first)
{
    fmpq_t size;
    fmpq_init(size);
    fmpq_set(size, coefficient);
    if (id != TTC_NONE && ttc_kind_of(w->graph, id) == TTC_PRODUCT) fmpq_mul(size, size, ttc_coefficient(w->graph, id));
    bool negative = fmpq_sgn(size) < 0;
    fmpq_abs(size, size);
    ttc_text_add(w->text, is_first ? (negative ? "-" : "") : negative ? " - " : " + ");
    if (id == TTC_NONE) {
        write_number(w, size);
    } else if (ttc_kind_of(w->graph, id) == TTC_PRODUCT) {
        write_product(w, id, size);
    } else {
        if (!fmpq_is_one(size)) {
            write_number(w, size);
            ttc_text_add(w->text, "*");
        }
        write_base(w, id);
    }
    fmpq_clear(size);
}

static void write_expression(const writer *w, ttc_id id)
{
    fmpq_t one;
    fmpq_init(one);
    fmpq_one(one);
    switch (ttc_kind_of(w->graph, id)) {
    case TTC_NUMBER: write_term(w, TTC_NONE, ttc_coefficient(w->graph, id), true); break;
    case TTC_SYMBOL: w->symbol(w->context, w->text, ttc_symbol_of(w->graph, id)); break;
    case TTC_PRODUCT: write_term(w, id, one, true); break;
    case TTC_SUM: {
        bool has_constant = !fmpq_is_zero(ttc_coefficient(w->graph, id));
        if (has_constant) write_term(w, TTC_NONE, ttc_coefficient(w->graph, id), true);
        for (size_t i = 0; i < ttc_part_count(w->graph, id); i++) {
            ttc_part part = ttc_part_at(w->graph, id, i);
            write_term(w, part.id, part.coefficient, i == 0 && !has_constant);
        }
        break;
    }
    }
    fmpq_clear(one);
}

void ttc_emit_expression(ttc_text *text, const ttc_graph *graph, ttc_id id, ttc_symbol_writer symbol, void *context)
{
    const writer w = { text, graph, symbol, context, true };
    write_expression(&w, id);
}

void ttc_emit_formula(ttc_text *text, const ttc_graph *graph, ttc_id id, ttc_symbol_writer symbol, void *context)
{
    const writer w = { text, graph, symbol, context, false };
    write_expression(&w, id);
}

void ttc_emit_symbol_name(void *context, ttc_text *text, uint32_t symbol)
{
    const ttc_field *field = context;
    ttc_text_add(text, field->symbols[symbol].name);
}

void ttc_emit_condition(ttc_text *text, ttc_field *field, const ttc_bindings *bindings)
{
    for (size_t i = 0; i < bindings->count; i++) {
        ttc_text_format(text, "%s%s = ", i == 0 ? "" : ", ", field->model->symbols[bindings->items[i].symbol].name);
        ttc_emit_formula(text, field->graph, bindings->items[i].expression, ttc_emit_symbol_name, field);
    }
}
