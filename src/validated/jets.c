#include "validated/jets.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

struct jlt_jets {
    const jlt_formulas *of;
    const ttc_program *program;
    unsigned order, length; /* length of every series: order + 1 */
    unsigned degree, terms; /* of the polynomials; each of their `terms` coefficients is a time series */
    size_t size;
    bool *series;           /* (size,): whether the value depends on states */
    size_t *place;          /* (size,): where its series begins in `values` */
    size_t *partner;        /* (size,): for a cosine, where the sine of its argument is, and the reverse; else 0 */
    arb_ptr values;         /* states, (dim, terms, length); the program's values, (size, terms, length); then the partners */
    size_t count;           /* number of balls in values */
    arb_ptr slopes;         /* (length,): w(p) a_p, see slope() */
    arb_t scratch;
};

static arb_ptr at(const jlt_jets *self, size_t value)
{
    return self->values + (self->of->dim + value) * self->terms * self->length;
}

/* The index of the state that a value is, free parameters being appended to the states; SIZE_MAX if it is not a state. */
static size_t state_of(const jlt_jets *self, ttc_value value)
{
    const ttc_instruction *i = ttc_program_at(self->program, value);

    if (i->op == TTC_OP_INPUT) return i->index;
    for (unsigned k = 0; i->op == TTC_OP_PARAMETER && k < self->of->free_count; k++)
        if (self->of->free[k] == i->index) return self->of->states + k;
    return SIZE_MAX;
}

/* The series of a value. */
static arb_ptr series_of(const jlt_jets *self, ttc_value value) { return self->values + self->place[value]; }

static jlt_status look_through(jlt_jets *self)
{
    size_t partners = 0;

    for (size_t v = 0; v < self->size; v++) {
        const ttc_instruction *i = ttc_program_at(self->program, (ttc_value)v);
        if (i->op == TTC_OP_FMA || i->op == TTC_OP_FMS || i->op == TTC_OP_FNMA) return JLT_ERR_UNSUPPORTED;
        const size_t state = state_of(self, (ttc_value)v);
        self->series[v] = state != SIZE_MAX;
        self->place[v] = (state != SIZE_MAX ? state : self->of->dim + v) * self->terms * self->length;
        for (unsigned k = 0; k < ttc_op_arity(i->op); k++) self->series[v] |= self->series[i->operands[k]];
        if (i->op == TTC_OP_COSINE || i->op == TTC_OP_SINE) self->partner[v] = self->size + partners++;
    }
    self->count = (self->of->dim + self->size + partners) * self->terms * self->length;
    self->values = _arb_vec_init((slong)self->count);
    self->slopes = _arb_vec_init((slong)self->length);
    return JLT_OK;
}

unsigned jlt_jets_terms(unsigned degree) { return (degree + 1) * (degree + 2) / 2; }

