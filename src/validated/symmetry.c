#include "validated/symmetry.h"

#include "core/memory.h"
#include "validated/cycle_map.h"

#include <math.h>

/* The parity of a function f under R: EVEN, f(Rx) = f(x); ODD, f(Rx) = -f(x); zero is both. */
enum { NONE = 0, EVEN = 1, ODD = 2, BOTH = 3 };

static unsigned char product(unsigned char a, unsigned char b)
{
    const bool even = (a & b) != NONE, odd = (a & EVEN && b & ODD) || (a & ODD && b & EVEN);

    return (unsigned char)((even ? EVEN : NONE) | (odd ? ODD : NONE));
}

/* The parity of one instruction's value; of: the parities of all values before it. */
static unsigned char parity(const ttc_instruction *i, const unsigned char *of, const signed char *signs)
{
    switch (i->op) {
    case TTC_OP_INPUT: return signs[i->index] > 0 ? EVEN : ODD;
    case TTC_OP_CONSTANT: return fmpq_is_zero(i->constant) ? BOTH : EVEN;
    case TTC_OP_PARAMETER:
    case TTC_OP_PI: return EVEN;
    case TTC_OP_NEGATE:
    case TTC_OP_SINE: return of[i->a];
    case TTC_OP_ADD:
    case TTC_OP_SUBTRACT: return of[i->a] & of[i->b];
    case TTC_OP_MULTIPLY:
    case TTC_OP_DIVIDE: return product(of[i->a], of[i->b]);
    case TTC_OP_COSINE: return of[i->a] != NONE ? EVEN : NONE;
    case TTC_OP_ROOT:
    case TTC_OP_EXP:
    case TTC_OP_LOG: return of[i->a] & EVEN;
    default: return NONE;
    }
}

bool jlt_symmetry_keeps(const jlt_cycle *of, const signed char *signs)
{
    const jlt_cycle_question *q = of->question;
    const ttc_program *program = of->formulas->levels;
    JLT_FREED unsigned char *parities = calloc(ttc_program_size(program) + 1, 1);
    bool keeps = parities != NULL && signs[q->column] < 0 && arb_is_zero(q->section);

    for (size_t v = 0; keeps && v < ttc_program_size(program); v++)
        parities[v] = parity(ttc_program_at(program, (ttc_value)v), parities, signs);
    for (unsigned j = 0; keeps && j < q->level_count; j++) {
        const unsigned char found = parities[ttc_program_output_at(program, j)];
        keeps = found & EVEN || (found & ODD && arb_is_zero(q->level_values + j));
    }
    return keeps;
}

static bool serves(const jlt_cycle *of, const jlt_reversor *reversor)
{
    return of->question->descriptor->claims[reversor->claim].verdict == JLT_PROVED && jlt_symmetry_keeps(of, reversor->signs);
}

/* The largest distance, along a state that the proof compares, of the images R x_(k-j) from the x_j. */
static double distance_of_image(const jlt_cycle *of, const signed char *signs, const double *x, unsigned legs, unsigned k)
{
    const unsigned states = of->question->descriptor->state_count;
    double largest = 0;

    for (unsigned j = 0; j < legs; j++)
        for (unsigned i = 0; i < of->unknowns; i++) {
            const unsigned state = jlt_cycle_map_state(of, i);
            largest = fmax(largest, fabs(signs[state] * x[(k + legs - j) % legs * states + state] - x[j * states + state]));
        }
    return largest;
}

jlt_status jlt_symmetry_foresee(double *miss, const jlt_cycle_question *question, const double *x, unsigned legs)
{
    const jlt_descriptor *d = question->descriptor;
    double size = 0;
    jlt_cycle *of;

    JLT_PASS(jlt_cycle_create(&of, question));
    *miss = INFINITY;
    for (unsigned i = 0; i < legs * d->state_count; i++) size = fmax(size, fabs(x[i]));
    for (unsigned i = 0; i < d->reversor_count; i++)
        for (unsigned k = 0; k < legs && serves(of, &d->reversors[i]); k++)
            *miss = fmin(*miss, distance_of_image(of, d->reversors[i].signs, x, legs, k) / size);
    jlt_cycle_destroy(of);
    return JLT_OK;
}

/* The legs of a cycle: its boxes, instants, windows around these, and the exact times of the legs. */
typedef struct {
    arb_srcptr box, instants;
    arb_ptr times, windows;
} passage;

