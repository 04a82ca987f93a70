#include "validated/cycle_map.h"

#include <math.h>
#include <stdlib.h>

enum { NEWTON_STEPS = 12 };

jlt_status jlt_cycle_create(jlt_cycle **cycle, const jlt_cycle_question *question)
{
    jlt_cycle *self = calloc(1, sizeof *self);
    jlt_status st = JLT_ERR_NOMEM;

    *cycle = NULL;
    if (self == NULL) return st;
    self->question = question;
    st = JLT_ERR_ARG;
    if (question->descriptor->state_count > JLT_CYCLE_STATES_MAX
        || question->descriptor->state_count < 2 + question->level_count)
        goto done;
    JLT_TRY(jlt_formulas_create(&self->formulas, question->descriptor, question->free, question->free_count, question->levels,
                                question->level_count));
    self->unknowns = self->formulas->states - 1;
    self->state = _arb_vec_init((slong)self->formulas->dim);
    jlt_arrival_init(&self->arrival, self->formulas->dim);
    JLT_TRY(jlt_step_create(&self->step, self->formulas, question->params, jlt_step_accuracy_for(question->digits)));
    JLT_TRY(jlt_jets_create(&self->levels, self->formulas, self->formulas->levels, 0));
    *cycle = self;
    self = NULL; /* ownership moved to the caller */
done:
    jlt_cycle_destroy(self);
    return st;
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

/* Elimination with full pivoting of the gradients' middles: the columns of the pivots are left out. */
jlt_status jlt_cycle_choose(jlt_cycle *self, unsigned *kept, arb_srcptr y)
{
    const unsigned m = self->question->level_count, n = self->unknowns;
    double a[JLT_FORMULAS_LEVELS_MAX][JLT_CYCLE_STATES_MAX];
    bool left[JLT_CYCLE_STATES_MAX] = { false };
    arb_mat_t gradients;
    unsigned count = 0;

    arb_mat_init(gradients, m, n);
    jlt_cycle_map_gradients(self, gradients, NULL, y);
    for (unsigned j = 0; j < m; j++)
        for (unsigned i = 0; i < n; i++) a[j][i] = arf_get_d(arb_midref(arb_mat_entry(gradients, j, i)), ARF_RND_NEAR);
    arb_mat_clear(gradients);
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

/* G and DG at or over y, by one arrival. */
static jlt_status equations(jlt_cycle *self, arb_mat_t G, arb_mat_t DG, arb_srcptr y, const arf_t instant, const unsigned *kept)
{
    const jlt_status st = jlt_cycle_map_arrive(self, y, instant);

    if (st == JLT_OK) jlt_cycle_map_equations(self, G, DG, y, kept);
    return st;
}

/* The inverse of the middle, exact; false where it has none. */
static bool invert_middle(arb_mat_t M, const arb_mat_t DG, slong bits)
{
    arb_mat_t middle;
    bool regular;

    arb_mat_init(middle, arb_mat_nrows(DG), arb_mat_ncols(DG));
    arb_mat_get_mid(middle, DG);
    regular = arb_mat_inv(M, middle, bits);
    arb_mat_get_mid(M, M);
    arb_mat_clear(middle);
    return regular;
}

/* log2 of the largest entry. */
static double size_of(const arb_mat_t column)
{
    double size = -INFINITY;
    mag_t bound;

    mag_init(bound);
    for (slong i = 0; i < arb_mat_nrows(column); i++) {
        arb_get_mag(bound, arb_mat_entry(column, i, 0));
        size = fmax(size, mag_get_d_log2_approx(bound));
    }
    mag_clear(bound);
    return size;
}

jlt_status jlt_cycle_refine(jlt_cycle *self, arb_ptr y, arf_t instant, const unsigned *kept)
{
    const slong n = (slong)self->unknowns, bits = jlt_step_bits(self->step);
    /* the error of what comes out is about the square of the last correction, that of the instant the correction itself */
    const double enough = -2.6 * self->question->digits;
    jlt_status st = JLT_ERR_NO_CONVERGENCE;
    double size = INFINITY;
    arb_mat_t G, DG, M, correction;

    arb_mat_init(G, n, 1);
    arb_mat_init(correction, n, 1);
    arb_mat_init(DG, n, n);
    arb_mat_init(M, n, n);
    for (unsigned attempt = 0; attempt < NEWTON_STEPS && size > enough; attempt++) {
        JLT_TRY(equations(self, G, DG, y, instant, kept));
        arf_set_round(instant, arb_midref(self->arrival.time), bits, ARF_RND_DOWN);
        st = JLT_ERR_NO_CONVERGENCE;
        if (!invert_middle(M, DG, bits)) goto done;
        arb_mat_mul(correction, M, G, bits);
        size = size_of(correction);
        if (!(size < 0)) goto done;
        for (slong i = 0; i < n; i++) {
            arb_sub(y + i, y + i, arb_mat_entry(correction, i, 0), bits);
            arb_get_mid_arb(y + i, y + i);
        }
    }
    st = size <= enough ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
done:
    arb_mat_clear(G);
    arb_mat_clear(correction);
    arb_mat_clear(DG);
    arb_mat_clear(M);
    return st;
}

void jlt_cycle_result_init(jlt_cycle_result *result, const jlt_cycle *of)
{
    *result = (jlt_cycle_result){ .unknowns = of->unknowns, .multipliers = of->unknowns - of->question->level_count };
    result->solution = _arb_vec_init((slong)of->unknowns);
    arb_init(result->period);
    arb_init(result->trace);
    arb_init(result->determinant);
    arb_init(result->matrix_determinant);
    for (unsigned i = 0; i < 2; i++) acb_init(result->multiplier + i);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_init(result->least + i);
}

void jlt_cycle_result_clear(jlt_cycle_result *result)
{
    _arb_vec_clear(result->solution, (slong)result->unknowns);
    arb_clear(result->period);
    arb_clear(result->trace);
    arb_clear(result->determinant);
    arb_clear(result->matrix_determinant);
    for (unsigned i = 0; i < 2; i++) acb_clear(result->multiplier + i);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_clear(result->least + i);
}

/* Krawczyk's operator, see cycle.h: y0, M and M G(y0) are those of the first box for all. */
typedef struct {
    slong n, bits;
    arb_ptr middle;
    arb_mat_t M, offset, DG, unused;
} operator;

static void operator_clear(operator *self)
{
    _arb_vec_clear(self->middle, self->n);
    arb_mat_clear(self->M);
    arb_mat_clear(self->offset);
    arb_mat_clear(self->DG);
    arb_mat_clear(self->unused);
}

/* At the middle of the box; M is the inverse near it. *regular: there is one. */
static jlt_status operator_init(operator *self, jlt_cycle *cycle, bool *regular, arb_srcptr box, const arf_t instant,
                                const unsigned *kept)
{
    const slong n = (slong)cycle->unknowns;
    arb_mat_t G;
    jlt_status st;

    *self = (operator){ .n = n, .bits = jlt_step_bits(cycle->step), .middle = _arb_vec_init(n) };
    arb_mat_init(self->M, n, n);
    arb_mat_init(self->offset, n, 1);
    arb_mat_init(self->DG, n, n);
    arb_mat_init(self->unused, n, 1);
    arb_mat_init(G, n, 1);
    for (slong i = 0; i < n; i++) arb_get_mid_arb(self->middle + i, box + i);
    st = equations(cycle, G, self->DG, self->middle, instant, kept);
    *regular = st == JLT_OK && invert_middle(self->M, self->DG, self->bits);
    arb_mat_mul(self->offset, self->M, G, self->bits);
    arb_mat_clear(G);
    return st;
}

/* K(y), by one arrival from all of y, which the cycle keeps. */
static jlt_status operator_apply(operator *self, jlt_cycle *cycle, arb_ptr K, arb_srcptr y, const arf_t instant,
                                 const unsigned *kept)
{
    const slong n = self->n;
    arb_mat_t rest, away;
    jlt_status st;

    arb_mat_init(rest, n, n);
    arb_mat_init(away, n, 1);
    JLT_TRY(equations(cycle, self->unused, self->DG, y, instant, kept));
    arb_mat_mul(rest, self->M, self->DG, self->bits);
    arb_mat_neg(rest, rest);
    for (slong i = 0; i < n; i++) {
        arb_add_ui(arb_mat_entry(rest, i, i), arb_mat_entry(rest, i, i), 1, self->bits);
        arb_sub(arb_mat_entry(away, i, 0), y + i, self->middle + i, self->bits);
    }
    arb_mat_mul(away, rest, away, self->bits);
    arb_mat_sub(away, away, self->offset, self->bits);
    for (slong i = 0; i < n; i++) arb_add(K + i, arb_mat_entry(away, i, 0), self->middle + i, self->bits);
done:
    arb_mat_clear(rest);
    arb_mat_clear(away);
    return st;
}

static bool all_inside(arb_srcptr outer, arb_srcptr inner, slong n)
{
    for (slong i = 0; i < n; i++)
        if (!arb_is_finite(inner + i) || !arb_contains_interior(outer + i, inner + i)) return false;
    return true;
}

/* log2 of the longest edge. */
static double width_of(arb_srcptr box, slong n)
{
    double width = -INFINITY;

    for (slong i = 0; i < n; i++) width = fmax(width, mag_get_d_log2_approx(arb_radref(box + i)));
    return width;
}

/* The box proved, then smaller and smaller ones around the zero, as long as they shrink; the last arrival is from the result. */
static jlt_status krawczyk(jlt_cycle *self, jlt_cycle_result *result, arb_srcptr box, const arf_t instant, const unsigned *kept)
{
    const slong n = (slong)self->unknowns;
    arb_ptr K = _arb_vec_init(n);
    bool regular = false;
    operator op;
    jlt_status st;

    result->verdict = JLT_CYCLE_UNSHOWN;
    JLT_TRY(operator_init(&op, self, &regular, box, instant, kept));
    if (!regular) goto done;
    JLT_TRY(operator_apply(&op, self, K, box, instant, kept));
    if (!all_inside(box, K, n)) goto done;
    result->verdict = JLT_CYCLE_PROVED;
    for (double before = INFINITY; width_of(K, n) < before - 3;) {
        before = width_of(K, n);
        _arb_vec_set(result->solution, K, n);
        JLT_TRY(operator_apply(&op, self, K, result->solution, instant, kept));
        for (slong i = 0; i < n; i++)
            if (!arb_intersection(K + i, K + i, result->solution + i, op.bits)) result->verdict = JLT_CYCLE_CONTRADICTED;
    }
done:
    operator_clear(&op);
    _arb_vec_clear(K, n);
    return st;
}

/* Roots of mu^2 - trace mu + determinant; and Jury's conditions that both lie inside the unit circle. */
static void solve(jlt_cycle_result *result, slong bits)
{
    acb_t half, root;
    arb_t size;

    acb_init(half);
    acb_init(root);
    arb_init(size);
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
    }
    acb_clear(half);
    acb_clear(root);
    arb_clear(size);
}

jlt_status jlt_cycle_prove(jlt_cycle *self, jlt_cycle_result *result, arb_srcptr box, const arf_t instant, const unsigned *kept)
{
    const slong bits = jlt_step_bits(self->step);
    arb_mat_t D;
    jlt_status st;

    arb_mat_init(D, result->multipliers, result->multipliers);
    JLT_TRY(krawczyk(self, result, box, instant, kept));
    if (result->verdict != JLT_CYCLE_PROVED) goto done;
    result->steps = self->arrival.steps;
    if (!jlt_cycle_map_restrict(self, D, result->solution, kept)) {
        result->verdict = JLT_CYCLE_OPEN;
        goto done;
    }
    arb_set(result->period, self->arrival.time);
    arb_mat_trace(result->trace, D, bits);
    arb_mat_det(result->matrix_determinant, D, bits);
    arb_exp(result->determinant, self->arrival.expansion, bits);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_set(result->least + i, self->arrival.least + i);
    if (!arb_overlaps(result->determinant, result->matrix_determinant)) result->verdict = JLT_CYCLE_CONTRADICTED;
    solve(result, bits);
done:
    arb_mat_clear(D);
    return st;
}
