/* Writes the divisors of the equations, roots and logarithms as the table has them, before anything cancels; they are nonzero in
 * the domain. A kernel in which a divisor cancels shows nothing of its zeros, so starts are checked against these values. Also the
 * divisors of integrals and densities in parameters alone, and parameters with which they vanish: where these do, no kernel can be
 * prepared. */
#include "emit/emit.h"

#include <stdlib.h>

#include "base/array.h"
#include "show/print.h"

typedef struct {
    const ttc_claim *claim; /* the claim that divides by it; NULL: the domain excludes its zeros */
    ttc_id written;         /* as the table writes it */
    ttc_id outputs[2];      /* in the field's symbols, and `squares` of it, or of a radicand `radicand_squares` */
} factor;

typedef struct {
    ttc_field *field;
    factor *factors;
    size_t count;
    bool failed;
} factor_list;

/* The expression with each number and symbol squared: a value far below the square root of this is lost in rounding. */
static ttc_id squares(ttc_graph *graph, ttc_id id)
{
    ttc_id result;
    fmpq_t square;
    if (id == TTC_NONE || ttc_kind_of(graph, id) == TTC_SYMBOL) return ttc_power(graph, id, 2);
    fmpq_init(square);
    fmpq_mul(square, ttc_coefficient(graph, id), ttc_coefficient(graph, id));
    result = ttc_number(graph, square);
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const ttc_id below = squares(graph, part.id);
        fmpq_mul(square, part.coefficient, part.coefficient);
        result = ttc_kind_of(graph, id) == TTC_SUM ? ttc_add(graph, result, ttc_scale(graph, below, square))
                                                   : ttc_multiply(graph, result, ttc_power(graph, below, part.exponent));
    }
    fmpq_clear(square);
    return result;
}

/* Whether no term of a radicand is negative, as in a sum of squares: it can only touch zero, within all other conditions. */
static bool has_no_negative_term(ttc_field *field, ttc_id radicand)
{
    ttc_graph *graph = field->graph;
    const ttc_id id = ttc_field_specialise(field, radicand);
    if (id == TTC_NONE) return false;
    if (ttc_kind_of(graph, id) != TTC_SUM) return ttc_extent_is_nonnegative(ttc_field_extent(field, id));
    bool good = fmpq_sgn(ttc_coefficient(graph, id)) >= 0;
    for (size_t i = 0; good && i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const ttc_extent term = ttc_field_extent(field, part.id);
        good = fmpq_sgn(part.coefficient) > 0 ? ttc_extent_is_nonnegative(term) : ttc_extent_is_nonpositive(term);
    }
    return good;
}

/* A radicand without negative terms, with the base of every even power replaced by the root of its `squares`. Rounding errors of
 * the bases leave a radicand that should be zero at about this times the square of the unit roundoff. */
static ttc_id rounded(ttc_graph *graph, ttc_id id)
{
    const bool is_sum = id != TTC_NONE && ttc_kind_of(graph, id) == TTC_SUM;
    if (!is_sum && (id == TTC_NONE || ttc_kind_of(graph, id) != TTC_PRODUCT)) return id;
    ttc_id result = ttc_number(graph, ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        if (is_sum) result = ttc_add(graph, result, ttc_scale(graph, rounded(graph, part.id), part.coefficient));
        else if (part.exponent % 2 != 0) result = ttc_multiply(graph, result, ttc_power(graph, part.id, part.exponent));
        else result = ttc_multiply(graph, result, ttc_power(graph, squares(graph, part.id), part.exponent / 2));
    }
    return result;
}

/* What is put out for a radicand in place of `squares`, so that the root of the radicand, not itself, is compared with rounding. */
static ttc_id radicand_squares(ttc_graph *graph, ttc_id id) { return ttc_multiply(graph, id, rounded(graph, id)); }

