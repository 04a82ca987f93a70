#include "validated/homoclinic_chain.h"

/* Find the state other than the section's that the reversor flips. Returns false if there is not exactly one, it is not kept, or
 * the section is not mapped to itself. */
static bool find_flipped(unsigned *state, const jlt_homoclinic_question *question)
{
    const jlt_cycle_question *q = question->question;
    unsigned count = 0;

    if (question->signs == NULL || question->signs[q->column] > 0 || !arb_is_zero(q->section)) return false;
    for (unsigned i = 0; i < q->descriptor->state_count; i++)
        if (i != q->column && question->signs[i] < 0) *state = i, count++;
    return count == 1 && (*state == question->kept[0] || *state == question->kept[1]);
}

bool jlt_homoclinic_chain_init(jlt_homoclinic_chain *self, jlt_cycle *of, const jlt_homoclinic_question *question,
                               arb_srcptr saddle)
{
    const slong n = (slong)of->unknowns, count = n * (slong)question->legs, dim = (slong)of->formulas->dim;
    bool invertible;

    *self = (jlt_homoclinic_chain){ .of = of, .question = question };
    self->saddle = _arb_vec_init(n);
    self->own_instants = _arb_vec_init((slong)question->legs);
    self->point = _arb_vec_init(dim);
    arb_mat_init(self->inverse, 2, 2);
    arb_mat_init(self->DG, count, count);
    arb_mat_init(self->landing, dim, n);
    arb_init(self->start);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_init(self->least + i);
    _arb_vec_set(self->saddle, saddle, n);
    _arb_vec_set(self->own_instants, question->instants, (slong)question->legs);
    JLT_SCOPED_MATRIX(arb, 2, 2, frame);
    for (unsigned i = 0; i < 4; i++) arb_set(arb_mat_entry(frame, i / 2, i % 2), question->frame + i);
    invertible = arb_mat_inv(self->inverse, frame, jlt_step_bits(of->step));
    return find_flipped(&self->flipped, question) && invertible;
}

void jlt_homoclinic_chain_clear(jlt_homoclinic_chain *self)
{
    _arb_vec_clear(self->saddle, (slong)self->of->unknowns);
    _arb_vec_clear(self->own_instants, (slong)self->question->legs);
    _arb_vec_clear(self->point, (slong)self->of->formulas->dim);
    arb_mat_clear(self->inverse);
    arb_mat_clear(self->DG);
    arb_mat_clear(self->landing);
    arb_clear(self->start);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_clear(self->least + i);
}

/* The index of the unknown that a state is. */
static unsigned unknown_of(const jlt_homoclinic_chain *self, unsigned state)
{
    return state < self->of->question->column ? state : state - 1;
}

/* Box y around N: q = q* + frame (u, s), w = w* + dw/dq (q - q*), with dw/dq over a box that contains this w in its interior, so
 * that the level set is a graph over all of N. Returns false if that is not proved. */
static bool surround(jlt_homoclinic_chain *self, arb_ptr y)
{
    const jlt_homoclinic_question *q = self->question;
    const unsigned n = self->of->unknowns, m = n - 2;
    const slong bits = jlt_step_bits(self->of->step);
    bool inside = false;
    JLT_SCOPED_MATRIX(arb, 2, 1, away, xi);
    JLT_SCOPED_MATRIX(arb, 2, 2, frame);
    JLT_SCOPED_MATRIX(arb, m, 2, slope);
    JLT_SCOPED_MATRIX(arb, m, 1, left);

    arb_get_mag(arb_radref(arb_mat_entry(xi, 0, 0)), q->reach);
    arb_mul(arb_mat_entry(away, 0, 0), q->reach, q->slope, bits);
    arb_get_mag(arb_radref(arb_mat_entry(xi, 1, 0)), arb_mat_entry(away, 0, 0));
    for (unsigned i = 0; i < 4; i++) arb_set(arb_mat_entry(frame, i / 2, i % 2), q->frame + i);
    arb_mat_mul(away, frame, xi, bits);
    _arb_vec_set(y, self->saddle, n);
    for (unsigned k = 0; k < 2; k++) {
        arb_ptr out = y + unknown_of(self, q->kept[k]);
        arb_add(out, out, arb_mat_entry(away, k, 0), bits);
    }
    for (unsigned attempt = 0; attempt < 4 && !inside; attempt++) {
        if (!jlt_cycle_map_solve_levels(self->of, slope, y, q->kept)) break;
        arb_mat_mul(left, slope, away, bits);
        inside = true;
        for (unsigned i = 0, l = 0; i < n; i++) {
            if (jlt_cycle_map_is_kept(self->of, jlt_cycle_map_state(self->of, i), q->kept)) continue;
            arb_ptr w = arb_mat_entry(left, l++, 0);
            arb_add(w, w, self->saddle + i, bits);
            inside = inside && arb_contains_interior(y + i, w);
        }
        for (unsigned i = 0, l = 0; i < n && !inside; i++) {
            if (jlt_cycle_map_is_kept(self->of, jlt_cycle_map_state(self->of, i), q->kept)) continue;
            arb_set(y + i, arb_mat_entry(left, l++, 0));
            mag_mul_2exp_si(arb_radref(y + i), arb_radref(y + i), 1);
        }
        if (m == 0) inside = true;
    }
    return inside;
}

