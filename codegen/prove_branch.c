/* The field a claim lives in: substitutions, and the zero levels it is restricted to.
 *
 * A zero level h = 0 is factored; each factor is a branch. On a branch one state becomes a rational function of the others
 * (where the factor is linear in it) or a square root (where quadratic), so a generic point of the branch is reached, and
 * an identity there holds on all of it. What could hide is a component on which the leading coefficient A vanishes as well:
 * it would need A = 0 to cost nothing, so A = h_1 = ... = h_k = 0 is shown to have codimension k + 1 or more. */
#include "prove_task.h"

#include <stdlib.h>

#include <flint/fmpz_mpoly_factor.h>

enum { RELATION_LIMIT = 16, HIDING_DEPTH = 4 };

/* A substitution found by solving: a state equal to an expression, or to a square root of one. */
typedef struct {
    uint32_t symbol;
    ttc_id expression;
    bool square;
} solution;

typedef struct {
    solution solutions[2 * RELATION_LIMIT];
    size_t solution_count, spares;
    size_t relation_count;            /* solved so far */
    ttc_id leading[RELATION_LIMIT];   /* coefficients divided by that may vanish somewhere */
    size_t leading_count;
} branch;

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

static bool open_field(ttc_task *task, const branch *b, unsigned choices)
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
static void run_signs(ttc_task *task, const branch *b, ttc_prover prover)
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

static ttc_id term_node(ttc_task *task, const fmpz_mpoly_t polynomial, slong index)
{
    ttc_graph *graph = task->model->graph;
    fmpq_t coefficient;
    fmpq_init(coefficient);
    fmpz_mpoly_get_term_coeff_fmpz(fmpq_numref(coefficient), polynomial, index, task->ring->context);
    ttc_id node = ttc_number(graph, coefficient);
    for (size_t v = 0; v < task->ring->variable_count; v++) {
        ulong exponent = fmpz_mpoly_get_term_var_exp_ui(polynomial, index, (slong)v, task->ring->context);
        size_t symbol = exponent == 0 ? SIZE_MAX : ttc_valuation_symbol(task->field, (slong)v);
        if (exponent == 0) continue;
        ttc_id factor = symbol == SIZE_MAX ? TTC_NONE : ttc_symbol(graph, (uint32_t)symbol);
        node = ttc_multiply(graph, node, ttc_power(graph, factor, (long)exponent));
    }
    fmpq_clear(coefficient);
    return node;
}

static ttc_id polynomial_node(ttc_task *task, const fmpz_mpoly_t polynomial)
{
    ttc_id sum = ttc_integer(task->model->graph, 0);
    for (slong i = 0; i < fmpz_mpoly_length(polynomial, task->ring->context); i++)
        sum = ttc_add(task->model->graph, sum, term_node(task, polynomial, i));
    return sum;
}

static bool is_state_variable(ttc_task *task, slong variable)
{
    size_t symbol = ttc_valuation_symbol(task->field, variable);
    if (symbol >= task->model->symbol_count) return symbol != SIZE_MAX;
    ttc_symbol_kind kind = task->model->symbols[symbol].kind;
    return kind == TTC_STATE || kind == TTC_ROOT || kind == TTC_COSINE || kind == TTC_SINE;
}

static bool state_free(ttc_task *task, const fmpz_mpoly_t polynomial)
{
    for (size_t v = 0; v < task->ring->variable_count; v++)
        if (is_state_variable(task, (slong)v) && fmpz_mpoly_degree_si(polynomial, (slong)v, task->ring->context) > 0)
            return false;
    return true;
}

/* An irreducible factor that cannot vanish: free of states, or a factor of the radicand of a positive root. */
static bool never_zero(ttc_task *task, const fmpz_mpoly_t factor)
{
    if (state_free(task, factor)) return true;
    bool result = false;
    fmpz_mpoly_t norm, quotient;
    fmpz_mpoly_init(norm, task->ring->context);
    fmpz_mpoly_init(quotient, task->ring->context);
    for (size_t i = 0; !result && i < task->ring->generator_count; i++) {
        if (!task->ring->generators[i].positive) continue;
        ttc_ratio_norm(task->ring, norm, &task->ring->generators[i].square);
        result = fmpz_mpoly_divides(quotient, norm, factor, task->ring->context) != 0;
    }
    fmpz_mpoly_clear(quotient, task->ring->context);
    fmpz_mpoly_clear(norm, task->ring->context);
    return result;
}

