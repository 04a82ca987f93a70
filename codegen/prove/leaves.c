/* The leaves of a claim: the set that its conditions allow, cut into pieces on which some symbols follow from free ones.
 *
 * A zero level h = 0 is factored. On a factor A s^d + ... of degree d <= 2 in a symbol s, s follows from the other symbols where
 * A is not zero; the points where A = 0 as well are cut in the same way, with A = 0 as one more level. So the leaves cover every
 * real point, and what is shown at a generic point of a leaf holds on all of it, by continuity. */
#include "prove/divided.h"
#include "prove/domain.h"

#include <stdlib.h>
#include <string.h>

enum { LEAF_LIMIT = 512 };

/* The leaves that were visited so far, and what was found on them. */
typedef struct {
    ttc_task *task;
    ttc_prover prover;
    size_t leaves, with_point, undecided; /* numbers of all; with a known point; that may have points, with none known */
    size_t skipped; /* leaves that may be components, without a known point, those without points or values included */
    const char *why_empty; /* why the last leaf without points has none */
    char *none, *none_at;  /* of a claim of existence: remainder and point of the first leaf that has no example */
    bool is_partial;       /* the claim divides by zero on a whole part of the domain, */
    char *undefined_at;    /* with this point, or NULL if none was found */
} cover;

static bool is_invariant(const ttc_task *task) { return task->claim->kind == TTC_CLAIM_INVARIANT; }

/* Returns true if all goals that were met are zero for the present signs of roots. A goal was met for some signs; other signs, for
 * which it is not zero, belong to other subcases. */
static bool is_in_subcase(ttc_task *task)
{
    bool zero = true;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; zero && i < task->met_count; i++) {
        ttc_evaluate(task->field, &value, task->met[i]);
        zero = task->ring->status != TTC_RING_OK || ttc_ratio_is_zero(task->ring, &value);
    }
    ttc_ratio_clear(task->ring, &value);
    return zero;
}

/* Add the conditions of the domain, and search for a point of the leaf. Returns false if the leaf has none. */
static bool look_for_point(cover *c, const ttc_subcase *b)
{
    ttc_task *task = c->task;
    char *text = NULL;
    ttc_subcase_add_conditions(task, b);
    ttc_domain_add(task, &task->domain, task->extent);
    if (ttc_ring_has_no_value(task->ring->status)) {
        c->why_empty = ttc_ring_status_text(task->ring->status);
        return false;
    }
    if (task->ring->status != TTC_RING_OK) return true;
    ttc_search_result result = ttc_task_search(task, NULL, TTC_IS_ZERO, &text);
    task->has_point = result == TTC_POINT_FOUND;
    if (result == TTC_POINT_IMPOSSIBLE || result == TTC_POINT_EXCLUDED) {
        c->why_empty = *task->why_empty != '\0' ? task->why_empty : "no point of the domain meets its conditions";
        return false;
    }
    if (!task->has_point) c->undecided++;
    else if (c->with_point++ == 0 && task->status == TTC_PROVED && task->point == NULL) {
        task->point = text;
        text = NULL;
    }
    free(text);
    return true;
}

/* Returns true for a leaf that is no component of the levels. A component of n levels has codimension at most n; a leaf of more
 * relations lies within components that other leaves show to be kept, and so are their real points. */
static bool is_no_component(const ttc_task *task, const ttc_subcase *b)
{
    const size_t levels = task->claim->modulo_count + task->level_count + is_invariant(task) + b->terms_added;
    return !b->is_orphan && b->relation_count > levels;
}

static void place_leaf(ttc_task *task, const ttc_subcase *b)
{
    task->is_thin = b->terms_added > 0 || (is_invariant(task) ? b->is_degenerate || b->is_orphan : is_no_component(task, b));
    task->apart = b->apart;
}

/* Postpone the refutation of a claim of existence, which holds only if every leaf refutes it. */
static void put_off(cover *c)
{
    ttc_task *task = c->task;
    if (task->claim->kind != TTC_CLAIM_OBSTRUCTS || task->status != TTC_REFUTED) return;
    if (c->none == NULL) {
        c->none = task->remainder;
        c->none_at = task->point;
    } else {
        free(task->remainder);
        free(task->point);
    }
    task->status = TTC_PROVED;
    task->remainder = task->point = NULL;
}

