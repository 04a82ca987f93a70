#include "show/print.h"

#include <stdlib.h>
#include <string.h>

enum { OPERAND_LIMIT = 1000000 };

typedef struct {
    FILE *stream;
    const ttc_model *model;
    ttc_notation notation;
} printer;

static const char *const greek[] = { "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
                                     "lambda", "mu", "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi",
                                     "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi",
                                     "Psi", "Omega" };

/* One part of a name, between underscores. */
static void print_latex_word(FILE *stream, const char *word, size_t length)
{
    for (size_t i = 0; i < sizeof greek / sizeof *greek; i++)
        if (strlen(greek[i]) == length && memcmp(greek[i], word, length) == 0) {
            fprintf(stream, "\\%s", greek[i]);
            return;
        }
    if (length == 1 || (*word >= '0' && *word <= '9')) fprintf(stream, "%.*s", (int)length, word);
    else fprintf(stream, "\\mathrm{%.*s}", (int)length, word);
}

static void print_latex_symbol(FILE *stream, const char *name)
{
    size_t end = strcspn(name, "_"), letters = end;
    while (letters > 1 && name[letters - 1] >= '0' && name[letters - 1] <= '9') letters--;
    print_latex_word(stream, name, letters);
    if (name[letters] == '\0') return;
    fputs("_{", stream);
    if (letters < end) fprintf(stream, "%.*s", (int)(end - letters), name + letters);
    for (const char *at = name + end, *gap = letters < end ? "," : ""; *at != '\0'; gap = ",") {
        at++;
        size_t length = strcspn(at, "_");
        if (length == 0) continue;
        fputs(gap, stream);
        print_latex_word(stream, at, length);
        at += length;
    }
    fputc('}', stream);
}

void ttc_print_name(FILE *stream, const char *name, ttc_notation notation)
{
    if (notation == TTC_NOTATION_LATEX) print_latex_symbol(stream, name);
    else fputs(name, stream);
}

void ttc_print_symbol(FILE *stream, const ttc_model *model, uint32_t symbol, ttc_notation notation)
{
    ttc_print_name(stream, model->symbols[symbol].name, notation);
}

static void print_sum(const printer *p, ttc_id id);

static void print_power(const printer *p, ttc_id base, int32_t exponent)
{
    bool latex = p->notation == TTC_NOTATION_LATEX;
    if (ttc_kind_of(p->model->graph, base) == TTC_SYMBOL) {
        ttc_print_symbol(p->stream, p->model, ttc_symbol_of(p->model->graph, base), p->notation);
    } else {
        fputs(latex ? "\\left(" : "(", p->stream);
        print_sum(p, base);
        fputs(latex ? "\\right)" : ")", p->stream);
    }
    if (exponent != 1) fprintf(p->stream, latex ? "^{%d}" : "^%d", (int)exponent);
}

/* The factors of a SYMBOL or PRODUCT whose exponents have the given sign, after a number that is written unless it is 1
 * and there are factors. Returns how many factors were written, the number counted. */
static size_t print_factors(const printer *p, ttc_id id, int sign, const fmpz *number)
{
    const ttc_graph *graph = p->model->graph;
    const char *times = p->notation == TTC_NOTATION_LATEX ? " " : "*";
    size_t written = 0;
    if (!fmpz_is_one(number)) {
        fmpz_fprint(p->stream, number);
        written++;
    }
    if (id != TTC_NONE && ttc_kind_of(graph, id) == TTC_SYMBOL && sign > 0) {
        if (written++ > 0) fputs(times, p->stream);
        print_power(p, id, 1);
    }
    for (size_t i = 0; id != TTC_NONE && i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        if ((part.exponent > 0) != (sign > 0)) continue;
        if (written++ > 0) fputs(times, p->stream);
        print_power(p, part.id, abs(part.exponent));
    }
    if (written == 0) fputc('1', p->stream);
    return written;
}

