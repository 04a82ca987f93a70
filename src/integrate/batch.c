#include "integrate/batch.h"

#include <math.h>

#include "integrate/batch_lanes.h"
#include "integrate/batch_method.h"
#include "integrate/invariant.h"

static jlt_status run(const jlt_batch_job *job)
{
    switch (job->map->kernels->lanes) {
#if defined(JLT_HAVE_X86)
    case 8: return jlt_batch_lanes_avx512(job);
    case 4:
        return jlt_batch_lanes_avx2(job);
#endif
    case 2: return jlt_batch_lanes_baseline(job);
    default: return JLT_ERR_UNSUPPORTED;
    }
}

size_t jlt_batch_most_steps(double tolerance)
{
    const double steps = 400 * pow(tolerance / 1e-12, -0.2);
    return !(steps < 400) ? 400 : steps < 100 ? 100 : (size_t)steps;
}

double jlt_batch_rest(double tolerance) { return fmax(0.002 * sqrt(tolerance), 10 * tolerance); }

unsigned jlt_batch_columns(const jlt_batch_map *map)
{
    return map->tangents > 0 ? map->dim * (1 + map->tangents) + 2 : map->dim + map->clock;
}

static bool is_method(const jlt_batch_method *method)
{
    size_t i = 0;

    while (jlt_batch_method_at(i) != NULL && jlt_batch_method_at(i) != method) i++;
    return jlt_batch_method_at(i) == method;
}

/* Whether the members of a map are what their comments say. */
static bool is_in_range(const jlt_batch_map *map)
{
    const jlt_batch_watch *watch = map->watch;
    const jlt_descriptor *project = map->project;

    return map->dim > 0 && map->dim <= JLT_BATCH_STATES_MAX && map->column < map->dim && map->root < (int)map->dim &&
           map->direction >= -1 && map->direction <= 1 && map->turn >= 0 && isfinite(map->turn) && map->tolerance > 0 &&
           map->tolerance < 1 && is_method(map->method) && map->kernels != NULL && map->cases != NULL &&
           map->tangents <= JLT_BATCH_COLUMNS_MAX &&
           (map->domain == NULL || map->domain->conditions <= JLT_BATCH_CONDITIONS_MAX) &&
           (watch == NULL || (watch->count > 0 && watch->count <= JLT_BATCH_CONDITIONS_MAX)) &&
           (project == NULL ||
            (map->tangents == 0 && map->kernels->integral_gradients != NULL && project->integral_count < JLT_INVARIANTS_MAX &&
             project->lifted_count == (map->root >= 0)));
}

jlt_status jlt_batch_section(const jlt_batch_map *map, const double *starts, size_t count, size_t returns,
                             jlt_batch_row row, jlt_batch_end end, void *context, jlt_batch_work *work)
{
    size_t next = 0;
    int stop = 0;
    const unsigned columns = jlt_batch_columns(map);

    if (!is_in_range(map) || columns > JLT_BATCH_COLUMNS_MAX || (map->returns_of == NULL && returns == 0)) return JLT_ERR_ARG;
    for (size_t i = 0; map->returns_of != NULL && i < count; i++)
        if (map->returns_of[i] == 0) return JLT_ERR_ARG;
    const size_t wide = JLT_BATCH_VECTORS * map->kernels->lanes, filled = (count + wide - 1) / wide;
    const int threads = map->threads < filled ? (int)map->threads : (int)filled; /* others would only wait, spinning */
    size_t steps = 0, rejected = 0, stages = 0;
    int failure = JLT_OK;
#if defined(_OPENMP)
#pragma omp parallel num_threads(threads > 1 ? threads : 1) reduction(+ : steps, rejected, stages) reduction(max : failure)
#else
    (void)threads;
#endif
    {
        jlt_batch_work mine = { 0 };
        failure = (int)run(&(jlt_batch_job){ map, starts, count, returns, columns, row, end, context, &mine, &next, &stop });
        steps = mine.steps;
        rejected = mine.rejected;
        stages = mine.stages;
    }
    if (work != NULL) *work = (jlt_batch_work){ steps, rejected, stages };
    return (jlt_status)failure;
}