static void add_factor(factor_list *list, const ttc_claim *claim, ttc_id written, bool is_radicand)
{
    ttc_graph *graph = list->field->graph;
    if (ttc_kind_of(graph, written) == TTC_PRODUCT) {
        for (size_t i = 0; i < ttc_part_count(graph, written); i++)
            add_factor(list, claim, ttc_part_at(graph, written, i).id, is_radicand);
        return;
    }
    const ttc_id id = ttc_field_specialise(list->field, written);
    list->failed |= id == TTC_NONE;
    if (!list->failed && ttc_kind_of(graph, id) == TTC_SYMBOL) {
        const ttc_symbol_entry *symbol = list->field->model->symbols + ttc_symbol_of(graph, id);
        if (symbol->kind == TTC_ROOT && has_no_negative_term(list->field, symbol->definition)) {
            add_factor(list, claim, symbol->definition, true);
            return;
        }
    }
    if (list->failed || (ttc_field_extent(list->field, id).signs & TTC_SIGN_ZERO) == 0) return;
    if (claim != NULL && !ttc_field_is_constant(list->field, id)) {
        const ttc_symbol_entry *param = ttc_model_zero_divisor(list->field->model, written);
        if (param != NULL) add_factor(list, claim, param->node, false);
        return;
    }
    for (size_t i = 0; i < list->count; i++)
        if (list->factors[i].outputs[0] == id) return;
    const ttc_id sum = is_radicand ? radicand_squares(graph, id) : squares(graph, id);
    if (sum == TTC_NONE) ttc_graph_clear_error(graph); /* a power exceeds the graph's limits: leave it out */
    if (sum == TTC_NONE) return;
    list->failed |= !TTC_ARRAY_GROW(list->factors, list->count);
    if (list->failed) return;
    list->factors[list->count++] = (factor){ claim, written, { id, sum } };
}

static bool find_factors(factor_list *list)
{
    const ttc_model *model = list->field->model;
    unsigned char *used = ttc_model_uses_of_domain(model);
    list->failed = used == NULL;
    for (size_t i = 0; !list->failed && i < model->divisor_count; i++) {
        const ttc_divisor *d = model->divisors + i;
        if (d->role == TTC_DIVIDES_FIELD || (d->role == TTC_DIVIDES_SYMBOL && used[d->owner]))
            add_factor(list, NULL, d->divisor, false);
    }
    for (size_t i = 0; !list->failed && i < model->divisor_count; i++)
        for (uint32_t k = 0; !list->failed && k < model->claim_count; k++)
            if (ttc_model_prepares(model, k, model->divisors + i))
                add_factor(list, model->claims + k, model->divisors[i].divisor, false);
    free(used);
    return !list->failed;
}

/* The condition that a divisor is not zero; general words if that is too long. */
static void add_text(ttc_text *text, const ttc_model *model, ttc_id id)
{
    char *written = ttc_print_relation(model, id, " != 0");
    ttc_text_add_escaped(text, written != NULL ? written : "what it divides by to be other than 0");
    free(written);
}

static bool add_factors(ttc_text *text, factor_list *list)
{
    ttc_field *field = list->field;
    ttc_id *outputs = calloc(2 * list->count, sizeof *outputs);
    bool good = outputs != NULL;
    for (size_t i = 0; good && i < 2 * list->count; i++) outputs[i] = list->factors[i / 2].outputs[i % 2];
    good = good && ttc_emit_outputs(text, "divisor_values", field, outputs, 2 * list->count);
    free(outputs);
    ttc_text_add(text, "static const jlt_region divisors[] = {\n");
    for (size_t i = 0; good && i < list->count; i++) {
        const ttc_claim *claim = list->factors[i].claim;
        if (claim == NULL) ttc_text_add(text, "    { \"a division\", \"");
        else ttc_text_format(text, "    { \"the %s %s\", \"", ttc_claim_kind_name(claim->kind), claim->name);
        add_text(text, field->model, list->factors[i].written);
        ttc_text_format(text, "\", %d },\n", ttc_field_is_constant(field, list->factors[i].outputs[0]));
    }
    ttc_text_add(text, "};\n\n");
    return good;
}

bool ttc_emit_divisors(ttc_text *text, ttc_field *field, size_t *count)
{
    factor_list list = { .field = field };
    *count = 0;
    if (!ttc_field_is_general(field) || ttc_field_lifted_count(field) > 0) return true;
    const bool good = find_factors(&list) && (list.count == 0 || add_factors(text, &list));
    *count = list.count;
    free(list.factors);
    return good;
}
