#include "validated/jets.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

struct jlt_jets {
    const jlt_formulas *of;
    const ttc_program *program;
    unsigned order, length; /* length of every series: order + 1 */
    size_t size;
    bool *series;           /* (size,): depends on states */
    size_t *partner;        /* (size,): of a cosine or sine, where the other one is */
    arb_ptr values;         /* the states, (dim, length); the program's values, (size, length); partners */
    size_t count;           /* of balls in values */
    arb_ptr slopes;         /* (length,): j a_j */
    arb_t scratch;
};

static arb_ptr at(const jlt_jets *self, size_t value) { return self->values + (self->of->dim + value) * self->length; }

/* Which state a value is, free parameters behind the states; SIZE_MAX: it is none. */
static size_t state_of(const jlt_jets *self, ttc_value value)
{
    const ttc_instruction *i = ttc_program_at(self->program, value);

    if (i->op == TTC_OP_INPUT) return i->index;
    for (unsigned k = 0; i->op == TTC_OP_PARAMETER && k < self->of->free_count; k++)
        if (self->of->free[k] == i->index) return self->of->states + k;
    return SIZE_MAX;
}

/* Where the series of a value is. */
static arb_ptr series_of(const jlt_jets *self, ttc_value value)
{
    const size_t state = state_of(self, value);

    return state != SIZE_MAX ? self->values + state * self->length : at(self, value);
}

static jlt_status look_through(jlt_jets *self)
{
    size_t partners = 0;

    for (size_t v = 0; v < self->size; v++) {
        const ttc_instruction *i = ttc_program_at(self->program, (ttc_value)v);
        const ttc_value operands[] = { i->a, i->b, i->c };
        if (i->op == TTC_OP_FMA || i->op == TTC_OP_FMS || i->op == TTC_OP_FNMA) return JLT_ERR_UNSUPPORTED;
        self->series[v] = state_of(self, (ttc_value)v) != SIZE_MAX;
        for (unsigned k = 0; k < ttc_op_arity(i->op); k++) self->series[v] |= self->series[operands[k]];
        if (i->op == TTC_OP_COSINE || i->op == TTC_OP_SINE) self->partner[v] = self->size + partners++;
    }
    self->count = (self->of->dim + self->size + partners) * self->length;
    self->values = _arb_vec_init((slong)self->count);
    self->slopes = _arb_vec_init((slong)self->length);
    return JLT_OK;
}

jlt_status jlt_jets_create(jlt_jets **jets, const jlt_formulas *of, const ttc_program *program, unsigned order)
{
    jlt_jets *self = calloc(1, sizeof *self);
    jlt_status st = JLT_ERR_NOMEM;

    *jets = NULL;
    if (self == NULL) return st;
    arb_init(self->scratch);
    self->of = of;
    self->program = program;
    self->order = order;
    self->length = order + 1;
    self->size = ttc_program_size(program);
    self->series = calloc(self->size + 1, sizeof *self->series);
    self->partner = calloc(self->size + 1, sizeof *self->partner);
    if (self->series == NULL || self->partner == NULL) goto done;
    JLT_TRY(look_through(self));
    *jets = self;
    self = NULL; /* ownership moved to the caller */
done:
    jlt_jets_destroy(self);
    return st;
}

void jlt_jets_destroy(jlt_jets *jets)
{
    if (jets == NULL) return;
    if (jets->values != NULL) _arb_vec_clear(jets->values, (slong)jets->count);
    if (jets->slopes != NULL) _arb_vec_clear(jets->slopes, (slong)jets->length);
    arb_clear(jets->scratch);
    free(jets->series);
    free(jets->partner);
    free(jets);
}

/* out = (sum over j of j a_j b_(k-j))/k, j = 1 .. last */
static void slope(jlt_jets *self, arb_t out, arb_srcptr a, arb_srcptr b, unsigned k, unsigned last, slong bits)
{
    for (unsigned j = 1; j <= last; j++) arb_mul_ui(self->slopes + j, a + j, j, bits);
    arb_dot(out, NULL, 0, self->slopes + 1, 1, b + k - 1, -1, (slong)last, bits);
    arb_div_ui(out, out, k, bits);
}

static void root(arb_ptr r, arb_srcptr a, unsigned k, arb_t scratch, slong bits)
{
    if (k == 0) {
        arb_sqrt(r, a, bits);
        return;
    }
    arb_dot(scratch, a + k, 1, r + 1, 1, r + k - 1, -1, (slong)k - 1, bits);
    arb_mul_2exp_si(scratch, scratch, -1);
    arb_div(r + k, scratch, r, bits);
}

