/* Searches for a short program in several ways, all deterministic. */
#include "optimize/optimize.h"

#include "optimize/extract_binomial.h"
#include "optimize/workspace.h"
#include "optimize/workspace_lower.h"

#include <limits.h>
#include <stdlib.h>

/* An operation costs 2, and each of its flops 1 more: the mean of targets with and without fused operations. A division or root
 * costs as much as six multiplications, a cosine, sine, exponential or logarithm as much as twenty. */
static unsigned cost_of(const ttc_program *program)
{
    ttc_count c = ttc_program_count(program);
    return 3 * (c.add + c.multiply) + 4 * c.fma + 18 * (c.divide + c.root) + 60 * c.elementary;
}

/* A search tries several extractions from one start, then undoes and redoes parts of the best, until `patience` rounds in a row
 * improve nothing; cheap starts are searched several times. Work is counted in comparisons and bounded, so that a search ends at
 * the same place on every machine. */
typedef struct {
    unsigned repeats;      /* most searches from one start */
    unsigned seeds;        /* extractions at the beginning of a search */
    unsigned patience;     /* rounds in a row without improvement */
    unsigned finishes;     /* ways tried to make a program of the best */
    uint64_t repeat_limit; /* search again only below this work on the kernel */
    uint64_t work_limit;   /* ends one search */
    uint64_t pair_limit;   /* see ttc_workspace_extract */
} search_limits;

static const search_limits efforts[] = {
    [TTC_EFFORT_QUICK] = { 1, 2, 4, 2, 0, 500000, 40000 },
    [TTC_EFFORT_FULL] = { 8, 8, 80, 16, 500000, 60000000, 200000 },
};

/* How a workspace becomes a program. seed: of the last extraction; above 0, reciprocals are written out for it. */
typedef struct {
    const search_limits *limits;
    bool one_division;
    uint64_t seed;
} strategy;

static ttc_program *finish(const ttc_workspace *workspace, ttc_prepared *prepared, strategy how)
{
    ttc_program *fused = NULL;
    ttc_workspace *copy = ttc_workspace_clone(workspace);
    if (copy == NULL) return NULL;
    if (how.one_division) ttc_workspace_share_reciprocals(copy, how.seed > 0);
    /* Products that recover reciprocals may share parts with others. */
    ttc_workspace_tidy(copy);
    ttc_workspace_cancel(copy);
    ttc_workspace_extract(copy, how.seed, how.limits->pair_limit);
    ttc_workspace_tidy(copy);
    if (!copy->failed) {
        ttc_program *program = ttc_workspace_lower(copy, prepared);
        if (program != NULL) fused = ttc_program_fuse(program);
        ttc_program_destroy(program);
    }
    ttc_workspace_destroy(copy);
    return fused;
}

/* Time of a program: cost, where other work fills the processor; latency, where its operations wait for each other. */
typedef struct {
    unsigned cost, latency; /* UINT_MAX on failure */
} rating;

/* The values that the program would prepare are discarded. */
static rating rate(const ttc_workspace *workspace, strategy how)
{
    ttc_prepared scratch = { .field = workspace->field };
    ttc_program *program = finish(workspace, &scratch, how);
    rating r = { UINT_MAX, UINT_MAX };
    if (program != NULL) r = (rating){ cost_of(program), ttc_program_latency(program) };
    ttc_program_destroy(program);
    ttc_prepared_clear(&scratch);
    return r;
}

/* Whether separate divisions save at least four operations each: they need no products that combine denominators and recover
 * reciprocals, and do not wait for each other. */
static bool prefers_separate_divisions(const ttc_workspace *workspace, const search_limits *limits)
{
    ttc_prepared scratch = { .field = workspace->field };
    ttc_program *one = finish(workspace, &scratch, (strategy){ limits, true, 0 });
    ttc_program *several = finish(workspace, &scratch, (strategy){ limits, false, 0 });
    bool prefers = false;
    if (one != NULL && several != NULL) {
        ttc_count a = ttc_program_count(one), b = ttc_program_count(several);
        prefers = ttc_count_flops(b) + 4 * (b.divide - a.divide) <= ttc_count_flops(a) && b.divide > a.divide;
    }
    ttc_program_destroy(one);
    ttc_program_destroy(several);
    ttc_prepared_clear(&scratch);
    return prefers;
}

