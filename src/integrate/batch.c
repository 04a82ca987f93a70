#include "integrate/batch.h"

#include "integrate/batch_lanes.h"

jlt_status jlt_batch_section(const jlt_batch_map *map, const double *starts, size_t count, size_t returns,
                             jlt_batch_row row, jlt_batch_end end, void *context, jlt_batch_work *work)
{
    jlt_batch_work ignored = { 0 };
    jlt_batch_job job = { map, starts, count, returns, row, end, context, work != NULL ? work : &ignored };

    if (map->dim == 0 || map->dim > 16 || map->column >= map->dim || !(map->tolerance > 0) || map->kernels == NULL)
        return JLT_ERR_ARG;
    *job.work = (jlt_batch_work){ 0 };
    switch (map->kernels->lanes) {
#if defined(JLT_HAVE_X86)
    case 8:
        return jlt_batch_lanes_avx512(&job);
    case 4:
        return jlt_batch_lanes_avx2(&job);
#endif
    case 2:
        return jlt_batch_lanes_baseline(&job);
    default:
        return JLT_ERR_UNSUPPORTED;
    }
}
