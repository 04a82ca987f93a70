/* Times a repeated computation; writes numbers of a table, and lists tolerances. */
#include "bench.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

static const double longest_repeated = 0.5;

static double now(unsigned threads)
{
    struct timespec t;
    clock_gettime(threads > 1 ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

jlt_status jlt_bench_clock(jlt_bench_time *time, size_t repeats, unsigned threads, jlt_status (*pass)(void *context, bool first),
                           void *context)
{
    jlt_status st = JLT_OK;
    double *times = calloc(repeats + 1, sizeof *times);

    if (times == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i <= repeats; i++) {
        const double begin = now(threads);
        JLT_TRY(pass(context, i == 0));
        times[i] = now(threads) - begin;
        if (times[0] > longest_repeated) {
            *time = (jlt_bench_time){ times[0], times[0], times[0] };
            goto done;
        }
    }
    qsort(times + 1, repeats, sizeof *times, ascending);
    *time = (jlt_bench_time){ times[1], times[1 + repeats / 2], times[repeats] };
done:
    free(times);
    return st;
}

void jlt_bench_number(FILE *table, const char *format, double value)
{
    fputc(',', table);
    if (!isnan(value)) fprintf(table, format, value);
}

double jlt_bench_tolerance(const jlt_bench_options *options, size_t index)
{
    const size_t decade = options->quick ? 5 + 3 * index : 4 + index;
    return decade <= 15 ? strtod((const char[]){ '1', 'e', '-', (char)('0' + decade / 10), (char)('0' + decade % 10), 0 }, NULL)
                        : 0;
}