/* Prove the claim on one leaf, for each sign of roots whose radicand became a square. If not settled, it may still be refuted. */
static void visit(cover *c, const ttc_subcase *b)
{
    ttc_task *task = c->task;
    bool again = true;
    unsigned most = 0; /* greatest number of roots of either sign, which depends on the signs of earlier ones */
    for (unsigned choices = 0; again && task->status != TTC_REFUTED; choices++) {
        ttc_proof_status before = task->status;
        char *reason = task->remainder;
        if (++c->leaves > LEAF_LIMIT) {
            ttc_task_unsettle(task, "its conditions fall into more than %d cases", (int)LEAF_LIMIT);
            return;
        }
        if (!ttc_subcase_open(task, b, choices)) {
            ttc_task_unsettle(task, "out of memory");
            return;
        }
        if (before == TTC_UNSETTLED) {
            task->status = TTC_PROVED;
            task->remainder = NULL;
        }
        bool is_here = is_in_subcase(task), has_points = is_here && look_for_point(c, b);
        if (has_points) {
            place_leaf(task, b);
            ttc_subcase_check_foundations(task);
            if (ttc_task_open(task)) c->prover(task);
            put_off(c);
            c->is_partial |= !task->has_point && ttc_divided_perhaps(task, b);
            if (ttc_ring_has_no_value(task->ring->status))
                ttc_task_unsettle(task, "%s", ttc_ring_status_text(task->ring->status));
            else if (task->ring->status != TTC_RING_OK || task->domain.failed)
                ttc_task_unsettle(task, "%s", task->domain.failed ? "out of memory" : ttc_ring_status_text(task->ring->status));
        }
        const bool is_known = !is_here || is_no_component(task, b) || (has_points && task->has_point);
        c->skipped += !is_known || task->ring->has_sign_of_quotient; /* also of a root that the prover alone uses */
        if (is_here && !has_points && !c->is_partial) c->is_partial = ttc_divided_by_zero(task, b, &c->undefined_at);
        if (before == TTC_UNSETTLED && task->status != TTC_REFUTED) {
            free(task->remainder);
            task->status = before;
            task->remainder = reason;
        } else if (before == TTC_UNSETTLED) free(reason);
        if (task->ring->choice_count > most) most = task->ring->choice_count;
        again = choices + 1 < 1u << most && !task->exhibited;
        ttc_subcase_close(task);
    }
}

static void descend(cover *c, const ttc_subcase *b);

/* Descend with a new field, as solutions change it; afterwards the task has its present field again. */
static void descend_apart(cover *c, const ttc_subcase *b)
{
    ttc_task *task = c->task;
    ttc_valuation *field = task->field;
    ttc_conditions domain = task->domain;
    task->field = NULL;
    task->ring = NULL;
    descend(c, b);
    task->field = field;
    task->domain = domain;
    task->ring = ttc_valuation_ring(field);
}

/* Solve factor = 0 for a symbol, and descend; then, if the leading coefficient can vanish, descend with that as one more goal. The
 * goal itself is not removed: that its norm vanishes means that some conjugate of it does. */
static void follow(cover *c, const ttc_subcase *b, const fmpz_mpoly_t factor, bool is_alone)
{
    ttc_subcase solved = *b, degenerate = *b;
    ttc_id lead;
    if (!ttc_subcase_solve(&solved, &lead, c->task, factor)) {
        ttc_task_unsettle(c->task, "the zero level cannot be solved for a state or parameter, linearly or by a square root");
        return;
    }
    if (lead != TTC_NONE && ttc_kind_of(c->task->model->graph, lead) != TTC_NUMBER) solved.leads[solved.lead_count++] = lead;
    solved.own_solved |= b->goal_count == 1 && c->task->claim->kind == TTC_CLAIM_INVARIANT;
    const size_t skipped = c->skipped;
    descend_apart(c, &solved);
    degenerate.is_degenerate = true;
    degenerate.is_orphan |= c->skipped > skipped; /* it may hold all real points of a component that was skipped */
    if (lead == TTC_NONE || ttc_kind_of(c->task->model->graph, lead) == TTC_NUMBER || c->task->status == TTC_REFUTED) return;
    ttc_id itself = ttc_subcase_expression(c->task, factor);
    if (degenerate.goal_count + 2 > sizeof degenerate.goals / sizeof *degenerate.goals) {
        ttc_task_unsettle(c->task, "the zero level falls into too many cases");
        return;
    }
    /* The goal remains, and, if its norm has several factors, this one becomes a goal too. */
    if (itself != TTC_NONE && !is_alone) degenerate.goals[degenerate.goal_count++] = itself;
    degenerate.goals[degenerate.goal_count++] = lead;
    descend_apart(c, &degenerate);
}