/* The best workspace of a search; one of equal cost replaces it, so that a search drifts over ties. */
typedef struct {
    const search_limits *limits;
    ttc_workspace *best;
    unsigned cost;
    uint64_t work;
} best_so_far;

/* Keep the workspace if it costs no more than the best. Takes ownership of it. */
static void keep_better(best_so_far *c, ttc_workspace *workspace)
{
    unsigned cost = workspace == NULL || workspace->failed ? UINT_MAX : rate(workspace, (strategy){ c->limits, true, 0 }).cost;
    if (workspace != NULL && cost <= c->cost) {
        ttc_workspace_destroy(c->best);
        c->best = workspace;
        c->cost = cost;
    } else {
        ttc_workspace_destroy(workspace);
    }
}

static void extract_from(best_so_far *c, const ttc_workspace *start, uint64_t seed)
{
    ttc_workspace *workspace = ttc_workspace_clone(start);
    if (workspace == NULL) return;
    if (seed % 2 == 1) ttc_workspace_rescale(workspace);
    c->work += ttc_workspace_extract(workspace, seed / 2, c->limits->pair_limit);
    ttc_workspace_rescale(workspace);
    ttc_workspace_tidy(workspace);
    keep_better(c, workspace);
}

/* Undo some of what was extracted, and extract again (Schrimpf, Schneider, Stamm-Wilbrandt, Dueck 2000). */
static void ruin_and_recreate(best_so_far *c, uint64_t round)
{
    ttc_workspace *workspace = ttc_workspace_clone(c->best);
    if (workspace == NULL) return;
    uint64_t random = round * UINT64_C(0x9E3779B97F4A7C15) + 12345;
    unsigned percent = 3u + 7u * (unsigned)(round % 5);
    for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) {
        random = random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        if (workspace->variables[v].is_extracted && (random >> 33) % 100 < percent) ttc_workspace_inline(workspace, v);
    }
    ttc_workspace_tidy(workspace);
    if (!workspace->failed) c->work += ttc_workspace_extract(workspace, round, c->limits->pair_limit);
    ttc_workspace_rescale(workspace);
    ttc_workspace_tidy(workspace);
    keep_better(c, workspace);
}

static best_so_far search(const ttc_workspace *start, uint64_t number, const search_limits *limits)
{
    best_so_far c = { limits, NULL, UINT_MAX, 0 };
    for (uint64_t seed = 0; seed < limits->seeds && c.work < limits->work_limit; seed++)
        extract_from(&c, start, seed == 0 ? number % 2 : number * limits->seeds + seed);
    unsigned before = c.cost;
    for (uint64_t round = 1, idle = 0; idle < limits->patience && c.work < limits->work_limit && c.best != NULL; round++) {
        ruin_and_recreate(&c, (number << 32) + round);
        idle = c.cost < before ? 0 : idle + 1;
        before = c.cost;
    }
    return c;
}

enum { STARTS = 4 };

/* starts[0], [1]: `outputs` and `other` as given; [2], [3]: with products written out. NULL where `other` is, or where that
 * changes nothing. */
static bool make_starts(ttc_workspace **starts, ttc_field *field, const ttc_id *outputs, const ttc_id *other, size_t count)
{
    for (int k = 0; k < STARTS; k++) starts[k] = NULL;
    for (int k = 0; k < 2; k++) {
        const ttc_id *ids = k == 0 ? outputs : other;
        if (ids == NULL) continue;
        starts[k] = ttc_workspace_create(field, ids, count);
        starts[k + 2] = starts[k] == NULL ? NULL : ttc_workspace_clone(starts[k]);
        if (starts[k + 2] == NULL) return false;
        bool differs = ttc_workspace_write_out(starts[k + 2]);
        ttc_workspace_raise_reciprocals(starts[k]);
        ttc_workspace_raise_reciprocals(starts[k + 2]);
        if (differs) continue;
        ttc_workspace_destroy(starts[k + 2]);
        starts[k + 2] = NULL;
    }
    return true;
}

