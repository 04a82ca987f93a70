#include "validated/cycle_map.h"

unsigned jlt_cycle_map_state(const jlt_cycle *self, unsigned i)
{
    return i < self->question->column ? i : i + 1;
}

static void place(jlt_cycle *self, arb_srcptr y)
{
    const jlt_cycle_question *q = self->question;

    for (unsigned i = 0; i < self->unknowns; i++) arb_set(self->state + jlt_cycle_map_state(self, i), y + i);
    arb_set(self->state + q->column, q->section);
    for (unsigned i = 0; i < q->free_count; i++) arb_set(self->state + self->formulas->states + i, q->params + q->free[i]);
}

jlt_status jlt_cycle_map_arrive(jlt_cycle *self, arb_srcptr y, const arf_t instant, int direction, arb_srcptr turns)
{
    const jlt_cycle_question *q = self->question;
    const slong bits = jlt_step_bits(self->step);
    jlt_status st;
    JLT_SCOPED(arb, section);

    arb_set(section, q->section);
    if (turns != NULL) arb_add(section, section, turns + q->column, bits);
    place(self, y);
    st = jlt_arrival_compute(&self->arrival, self->step, self->state, q->column, section, instant, direction);
    if (st == JLT_OK && turns != NULL) _arb_vec_sub(self->arrival.x, self->arrival.x, turns, (slong)self->formulas->states, bits);
    return st;
}

void jlt_cycle_map_gradients(jlt_cycle *self, arb_mat_t gradients, arb_ptr values, arb_srcptr y)
{
    const unsigned m = self->question->level_count;

    place(self, y);
    jlt_jets_run(self->levels, self->state, self->question->params, jlt_step_bits(self->step));
    for (unsigned j = 0; j < m; j++) {
        if (values != NULL) arb_set(values + j, jlt_jets_output(self->levels, j));
        for (unsigned i = 0; i < self->unknowns; i++)
            arb_set(arb_mat_entry(gradients, j, i),
                    jlt_jets_output(self->levels, m + j * self->formulas->dim + jlt_cycle_map_state(self, i)));
    }
}

void jlt_cycle_map_level_equations(jlt_cycle *self, arb_mat_t G, arb_mat_t DG, slong row, slong from, arb_srcptr y)
{
    const unsigned m = self->question->level_count, n = self->unknowns;
    JLT_SCOPED_VECTOR(arb, values, m + 1);
    JLT_SCOPED_MATRIX(arb, m, n, gradients);

    jlt_cycle_map_gradients(self, gradients, values, y);
    for (unsigned j = 0; j < m; j++) {
        arb_sub(arb_mat_entry(G, row + j, 0), values + j, self->question->level_values + j, jlt_step_bits(self->step));
        for (unsigned l = 0; l < n; l++) arb_set(arb_mat_entry(DG, row + j, from + l), arb_mat_entry(gradients, j, l));
    }
}

void jlt_cycle_map_equations(jlt_cycle *self, arb_mat_t G, arb_mat_t DG, slong row, slong from, slong to, arb_srcptr y,
                             arb_srcptr next, const unsigned *kept)
{
    const unsigned n = self->unknowns, k = n - self->question->level_count;
    const slong bits = jlt_step_bits(self->step);

    for (unsigned i = 0; i < k; i++) {
        for (unsigned l = 0; l < n; l++) {
            const unsigned state = jlt_cycle_map_state(self, l);
            arb_ptr out = arb_mat_entry(DG, row + i, from + l);
            arb_add(out, out, arb_mat_entry(self->arrival.slope, kept[i], state), bits);
            if (state != kept[i]) continue;
            arb_sub(arb_mat_entry(G, row + i, 0), self->arrival.x + state, next + l, bits);
            out = arb_mat_entry(DG, row + i, to + l);
            arb_sub_ui(out, out, 1, bits);
        }
    }
    jlt_cycle_map_level_equations(self, G, DG, row + k, from, y);
}

bool jlt_cycle_map_is_kept(const jlt_cycle *self, unsigned state, const unsigned *kept)
{
    for (unsigned i = 0; i < self->unknowns - self->question->level_count; i++)
        if (kept[i] == state) return true;
    return false;
}

bool jlt_cycle_map_solve_levels(jlt_cycle *self, arb_mat_t slope, arb_srcptr y, const unsigned *kept)
{
    const unsigned m = self->question->level_count, n = self->unknowns;
    const slong bits = jlt_step_bits(self->step);
    bool invertible;
    JLT_SCOPED_MATRIX(arb, m, n, gradients);
    JLT_SCOPED_MATRIX(arb, m, m, by_left, inverse);
    JLT_SCOPED_MATRIX(arb, m, n - m, by_kept);

    jlt_cycle_map_gradients(self, gradients, NULL, y);
    for (unsigned j = 0; j < m; j++) {
        unsigned left = 0, held = 0;
        for (unsigned i = 0; i < n; i++) {
            const bool keeps = jlt_cycle_map_is_kept(self, jlt_cycle_map_state(self, i), kept);
            arb_set(keeps ? arb_mat_entry(by_kept, j, held) : arb_mat_entry(by_left, j, left), arb_mat_entry(gradients, j, i));
            if (keeps) held++;
            else left++;
        }
    }
    invertible = m == 0 || arb_mat_inv(inverse, by_left, bits);
    arb_mat_mul(slope, inverse, by_kept, bits);
    arb_mat_neg(slope, slope);
    return invertible;
}

bool jlt_cycle_map_meets(jlt_cycle *self, arb_srcptr next, const unsigned *kept)
{
    const unsigned m = self->question->level_count, n = self->unknowns;
    JLT_SCOPED_VECTOR(arb, hull, n);
    JLT_SCOPED_MATRIX(arb, m, n - m, slope);

    for (unsigned i = 0; i < n; i++) {
        const unsigned state = jlt_cycle_map_state(self, i);
        arb_set(hull + i, next + i);
        if (!jlt_cycle_map_is_kept(self, state, kept))
            arb_union(hull + i, next + i, self->arrival.x + state, jlt_step_bits(self->step));
    }
    return jlt_cycle_map_solve_levels(self, slope, hull, kept);
}

bool jlt_cycle_map_restrict(jlt_cycle *self, arb_mat_t D, arb_srcptr y, const unsigned *kept)
{
    const unsigned m = self->question->level_count, n = self->unknowns, k = n - m;
    const slong bits = jlt_step_bits(self->step);
    bool invertible;
    JLT_SCOPED_MATRIX(arb, m, k, slope);

    invertible = jlt_cycle_map_solve_levels(self, slope, y, kept);
    for (unsigned i = 0; invertible && i < k; i++)
        for (unsigned l = 0; l < k; l++) {
            arb_ptr out = arb_mat_entry(D, i, l);
            unsigned left = 0;
            arb_set(out, arb_mat_entry(self->arrival.slope, kept[i], kept[l]));
            for (unsigned u = 0; u < n; u++) {
                const unsigned state = jlt_cycle_map_state(self, u);
                if (jlt_cycle_map_is_kept(self, state, kept)) continue;
                arb_addmul(out, arb_mat_entry(self->arrival.slope, kept[i], state), arb_mat_entry(slope, left, l), bits);
                left++;
            }
        }
    return invertible;
}