/* If a level was split into the terms of a sum, descend to the points at which all of them are zero: it has no other points. */
static bool follow_terms(cover *c, const ttc_subcase *b, bool is_split)
{
    if (!is_split) return false;
    c->skipped++; /* the component has no leaf of its own */
    descend_apart(c, b);
    return true;
}

static void follow_factors(cover *c, const ttc_subcase *b, const fmpz_mpoly_t norm)
{
    ttc_task *task = c->task;
    fmpz_mpoly_factor_t factors;
    fmpz_mpoly_factor_init(factors, task->ring->context);
    if (!fmpz_mpoly_factor(factors, norm, task->ring->context)) ttc_task_unsettle(task, "the zero level could not be factored");
    const bool is_whole = b->goal_count + b->relation_count + task->claim->modulo_count + task->ring->choice_count == 1;
    if (is_whole && is_invariant(task)) task->radical = ttc_subcase_others(task, factors, -1);
    for (slong i = 0; i < factors->num && task->status != TTC_REFUTED; i++) {
        if (!(ttc_conditions_signs(&task->domain, factors->poly + i) & TTC_CAN_BE_ZERO)) continue;
        ttc_subcase one = *b;
        if (is_invariant(task) && b->goal_count == 1 && !b->own_solved) one.apart = ttc_subcase_others(task, factors, i);
        const bool is_alone = factors->num == 1, is_split = ttc_subcase_split_factor(&one, task, factors->poly + i, is_alone);
        if (!follow_terms(c, &one, is_split)) follow(c, &one, factors->poly + i, is_alone);
    }
    fmpz_mpoly_factor_clear(factors, task->ring->context);
}

/* Meet the last goal of the subcase, which is changed, in the field in which earlier solutions are bound. */
static void meet(cover *c, ttc_subcase *b)
{
    ttc_task *task = c->task;
    ttc_ratio value;
    fmpz_mpoly_t norm;
    ttc_ratio_init(task->ring, &value);
    fmpz_mpoly_init(norm, task->ring->context);
    ttc_evaluate(task->field, &value, b->goals[b->goal_count - 1]);
    ttc_subcase_keep_signs(b, task);
    if (task->ring->status == TTC_RING_OK) ttc_subcase_level(task, norm, &value);
    ttc_ring_status status = task->ring->status;
    if (ttc_ring_has_no_value(status)) {
        c->why_empty = ttc_ring_status_text(status);
        c->skipped++; /* there may be a component where a denominator of the leaf vanishes */
        if (is_invariant(task) && b->goal_count == 1 && !c->is_partial)
            c->is_partial = ttc_divided_by_zero(task, b, &c->undefined_at);
    } else if (status != TTC_RING_OK) {
        ttc_task_unsettle(task, "on the zero level, %s", ttc_ring_status_text(status));
    } else if (is_invariant(task) && b->goal_count == 1 && !b->own_solved && !b->is_degenerate && !b->is_orphan
               && b->terms_added == 0 && (ttc_conditions_signs(&task->domain, value.numerator) & TTC_CAN_BE_ZERO)
               && !ttc_task_moves(task, &value) && look_for_point(c, b)) {
        ttc_task_unsettle(task, "%s does not depend on the states, or is zero wherever its conditions hold: that says nothing",
                          task->claim->name);
    } else if (ttc_ratio_is_zero(task->ring, &value)) {
        const ttc_id goal = b->goals[--b->goal_count];
        if (b->met_count < sizeof b->met / sizeof *b->met) b->met[b->met_count++] = goal;
        else ttc_task_unsettle(task, "the zero level falls into too many cases");
        descend_apart(c, b);
    } else {
        ttc_subcase terms = *b; /* of an invariant, they would be leaves within other components, which the flow may leave */
        const ttc_id goal = terms.goals[--terms.goal_count];
        if (is_invariant(task) || !follow_terms(c, &terms, ttc_subcase_split(&terms, task, goal))) follow_factors(c, b, norm);
    }
    fmpz_mpoly_clear(norm, task->ring->context);
    ttc_ratio_clear(task->ring, &value);
}