jlt_status jlt_homoclinic_chain_local(jlt_homoclinic_chain *self, arb_mat_t A, arb_ptr around, bool *determined)
{
    const jlt_homoclinic_question *q = self->question;
    const slong bits = jlt_step_bits(self->of->step);
    JLT_SCOPED_MATRIX(arb, 2, 2, D, frame);

    *determined = surround(self, around);
    if (!*determined) return JLT_OK;
    JLT_PASS(jlt_cycle_map_arrive(self->of, around, arb_midref(q->saddle_instant), q->question->direction, NULL));
    *determined = jlt_cycle_map_restrict(self->of, D, around, q->kept);
    for (unsigned i = 0; i < 4; i++) arb_set(arb_mat_entry(frame, i / 2, i % 2), q->frame + i);
    arb_mat_mul(A, D, frame, bits);
    arb_mat_mul(A, self->inverse, A, bits);
    return JLT_OK;
}

bool jlt_homoclinic_chain_is_cone(const jlt_homoclinic_chain *self, const arb_mat_t A)
{
    const slong bits = jlt_step_bits(self->of->step);
    bool is_cone;
    JLT_SCOPED(arb, s, along, across, size);

    arb_get_mag(arb_radref(s), self->question->slope);
    arb_set(along, arb_mat_entry(A, 0, 0));
    arb_addmul(along, arb_mat_entry(A, 0, 1), s, bits);
    arb_set(across, arb_mat_entry(A, 1, 0));
    arb_addmul(across, arb_mat_entry(A, 1, 1), s, bits);
    arb_abs(size, along);
    arb_sub_ui(size, size, 1, bits);
    is_cone = arb_is_positive(size);
    arb_div(across, across, along, bits);
    arb_abs(across, across);
    is_cone = is_cone && arb_lt(across, self->question->slope);
    return is_cone;
}

/* The first equation, x_0 on the graph: s - g(u) = 0. */
static void begin(jlt_homoclinic_chain *self, arb_mat_t G, arb_mat_t DG, arb_srcptr y)
{
    const jlt_homoclinic_question *q = self->question;
    const slong bits = jlt_step_bits(self->of->step);
    JLT_SCOPED(arb, away, across, g, slope);

    arb_zero(self->start);
    arb_get_mag(arb_radref(slope), q->slope);
    for (unsigned k = 0; k < 2; k++) {
        const unsigned i = unknown_of(self, q->kept[k]);
        arb_ptr out = arb_mat_entry(DG, 0, i);
        arb_sub(away, y + i, self->saddle + i, bits);
        arb_addmul(self->start, arb_mat_entry(self->inverse, 0, k), away, bits);
        arb_addmul(across, arb_mat_entry(self->inverse, 1, k), away, bits);
        arb_set(out, arb_mat_entry(self->inverse, 1, k));
        arb_submul(out, slope, arb_mat_entry(self->inverse, 0, k), bits);
    }
    arb_mul(g, slope, self->start, bits);
    arb_sub(arb_mat_entry(G, 0, 0), across, g, bits);
    arb_abs(away, self->start);
    self->inside = arb_lt(away, q->reach);
}

/* The last equations: levels, and 0 of the flipped state at the arrival from the last point. */
static void land(jlt_homoclinic_chain *self, arb_mat_t G, arb_mat_t DG, slong row, slong from, arb_srcptr y)
{
    const jlt_arrival *arrival = &self->of->arrival;

    jlt_cycle_map_level_equations(self->of, G, DG, row, from, y);
    row += self->of->question->level_count;
    arb_set(arb_mat_entry(G, row, 0), arrival->x + self->flipped);
    _arb_vec_set(self->point, arrival->x, (slong)self->of->formulas->dim);
    for (unsigned l = 0; l < self->of->unknowns; l++) {
        const unsigned state = jlt_cycle_map_state(self->of, l);
        arb_set(arb_mat_entry(DG, row, from + l), arb_mat_entry(arrival->slope, self->flipped, state));
        for (unsigned i = 0; i < self->of->formulas->dim; i++)
            arb_set(arb_mat_entry(self->landing, i, l), arb_mat_entry(arrival->slope, i, state));
    }
}

static jlt_status equations(void *context, arb_mat_t G, arb_mat_t DG, arb_srcptr y)
{
    jlt_homoclinic_chain *self = context;
    const jlt_homoclinic_question *q = self->question;
    const slong n = (slong)self->of->unknowns, last = (slong)q->legs - 1;

    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_pos_inf(self->least + i);
    self->meets = self->goes_on = true;
    begin(self, G, DG, y);
    for (slong i = 0; i <= last; i++) {
        arb_srcptr here = y + i * n;
        JLT_PASS(jlt_cycle_map_arrive(self->of, here, arb_midref(self->own_instants + i),
                                      i < last ? q->question->direction : q->landing, NULL));
        jlt_step_lower(self->least, self->of->arrival.least, JLT_ARRIVAL_VALIDS_MAX);
        self->goes_on = arb_is_positive(self->of->arrival.time) && self->goes_on;
        if (self->adjusts) arb_get_mid_arb(self->own_instants + i, self->of->arrival.time);
        if (i == last) land(self, G, DG, 1 + i * n, i * n, here);
        else {
            jlt_cycle_map_equations(self->of, G, DG, 1 + i * n, i * n, (i + 1) * n, here, here + n, q->kept);
            self->meets = jlt_cycle_map_meets(self->of, here + n, q->kept) && self->meets;
        }
    }
    arb_mat_set(self->DG, DG);
    return JLT_OK;
}

jlt_krawczyk jlt_homoclinic_chain_equations(jlt_homoclinic_chain *self)
{
    return (jlt_krawczyk){ .n = (slong)(self->question->legs * self->of->unknowns), .bits = jlt_step_bits(self->of->step),
                           .equations = equations, .context = self };
}
