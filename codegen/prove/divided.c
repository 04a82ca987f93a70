#include "prove/divided.h"

#include "algebra/independence.h"
#include "prove/domain.h"

#include <stdlib.h>

/* Flags, by divisor of the table, of those that the claim alone brings in, for free(); NULL: none, or not asked of this claim. */
static unsigned char *divisors_of(ttc_task *task, const ttc_subcase *leaf)
{
    const bool is_given = task->role == TTC_DIVIDES_VARIANT && task->claim->when.count > 0; /* asked without `when` */
    if (task->claim->kind == TTC_CLAIM_EQUILIBRIA || leaf->is_degenerate || is_given) return NULL;
    if (task->role == TTC_DIVIDES_FIELD || task->role == TTC_DIVIDES_LIFT) return NULL;
    unsigned char *of_claim = ttc_domain_divisors_of_claim(task);
    bool some = false;
    if (of_claim == NULL) ttc_task_unsettle(task, "out of memory");
    for (size_t i = 0; of_claim != NULL && !some && i < task->model->divisor_count; i++) some = of_claim[i] != 0;
    if (some) return of_claim;
    free(of_claim);
    return NULL;
}

bool ttc_divided_by_zero(ttc_task *task, const ttc_subcase *leaf, char **at)
{
    unsigned char *divisors = divisors_of(task, leaf);
    if (divisors == NULL) return false;
    /* Search in the same field, in which roots have the signs of this leaf; the failure of its ring is due to the claim alone. */
    const ttc_ring_status failed = task->ring->status;
    ttc_conditions whole = task->domain;
    bool divided = false;
    task->ring->status = TTC_RING_OK;
    ttc_conditions_init(&task->domain, task->field);
    ttc_subcase_add_conditions(task, leaf);
    ttc_domain_add(task, &task->domain, TTC_DOMAIN_WITHOUT_CLAIM);
    if (task->ring->status == TTC_RING_OK && !task->domain.contradictory) {
        const ttc_search_result result = ttc_task_search(task, NULL, TTC_IS_ZERO, at);
        divided = result == TTC_POINT_FOUND || result == TTC_POINT_NOT_DECIDED;
    }
    divided |= task->ring->status != TTC_RING_OK && !ttc_ring_has_no_value(task->ring->status);
    ttc_conditions_clear(&task->domain);
    task->domain = whole;
    task->ring->status = failed;
    free(divisors);
    return divided;
}

bool ttc_divided_perhaps(ttc_task *task, const ttc_subcase *leaf)
{
    unsigned char *divisors = divisors_of(task, leaf);
    bool perhaps = false;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; divisors != NULL && !perhaps && i < task->model->divisor_count; i++) {
        if (!divisors[i] || task->ring->status != TTC_RING_OK) continue;
        ttc_evaluate(task->field, &value, task->model->divisors[i].divisor);
        perhaps = task->ring->status == TTC_RING_OK && !ttc_ring_settles(task->ring, value.numerator);
    }
    ttc_ratio_clear(task->ring, &value);
    free(divisors);
    return perhaps;
}