static ttc_workspace *search_all(ttc_workspace *const *starts, const search_limits *limits)
{
    best_so_far best = { limits, NULL, UINT_MAX, 0 };
    uint64_t work = 0;
    for (uint64_t k = 0; k < STARTS || (k < STARTS * (uint64_t)limits->repeats && work < limits->repeat_limit); k++) {
        if (starts[k % STARTS] == NULL) continue;
        best_so_far c = search(starts[k % STARTS], k, limits);
        work += c.work;
        if (c.best != NULL && c.cost < best.cost) {
            ttc_workspace_destroy(best.best);
            best = c;
        } else {
            ttc_workspace_destroy(c.best);
        }
    }
    return best.best;
}

/* A workspace, and the strategy that makes its program. */
typedef struct {
    ttc_workspace *workspace;
    strategy how;
    rating rating;
} choice;

/* Of several strategies, take each that costs no more than the last one taken and has less latency. */
static choice choose(ttc_workspace *workspace, ttc_purpose purpose, const search_limits *limits)
{
    bool one_division = purpose == TTC_FOR_STEPS
                        || (purpose == TTC_FOR_POINTS && !prefers_separate_divisions(workspace, limits));
    choice c = { workspace, { limits, one_division, 0 }, { UINT_MAX, UINT_MAX } };
    c.rating = rate(workspace, c.how);
    for (uint64_t seed = 1; seed < limits->finishes && purpose != TTC_FOR_JETS; seed++) {
        strategy how = { limits, c.how.one_division, seed };
        rating r = rate(workspace, how);
        if (r.cost > c.rating.cost || r.latency >= c.rating.latency) continue;
        c.how = how;
        c.rating = r;
    }
    return c;
}

/* The workspace, or a variant in which no division waits for a root if that has less latency at a cost at most a thirtieth higher:
 * one orbit waits for the latency of each call, a batch for the number of operations. Takes ownership. */
static choice choose_quick(ttc_workspace *workspace, ttc_purpose purpose, const search_limits *limits)
{
    choice c = choose(workspace, purpose, limits);
    ttc_workspace *other = purpose == TTC_FOR_JETS ? NULL : ttc_workspace_clone(workspace);
    if (other == NULL || !ttc_workspace_divide_by_radicands(other)) {
        ttc_workspace_destroy(other);
        return c;
    }
    ttc_workspace_tidy(other);
    choice o = choose(other, purpose, limits);
    bool is_quicker = !other->failed && o.rating.latency < c.rating.latency && 30 * o.rating.cost <= 31 * c.rating.cost;
    ttc_workspace_destroy(is_quicker ? workspace : other);
    return is_quicker ? o : c;
}

ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, const ttc_id *other, size_t count, ttc_purpose purpose,
                          ttc_effort effort, ttc_prepared *prepared)
{
    ttc_workspace *starts[STARTS], *best = NULL;
    ttc_program *program = NULL, *scheduled = NULL;
    ttc_scale_ratios ratios = { 0 };
    bool ok = make_starts(starts, field, outputs, other, count);
    for (int k = 0; k < STARTS && ok; k++)
        if (starts[k] != NULL) starts[k]->ratios = &ratios;
    if (ok) best = search_all(starts, efforts + effort);
    if (best != NULL) {
        choice c = choose_quick(best, purpose, efforts + effort);
        program = finish(c.workspace, prepared, c.how);
        ttc_workspace_destroy(c.workspace);
    }
    if (program != NULL) scheduled = ttc_program_schedule(program);
    ttc_program_destroy(program);
    for (int k = 0; k < STARTS; k++) ttc_workspace_destroy(starts[k]);
    ttc_scale_ratios_clear(&ratios);
    return scheduled;
}
