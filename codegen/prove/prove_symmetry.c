/* Provers of maps that take motions to motions: reversors, which reverse time, symmetries and periods. A map S is affine in the
 * states; with the field f, f(S x) = -DS f(x) for a reversor, f(S x) = DS f(x) for the others. */
#include "prove/domain.h"
#include "prove/prove_image.h"

#include <stdio.h>
#include <stdlib.h>

/* Enter the model at the image of a point: states bound to their images, other symbols to themselves. Roots are evaluated in the
 * field first, so that those at the image are expressed through them. NULL, and the claim not settled, when memory is out. */
static ttc_valuation *enter_image(ttc_task *task, const ttc_bindings *bindings)
{
    const ttc_model *model = task->model;
    ttc_ratio root;
    ttc_ratio_init(task->ring, &root);
    for (size_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_ROOT) ttc_evaluate(task->field, &root, model->symbols[i].node);
    ttc_ratio_clear(task->ring, &root);
    ttc_valuation *map = ttc_task_enter_map(task, model, task->field);
    if (map == NULL) return NULL;
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        ttc_symbol_kind kind = model->symbols[i].kind;
        if (kind == TTC_PARAM || kind == TTC_STATE || kind == TTC_LEVEL || kind == TTC_LAMBDA || kind == TTC_PI)
            ttc_valuation_bind(map, i, model->symbols[i].node);
    }
    for (size_t i = 0; i < bindings->count; i++) ttc_valuation_bind(map, bindings->items[i].symbol, bindings->items[i].expression);
    return map;
}

static ttc_id image_of_state(const ttc_task *task, size_t state)
{
    uint32_t symbol = task->model->states[state];
    for (size_t i = 0; i < task->claim->bindings.count; i++)
        if (task->claim->bindings.items[i].symbol == symbol) return task->claim->bindings.items[i].expression;
    return task->model->symbols[symbol].node;
}

/* Returns true if a ratio does not depend on states, directly or through functions. */
static bool is_fixed(ttc_task *task, const ttc_ratio *value)
{
    for (size_t v = 0; v < task->ring->variable_count; v++) {
        if (!ttc_ratio_uses(task->ring, value, (slong)v)) continue;
        const size_t symbol = ttc_valuation_symbol(task->field, (slong)v);
        if (symbol >= task->model->symbol_count) continue;
        const ttc_symbol_entry *entry = &task->model->symbols[symbol];
        for (size_t i = 0; i < task->model->state_count; i++)
            if (ttc_model_depends(task->model, entry->node, task->model->states[i])) return false;
    }
    return true;
}

/* matrix = DS, shape (state_count, state_count). The claim is not settled if the map is not affine. */
static void set_matrix(ttc_task *task, ttc_ratio *matrix)
{
    const size_t n = task->model->state_count;
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n && ttc_task_open(task); j++) {
            ttc_evaluate(task->field, &matrix[i * n + j], ttc_derive_state(task->model, image_of_state(task, i), j));
            if (ttc_task_open(task) && !is_fixed(task, &matrix[i * n + j]))
                ttc_task_unsettle(task, "the image of %s is not affine in the states",
                                task->model->symbols[task->model->states[i]].name);
        }
}

static void swap_rows(ttc_ratio *matrix, size_t n, size_t a, size_t b)
{
    for (size_t j = 0; j < n; j++) {
        ttc_ratio kept = matrix[a * n + j];
        matrix[a * n + j] = matrix[b * n + j];
        matrix[b * n + j] = kept;
    }
}

