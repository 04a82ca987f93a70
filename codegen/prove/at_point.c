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

/* Returns true if the claim is refuted as the expression is not zero at this point. */
static bool refute_at(ttc_task *task, ttc_ball *ball, ttc_witness *point, ttc_id id, const char *name)
{
    enum { DIGITS = 12 };
    bool excludes_zero = false;
    char *value = set_ball(ball, task, point) ? ttc_ball_text(ball, id, DIGITS, &excludes_zero) : NULL;
    if (value != NULL && excludes_zero) ttc_task_refute_at(task, ttc_witness_text(point), NULL, "%s = %s", name, value);
    free(value);
    return excludes_zero;
}

bool ttc_task_refute_at_point(ttc_task *task, ttc_id id, const char *name)
{
    enum { POINTS = 8 }; /* the value may be zero at some, by chance */
    const ttc_ring_status status = task->ring->status;
    bool refuted = false;
    unsigned attempt = 0;
    ttc_witness point;
    if (task->status != TTC_PROVED || id == TTC_NONE || task->has_left_out) return false;
    task->ring->status = TTC_RING_OK;
    ttc_ball *ball = ttc_ball_create(task->model);
    if (ttc_witness_init(&point, task->field) && ball != NULL)
        for (unsigned i = 0; i < POINTS && !refuted && ttc_search_next(&point, &task->domain, &attempt); i++)
            refuted = refute_at(task, ball, &point, id, name);
    ttc_witness_clear(&point);
    ttc_ball_destroy(ball);
    if (!refuted) task->ring->status = status;
    return refuted;
}
