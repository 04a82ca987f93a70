/* Refutations at one point, in ball arithmetic and without algebra: where a remainder cannot be computed, its value still can. */
#include "prove/prove_task.h"

#include "ball/ball.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Set a ball evaluator to a point of the leaf. Returns false if a value is not known. */
static bool set_ball(ttc_ball *ball, ttc_task *task, ttc_witness *point)
{
    enum { PRECISION = 2048 };
    bool ok = true;
    ttc_ratio value;
    arb_t enclosure;
    ttc_ratio_init(task->ring, &value);
    arb_init(enclosure);
    for (uint32_t i = 0; ok && i < task->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &task->model->symbols[i];
        if (entry->kind != TTC_PARAM && entry->kind != TTC_STATE && entry->kind != TTC_LEVEL) continue;
        ttc_evaluate(task->field, &value, entry->node);
        ttc_witness_enclose(enclosure, point, &value, PRECISION);
        ok = task->ring->status == TTC_RING_OK && arb_is_finite(enclosure);
        if (ok) ttc_ball_set_ball(ball, i, enclosure);
    }
    arb_clear(enclosure);
    ttc_ratio_clear(task->ring, &value);
    return ok;
}

/* Returns true if an expression is not zero at one of some points of the leaf. text, where: NULL, or get its value and that
 * point. */
static bool is_not_zero_at_point(ttc_task *task, ttc_id id, char **text, char **where)
{
    enum { DIGITS = 12, POINTS = 8 }; /* points, as the value may be zero at some by chance */
    bool excludes_zero = false;
    unsigned attempt = 0;
    ttc_witness point;
    ttc_ball *ball = ttc_ball_create(task->model);
    bool found = ttc_witness_init(&point, task->field) && ball != NULL
                 && (ttc_search_next(&point, &task->domain, &attempt)
                     || ttc_search_point(&point, &task->domain) == TTC_POINT_FOUND);
    for (unsigned i = 0; found && !excludes_zero && i < POINTS; i++) {
        char *value = set_ball(ball, task, &point) ? ttc_ball_text(ball, id, DIGITS, &excludes_zero) : NULL;
        if (excludes_zero && where != NULL) *where = ttc_witness_text(&point);
        if (excludes_zero && text != NULL) *text = value;
        else free(value);
        if (!excludes_zero) found = ttc_search_next(&point, &task->domain, &attempt);
    }
    ttc_witness_clear(&point);
    ttc_ball_destroy(ball);
    return excludes_zero;
}

unsigned ttc_task_signs_at_points(ttc_task *task, ttc_id id)
{
    enum { ATTEMPTS = 6 };
    unsigned signs = 0;
    ttc_witness point;
    ttc_ball *ball = ttc_ball_create(task->model);
    const bool ok = ttc_witness_init(&point, task->field) && ball != NULL;
    for (unsigned i = 0; ok && i < ATTEMPTS; i++) {
        if (!ttc_search_attempt(&point, &task->domain, i) || !set_ball(ball, task, &point)) continue;
        const int sign = ttc_ball_sign(ball, id);
        signs |= sign > 0 ? TTC_CAN_BE_POSITIVE : sign < 0 ? TTC_CAN_BE_NEGATIVE : 0;
    }
    ttc_witness_clear(&point);
    ttc_ball_destroy(ball);
    return signs;
}

bool ttc_task_refute_at_point(ttc_task *task, ttc_id id, const char *name)
{
    const ttc_ring_status status = task->ring->status;
    char *value = NULL, *where = NULL;
    if (task->status != TTC_PROVED || id == TTC_NONE || task->has_left_out) return false;
    task->ring->status = TTC_RING_OK;
    if (is_not_zero_at_point(task, id, &value, &where)) {
        ttc_task_refute_at(task, where, NULL, "%s = %s", name, value);
        free(value);
        return true;
    }
    task->ring->status = status;
    return false;
}

/* Returns true if the points of the leaf are an open set of states. */
static bool is_open_in_states(const ttc_task *task)
{
    for (size_t i = 0; i < task->model->state_count; i++)
        if (ttc_valuation_is_bound(task->field, task->model->states[i])) return false;
    return task->claim->modulo_count == 0 && task->level_count == 0 && !ttc_task_restricts_states(task);
}

/* Returns true if an expression has one form on the whole leaf, whatever the signs of roots whose radicand is a square. */
static bool has_one_form(ttc_task *task, ttc_id id)
{
    const ttc_model *model = task->model;
    ttc_ratio root;
    ttc_ratio_init(task->ring, &root);
    for (uint32_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_ROOT && ttc_model_depends(model, id, i))
            ttc_evaluate(task->field, &root, model->symbols[i].node);
    ttc_ratio_clear(task->ring, &root);
    return ttc_task_open(task) && task->ring->choice_count == 0;
}

