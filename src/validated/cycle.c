#include "validated/cycle_map.h"

#include <math.h>
#include <stdlib.h>

jlt_status jlt_cycle_create(jlt_cycle **cycle, const jlt_cycle_question *question)
{
    JLT_OWNED(jlt_cycle) *self = calloc(1, sizeof *self);

    *cycle = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    self->question = question;
    if (question->descriptor->state_count > JLT_CYCLE_STATES_MAX
        || question->descriptor->state_count < 2 + question->level_count)
        return JLT_ERR_ARG;
    JLT_PASS(jlt_formulas_create(&self->formulas, question->descriptor, question->free, question->free_count, question->levels,
                                 question->level_count));
    self->unknowns = self->formulas->states - 1;
    self->state = _arb_vec_init((slong)self->formulas->dim);
    jlt_arrival_init(&self->arrival, self->formulas->dim);
    JLT_PASS(jlt_step_create(&self->step, self->formulas, question->params, jlt_step_accuracy_for(question->digits),
                             question->watch));
    JLT_PASS(jlt_jets_create(&self->levels, self->formulas, self->formulas->levels, 0, 0));
    *cycle = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

void jlt_cycle_destroy(jlt_cycle *cycle)
{
    if (cycle == NULL) return;
    if (cycle->formulas != NULL) {
        _arb_vec_clear(cycle->state, (slong)cycle->formulas->dim);
        jlt_arrival_clear(&cycle->arrival);
    }
    jlt_step_destroy(cycle->step);
    jlt_jets_destroy(cycle->levels);
    jlt_formulas_destroy(cycle->formulas);
    free(cycle);
}

/* Eliminate the midpoints of the gradients with full pivoting; the states of the pivot columns are left out. */
jlt_status jlt_cycle_choose(jlt_cycle *self, unsigned *kept, arb_srcptr y)
{
    const unsigned m = self->question->level_count, n = self->unknowns;
    double a[JLT_FORMULAS_LEVELS_MAX][JLT_CYCLE_STATES_MAX];
    bool left[JLT_CYCLE_STATES_MAX] = { false };
    unsigned count = 0;
    JLT_SCOPED_MATRIX(arb, m, n, gradients);

    jlt_cycle_map_gradients(self, gradients, NULL, y);
    for (unsigned j = 0; j < m; j++)
        for (unsigned i = 0; i < n; i++) a[j][i] = arf_get_d(arb_midref(arb_mat_entry(gradients, j, i)), ARF_RND_NEAR);
    for (unsigned j = 0; j < m; j++) {
        unsigned row = j, column = 0;
        for (unsigned k = j; k < m; k++)
            for (unsigned i = 0; i < n; i++)
                if (!left[i] && (left[column] || fabs(a[k][i]) > fabs(a[row][column]))) row = k, column = i;
        if (!(fabs(a[row][column]) > 1e-12)) return JLT_ERR_DOMAIN;
        left[column] = true;
        for (unsigned i = 0; i < n; i++) {
            const double pivot = a[row][i];
            a[row][i] = a[j][i];
            a[j][i] = pivot;
        }
        for (unsigned k = j + 1; k < m; k++) {
            const double factor = a[k][column] / a[j][column];
            for (unsigned i = 0; i < n; i++) a[k][i] -= factor * a[j][i];
        }
    }
    for (unsigned i = 0; i < n; i++)
        if (!left[i]) kept[count++] = jlt_cycle_map_state(self, i);
    return JLT_OK;
}

/* The multiple shooting problem, and the quantities of the orbit from its last evaluation. */
typedef struct {
    jlt_cycle *cycle;
    const unsigned *kept;
    arb_ptr instants;
    unsigned legs;
    bool adjusts;         /* instants are set to the times of arrival */
    bool closes;          /* the legs meet */
    bool goes_on;         /* each leg takes positive time */
    arb_t time, expansion;
    arb_mat_t D;          /* derivative over all legs, (kept, kept) */
    arf_struct least[JLT_ARRIVAL_VALIDS_MAX];
} shooting;

static void shooting_init(shooting *self, jlt_cycle *cycle, arb_ptr instants, unsigned legs, const unsigned *kept)
{
    const slong k = (slong)(cycle->unknowns - cycle->question->level_count);

    *self = (shooting){ .cycle = cycle, .kept = kept, .instants = instants, .legs = legs };
    arb_init(self->time);
    arb_init(self->expansion);
    arb_mat_init(self->D, k, k);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_init(self->least + i);
}

static void shooting_clear(shooting *self)
{
    arb_clear(self->time);
    arb_clear(self->expansion);
    arb_mat_clear(self->D);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_clear(self->least + i);
}

/* Add a leg to the quantities of the orbit. */
static void follow(shooting *self, arb_srcptr y, arb_srcptr next)
{
    const jlt_arrival *arrival = &self->cycle->arrival;
    const slong bits = jlt_step_bits(self->cycle->step);
    JLT_SCOPED_MATRIX(arb, arb_mat_nrows(self->D), arb_mat_ncols(self->D), D);

    self->closes = jlt_cycle_map_restrict(self->cycle, D, y, self->kept) && jlt_cycle_map_meets(self->cycle, next, self->kept)
                   && self->closes;
    self->goes_on = arb_is_positive(arrival->time) && self->goes_on;
    arb_mat_mul(self->D, D, self->D, bits);
    arb_add(self->time, self->time, arrival->time, bits);
    arb_add(self->expansion, self->expansion, arrival->expansion, bits);
    jlt_step_lower(self->least, arrival->least, JLT_ARRIVAL_VALIDS_MAX);
}

static jlt_status shoot(void *context, arb_mat_t G, arb_mat_t DG, arb_srcptr y)
{
    shooting *self = context;
    const slong n = (slong)self->cycle->unknowns;
    arb_srcptr turns = self->cycle->question->turns;

    self->closes = self->goes_on = true;
    arb_zero(self->time);
    arb_zero(self->expansion);
    arb_mat_one(self->D);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_pos_inf(self->least + i);
    for (slong i = 0; i < (slong)self->legs; i++) {
        const slong to = (i + 1) % (slong)self->legs * n;
        JLT_PASS(jlt_cycle_map_arrive(self->cycle, y + i * n, arb_midref(self->instants + i),
                                       self->cycle->question->direction, turns == NULL ? NULL : turns + i * (n + 1)));
        jlt_cycle_map_equations(self->cycle, G, DG, i * n, i * n, to, y + i * n, y + to, self->kept);
        follow(self, y + i * n, y + to);
        if (self->adjusts) arb_get_mid_arb(self->instants + i, self->cycle->arrival.time);
    }
    return JLT_OK;
}

static jlt_krawczyk problem_of(shooting *self)
{
    return (jlt_krawczyk){ .n = (slong)(self->legs * self->cycle->unknowns), .bits = jlt_step_bits(self->cycle->step),
                           .equations = shoot, .context = self };
}

jlt_status jlt_cycle_refine(jlt_cycle *self, arb_ptr y, arb_ptr instants, unsigned legs, const unsigned *kept)
{
    jlt_krawczyk problem;
    shooting orbit;
    jlt_status st;

    shooting_init(&orbit, self, instants, legs, kept);
    orbit.adjusts = true;
    problem = problem_of(&orbit);
    /* the error of the result is about the square of the last correction; that of the instants is the correction itself */
    st = jlt_krawczyk_refine(&problem, y, 2.6 * self->question->digits);
    shooting_clear(&orbit);
    return st;
}

jlt_status jlt_cycle_reach(jlt_cycle *self, arb_ptr reach, arb_srcptr y, arb_srcptr instants, unsigned legs, const unsigned *kept)
{
    JLT_SCOPED_VECTOR(arb, own, (slong)legs);
    JLT_CLEARED(shooting_clear) shooting orbit;

    _arb_vec_set(own, instants, (slong)legs);
    shooting_init(&orbit, self, own, legs, kept);
    const jlt_krawczyk problem = problem_of(&orbit);
    JLT_SCOPED_MATRIX(arb, problem.n, 1, G);
    JLT_SCOPED_MATRIX(arb, problem.n, problem.n, DG, M);
    JLT_PASS(shoot(&orbit, G, DG, y));
    if (!jlt_krawczyk_invert(M, DG, problem.bits)) return JLT_ERR_NO_CONVERGENCE;
    arb_mat_mul(G, M, G, problem.bits);
    for (slong i = 0; i < problem.n; i++) {
        arb_get_abs_ubound_arf(arb_midref(reach + i), arb_mat_entry(G, i, 0), problem.bits);
        mag_zero(arb_radref(reach + i));
    }
    return JLT_OK;
}

void jlt_cycle_result_init(jlt_cycle_result *result, const jlt_cycle *of, unsigned legs)
{
    *result = (jlt_cycle_result){ .legs = legs, .unknowns = of->unknowns,
                                  .multipliers = of->unknowns - of->question->level_count };
    result->solution = _arb_vec_init((slong)(legs * of->unknowns));
    arb_init(result->period);
    arb_init(result->trace);
    arb_init(result->determinant);
    arb_init(result->matrix_determinant);
    for (unsigned i = 0; i < 2; i++) acb_init(result->multiplier + i);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_init(result->least + i);
}

void jlt_cycle_result_clear(jlt_cycle_result *result)
{
    _arb_vec_clear(result->solution, (slong)(result->legs * result->unknowns));
    arb_clear(result->period);
    arb_clear(result->trace);
    arb_clear(result->determinant);
    arb_clear(result->matrix_determinant);
    for (unsigned i = 0; i < 2; i++) acb_clear(result->multiplier + i);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_clear(result->least + i);
}

/* Whether a power of D, by repeated squaring, is proved to shrink all vectors: all eigenvalues lie inside the unit circle. */
static bool contracts(const arb_mat_t D, slong bits)
{
    enum { SQUARINGS = 16 };
    bool found = false;
    JLT_SCOPED_MATRIX(arb, arb_mat_nrows(D), arb_mat_ncols(D), power);
    JLT_SCOPED(mag, norm);

    arb_mat_set(power, D);
    for (unsigned i = 0; !found && i <= SQUARINGS && arb_mat_is_finite(power); i++) {
        arb_mat_bound_inf_norm(norm, power);
        found = mag_cmp_2exp_si(norm, 0) < 0;
        arb_mat_sqr(power, power, bits);
    }
    return found;
}

/* Solve mu^2 - trace mu + determinant = 0. Both roots lie inside the unit circle by Jury's conditions; there is a saddle if
 * |trace| > |1 + determinant|, so that 1 or -1 lies between the roots, and determinant > 0. */
static void solve(jlt_cycle_result *result, const arb_mat_t D, slong bits)
{
    JLT_SCOPED(acb, half, root);
    JLT_SCOPED(arb, size);

    if (result->multipliers == 1) {
        acb_set_arb(result->multiplier, result->trace);
        arb_abs(size, result->trace);
        arb_sub_ui(size, size, 1, bits);
        result->sink = arb_is_negative(size);
    } else if (result->multipliers == 2) {
        acb_set_arb(half, result->trace);
        acb_mul_2exp_si(half, half, -1);
        acb_mul(root, half, half, bits);
        acb_sub_arb(root, root, result->determinant, bits);
        acb_sqrt(root, root, bits);
        acb_add(result->multiplier, half, root, bits);
        acb_sub(result->multiplier + 1, half, root, bits);
        arb_abs(size, result->trace);
        arb_sub(size, size, result->determinant, bits);
        arb_sub_ui(size, size, 1, bits);
        result->sink = arb_is_negative(size);
        arb_abs(size, result->determinant);
        arb_sub_ui(size, size, 1, bits);
        result->sink = result->sink && arb_is_negative(size);
        arb_add_ui(size, result->determinant, 1, bits);
        acb_set_arb(half, result->trace);
        arb_mul(acb_realref(half), acb_realref(half), acb_realref(half), bits);
        arb_submul(acb_realref(half), size, size, bits);
        result->saddle = arb_is_positive(acb_realref(half)) && arb_is_positive(result->determinant);
    } else result->sink = contracts(D, bits);
}

jlt_status jlt_cycle_prove(jlt_cycle *self, jlt_cycle_result *result, arb_srcptr box, arb_srcptr instants,
                           const unsigned *kept)
{
    const slong bits = jlt_step_bits(self->step);
    JLT_SCOPED_VECTOR(arb, own, (slong)result->legs);
    jlt_krawczyk_verdict verdict;
    jlt_krawczyk problem;
    JLT_CLEARED(shooting_clear) shooting orbit;

    _arb_vec_set(own, instants, (slong)result->legs);
    shooting_init(&orbit, self, own, result->legs, kept);
    problem = problem_of(&orbit);
    result->verdict = JLT_CYCLE_UNSHOWN;
    JLT_PASS(jlt_krawczyk_prove(&problem, &verdict, result->solution, box));
    if (verdict == JLT_KRAWCZYK_UNSHOWN) return JLT_OK;
    result->verdict = !orbit.goes_on ? JLT_CYCLE_STILL : orbit.closes ? JLT_CYCLE_PROVED : JLT_CYCLE_OPEN;
    if (result->verdict != JLT_CYCLE_PROVED) return JLT_OK;
    arb_set(result->period, orbit.time);
    arb_mat_trace(result->trace, orbit.D, bits);
    arb_mat_det(result->matrix_determinant, orbit.D, bits);
    arb_exp(result->determinant, orbit.expansion, bits);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_set(result->least + i, orbit.least + i);
    if (verdict == JLT_KRAWCZYK_CONTRADICTED || !arb_overlaps(result->determinant, result->matrix_determinant))
        result->verdict = JLT_CYCLE_CONTRADICTED;
    solve(result, orbit.D, bits);
    return JLT_OK;
}