static bool in_some_radicand(ttc_task *task, const fmpz_mpoly_t polynomial, slong variable)
{
    for (size_t i = task->ring->generator_count; i-- > 0;) {
        const ttc_generator *generator = &task->ring->generators[i];
        if (fmpz_mpoly_degree_si(polynomial, generator->variable, task->ring->context) < 1) continue;
        if (ttc_ratio_uses(task->ring, &generator->square, variable)) return true;
        if (in_some_radicand(task, generator->square.numerator, variable)) return true;
    }
    return false;
}

static bool is_generator(const ttc_ring *ring, slong variable)
{
    for (size_t i = 0; i < ring->generator_count; i++)
        if (ring->generators[i].variable == variable) return true;
    return false;
}

/* The state to solve for: a leading coefficient free of states before any other, linear before quadratic, short before
 * long. */
static slong choose_variable(ttc_task *task, const fmpz_mpoly_t factor, ulong *degree)
{
    slong best = -1, best_cost = WORD_MAX;
    fmpz_mpoly_t leading;
    fmpz_mpoly_init(leading, task->ring->context);
    for (slong v = 0; v < (slong)task->ring->variable_count; v++) {
        slong d = fmpz_mpoly_degree_si(factor, v, task->ring->context);
        if (d < 1 || d > 2 || !is_state_variable(task, v) || is_generator(task->ring, v)) continue;
        if (in_some_radicand(task, factor, v)) continue;
        ulong exponent = (ulong)d;
        fmpz_mpoly_get_coeff_vars_ui(leading, factor, &v, &exponent, 1, task->ring->context);
        slong cost = state_free(task, leading) ? d - 1 : 2 * fmpz_mpoly_length(leading, task->ring->context) + d - 1;
        if (cost < best_cost) {
            best = v;
            best_cost = cost;
            *degree = exponent;
        }
    }
    fmpz_mpoly_clear(leading, task->ring->context);
    return best;
}

static ttc_id coefficient_node(ttc_task *task, const fmpz_mpoly_t factor, slong variable, ulong exponent)
{
    fmpz_mpoly_t coefficient;
    fmpz_mpoly_init(coefficient, task->ring->context);
    fmpz_mpoly_get_coeff_vars_ui(coefficient, factor, &variable, &exponent, 1, task->ring->context);
    ttc_id node = polynomial_node(task, coefficient);
    fmpz_mpoly_clear(coefficient, task->ring->context);
    return node;
}

/* a x^2 + b x + c = 0 as x = y - b/(2a), y^2 = (b^2 - 4ac)/(4a^2); a x + b = 0 as x = -b/a. False when it cannot. */
static bool solve(ttc_task *task, branch *b, const fmpz_mpoly_t factor)
{
    ttc_graph *graph = task->model->graph;
    ulong degree = 0;
    slong variable = choose_variable(task, factor, &degree);
    if (variable < 0 || b->relation_count == RELATION_LIMIT) return false;
    uint32_t symbol = (uint32_t)ttc_valuation_symbol(task->field, variable);
    ttc_id coefficients[3] = { TTC_NONE };
    for (ulong k = 0; k <= degree; k++) coefficients[k] = coefficient_node(task, factor, variable, k);
    ttc_id lead = coefficients[degree], zero = ttc_integer(graph, 0);
    if (degree == 1) {
        ttc_id value = ttc_subtract(graph, zero, ttc_divide(graph, coefficients[0], lead));
        b->solutions[b->solution_count++] = (solution){ symbol, value, false };
    } else if (coefficients[1] == zero) {
        ttc_id square = ttc_subtract(graph, zero, ttc_divide(graph, coefficients[0], lead));
        b->solutions[b->solution_count++] = (solution){ symbol, square, true };
    } else {
        if (b->spares == TTC_SPARE_SYMBOLS) return false;
        uint32_t spare = (uint32_t)(task->model->symbol_count + b->spares++);
        ttc_id middle = ttc_divide(graph, coefficients[1], ttc_multiply(graph, ttc_integer(graph, 2), lead));
        ttc_id square = ttc_power(graph, middle, 2);
        square = ttc_subtract(graph, square, ttc_divide(graph, coefficients[0], lead));
        ttc_id value = ttc_subtract(graph, ttc_symbol(graph, spare), middle);
        b->solutions[b->solution_count++] = (solution){ spare, square, true };
        b->solutions[b->solution_count++] = (solution){ symbol, value, false };
    }
    b->relation_count++;
    fmpz_mpoly_t leading;
    fmpz_mpoly_init(leading, task->ring->context);
    fmpz_mpoly_get_coeff_vars_ui(leading, factor, &variable, &degree, 1, task->ring->context);
    if (!state_free(task, leading)) b->leading[b->leading_count++] = lead;
    fmpz_mpoly_clear(leading, task->ring->context);
    return true;
}

