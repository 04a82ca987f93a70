/* Levels that are zero only where all their terms are. */
#include "prove/signs.h"
#include "prove/subcase.h"

/* The real points of the level may be too few for their component: its leaves are shown to be kept one by one. They are parts of
 * the level like any other, on which a claim may not divide by zero. */
bool ttc_subcase_split(ttc_subcase *b, ttc_task *task, ttc_id sum)
{
    const ttc_graph *graph = task->model->graph;
    const ttc_claim_kind kind = task->claim->kind;
    const bool counts_points = task->is_lower || kind == TTC_CLAIM_EQUAL || kind == TTC_CLAIM_POSITIVE || kind == TTC_CLAIM_RATE ||
                               kind == TTC_CLAIM_INVARIANT;
    if (sum == TTC_NONE || !counts_points || !ttc_signs_are_one(task, sum)) return false;
    const size_t terms = ttc_part_count(graph, sum);
    if (b->goal_count + terms > sizeof b->goals / sizeof *b->goals) return false;
    for (size_t i = 0; i < terms; i++) b->goals[b->goal_count++] = ttc_part_at(graph, sum, i).id;
    b->is_orphan = true;
    return true;
}