static size_t count_denominators(const ttc_graph *graph, ttc_id id, const fmpz *number)
{
    size_t count = fmpz_is_one(number) ? 0 : 1;
    for (size_t i = 0; id != TTC_NONE && i < ttc_part_count(graph, id); i++) count += ttc_part_at(graph, id, i).exponent < 0;
    return count;
}

/* The base of the first factor with a negative exponent, if that is -1. */
static ttc_id lone_denominator(const ttc_graph *graph, ttc_id id)
{
    for (size_t i = 0; id != TTC_NONE && i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        if (part.exponent < 0) return part.exponent == -1 ? part.id : TTC_NONE;
    }
    return TTC_NONE;
}

/* |coefficient| * id, id a SYMBOL, a PRODUCT (its own coefficient apart), or TTC_NONE for 1 */
static void print_product(const printer *p, const fmpq *coefficient, ttc_id id)
{
    bool latex = p->notation == TTC_NOTATION_LATEX;
    fmpz_t numerator;
    fmpz_init(numerator);
    fmpz_abs(numerator, fmpq_numref(coefficient));
    size_t below = count_denominators(p->model->graph, id, fmpq_denref(coefficient));
    if (below > 0 && latex) fputs("\\frac{", p->stream);
    print_factors(p, id, 1, numerator);
    if (below > 0) {
        const ttc_id alone = latex && below == 1 ? lone_denominator(p->model->graph, id) : TTC_NONE;
        fputs(latex ? "}{" : below > 1 ? "/(" : "/", p->stream);
        if (alone != TTC_NONE) print_sum(p, alone); /* the bar serves as brackets */
        else print_factors(p, id, -1, fmpq_denref(coefficient));
        fputs(latex ? "}" : below > 1 ? ")" : "", p->stream);
    }
    fmpz_clear(numerator);
}

static void print_signed(const printer *p, const fmpq *coefficient, ttc_id id, bool first)
{
    bool negative = fmpq_sgn(coefficient) < 0;
    if (first) fputs(negative ? "-" : "", p->stream);
    else fputs(negative ? " - " : " + ", p->stream);
    print_product(p, coefficient, id);
}

static void print_sum(const printer *p, ttc_id id)
{
    const ttc_graph *graph = p->model->graph;
    const fmpq one = { 1, 1 };
    switch (ttc_kind_of(graph, id)) {
    case TTC_NUMBER: print_signed(p, ttc_coefficient(graph, id), TTC_NONE, true); break;
    case TTC_SYMBOL: print_signed(p, &one, id, true); break;
    case TTC_PRODUCT: print_signed(p, ttc_coefficient(graph, id), id, true); break;
    case TTC_SUM:
        for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
            ttc_part part = ttc_part_at(graph, id, i);
            print_signed(p, part.coefficient, part.id, i == 0);
        }
        if (!fmpq_is_zero(ttc_coefficient(graph, id))) print_signed(p, ttc_coefficient(graph, id), TTC_NONE, false);
        break;
    }
}

/* Parts have lower ids than wholes, so one sweep counts operands. */
static bool is_printable(const ttc_graph *graph, ttc_id id)
{
    double *operands = malloc(((size_t)id + 1) * sizeof *operands);
    if (operands == NULL) return false;
    for (ttc_id at = 1; at <= id; at++) {
        operands[at] = 1;
        for (size_t i = 0; i < ttc_part_count(graph, at); i++) operands[at] += operands[ttc_part_at(graph, at, i).id];
    }
    bool result = operands[id] <= OPERAND_LIMIT;
    free(operands);
    return result;
}

bool ttc_print(FILE *stream, const ttc_model *model, ttc_id id, ttc_notation notation)
{
    if (id == TTC_NONE || !is_printable(model->graph, id)) return false;
    printer p = { stream, model, notation };
    print_sum(&p, id);
    return true;
}

char *ttc_print_relation(const ttc_model *model, ttc_id id, const char *relation)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    if (stream == NULL) return NULL;
    const bool printed = ttc_print(stream, model, id, TTC_NOTATION_TEXT) && fputs(relation, stream) >= 0;
    if (fclose(stream) == 0 && printed) return text;
    free(text);
    return NULL;
}