static void descend(search *s, const branch *b, size_t goal);

/* On this branch some leading coefficient vanishes after all: its points belong to those that the count of codimension
 * looks after. */
static bool is_degenerate(ttc_task *task, const branch *b)
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

static void check_hidden(search *s, const branch *b)
{
    ttc_id goals[RELATION_LIMIT + 1];
    for (size_t i = 0; i < b->leading_count; i++) {
        goals[0] = b->leading[i];
        for (size_t k = 0; k < s->goal_count; k++) goals[k + 1] = s->goals[k];
        if (!codimension_reached(s->task, goals, s->goal_count + 1, s->goal_count + 1, 0))
            ttc_task_reject(s->task, "the zero level may have further components, which were not examined");
    }
}

/* Every relation is solved: the claim itself. */
static void finish(search *s, const branch *b)
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
static void descend_apart(search *s, const branch *b, size_t goal)
{
    ttc_valuation *field = s->task->field;
    ttc_ring *ring = s->task->ring;
    s->task->field = NULL;
    s->task->ring = NULL;
    descend(s, b, goal);
    s->task->field = field;
    s->task->ring = ring;
}

static void follow(search *s, const branch *b, size_t goal, const fmpz_mpoly_t factor)
{
    branch next = *b;
    ttc_task *task = s->task;
    if (!solve(task, &next, factor)) {
        if (s->counting) s->reached = false;
        else ttc_task_reject(task, "the zero level cannot be solved for a state, linearly or by a square root");
        return;
    }
    if (s->counting && next.relation_count < s->needed && next.leading_count > b->leading_count) {
        ttc_id goals[2 * RELATION_LIMIT];
        size_t count = 0;
        goals[count++] = next.leading[next.leading_count - 1];
        for (size_t i = 0; i < s->goal_count && count < RELATION_LIMIT; i++) goals[count++] = s->goals[i];
        s->reached = s->reached && s->depth < HIDING_DEPTH && s->goal_count < RELATION_LIMIT
                     && codimension_reached(task, goals, count, s->needed, s->depth + 1);
    }
    if (!s->counting || s->reached) descend_apart(s, &next, goal + 1);
}

/* Each factor of `norm` that can vanish is a branch; or, when the relation holds generators, the relation is one as it
 * stands (whole != NULL), unless nothing of its norm can vanish. */
static void follow_factors(search *s, const branch *b, size_t goal, const fmpz_mpoly_t norm, const fmpz_mpoly_struct *whole)
{
    ttc_task *task = s->task;
    fmpz_mpoly_factor_t factors;
    fmpz_mpoly_factor_init(factors, task->ring->context);
    if (!fmpz_mpoly_factor(factors, norm, task->ring->context)) {
        if (s->counting) s->reached = false;
        else ttc_task_reject(task, "the zero level could not be factored");
    }
    for (slong i = 0; i < factors->num && task->status == TTC_PROVED; i++) {
        if (never_zero(task, factors->poly + i)) continue;
        follow(s, b, goal, whole != NULL ? whole : factors->poly + i);
        if (whole != NULL) break;
    }
    fmpz_mpoly_factor_clear(factors, task->ring->context);
}

static void meet(search *s, const branch *b, size_t goal)
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
static void descend(search *s, const branch *b, size_t goal)
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
    branch start = { .solution_count = 0 };
    descend_apart(&s, &start, 0);
    return s.reached;
}

void ttc_task_run(ttc_task *task, ttc_prover prover)
{
    ttc_id goals[RELATION_LIMIT];
    search s = { .task = task, .prover = prover, .goals = goals, .goal_count = task->claim->modulo_count };
    branch start = { .solution_count = 0 };
    if (task->claim->modulo_count > RELATION_LIMIT) {
        ttc_task_reject(task, "more than %d zero levels", (int)RELATION_LIMIT);
        return;
    }
    for (size_t i = 0; i < task->claim->modulo_count; i++)
        goals[i] = task->model->claims[task->claim->modulo[i]].expression;
    descend(&s, &start, 0);
    if (s.examined == 0) ttc_task_reject(task, "the zero level it is restricted to is empty");
}
