/* The field a claim lives in: substitutions, and the zero levels it is restricted to.
 *
 * A zero level h = 0 is factored; each factor is a branch. On a branch one state becomes a rational function of the others
 * (where the factor is linear in it) or a square root (where quadratic), so a generic point of the branch is reached, and
 * an identity there holds on all of it. What could hide is a component on which the leading coefficient A vanishes as well:
 * it would need A = 0 to cost nothing, so A = h_1 = ... = h_k = 0 is shown to have codimension k + 1 or more. */
#include "prove/branch.h"

#include <flint/fmpz_mpoly_factor.h>

enum { HIDING_DEPTH = 4 };

typedef struct {
    ttc_task *task;
    ttc_prover prover;
    const ttc_id *goals; /* expressions whose zero sets meet */
    size_t goal_count;
    size_t examined;     /* branches on which the claim was put to the proof */
    bool counting;       /* only count the codimension */
    size_t needed;
    bool reached;        /* so far every branch is empty or of the codimension needed */
    unsigned depth;
} search;

static bool codimension_reached(ttc_task *task, const ttc_id *goals, size_t count, size_t needed, unsigned depth);

static void bind_all(ttc_valuation *field, const ttc_bindings *bindings)
{
    for (size_t i = 0; i < bindings->count; i++)
        ttc_valuation_bind(field, bindings->items[i].symbol, bindings->items[i].expression);
}

static bool open_field(ttc_task *task, const ttc_branch *b, unsigned choices)
{
    const ttc_claim *family = ttc_task_family(task);
    task->field = ttc_valuation_create(task->model, choices);
    if (task->field == NULL) return false;
    task->ring = ttc_valuation_ring(task->field);
    bind_all(task->field, &task->claim->when);
    if (family != NULL && family != task->claim) bind_all(task->field, &family->when);
    if (family != NULL) bind_all(task->field, &family->bindings);
    for (size_t i = 0; i < b->solution_count; i++)
        if (b->solutions[i].square)
            ttc_valuation_bind_square(task->field, b->solutions[i].symbol, b->solutions[i].expression);
        else ttc_valuation_bind(task->field, b->solutions[i].symbol, b->solutions[i].expression);
    return true;
}

static void close_field(ttc_task *task)
{
    ttc_valuation_destroy(task->field);
    task->field = NULL;
    task->ring = NULL;
}

/* All signs of roots that became rational must agree on the verdict. */
static void run_signs(ttc_task *task, const ttc_branch *b, ttc_prover prover)
{
    ttc_proof_status first = TTC_PROVED;
    bool again = true;
    for (unsigned choices = 0; again && task->status != TTC_MEANINGLESS; choices++) {
        if (choices > 0) {
            first = task->status;
            task->status = TTC_PROVED;
        }
        if (!open_field(task, b, choices)) {
            task->ring = NULL;
            ttc_task_reject(task, "out of memory");
            return;
        }
        ttc_task_check_domain(task);
        if (ttc_task_open(task)) prover(task);
        if (task->ring->status != TTC_RING_OK) {
            task->status = TTC_PROVED;
            ttc_task_reject(task, "%s", ttc_ring_status_text(task->ring->status));
        }
        if (choices > 0 && task->status != TTC_MEANINGLESS && task->status != first) {
            task->status = TTC_PROVED;
            ttc_task_reject(task, "holds for one sign of a root whose radicand became a square, and not for the other");
        }
        again = choices + 1 < 1u << task->ring->choice_count;
        close_field(task);
    }
}

static void descend(search *s, const ttc_branch *b, size_t goal);

/* On this branch some leading coefficient vanishes after all: its points belong to those that the count of codimension
 * looks after. */
static bool is_degenerate(ttc_task *task, const ttc_branch *b)
{
    bool zero = false;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; !zero && i < b->leading_count; i++) {
        ttc_evaluate(task->field, &value, b->leading[i]);
        zero = task->ring->status == TTC_RING_DIVISION_BY_ZERO
               || (task->ring->status == TTC_RING_OK && ttc_ratio_is_zero(task->ring, &value));
    }
    ttc_ratio_clear(task->ring, &value);
    return zero;
}

static void check_hidden(search *s, const ttc_branch *b)
{
    ttc_id goals[TTC_BRANCH_RELATIONS_MAX + 1];
    for (size_t i = 0; i < b->leading_count; i++) {
        goals[0] = b->leading[i];
        for (size_t k = 0; k < s->goal_count; k++) goals[k + 1] = s->goals[k];
        if (!codimension_reached(s->task, goals, s->goal_count + 1, s->goal_count + 1, 0))
            ttc_task_reject(s->task, "the zero level may have further components, which were not examined");
    }
}

/* Every relation is solved: the claim itself. */
static void finish(search *s, const ttc_branch *b)
{
    if (s->counting) {
        s->reached = s->reached && b->relation_count >= s->needed;
        return;
    }
    check_hidden(s, b);
    if (s->task->status == TTC_MEANINGLESS) return;
    s->examined++;
    run_signs(s->task, b, s->prover);
}

/* A solution changes the field, which is therefore built anew further down; ours is kept. */
static void descend_apart(search *s, const ttc_branch *b, size_t goal)
{
    ttc_valuation *field = s->task->field;
    ttc_ring *ring = s->task->ring;
    s->task->field = NULL;
    s->task->ring = NULL;
    descend(s, b, goal);
    s->task->field = field;
    s->task->ring = ring;
}