static void descend(cover *c, const ttc_subcase *b)
{
    ttc_task *task = c->task;
    bool again = b->goal_count > 0;
    unsigned most = 0;
    if ((is_invariant(task) && is_no_component(task, b)) || (task->is_integral && c->with_point > 0)) return;
    if (!again) visit(c, b);
    for (unsigned choices = 0; again && task->status != TTC_REFUTED; choices++) {
        if (++c->leaves > LEAF_LIMIT || !ttc_subcase_open(task, b, choices)) {
            ttc_task_unsettle(task, "its conditions fall into more than %d cases, or memory is out", (int)LEAF_LIMIT);
            return;
        }
        ttc_subcase here = *b;
        if (is_in_subcase(task)) meet(c, &here);
        c->skipped += task->ring->has_sign_of_quotient;
        if (task->ring->choice_count > most) most = task->ring->choice_count;
        again = choices + 1 < 1u << most && !task->exhibited;
        ttc_subcase_close(task);
    }
}

/* Returns true if the claim requires that images have a certain dimension, and no leaf is known whose image has it. Leaves that may
 * lie within others are not tested for it one by one. */
static bool lacks_dimension(const ttc_task *task)
{
    const bool is_asked = task->claim->kind == TTC_CLAIM_REDUCTION || task->claim->kind == TTC_CLAIM_EMBEDDING;
    return is_asked && task->claim->modulo_count > 0 && task->kept == 0;
}

static void draw_verdict(cover *c)
{
    ttc_task *task = c->task;
    task->is_partial = c->is_partial;
    if (task->exhibited) {
        task->status = TTC_PROVED;
        free(task->remainder);
        task->remainder = NULL;
    } else if (task->status == TTC_PROVED && c->none != NULL) {
        task->status = TTC_REFUTED;
        free(task->point);
        task->remainder = c->none;
        task->point = c->none_at;
        c->none = c->none_at = NULL;
    } else if (task->status == TTC_PROVED && c->with_point > 0 && c->is_partial) {
        ttc_task_unsettle(task, "it divides by zero on a whole part of the domain%s%s",
                          c->undefined_at != NULL ? ", as at " : ", or that was not excluded",
                          c->undefined_at != NULL ? c->undefined_at : "");
    } else if (task->status == TTC_PROVED && c->with_point == 0 && c->undecided > 0) {
        ttc_task_unsettle(task, "no point of the domain was found that meets its conditions, nor was it shown that there is none");
    } else if (task->status == TTC_PROVED && c->with_point == 0) {
        const char *why = c->why_empty != NULL ? c->why_empty : "the zero level it is restricted to is empty";
        ttc_task_unsettle(task, "it says nothing: %s", why);
    } else if (task->status == TTC_PROVED && lacks_dimension(task)) {
        ttc_task_unsettle(task, "no point of the level is known at which its image has the dimension that it should have");
    }
    if (task->status == TTC_UNSETTLED) {
        free(task->point);
        free(task->note);
        task->point = task->note = NULL;
    }
    free(c->none);
    free(c->none_at);
    free(c->undefined_at);
}

/* A claim is false where an expression that must not be zero is zero. Such points are often irrational, and not found by searches
 * of a larger set; so a claim that is not settled is examined again on that zero level, then at quarter turns of angles. */
