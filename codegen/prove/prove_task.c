#include "prove/question.h"
#include "prove/subcase.h"

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