/* The determinant up to its sign, by elimination, which overwrites the matrix. */
static void set_determinant(ttc_task *task, ttc_ratio *determinant, ttc_ratio *matrix)
{
    ttc_ring *ring = task->ring;
    const size_t n = task->model->state_count;
    ttc_ratio factor, term;
    ttc_ratio_init(ring, &factor);
    ttc_ratio_init(ring, &term);
    ttc_ratio_set_integer(ring, determinant, 1);
    for (size_t k = 0; k < n && ttc_task_open(task); k++) {
        size_t pivot = k;
        while (pivot < n && ttc_ratio_is_zero(ring, &matrix[pivot * n + k])) pivot++;
        if (pivot == n) {
            ttc_ratio_set_integer(ring, determinant, 0);
            break;
        }
        if (pivot != k) swap_rows(matrix, n, pivot, k);
        ttc_ratio_multiply(ring, determinant, determinant, &matrix[k * n + k]);
        for (size_t i = k + 1; i < n; i++) {
            if (ttc_ratio_is_zero(ring, &matrix[i * n + k])) continue;
            ttc_ratio_divide(ring, &factor, &matrix[i * n + k], &matrix[k * n + k]);
            for (size_t j = k; j < n; j++) {
                ttc_ratio_multiply(ring, &term, &factor, &matrix[k * n + j]);
                ttc_ratio_subtract(ring, &matrix[i * n + j], &matrix[i * n + j], &term);
            }
        }
    }
    ttc_ratio_clear(ring, &term);
    ttc_ratio_clear(ring, &factor);
}

static bool is_identity(const ttc_task *task)
{
    for (size_t i = 0; i < task->model->state_count; i++)
        if (image_of_state(task, i) != task->model->symbols[task->model->states[i]].node) return false;
    return true;
}

/* Require that a symmetry has an inverse, and that a reversor is its own inverse. */
static void check_inverse(ttc_task *task, ttc_valuation *map, ttc_ratio *matrix)
{
    const ttc_model *model = task->model;
    if (task->claim->kind != TTC_CLAIM_REVERSOR) {
        ttc_ratio determinant;
        ttc_ratio_init(task->ring, &determinant);
        set_determinant(task, &determinant, matrix);
        ttc_task_require(task, &determinant, TTC_IS_NONZERO, "the map has no inverse: its determinant");
        ttc_ratio_clear(task->ring, &determinant);
        return;
    }
    for (size_t i = 0; i < model->state_count && ttc_task_open(task); i++) {
        const ttc_symbol_entry *state = &model->symbols[model->states[i]];
        ttc_task_require_equal(task, map, image_of_state(task, i), task->field, state->node, "S(S(%s)) - %s", state->name,
                               state->name);
    }
}

typedef struct {
    ttc_task *task;
    ttc_valuation *map;
    bool fails;
} image_of_symbols;

static bool is_moved(const ttc_task *task, uint32_t symbol)
{
    const ttc_model *model = task->model;
    for (size_t i = 0; i < model->state_count; i++)
        if (image_of_state(task, i) != model->symbols[model->states[i]].node
            && ttc_model_depends(model, model->symbols[symbol].node, model->states[i]))
            return true;
    return false;
}

/* The root of the table that has at each point the value of this one at the image; TTC_NONE: none is known. */
static ttc_id exchanged_root(ttc_task *task, ttc_valuation *map, uint32_t symbol)
{
    const ttc_model *model = task->model;
    ttc_id found = TTC_NONE;
    ttc_ratio value, other;
    ttc_ratio_init(task->ring, &value);
    ttc_ratio_init(task->ring, &other);
    ttc_evaluate(map, &value, model->symbols[symbol].node);
    for (size_t i = 0; found == TTC_NONE && i < model->symbol_count; i++) {
        if (model->symbols[i].kind != TTC_ROOT) continue;
        ttc_evaluate(task->field, &other, model->symbols[i].node);
        if (ttc_task_open(task) && ttc_ratio_equal(task->ring, &value, &other)) found = model->symbols[i].node;
    }
    ttc_ratio_clear(task->ring, &other);
    ttc_ratio_clear(task->ring, &value);
    return found;
}