static void follow(search *s, const ttc_branch *b, size_t goal, const fmpz_mpoly_t factor)
{
    ttc_branch next = *b;
    ttc_task *task = s->task;
    if (!ttc_branch_solve(&next, task, factor)) {
        if (s->counting) s->reached = false;
        else ttc_task_reject(task, "the zero level cannot be solved for a state, linearly or by a square root");
        return;
    }
    if (s->counting && next.relation_count < s->needed && next.leading_count > b->leading_count) {
        ttc_id goals[2 * TTC_BRANCH_RELATIONS_MAX];
        size_t count = 0;
        goals[count++] = next.leading[next.leading_count - 1];
        for (size_t i = 0; i < s->goal_count && count < TTC_BRANCH_RELATIONS_MAX; i++) goals[count++] = s->goals[i];
        s->reached = s->reached && s->depth < HIDING_DEPTH && s->goal_count < TTC_BRANCH_RELATIONS_MAX
                     && codimension_reached(task, goals, count, s->needed, s->depth + 1);
    }
    if (!s->counting || s->reached) descend_apart(s, &next, goal + 1);
}

/* Each factor of `norm` that can vanish is a branch; or, when the relation holds generators, the relation is one as it
 * stands (whole != NULL), unless nothing of its norm can vanish. */
static void follow_factors(search *s, const ttc_branch *b, size_t goal, const fmpz_mpoly_t norm, const fmpz_mpoly_struct *whole)
{
    ttc_task *task = s->task;
    fmpz_mpoly_factor_t factors;
    fmpz_mpoly_factor_init(factors, task->ring->context);
    if (!fmpz_mpoly_factor(factors, norm, task->ring->context)) {
        if (s->counting) s->reached = false;
        else ttc_task_reject(task, "the zero level could not be factored");
    }
    for (slong i = 0; i < factors->num && task->status == TTC_PROVED; i++) {
        if (ttc_branch_never_zero(task, factors->poly + i)) continue;
        follow(s, b, goal, whole != NULL ? whole : factors->poly + i);
        if (whole != NULL) break;
    }
    fmpz_mpoly_factor_clear(factors, task->ring->context);
}

static void meet(search *s, const ttc_branch *b, size_t goal)
{
    ttc_task *task = s->task;
    ttc_ratio value;
    fmpz_mpoly_t norm;
    ttc_ratio_init(task->ring, &value);
    fmpz_mpoly_init(norm, task->ring->context);
    ttc_evaluate(task->field, &value, s->goals[goal]);
    if (task->ring->status == TTC_RING_OK) ttc_ratio_norm(task->ring, norm, &value);
    bool rational = true;
    for (size_t i = 0; i < task->ring->generator_count; i++)
        if (ttc_ratio_uses(task->ring, &value, task->ring->generators[i].variable)) rational = false;
    ttc_ring_status status = task->ring->status;
    if (s->counting && status == TTC_RING_ROOT_OF_ZERO) {
        /* roots are positive: there is no such point */
    } else if (status != TTC_RING_OK) {
        if (s->counting) s->reached = false;
        else ttc_task_reject(task, "on the zero level, %s", ttc_ring_status_text(status));
    } else if (ttc_ratio_is_zero(task->ring, &value)) {
        if (s->counting) descend_apart(s, b, goal + 1);
        else ttc_task_reject(task, "one of the zero levels it is restricted to follows from those before it");
    } else {
        /* A norm vanishes wherever its factor does: enough for counting, too much for a proof. */
        follow_factors(s, b, goal, norm, rational || s->counting ? NULL : value.numerator);
    }
    fmpz_mpoly_clear(norm, task->ring->context);
    ttc_ratio_clear(task->ring, &value);
}

/* One more relation, for every sign of roots that became rational; on reaching the last, the claim itself. */
static void descend(search *s, const ttc_branch *b, size_t goal)
{
    ttc_task *task = s->task;
    bool degenerate = false, again = true;
    if (s->counting && (goal == s->goal_count || b->relation_count >= s->needed)) {
        finish(s, b);
        return;
    }
    for (unsigned choices = 0; again && task->status == TTC_PROVED; choices++) {
        if (!open_field(task, b, choices)) {
            ttc_task_reject(task, "out of memory");
            return;
        }
        if (is_degenerate(task, b)) degenerate = true;
        else if (goal < s->goal_count) meet(s, b, goal);
        again = goal < s->goal_count && choices + 1 < 1u << task->ring->choice_count;
        close_field(task);
    }
    if (s->counting || task->status != TTC_PROVED) return;
    if (degenerate) check_hidden(s, b);
    else if (goal == s->goal_count) finish(s, b);
}

static bool codimension_reached(ttc_task *task, const ttc_id *goals, size_t count, size_t needed, unsigned depth)
{
    search s = { .task = task, .goals = goals, .goal_count = count, .counting = true, .needed = needed,
                 .reached = true, .depth = depth };
    ttc_branch start = { .solution_count = 0 };
    descend_apart(&s, &start, 0);
    return s.reached;
}

void ttc_task_run(ttc_task *task, ttc_prover prover)
{
    ttc_id goals[TTC_BRANCH_RELATIONS_MAX];
    search s = { .task = task, .prover = prover, .goals = goals, .goal_count = task->claim->modulo_count };
    ttc_branch start = { .solution_count = 0 };
    if (task->claim->modulo_count > TTC_BRANCH_RELATIONS_MAX) {
        ttc_task_reject(task, "more than %d zero levels", (int)TTC_BRANCH_RELATIONS_MAX);
        return;
    }
    for (size_t i = 0; i < task->claim->modulo_count; i++)
        goals[i] = task->model->claims[task->claim->modulo[i]].expression;
    descend(&s, &start, 0);
    if (s.examined == 0) ttc_task_reject(task, "the zero level it is restricted to is empty");
}