/* Coefficient k of the functions but the root. */
static void function(jlt_jets *self, ttc_op op, arb_ptr r, arb_ptr other, arb_srcptr a, unsigned k, slong bits)
{
    if (op == TTC_OP_EXP) {
        if (k == 0) arb_exp(r, a, bits);
        else slope(self, r + k, a, r, k, k, bits);
    } else if (op == TTC_OP_LOG) {
        if (k == 0) arb_log(r, a, bits);
        else {
            slope(self, self->scratch, r, a, k, k - 1, bits);
            arb_sub(self->scratch, a + k, self->scratch, bits);
            arb_div(r + k, self->scratch, a, bits);
        }
    } else {
        arb_ptr cosine = op == TTC_OP_COSINE ? r : other, sine = op == TTC_OP_COSINE ? other : r;
        if (k == 0) {
            arb_sin_cos(sine, cosine, a, bits);
        } else {
            slope(self, sine + k, a, cosine, k, k, bits);
            slope(self, cosine + k, a, sine, k, k, bits);
            arb_neg(cosine + k, cosine + k);
        }
    }
}

static void step(jlt_jets *self, ttc_value value, arb_srcptr params, unsigned k, slong bits)
{
    const ttc_instruction *i = ttc_program_at(self->program, value);
    const unsigned arity = ttc_op_arity(i->op);
    arb_ptr r = at(self, value);
    arb_srcptr a = arity > 0 ? series_of(self, i->a) : NULL, b = arity > 1 ? series_of(self, i->b) : NULL;

    switch (i->op) {
    case TTC_OP_INPUT: break;
    case TTC_OP_PARAMETER: if (state_of(self, value) == SIZE_MAX) arb_set(r, params + i->index); break;
    case TTC_OP_CONSTANT: arb_set_fmpq(r, i->constant, bits); break;
    case TTC_OP_PI: arb_const_pi(r, bits); break;
    case TTC_OP_NEGATE: arb_neg(r + k, a + k); break;
    case TTC_OP_ADD: arb_add(r + k, a + k, b + k, bits); break;
    case TTC_OP_SUBTRACT: arb_sub(r + k, a + k, b + k, bits); break;
    case TTC_OP_MULTIPLY: /* by a number: its series ends with order 0 */
        if (!self->series[i->a]) arb_mul(r + k, a, b + k, bits);
        else if (!self->series[i->b]) arb_mul(r + k, a + k, b, bits);
        else arb_dot(r + k, NULL, 0, a, 1, b + k, -1, (slong)k + 1, bits);
        break;
    case TTC_OP_DIVIDE:
        if (k == 0 || !self->series[i->b]) arb_div(r + k, a + k, b, bits);
        else {
            arb_dot(self->scratch, a + k, 1, b + 1, 1, r + k - 1, -1, (slong)k, bits);
            arb_div(r + k, self->scratch, b, bits);
        }
        break;
    case TTC_OP_ROOT: root(r, a, k, self->scratch, bits); break;
    default: function(self, i->op, r, self->partner[value] != 0 ? at(self, self->partner[value]) : NULL, a, k, bits); break;
    }
}

void jlt_jets_run(jlt_jets *self, arb_srcptr x, arb_srcptr params, slong bits)
{
    for (unsigned i = 0; i < self->of->dim; i++) {
        arb_set(self->values + i * self->length, x + i);
        for (unsigned k = 1; k <= self->order; k++) arb_zero(self->values + i * self->length + k);
    }
    for (unsigned k = 0; k == 0 || k < self->order; k++) {
        for (size_t v = 0; v < self->size; v++)
            if (k == 0 || self->series[v]) step(self, (ttc_value)v, params, k, bits);
        for (unsigned i = 0; k < self->order && i < self->of->states; i++)
            arb_div_ui(self->values + i * self->length + k + 1, jlt_jets_output(self, i) + k, k + 1, bits);
    }
}

arb_srcptr jlt_jets_state(const jlt_jets *self, unsigned i)
{
    return self->values + i * self->length;
}

arb_srcptr jlt_jets_output(const jlt_jets *self, unsigned i)
{
    return series_of(self, ttc_program_output_at(self->program, i));
}

unsigned jlt_jets_output_length(const jlt_jets *self, unsigned i)
{
    const ttc_value value = ttc_program_output_at(self->program, i);

    if (self->series[value]) return self->length - (self->order > 0);
    return arb_is_zero(at(self, value)) ? 0 : 1;
}