static ttc_id image_of_symbol(void *context, uint32_t symbol)
{
    image_of_symbols *at = context;
    const ttc_model *model = at->task->model;
    for (size_t i = 0; i < model->state_count; i++)
        if (model->states[i] == symbol) return image_of_state(at->task, i);
    if (!ttc_symbol_is_function(model->symbols[symbol].kind) || !is_moved(at->task, symbol)) return TTC_NONE;
    const ttc_id found = model->symbols[symbol].kind == TTC_ROOT ? exchanged_root(at->task, at->map, symbol) : TTC_NONE;
    at->fails |= found == TTC_NONE;
    return found;
}

/* Returns true if f(S x) -+ DS f(x) could be written as an expression, as S moves no function, or exchanges roots: it is then
 * required to be zero. */
static bool require_as_expression(ttc_task *task, ttc_valuation *map, size_t state, bool reverses, const char *what)
{
    ttc_graph *graph = task->model->graph;
    image_of_symbols at = { task, map, false };
    const ttc_id field = ttc_model_expand(task->model, ttc_model_field(task->model, state));
    const ttc_id left = ttc_substitute(graph, field, image_of_symbol, &at);
    const ttc_id right = ttc_derive_field(task->model, image_of_state(task, state));
    if (at.fails || left == TTC_NONE || !ttc_task_open(task)) return false;
    ttc_task_require_identity(task, left, reverses ? ttc_subtract(graph, ttc_integer(graph, 0), right) : right, what);
    return true;
}

static void check_field(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *model = task->model;
    const bool reverses = task->claim->kind == TTC_CLAIM_REVERSOR;
    char what[160];
    ttc_ratio left, right;
    ttc_ratio_init(task->ring, &left);
    ttc_ratio_init(task->ring, &right);
    for (size_t i = 0; i < model->state_count && ttc_task_open(task); i++) {
        const char *name = model->symbols[model->states[i]].name;
        snprintf(what, sizeof what, reverses ? "f(Sx) + S f(x) in %s" : "f(Sx) - S f(x) in %s", name);
        if (require_as_expression(task, map, i, reverses, what)) continue;
        ttc_evaluate(map, &left, ttc_model_field(model, i));
        ttc_evaluate(task->field, &right, ttc_derive_field(model, image_of_state(task, i)));
        if (reverses) ttc_ratio_add(task->ring, &left, &left, &right);
        else ttc_ratio_subtract(task->ring, &left, &left, &right);
        ttc_task_require_zero(task, &left, "%s", what);
    }
    ttc_ratio_clear(task->ring, &right);
    ttc_ratio_clear(task->ring, &left);
}

/* Returns true if an image uses a function of states: it is then refused, even if it is affine on some leaf. */
static bool uses_functions_of_states(const ttc_model *model, ttc_id image)
{
    unsigned char *support = ttc_model_support(model, &image, 1);
    bool result = support == NULL;
    for (size_t i = 0; !result && i < model->symbol_count; i++) {
        if (!support[i] || !ttc_symbol_is_function(model->symbols[i].kind)) continue;
        for (size_t k = 0; !result && k < model->state_count; k++)
            result = ttc_model_depends(model, model->symbols[i].node, model->states[k]);
    }
    free(support);
    return result;
}

/* Require that a point of the domain, moved back by the period, lies in the domain. */
static void check_back(ttc_task *task)
{
    const ttc_model *model = task->model;
    ttc_binding back = task->claim->bindings.items[0];
    const ttc_id state = model->symbols[back.symbol].node;
    back.expression = ttc_subtract(model->graph, state, ttc_subtract(model->graph, back.expression, state));
    if (back.expression == TTC_NONE) ttc_task_unsettle(task, "out of memory");
    ttc_valuation *map = ttc_task_open(task) ? enter_image(task, &(ttc_bindings){ .items = &back, .count = 1 }) : NULL;
    if (map == NULL) return;
    ttc_domain_require_image(task, map, " a period before");
    ttc_task_leave_map(task);
}