static void look_at_zeros(cover *c, const ttc_subcase *start)
{
    const ttc_id zero = c->task->unexcluded;
    ttc_subcase level = *start, turns = *start;
    if (zero == TTC_NONE || start->goal_count == sizeof start->goals / sizeof *start->goals) return;
    level.goals[level.goal_count++] = zero;
    c->task->is_at_zeros = c->task->is_lower = true;
    if (c->task->status == TTC_UNSETTLED) descend(c, &level);
    if (c->task->status == TTC_UNSETTLED && ttc_subcase_add_turns(&turns, c->task, zero)) descend(c, &turns);
}

/* Prove the claim where denominators put aside are zero, as k^2 is in the normal form of 1/(1 + r) for r^2 = 1 + k^2; on these
 * leaves others may be put aside. */
static void look_aside(cover *c, const ttc_subcase *start)
{
    ttc_task *task = c->task;
    const size_t count = task->aside_count;
    const bool is_lower = task->is_lower;
    for (size_t i = task->aside_first; i < count && task->status == TTC_PROVED; i++) {
        cover there = { .task = task, .prover = c->prover };
        ttc_subcase zero = *start;
        zero.goals[zero.goal_count++] = task->aside[i];
        task->is_at_zeros = true;
        task->is_lower = is_lower;
        for (size_t k = 0; k < task->model->state_count; k++)
            task->is_lower |= ttc_model_depends(task->model, task->aside[i], task->model->states[k]);
        task->aside_first = task->aside_count = count;
        descend(&there, &zero);
        look_aside(&there, &zero);
        free(there.undefined_at);
    }
}

/* Prove the conditions on symbols under test, on leaves of their own: in the domain, then also without divisors and without domain
 * records that depend on these symbols, since the symbols have given values, which must meet them. */
static void prove_tested(ttc_task *task, ttc_prover prover, const ttc_subcase *start)
{
    const bool asked[] = { [TTC_DOMAIN_WHOLE] = true, [TTC_DOMAIN_OUT_OF_QUESTION] = ttc_domain_divides_by_tested(task),
                           [TTC_DOMAIN_OF_OTHERS] = ttc_domain_speaks_of_tested(task) };
    for (size_t extent = 0; extent < sizeof asked && task->status == TTC_PROVED; extent++) {
        cover c = { .task = task, .prover = prover };
        if (!asked[extent]) continue;
        task->extent = (ttc_domain_extent)extent;
        descend(&c, start);
        look_aside(&c, start);
        free(c.undefined_at);
        task->is_at_zeros = task->is_lower = false;
        task->aside_first = task->aside_count = 0;
    }
    if (task->status != TTC_PROVED) return;
    task->extent = TTC_DOMAIN_WHOLE;
    task->tested = NULL;
    free(task->point); /* it may violate conditions of the leaves that follow */
    task->point = NULL;
}

void ttc_task_run(ttc_task *task, ttc_prover prover)
{
    const ttc_claim *claim = task->claim;
    cover c = { .task = task, .prover = prover };
    ttc_subcase start = { .solution_count = 0 };
    if (claim->modulo_count + task->level_count + 1 > TTC_SUBCASE_RELATIONS_MAX) {
        ttc_task_unsettle(task, "more than %d zero levels", TTC_SUBCASE_RELATIONS_MAX - 1);
        return;
    }
    /* Goals are met from the last to the first: the invariant's own level after those to which `modulo` restricts it. */
    if (claim->kind == TTC_CLAIM_INVARIANT) start.goals[start.goal_count++] = claim->expression;
    for (size_t i = claim->modulo_count; i-- > 0;)
        start.goals[start.goal_count++] = task->model->claims[claim->modulo[i]].expression;
    for (size_t i = task->level_count; i-- > 0;) start.goals[start.goal_count++] = task->levels[i];
    for (size_t i = 0; i < start.goal_count; i++)
        start.goals[i] = ttc_subcase_without_functions(task->model, start.goals[i]);
    if (task->tested != NULL) prove_tested(task, prover, &start);
    if (task->status == TTC_PROVED) descend(&c, &start);
    look_aside(&c, &start);
    look_at_zeros(&c, &start);
    draw_verdict(&c);
}
