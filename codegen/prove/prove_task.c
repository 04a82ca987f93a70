#include "prove/question.h"
#include "prove/subcase.h"

#include "ball/ball.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REMAINDER_LIMIT = 4000 /* characters kept of a remainder */ };

static char *format_text(const char *format, va_list arguments)
{
    va_list copy;
    va_copy(copy, arguments);
    int length = vsnprintf(NULL, 0, format, copy);
    va_end(copy);
    char *text = length < 0 ? NULL : malloc((size_t)length + 1);
    if (text != NULL) vsnprintf(text, (size_t)length + 1, format, arguments);
    return text;
}

/* "what = value", for free(); takes ownership of what. */
static char *with_value(ttc_task *task, char *what, const ttc_ratio *ratio)
{
    char *value = ratio == NULL || what == NULL ? NULL : ttc_ratio_text(task->ring, ratio);
    if (value == NULL) return what;
    size_t shown = strlen(value) > REMAINDER_LIMIT ? REMAINDER_LIMIT : strlen(value);
    size_t size = strlen(what) + shown + 64;
    char *text = malloc(size);
    if (text != NULL)
        snprintf(text, size, "%s = %.*s%s", what, (int)shown, value, shown < strlen(value) ? " ... (cut)" : "");
    free(value);
    free(what);
    return text;
}

static void settle(ttc_task *task, ttc_proof_status status, char *remainder, char *point)
{
    if (task->exhibited) { /* a claim of existence stays proved */
        free(remainder);
        free(point);
        return;
    }
    task->status = status;
    free(task->remainder);
    free(task->point);
    task->remainder = remainder;
    task->point = point;
}

void ttc_task_unsettle(ttc_task *task, const char *format, ...)
{
    if (task->status != TTC_PROVED) return;
    va_list arguments;
    va_start(arguments, format);
    settle(task, TTC_UNSETTLED, format_text(format, arguments), NULL);
    va_end(arguments);
}

void ttc_task_adopt(ttc_task *task, ttc_task *other)
{
    task->relies_on_solver |= other->relies_on_solver;
    if (other->status != TTC_PROVED) {
        settle(task, other->status, other->remainder, other->point);
    } else {
        free(other->remainder);
        free(other->point);
    }
    free(other->note);
    other->remainder = other->point = other->note = NULL;
}

bool ttc_task_open(const ttc_task *task)
{
    return task->status == TTC_PROVED && task->ring->status == TTC_RING_OK;
}

ttc_valuation *ttc_task_enter_map(ttc_task *task, const ttc_model *model, ttc_valuation *base)
{
    ttc_valuation *map = ttc_valuation_map(model, base);
    if (map == NULL) ttc_task_unsettle(task, "out of memory");
    else task->maps[task->map_count++] = map;
    return map;
}

void ttc_task_leave_map(ttc_task *task) { ttc_valuation_destroy(task->maps[--task->map_count]); }

void ttc_task_refute(ttc_task *task, const ttc_ratio *remainder, const char *format, ...)
{
    char *point = NULL;
    if (!ttc_task_open(task)) return;
    if (ttc_task_search(task, NULL, TTC_IS_ZERO, &point) != TTC_POINT_FOUND) {
        ttc_task_unsettle(task, "false in one case of its conditions, in which no point of the domain is known");
        return;
    }
    va_list arguments;
    va_start(arguments, format);
    settle(task, TTC_REFUTED, with_value(task, format_text(format, arguments), remainder), point);
    va_end(arguments);
}

void ttc_task_refute_at(ttc_task *task, char *point, const ttc_ratio *remainder, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    settle(task, TTC_REFUTED, with_value(task, format_text(format, arguments), remainder), point);
    va_end(arguments);
}

static void require_zero(ttc_task *task, const ttc_ratio *remainder, const char *format, va_list arguments)
{
    char *point = NULL;
    /* Zero in form is enough; that it is not zero is shown at a point, whatever is known of exponentials and logarithms. */
    if (!ttc_task_open(task) || fmpz_mpoly_is_zero(remainder->numerator, task->ring->context)) return;
    ttc_search_result result = ttc_task_search_against(task, remainder, TTC_IS_ZERO, &point);
    if (result == TTC_POINT_IMPOSSIBLE || result == TTC_POINT_EXCLUDED) return;
    char *what = with_value(task, format_text(format, arguments), remainder);
    if (result == TTC_POINT_FOUND) {
        settle(task, TTC_REFUTED, what, point);
        return;
    }
    ttc_task_unsettle(task, "%s, which is not zero identically; no point of the domain was found at which it is not zero",
                      what == NULL ? "" : what);
    free(what);
}

