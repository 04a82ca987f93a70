/* List scheduling for few live temporaries. Among the operations whose operands are there, the next is the one that frees
 * most temporaries; ties, and near ties by a weight that several tries vary, go to the longest chain that still hangs on
 * it. The order as it came, and the tries: the one with the fewest temporaries alive at once is kept. */
#include "optimize/program.h"

#include <stdlib.h>

enum { TRIES = 6 };

typedef struct {
    const ttc_program *program;
    size_t n;
    unsigned *uses;      /* by value: uses as an operand that are still to come */
    unsigned *waiting;   /* by value: operands not yet there */
    unsigned *chain;     /* by value: longest way to an output, in rough latencies */
    unsigned char *done;
    ttc_value *order;
    unsigned *counts;    /* a copy of uses, for a fresh try */
} scheduler;

static bool is_leaf(const scheduler *s, ttc_value value)
{
    return ttc_op_arity(ttc_program_at(s->program, value)->op) == 0;
}

/* Distinct operands, at most three; returns their number. */
static unsigned operands_of(const scheduler *s, ttc_value value, ttc_value *operands)
{
    const ttc_instruction *i = ttc_program_at(s->program, value);
    const ttc_value all[] = { i->a, i->b, i->c };
    unsigned count = 0;
    for (unsigned k = 0; k < ttc_op_arity(i->op); k++) {
        bool known = false;
        for (unsigned j = 0; j < count; j++) known |= operands[j] == all[k];
        if (!known) operands[count++] = all[k];
    }
    return count;
}

static void prepare(scheduler *s)
{
    ttc_value operands[3];
    for (size_t k = s->n; k-- > 0;) {
        unsigned count = operands_of(s, (ttc_value)k, operands);
        unsigned chain = s->chain[k] + ttc_op_latency(ttc_program_at(s->program, (ttc_value)k)->op);
        for (unsigned j = 0; j < count; j++) {
            s->counts[operands[j]]++;
            if (s->chain[operands[j]] < chain) s->chain[operands[j]] = chain;
        }
    }
}

/* Temporaries freed by an operation, less the one it makes. */
static int relief_of(const scheduler *s, ttc_value value)
{
    ttc_value operands[3];
    unsigned count = operands_of(s, value, operands);
    int relief = s->counts[value] == 0 ? 0 : -1;
    for (unsigned j = 0; j < count; j++) relief += s->uses[operands[j]] == 1 && !is_leaf(s, operands[j]);
    return relief;
}

static void start(scheduler *s)
{
    ttc_value operands[3];
    for (size_t k = 0; k < s->n; k++) {
        s->uses[k] = s->counts[k];
        s->done[k] = is_leaf(s, (ttc_value)k);
        s->waiting[k] = 0;
        unsigned count = operands_of(s, (ttc_value)k, operands);
        for (unsigned j = 0; j < count; j++) s->waiting[k] += !is_leaf(s, operands[j]);
    }
}

static void finish(scheduler *s, ttc_value value)
{
    ttc_value operands[3];
    unsigned count = operands_of(s, value, operands);
    s->done[value] = 1;
    for (unsigned j = 0; j < count; j++) s->uses[operands[j]]--;
    for (size_t k = value + 1; k < s->n; k++) {
        count = operands_of(s, (ttc_value)k, operands);
        for (unsigned j = 0; j < count; j++) s->waiting[k] -= operands[j] == value;
    }
}

/* One schedule; returns the most temporaries alive at once. Leaves come first: they take no temporary. */
static unsigned schedule(scheduler *s, unsigned weight, ttc_value *order)
{
    size_t count = 0;
    int live = 0, most = 0;
    start(s);
    for (size_t k = 0; k < s->n; k++)
        if (s->done[k]) order[count++] = (ttc_value)k;
    while (count < s->n) {
        ttc_value best = TTC_NO_VALUE;
        long best_score = 0;
        for (size_t k = 0; k < s->n; k++) {
            if (s->done[k] || s->waiting[k] > 0) continue;
            long score = 64L * relief_of(s, (ttc_value)k) + (long)(weight * s->chain[k]);
            if (best != TTC_NO_VALUE && score <= best_score) continue;
            best = (ttc_value)k;
            best_score = score;
        }
        int relief = relief_of(s, best);
        if (live + 1 > most) most = live + 1;
        live -= relief;
        order[count++] = best;
        finish(s, best);
    }
    return (unsigned)most;
}

ttc_program *ttc_program_schedule(const ttc_program *program)
{
    size_t n = ttc_program_size(program);
    static const unsigned weights[TRIES] = { 1, 4, 8, 16, 32, 64 };
    scheduler s = { .program = program, .n = n };
    ttc_program *best = ttc_program_trim(program);
    unsigned best_live = ttc_program_count(program).live;
    s.uses = calloc(n + 1, sizeof *s.uses);
    s.waiting = calloc(n + 1, sizeof *s.waiting);
    s.chain = calloc(n + 1, sizeof *s.chain);
    s.counts = calloc(n + 1, sizeof *s.counts);
    s.done = calloc(n + 1, 1);
    s.order = calloc(n + 1, sizeof *s.order);
    bool ok = best != NULL && s.uses != NULL && s.waiting != NULL && s.chain != NULL && s.counts != NULL
              && s.done != NULL && s.order != NULL;
    if (ok) prepare(&s);
    for (int k = 0; ok && k < TRIES; k++) {
        unsigned live = schedule(&s, weights[k], s.order);
        if (live >= best_live) continue;
        ttc_program *scheduled = ttc_program_reorder(program, s.order, n);
        ok = scheduled != NULL;
        if (!ok) break;
        ttc_program_destroy(best);
        best = scheduled;
        best_live = live;
    }
    free(s.uses);
    free(s.waiting);
    free(s.chain);
    free(s.counts);
    free(s.done);
    free(s.order);
    if (ok) return best;
    ttc_program_destroy(best);
    return NULL;
}