jlt_status jlt_jets_create(jlt_jets **jets, const jlt_formulas *of, const ttc_program *program, unsigned order, unsigned degree)
{
    JLT_OWNED(jlt_jets) *self = calloc(1, sizeof *self);

    *jets = NULL;
    if (self == NULL) return JLT_ERR_NOMEM;
    arb_init(self->scratch);
    self->of = of;
    self->program = program;
    self->order = order;
    self->length = order + 1;
    self->degree = degree;
    self->terms = jlt_jets_terms(degree);
    self->size = ttc_program_size(program);
    self->series = calloc(self->size + 1, sizeof *self->series);
    self->partner = calloc(self->size + 1, sizeof *self->partner);
    self->place = calloc(self->size + 1, sizeof *self->place);
    if (self->series == NULL || self->partner == NULL || self->place == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(look_through(self));
    *jets = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

void jlt_jets_destroy(jlt_jets *jets)
{
    if (jets == NULL) return;
    if (jets->values != NULL) _arb_vec_clear(jets->values, (slong)jets->count);
    if (jets->slopes != NULL) _arb_vec_clear(jets->slopes, (slong)jets->length);
    arb_clear(jets->scratch);
    free(jets->series);
    free(jets->place);
    free(jets->partner);
    free(jets);
}

/* The index of the coefficient of t^k u^i v^j. */
typedef struct {
    unsigned k, i, j, term; /* term: index of u^i v^j in the polynomial, ordered by degree i + j */
} place;

static unsigned term_of(unsigned i, unsigned j) { return (i + j) * (i + j + 1) / 2 + j; }

/* Terms to omit from a sum of products a_p b_(n-p): p = 0, or p = n. */
enum { ALL = 0, NOT_FIRST = 1, NOT_LAST = 2 };

/* out = start +- sum of a_p b_(n-p), p from 0 to n; start may be NULL, meaning 0, or out. */
static void convolve(const jlt_jets *self, arb_t out, const arb_t start, bool minus, arb_srcptr a, arb_srcptr b, place n,
                     int without, slong bits)
{
    for (unsigned i = 0; i <= n.i; i++)
        for (unsigned j = 0; j <= n.j; j++) {
            const unsigned term = term_of(i, j), first = term == 0 && without & NOT_FIRST ? 1 : 0;
            const unsigned end = term == n.term && without & NOT_LAST ? n.k : n.k + 1;
            arb_srcptr from = a + term * self->length + first, to = b + term_of(n.i - i, n.j - j) * self->length + n.k - first;
            if (first <= end) arb_dot(out, start, minus, from, 1, to, -1, (slong)(end - first), bits);
            start = out;
        }
}

/* out = (sum over p of w(p) a_p b_(n-p))/w(n), the coefficient of the integral of a' b. The weight w is the order in t; if n has
 * order 0 in t, it is the degree in u and v. */
static void slope(jlt_jets *self, arb_t out, arb_srcptr a, arb_srcptr b, place n, int without, slong bits)
{
    arb_zero(out);
    for (unsigned i = 0; i <= n.i; i++)
        for (unsigned j = 0; j <= n.j; j++) {
            const unsigned term = term_of(i, j), first = n.k > 0 ? 1 : 0;
            const unsigned end = term == n.term && without & NOT_LAST ? n.k : n.k + 1;
            if (n.k == 0 && term == 0) continue; /* the weight is 0, and b_n is not known yet */
            for (unsigned k = first; k < end; k++)
                arb_mul_ui(self->slopes + k, a + term * self->length + k, n.k > 0 ? k : i + j, bits);
            if (first < end)
                arb_dot(out, out, 0, self->slopes + first, 1, b + term_of(n.i - i, n.j - j) * self->length + n.k - first, -1,
                        (slong)(end - first), bits);
        }
    arb_div_ui(out, out, n.k > 0 ? n.k : n.i + n.j, bits);
}

static void root(const jlt_jets *self, arb_ptr r, arb_srcptr a, place n, arb_t scratch, slong bits)
{
    const size_t here = n.term * self->length + n.k;

    if (here == 0) {
        arb_sqrt(r, a, bits);
        return;
    }
    convolve(self, scratch, a + here, true, r, r, n, NOT_FIRST | NOT_LAST, bits);
    arb_mul_2exp_si(scratch, scratch, -1);
    arb_div(r + here, scratch, r, bits);
}

/* Coefficient n of the functions other than the root. */
static void function(jlt_jets *self, ttc_op op, arb_ptr r, arb_ptr other, arb_srcptr a, place n, slong bits)
{
    const size_t here = n.term * self->length + n.k;

    if (op == TTC_OP_EXP) {
        if (here == 0) arb_exp(r, a, bits);
        else slope(self, r + here, a, r, n, ALL, bits);
    } else if (op == TTC_OP_LOG) {
        if (here == 0) arb_log(r, a, bits);
        else {
            slope(self, self->scratch, r, a, n, NOT_LAST, bits);
            arb_sub(self->scratch, a + here, self->scratch, bits);
            arb_div(r + here, self->scratch, a, bits);
        }
    } else {
        arb_ptr cosine = op == TTC_OP_COSINE ? r : other, sine = op == TTC_OP_COSINE ? other : r;
        if (here == 0) {
            arb_sin_cos(sine, cosine, a, bits);
        } else {
            slope(self, sine + here, a, cosine, n, ALL, bits);
            slope(self, cosine + here, a, sine, n, ALL, bits);
            arb_neg(cosine + here, cosine + here);
        }
    }
}

static void step(jlt_jets *self, ttc_value value, arb_srcptr params, place n, slong bits)
{
    const ttc_instruction *i = ttc_program_at(self->program, value);
    const unsigned arity = ttc_op_arity(i->op);
    const size_t here = n.term * self->length + n.k;
    arb_ptr r = at(self, value);
    arb_srcptr a = arity > 0 ? series_of(self, i->a) : NULL, b = arity > 1 ? series_of(self, i->b) : NULL;

    switch (i->op) {
    case TTC_OP_INPUT: break;
    case TTC_OP_PARAMETER: if (series_of(self, value) == r) arb_set(r, params + i->index); break;
    case TTC_OP_CONSTANT: arb_set_fmpq(r, i->constant, bits); break;
    case TTC_OP_PI: arb_const_pi(r, bits); break;
    case TTC_OP_NEGATE: arb_neg(r + here, a + here); break;
    case TTC_OP_ADD: arb_add(r + here, a + here, b + here, bits); break;
    case TTC_OP_SUBTRACT: arb_sub(r + here, a + here, b + here, bits); break;
    case TTC_OP_MULTIPLY: /* a factor that does not depend on states has only the coefficient of order 0 */
        if (!self->series[i->a]) arb_mul(r + here, a, b + here, bits);
        else if (!self->series[i->b]) arb_mul(r + here, a + here, b, bits);
        else convolve(self, r + here, NULL, false, a, b, n, ALL, bits);
        break;
    case TTC_OP_DIVIDE:
        if (here == 0 || !self->series[i->b]) arb_div(r + here, a + here, b, bits);
        else {
            convolve(self, self->scratch, a + here, true, b, r, n, NOT_FIRST, bits);
            arb_div(r + here, self->scratch, b, bits);
        }
        break;
    case TTC_OP_ROOT: root(self, r, a, n, self->scratch, bits); break;
    default: function(self, i->op, r, self->partner[value] != 0 ? at(self, self->partner[value]) : NULL, a, n, bits); break;
    }
}

/* Compute the coefficients of t^k of all values; values that do not depend on states have only that of t^0. */
static void run_order(jlt_jets *self, arb_srcptr params, unsigned k, slong bits)
{
    for (size_t v = 0; v < self->size; v++) {
        if (k > 0 && !self->series[v]) continue;
        for (unsigned degree = 0; degree <= (self->series[v] ? self->degree : 0); degree++)
            for (unsigned j = 0; j <= degree; j++)
                step(self, (ttc_value)v, params, (place){ k, degree - j, j, term_of(degree - j, j) }, bits);
    }
}

void jlt_jets_run(jlt_jets *self, arb_srcptr x, arb_srcptr params, slong bits)
{
    for (unsigned i = 0; i < self->of->dim * self->terms; i++) {
        arb_set(self->values + i * self->length, x + i);
        for (unsigned k = 1; k <= self->order; k++) arb_zero(self->values + i * self->length + k);
    }
    for (unsigned k = 0; k == 0 || k < self->order; k++) {
        run_order(self, params, k, bits);
        for (unsigned i = 0; k < self->order && i < self->of->states; i++)
            for (unsigned term = 0; term < self->terms; term++)
                arb_div_ui(self->values + (i * self->terms + term) * self->length + k + 1,
                           jlt_jets_output(self, i) + term * self->length + k, k + 1, bits);
    }
}

arb_srcptr jlt_jets_state(const jlt_jets *self, unsigned i)
{
    return self->values + i * self->terms * self->length;
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
