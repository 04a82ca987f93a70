/* List scheduling for few live temporaries. Of the operations whose operands are computed, the next is the one that frees most
 * temporaries; ties, and near ties by a weight that varies between tries, go to the longest chain of dependents. Of the original
 * order and all tries, the one with the fewest live temporaries is kept. */
#include "optimize/program.h"

#include <stdlib.h>

enum { TRIES = 6 };

/* An operation that may come next; out of date when its score is not scheduler.score[value]. */
typedef struct {
    long score;
    ttc_value value;
} candidate;

typedef struct {
    const ttc_program *program;
    size_t n;
    unsigned *uses;      /* by value: users not yet scheduled */
    unsigned *waiting;   /* by value: operands not yet scheduled, leaves excluded */
    unsigned *chain;     /* by value: latency of the longest path to an output */
    unsigned char *done;
    long *score;         /* by value, once no operand is missing */
    ttc_value *order;
    unsigned *counts;    /* by value: number of users */
    size_t *first_user;  /* by value, shape (n + 1,): index of its first user in `users` */
    ttc_value *users;
    candidate *heap;     /* highest score first, then the lowest value; a value enters at most once for each operand */
    size_t heap_count;
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
    unsigned count = 0, arity = ttc_op_arity(i->op);
    for (unsigned k = 0; k < arity; k++) {
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
    size_t total = 0;
    for (size_t k = 0; k <= s->n; k++) {
        s->first_user[k] = total;
        if (k < s->n) total += s->counts[k];
    }
    for (size_t k = 0; k < s->n; k++) s->uses[k] = 0;
    for (size_t k = 0; k < s->n; k++) {
        unsigned count = operands_of(s, (ttc_value)k, operands);
        for (unsigned j = 0; j < count; j++)
            s->users[s->first_user[operands[j]] + s->uses[operands[j]]++] = (ttc_value)k;
    }
}

/* Temporaries that an operation frees, less the one that it makes. */
static int relief_of(const scheduler *s, ttc_value value)
{
    ttc_value operands[3];
    unsigned count = operands_of(s, value, operands);
    int relief = s->counts[value] == 0 ? 0 : -1;
    for (unsigned j = 0; j < count; j++) relief += s->uses[operands[j]] == 1 && !is_leaf(s, operands[j]);
    return relief;
}

static bool comes_before(const candidate *a, const candidate *b)
{
    return a->score != b->score ? a->score > b->score : a->value < b->value;
}

static void push(scheduler *s, unsigned weight, ttc_value value)
{
    candidate c = { 64L * relief_of(s, value) + (long)(weight * s->chain[value]), value };
    size_t at = s->heap_count++;
    s->score[value] = c.score;
    for (; at > 0 && comes_before(&c, s->heap + (at - 1) / 2); at = (at - 1) / 2) s->heap[at] = s->heap[(at - 1) / 2];
    s->heap[at] = c;
}

static candidate pop(scheduler *s)
{
    candidate top = s->heap[0], last = s->heap[--s->heap_count];
    size_t at = 0;
    for (size_t child = 1; child < s->heap_count; child = 2 * at + 1) {
        if (child + 1 < s->heap_count && comes_before(s->heap + child + 1, s->heap + child)) child++;
        if (!comes_before(s->heap + child, &last)) break;
        s->heap[at] = s->heap[child];
        at = child;
    }
    s->heap[at] = last;
    return top;
}

static void start(scheduler *s, unsigned weight)
{
    ttc_value operands[3];
    s->heap_count = 0;
    for (size_t k = 0; k < s->n; k++) {
        s->uses[k] = s->counts[k];
        s->done[k] = is_leaf(s, (ttc_value)k);
        s->waiting[k] = 0;
        unsigned count = operands_of(s, (ttc_value)k, operands);
        for (unsigned j = 0; j < count; j++) s->waiting[k] += !is_leaf(s, operands[j]);
    }
    for (size_t k = 0; k < s->n; k++)
        if (!s->done[k] && s->waiting[k] == 0) push(s, weight, (ttc_value)k);
}

/* Schedule a value: users wait for one operand fewer; where an operand has one user left, that user's score rises. */
static void finish(scheduler *s, unsigned weight, ttc_value value)
{
    ttc_value operands[3];
    unsigned count = operands_of(s, value, operands);
    s->done[value] = 1;
    for (unsigned j = 0; j < count; j++) s->uses[operands[j]]--;
    for (unsigned j = 0; j < count; j++) {
        if (s->uses[operands[j]] != 1 || is_leaf(s, operands[j])) continue;
        for (size_t u = s->first_user[operands[j]]; u < s->first_user[operands[j] + 1]; u++)
            if (!s->done[s->users[u]] && s->waiting[s->users[u]] == 0) push(s, weight, s->users[u]);
    }
    for (size_t u = s->first_user[value]; u < s->first_user[value + 1]; u++)
        if (--s->waiting[s->users[u]] == 0) push(s, weight, s->users[u]);
}

/* Make one schedule. Returns the most temporaries alive at once. Leaves come first: they take none. */
static unsigned schedule(scheduler *s, unsigned weight, ttc_value *order)
{
    size_t count = 0;
    int live = 0, most = 0;
    start(s, weight);
    for (size_t k = 0; k < s->n; k++)
        if (s->done[k]) order[count++] = (ttc_value)k;
    while (count < s->n) {
        candidate best = pop(s);
        if (s->done[best.value] || s->score[best.value] != best.score) continue;
        if (live + 1 > most) most = live + 1;
        live -= relief_of(s, best.value);
        order[count++] = best.value;
        finish(s, weight, best.value);
    }
    return (unsigned)most;
}

static bool allocate(scheduler *s)
{
    size_t n = s->n;
    s->uses = calloc(n + 1, sizeof *s->uses);
    s->waiting = calloc(n + 1, sizeof *s->waiting);
    s->chain = calloc(n + 1, sizeof *s->chain);
    s->counts = calloc(n + 1, sizeof *s->counts);
    s->done = calloc(n + 1, 1);
    s->score = calloc(n + 1, sizeof *s->score);
    s->order = calloc(n + 1, sizeof *s->order);
    s->first_user = calloc(n + 2, sizeof *s->first_user);
    s->users = calloc(3 * n + 1, sizeof *s->users);
    s->heap = calloc(4 * n + 1, sizeof *s->heap);
    return s->uses != NULL && s->waiting != NULL && s->chain != NULL && s->counts != NULL && s->done != NULL && s->score != NULL
           && s->order != NULL && s->first_user != NULL && s->users != NULL && s->heap != NULL;
}

static void release(scheduler *s)
{
    free(s->uses);
    free(s->waiting);
    free(s->chain);
    free(s->counts);
    free(s->done);
    free(s->score);
    free(s->order);
    free(s->first_user);
    free(s->users);
    free(s->heap);
}

ttc_program *ttc_program_schedule(const ttc_program *program)
{
    static const unsigned weights[TRIES] = { 1, 4, 8, 16, 32, 64 };
    scheduler s = { .program = program, .n = ttc_program_size(program) };
    ttc_program *best = ttc_program_trim(program);
    unsigned best_live = ttc_program_count(program).live;
    bool ok = best != NULL && allocate(&s);
    if (ok) prepare(&s);
    for (int k = 0; ok && k < TRIES; k++) {
        unsigned live = schedule(&s, weights[k], s.order);
        if (live >= best_live) continue;
        ttc_program *scheduled = ttc_program_reorder(program, s.order, s.n);
        ok = scheduled != NULL;
        if (!ok) break;
        ttc_program_destroy(best);
        best = scheduled;
        best_live = live;
    }
    release(&s);
    if (ok) return best;
    ttc_program_destroy(best);
    return NULL;
}