bool ttc_task_moves_at_point(ttc_task *task, ttc_id id)
{
    const ttc_model *model = task->model;
    bool moves = false;
    if (!ttc_task_open(task) || !is_open_in_states(task) || !has_one_form(task, id)) return false;
    for (size_t j = 0; !moves && j < model->state_count; j++) {
        const ttc_id slope = ttc_derive_state(model, id, j);
        moves = slope != TTC_NONE && !ttc_is_number(model->graph, slope, 0) && is_not_zero_at_point(task, slope, NULL, NULL);
    }
    return moves;
}

/* Set the evaluator `image` to the image of a point under the claim's map; the evaluator `ball` is at the point itself. */
static bool set_image(ttc_ball *image, ttc_ball *ball, ttc_task *task, ttc_witness *point)
{
    const ttc_bindings *map = &task->claim->bindings;
    bool ok = set_ball(image, task, point);
    arb_t value;
    arb_init(value);
    for (size_t i = 0; ok && i < map->count; i++) {
        ok = ttc_ball_value(value, ball, map->items[i].expression);
        if (ok) ttc_ball_set_ball(image, map->items[i].symbol, value);
    }
    arb_clear(value);
    return ok;
}

/* Returns true if left at the image is not the right side at the point; text then gets the difference. */
static bool differs(ttc_ball *image, ttc_id left, ttc_ball *ball, ttc_id right, char **text)
{
    enum { PRECISION = 256, DIGITS = 12 };
    arb_t difference, value;
    arb_init(difference);
    arb_init(value);
    const bool found = ttc_ball_value(difference, image, left) && ttc_ball_value(value, ball, right);
    arb_sub(difference, difference, value, PRECISION);
    const bool is_other = found && !arb_contains_zero(difference);
    char *written = is_other ? arb_get_str(difference, DIGITS, ARB_STR_MORE) : NULL;
    if (is_other) *text = strdup(written);
    flint_free(written);
    arb_clear(value);
    arb_clear(difference);
    return is_other;
}

static bool refute_map_at(ttc_task *task, ttc_ball *image, ttc_ball *ball, ttc_witness *point)
{
    const ttc_model *model = task->model;
    const bool reverses = task->claim->kind == TTC_CLAIM_REVERSOR, is_period = task->claim->kind == TTC_CLAIM_PERIODIC;
    char *text = NULL;
    for (size_t i = 0; i < model->state_count; i++) {
        const ttc_symbol_entry *state = model->symbols + model->states[i];
        ttc_id right = state->node;
        for (size_t k = 0; k < task->claim->bindings.count; k++)
            if (task->claim->bindings.items[k].symbol == model->states[i]) right = task->claim->bindings.items[k].expression;
        right = ttc_derive_field(model, right);
        if (reverses) right = ttc_subtract(model->graph, ttc_integer(model->graph, 0), right);
        if (!differs(image, ttc_model_field(model, i), ball, right, &text)) continue;
        ttc_task_refute_at(task, ttc_witness_text(point), NULL, "f(Sx) %c S f(x) in %s = %s", reverses ? '+' : '-', state->name,
                           text == NULL ? "" : text);
        free(text);
        return true;
    }
    for (size_t i = 0; is_period && i < model->validity_count; i++) {
        const ttc_validity *valid = model->validities + i;
        if (!differs(image, valid->expression, ball, valid->expression, &text)) continue;
        ttc_task_refute_at(task, ttc_witness_text(point), NULL, "valid %s a period of %s on - %s = %s", valid->name,
                           task->claim->name, valid->name, text == NULL ? "" : text);
        free(text);
        return true;
    }
    return false;
}

void ttc_task_refute_map_at_point(ttc_task *task)
{
    enum { POINTS = 8 };
    const ttc_ring_status status = task->ring->status;
    if (task->status != TTC_PROVED || status == TTC_RING_OK || task->has_left_out || task->domain.failed) return;
    task->ring->status = TTC_RING_OK;
    unsigned attempt = 0;
    bool refuted = false;
    ttc_witness point;
    ttc_ball *ball = ttc_ball_create(task->model), *image = ttc_ball_create(task->model);
    bool found = ttc_witness_init(&point, task->field) && ball != NULL && image != NULL;
    for (unsigned i = 0; found && !refuted && i < POINTS; i++) {
        found = ttc_search_next(&point, &task->domain, &attempt);
        refuted = found && set_ball(ball, task, &point) && set_image(image, ball, task, &point) &&
                  refute_map_at(task, image, ball, &point);
    }
    ttc_witness_clear(&point);
    ttc_ball_destroy(image);
    ttc_ball_destroy(ball);
    if (!refuted) task->ring->status = status;
}