/* Require that what holds the model valid is the same after the state has grown by its period: a section identifies such states. */
static void check_validities(ttc_task *task, ttc_valuation *map)
{
    const ttc_model *model = task->model;
    for (size_t i = 0; i < model->validity_count; i++) {
        const ttc_validity *valid = model->validities + i;
        ttc_task_require_equal(task, map, valid->expression, task->field, valid->expression, "valid %s a period of %s on - %s",
                               valid->name, task->claim->name, valid->name);
    }
}

static void prove_map(ttc_task *task)
{
    for (size_t i = 0; i < task->claim->bindings.count; i++)
        if (uses_functions_of_states(task->model, task->claim->bindings.items[i].expression))
            ttc_task_unsettle(task, "the image of %s is not affine in the states",
                              task->model->symbols[task->claim->bindings.items[i].symbol].name);
    if (!ttc_task_open(task)) return;
    const size_t entries = task->model->state_count * task->model->state_count;
    if (task->claim->kind == TTC_CLAIM_PERIODIC) check_back(task);
    ttc_valuation *map = enter_image(task, &task->claim->bindings);
    if (map == NULL) return;
    /* First, before the image's roots are in the ring, where they count as positive. */
    ttc_domain_require_image(task, map, " at the image");
    ttc_ratio *matrix = ttc_task_ratios(task, entries);
    if (matrix != NULL) {
        set_matrix(task, matrix);
        check_inverse(task, map, matrix);
        check_field(task, map);
        if (task->claim->kind == TTC_CLAIM_PERIODIC) check_validities(task, map);
    }
    ttc_task_free(task, matrix, entries);
    ttc_task_leave_map(task);
    ttc_task_refute_map_at_point(task);
}

void ttc_prove_reversor(ttc_task *task)
{
    if (ttc_task_restricts_states(task)) ttc_task_unsettle(task, "a reversor acts on an open set of states");
    else prove_map(task);
}

void ttc_prove_symmetry(ttc_task *task)
{
    if (ttc_task_restricts_states(task)) ttc_task_unsettle(task, "a symmetry acts on an open set of states");
    else if (is_identity(task)) ttc_task_unsettle(task, "every state stays as it is, which says nothing");
    else prove_map(task);
}

/* Require that an integral has the same value after the state has grown by its period. */
static void require_period(ttc_task *task, const ttc_claim *period, const ttc_claim *integral)
{
    ttc_valuation *map = enter_image(task, &period->bindings);
    if (map == NULL) return;
    ttc_task_require_equal(task, map, integral->expression, task->field, integral->expression, "%s a period of %s on - %s",
                           integral->name, period->name, integral->name);
    ttc_task_leave_map(task);
}

void ttc_prove_level_is_periodic(ttc_task *task, const ttc_claim *integral, uint32_t but)
{
    for (size_t i = 0; i < task->model->claim_count && ttc_task_open(task); i++) {
        const ttc_claim *claim = task->model->claims + i;
        if (claim->kind == TTC_CLAIM_PERIODIC && claim->bindings.items[0].symbol != but) require_period(task, claim, integral);
    }
}

static void prove_level(ttc_task *task) { ttc_prove_level_is_periodic(task, task->claim, UINT32_MAX); }

bool ttc_prove_turns(const ttc_model *model, ttc_id quantity, const ttc_bindings *when)
{
    const ttc_claim claim = { .kind = TTC_CLAIM_EQUAL, .name = "it", .expression = quantity, .when = *when };
    ttc_task task = { .model = model, .claim = &claim, .role = TTC_DIVIDES_FIELD };
    bool has_period = false;
    for (size_t i = 0; i < model->claim_count; i++) has_period |= model->claims[i].kind == TTC_CLAIM_PERIODIC;
    if (!has_period) return true;
    ttc_task_run(&task, prove_level);
    free(task.remainder);
    free(task.point);
    free(task.note);
    return task.status == TTC_PROVED;
}