void ttc_task_require_zero(ttc_task *task, const ttc_ratio *remainder, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    require_zero(task, remainder, format, arguments);
    va_end(arguments);
}

void ttc_task_require_equal(ttc_task *task, ttc_valuation *of_left, ttc_id left, ttc_valuation *of_right, ttc_id right,
                            const char *format, ...)
{
    ttc_ratio difference;
    va_list arguments;
    ttc_ratio_init(task->ring, &difference);
    ttc_evaluate(of_left, &difference, left);
    ttc_task_take_off(task, &difference, of_right, right);
    va_start(arguments, format);
    require_zero(task, &difference, format, arguments);
    va_end(arguments);
    ttc_ratio_clear(task->ring, &difference);
}

void ttc_task_take_off(ttc_task *task, ttc_ratio *out, ttc_valuation *valuation, ttc_id id)
{
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(valuation, &value, id);
    ttc_ratio_subtract(task->ring, out, out, &value);
    ttc_ratio_clear(task->ring, &value);
}

void ttc_task_require(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, const char *format, ...)
{
    char *point = NULL;
    if (!ttc_task_open(task)) return;
    ttc_search_result result = ttc_task_search_against(task, ratio, relation, &point);
    if (result == TTC_POINT_IMPOSSIBLE || result == TTC_POINT_EXCLUDED) return;
    va_list arguments;
    va_start(arguments, format);
    char *what = with_value(task, format_text(format, arguments), ratio);
    va_end(arguments);
    if (result == TTC_POINT_FOUND && !task->has_left_out) {
        settle(task, TTC_REFUTED, what, point);
        return;
    }
    free(point);
    if (task->unexcluded == TTC_NONE && relation != TTC_IS_NONNEGATIVE)
        task->unexcluded = ttc_task_expression(task, ratio->numerator);
    ttc_task_unsettle(task, "%s: %s", what == NULL ? "" : what,
                      result == TTC_POINT_FOUND
                          ? "false at a point that may lie outside the domain: conditions with a root or logarithm in question do "
                            "not count here, so write a 'domain' record without it"
                          : "neither shown nor refuted at a point");
    free(what);
}

const ttc_claim *ttc_task_family(const ttc_task *task)
{
    switch (task->claim->kind) {
    case TTC_CLAIM_EQUILIBRIA: return task->claim;
    case TTC_CLAIM_TRACE:
    case TTC_CLAIM_CHARPOLY:
    case TTC_CLAIM_OBSTRUCTS:
    case TTC_CLAIM_MATRIX:
    case TTC_CLAIM_LEFT_NULL: return &task->model->claims[task->claim->family];
    default: return NULL;
    }
}

void ttc_task_jacobian(ttc_task *task, ttc_ratio *out, size_t row, size_t column)
{
    ttc_id entry = ttc_derive_state(task->model, ttc_model_field(task->model, row), column);
    ttc_evaluate(task->field, out, entry);
}

static size_t root_count(const ttc_model *model)
{
    size_t count = 0;
    for (size_t i = 0; i < model->symbol_count; i++) count += model->symbols[i].kind == TTC_ROOT;
    return count;
}

void ttc_task_shorten(ttc_task *task, const char *form)
{
    char *value = task->status == TTC_REFUTED && task->remainder != NULL ? strstr(task->remainder, " = ") : NULL;
    if (form != NULL && value != NULL && strlen(form) < strlen(value + 3)) strcpy(value + 3, form);
}

/* Set a ball evaluator to a point, and bind the symbols of `when` to their expressions. Returns false if others are bound. */
static bool set_ball(ttc_ball *ball, ttc_task *task, const ttc_witness *point)
{
    bool ok = true;
    size_t bound_count = 0;
    for (uint32_t i = 0; i < task->model->symbol_count && ok; i++) {
        const ttc_symbol_kind kind = task->model->symbols[i].kind;
        const bool is_bound = ttc_valuation_is_bound(task->field, i);
        bound_count += is_bound;
        if ((kind != TTC_PARAM && kind != TTC_STATE && kind != TTC_LEVEL) || is_bound) continue;
        char *value = fmpq_get_str(NULL, 10, point->values + ttc_valuation_variable(task->field, i));
        ok = ttc_ball_set_fraction(ball, i, value);
        flint_free(value);
    }
    for (size_t i = 0; i < task->claim->when.count; i++)
        ttc_ball_bind(ball, task->claim->when.items[i].symbol, task->claim->when.items[i].expression);
    return ok && bound_count == task->claim->when.count;
}