/* Whether the images R y_(k-j) lie in the boxes, and their times in the windows. */
static bool is_image(const jlt_cycle *of, const jlt_cycle_result *cycle, unsigned k, const passage *legs_of,
                     const signed char *signs)
{
    const unsigned legs = cycle->legs, n = cycle->unknowns;
    const slong bits = jlt_step_bits(of->step);
    bool inside = true;
    JLT_SCOPED(arb, image);

    for (unsigned j = 0; inside && j < legs; j++) {
        const unsigned from = (k + legs - j) % legs;
        for (unsigned i = 0; inside && i < n; i++) {
            arb_set(image, cycle->solution + from * n + i);
            if (signs[jlt_cycle_map_state(of, i)] < 0) arb_neg(image, image);
            inside = arb_contains(legs_of->box + j * n + i, image);
        }
        arb_sub(image, legs_of->times + (from + legs - 1) % legs, legs_of->instants + j, bits);
        inside = inside && arb_contains(legs_of->windows + j, image);
    }
    return inside;
}

jlt_status jlt_symmetry_maps(jlt_cycle *of, bool *symmetric, const jlt_cycle_result *cycle, arb_srcptr box, arb_srcptr instants,
                             const signed char *signs)
{
    const unsigned n = cycle->unknowns;
    const int direction = of->question->direction;
    JLT_SCOPED_VECTOR(arb, times, (slong)cycle->legs);
    JLT_SCOPED_VECTOR(arb, windows, (slong)cycle->legs);
    const passage legs = { box, instants, times, windows };
    bool found = false;

    for (unsigned i = 0; i < cycle->legs; i++) {
        JLT_PASS(jlt_cycle_map_arrive(of, box + i * n, arb_midref(instants + i), direction, NULL));
        arb_set(legs.windows + i, of->arrival.window);
        JLT_PASS(jlt_cycle_map_arrive(of, cycle->solution + i * n, arb_midref(instants + i), direction, NULL));
        arb_set(legs.times + i, of->arrival.time);
    }
    for (unsigned k = 0; k < cycle->legs && !found; k++) found = is_image(of, cycle, k, &legs, signs);
    *symmetric = found;
    return JLT_OK;
}

static void judge(jlt_symmetry_result *result, const arb_t trace, slong bits)
{
    JLT_SCOPED(arb, bound);

    arb_abs(bound, trace);
    arb_sub_ui(bound, bound, 2, bits);
    if (arb_is_positive(bound))
        result->type = arb_is_positive(trace) ? JLT_SYMMETRY_HYPERBOLIC : JLT_SYMMETRY_INVERSE_HYPERBOLIC;
    else if (arb_is_negative(bound)) {
        result->type = JLT_SYMMETRY_ELLIPTIC;
        arb_mul_2exp_si(result->rotation, trace, -1);
        arb_acos(result->rotation, result->rotation, bits);
        arb_const_pi(bound, bits);
        arb_div(result->rotation, result->rotation, bound, bits);
        arb_mul_2exp_si(result->rotation, result->rotation, -1);
    }
}

jlt_status jlt_symmetry_prove(jlt_cycle *of, jlt_symmetry_result *result, const jlt_cycle_result *cycle, arb_srcptr box,
                              arb_srcptr instants)
{
    const jlt_descriptor *d = of->question->descriptor;
    bool symmetric = false;

    if (cycle->multipliers != 2) return JLT_ERR_ARG;
    result->verdict = JLT_SYMMETRY_NO_REVERSOR;
    for (unsigned i = 0; i < d->reversor_count && !symmetric; i++) {
        result->reversor = &d->reversors[i];
        if (!serves(of, result->reversor)) continue;
        JLT_PASS(jlt_symmetry_maps(of, &symmetric, cycle, box, instants, result->reversor->signs));
        result->verdict = symmetric ? JLT_SYMMETRY_PROVED : JLT_SYMMETRY_ASYMMETRIC;
    }
    if (symmetric) judge(result, cycle->trace, jlt_step_bits(of->step));
    return JLT_OK;
}

void jlt_symmetry_result_init(jlt_symmetry_result *result)
{
    *result = (jlt_symmetry_result){ .verdict = JLT_SYMMETRY_NO_REVERSOR };
    arb_init(result->rotation);
}

void jlt_symmetry_result_clear(jlt_symmetry_result *result)
{
    arb_clear(result->rotation);
}