/* Below this number of roots algebra is quick enough. */
enum { MANY_ROOTS = 5 };

/* Shift all free values of a point, each by another amount: the first point found often has values that are equal. */
static void shift_point(ttc_witness *point, unsigned times)
{
    fmpq_t shift;
    fmpq_init(shift);
    for (size_t v = 0; v < point->ring->variable_count; v++) {
        if (!ttc_witness_is_free(point, (slong)v)) continue;
        fmpq_set_si(shift, (slong)((v + 1) * (v + 1) * times % 23), 64);
        fmpq_add(point->values + v, point->values + v, shift);
    }
    fmpq_clear(shift);
    ttc_witness_changed(point);
}

/* Returns true if an expression is not zero at a point that meets the conditions of the leaf, in ball arithmetic. text, where:
 * NULL, or get the value and the point. */
static bool is_not_zero_at_point(ttc_task *task, ttc_id id, char **text, char **where)
{
    enum { DIGITS = 12, POINTS = 4 };
    bool excludes_zero = false;
    ttc_ball *ball = ttc_ball_create(task->model);
    ttc_witness point;
    const bool found = ttc_witness_init(&point, task->field) && ball != NULL &&
                       ttc_search_point(&point, &task->domain) == TTC_POINT_FOUND;
    for (unsigned times = 0; found && !excludes_zero && times < POINTS; times++) {
        if (times > 0) shift_point(&point, times);
        if (ttc_witness_meets_all(&point, &task->domain) != TTC_HOLDS || ttc_witness_sines(&point) != TTC_HOLDS) continue;
        if (!set_ball(ball, task, &point)) break;
        char *value = ttc_ball_text(ball, id, DIGITS, &excludes_zero);
        excludes_zero = value != NULL && excludes_zero;
        if (excludes_zero && where != NULL) *where = ttc_witness_text(&point);
        if (excludes_zero && text != NULL) *text = value;
        else free(value);
    }
    ttc_witness_clear(&point);
    ttc_ball_destroy(ball);
    return excludes_zero;
}

bool ttc_task_refute_at_point(ttc_task *task, ttc_id id, const char *name)
{
    char *value = NULL, *where = NULL;
    if (!ttc_task_open(task) || root_count(task->model) < MANY_ROOTS || id == TTC_NONE) return false;
    if (!is_not_zero_at_point(task, id, &value, &where)) return false;
    char *text = malloc(strlen(name) + strlen(value) + 8);
    if (text != NULL) sprintf(text, "%s = %s", name, value);
    settle(task, TTC_REFUTED, text, where);
    free(value);
    return true;
}

bool ttc_task_moves_at_point(ttc_task *task, ttc_id id)
{
    const ttc_model *model = task->model;
    bool moves = false;
    if (!ttc_task_open(task) || root_count(model) < MANY_ROOTS) return false;
    ttc_ratio root;
    ttc_ratio_init(task->ring, &root);
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_ROOT && ttc_model_depends(model, id, i))
            ttc_evaluate(task->field, &root, model->symbols[i].node);
    ttc_ratio_clear(task->ring, &root);
    if (task->ring->choice_count > 0) return false; /* it may be constant for one sign of a root */
    for (size_t j = 0; !moves && j < model->state_count; j++) {
        const ttc_id slope = ttc_derive_state(model, id, j);
        moves = slope != TTC_NONE && slope != ttc_integer(model->graph, 0) && is_not_zero_at_point(task, slope, NULL, NULL);
    }
    return moves;
}

ttc_ratio *ttc_task_ratios(ttc_task *task, size_t count)
{
    ttc_ratio *ratios = malloc((count + 1) * sizeof *ratios);
    if (ratios == NULL) {
        ttc_task_unsettle(task, "out of memory");
        return NULL;
    }
    for (size_t i = 0; i < count; i++) ttc_ratio_init(task->ring, &ratios[i]);
    return ratios;
}

void ttc_task_free(ttc_task *task, ttc_ratio *ratios, size_t count)
{
    if (ratios == NULL) return;
    for (size_t i = 0; i < count; i++) ttc_ratio_clear(task->ring, &ratios[i]);
    free(ratios);
}
