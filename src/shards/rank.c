#include "shards/rank.h"

#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Launchers that number their ranks. Where one runs inside another, both have set their variables, and the inner one counts: it
 * comes first here. */
static const struct {
    const char *name, *index, *count; /* index, count: environment variables; count NULL: the launcher does not say */
    size_t first;                     /* the number that it gives its first rank */
} engines[] = {
    { "Open MPI", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", 0 },
    { "PMI", "PMI_RANK", "PMI_SIZE", 0 },
    { "srun", "SLURM_PROCID", "SLURM_STEP_NUM_TASKS", 0 }, /* a batch script has SLURM_PROCID as well, but is no step */
    { "PMIx", "PMIX_RANK", NULL, 0 },
    { "GNU parallel", "PARALLEL_SEQ", NULL, 1 },
};
enum { ENGINES = sizeof engines / sizeof *engines };

static const size_t NUMBER_MAX = 1000000000;

__attribute__((format(printf, 2, 3)))
static jlt_status complain(char *message, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(message, JLT_RANK_TEXT_MAX, format, arguments);
    va_end(arguments);
    return JLT_ERR_ARG;
}

/* Read a decimal number of at most NUMBER_MAX that extends to `end`. Returns false if the text is not one. */
static bool whole(size_t *value, const char *text, const char *end)
{
    char *after;
    unsigned long long number;

    errno = 0;
    number = strtoull(text, &after, 10);
    if (*text < '0' || *text > '9' || after != end || errno != 0 || number > NUMBER_MAX) return false;
    *value = (size_t)number;
    return true;
}

/* Read an environment variable, if it is set. */
static jlt_status variable(size_t *value, char *message, const char *name)
{
    const char *text = getenv(name);

    if (text == NULL || whole(value, text, text + strlen(text))) return JLT_OK;
    return complain(message, "%s is '%s', which is no whole number: give --shard I/N", name, text);
}

/* Find this process's task in a Slurm array, counted from 0; 0 of 1 outside an array. known: how many tasks there are, numbered
 * from 1; 0: the array says. */
static jlt_status find_task(size_t *task, size_t *tasks, char *message, size_t known)
{
    size_t id = 0, low = 1, step = 1;

    *task = 0, *tasks = 1;
    if (getenv("SLURM_ARRAY_TASK_ID") == NULL) return JLT_OK;
    *tasks = known;
    JLT_PASS(variable(&id, message, "SLURM_ARRAY_TASK_ID"));
    if (known == 0) {
        JLT_PASS(variable(&low, message, "SLURM_ARRAY_TASK_MIN"));
        JLT_PASS(variable(&step, message, "SLURM_ARRAY_TASK_STEP"));
        JLT_PASS(variable(tasks, message, "SLURM_ARRAY_TASK_COUNT"));
    }
    *task = (id - low) / (step > 0 ? step : 1);
    if (id < low || *task >= *tasks || id != low + *task * step)
        return complain(message, "task %zu of the Slurm array is none of %zu in a row: write --array=1-N, or give --shard I/N", id,
                        *tasks);
    return JLT_OK;
}

/* Find the shard from the environment. known: how many shards there are; 0: the environment says. */
static jlt_status from_environment(jlt_rank *out, char *message, size_t known)
{
    size_t number = 0, count = 1, rank = 0, task = 0, tasks = 1, i = 0;

    while (i < ENGINES && (getenv(engines[i].index) == NULL || (engines[i].count != NULL && getenv(engines[i].count) == NULL))) i++;
    if (i < ENGINES) {
        JLT_PASS(variable(&number, message, engines[i].index));
        if (engines[i].count != NULL) JLT_PASS(variable(&count, message, engines[i].count));
        else if (known > 0) count = known;
        else return complain(message, "%s does not say how many processes it starts: give --shard /N, or --shard I/N",
                             engines[i].name);
        rank = number - engines[i].first;
    }
    JLT_PASS(find_task(&task, &tasks, message, i == ENGINES || count == 1 ? known : 0));
    if (i < ENGINES && engines[i].count == NULL) task = 0, tasks = 1;
    if (rank >= count) return complain(message, "%s says that this is process %zu of %zu: give --shard I/N", engines[i].name,
                                       number, count);
    *out = (jlt_rank){ .index = task * count + rank + 1, .count = tasks * count };
    const bool in_array = tasks > 1 || (i == ENGINES && getenv("SLURM_ARRAY_TASK_ID") != NULL);
    snprintf(out->engine, sizeof out->engine, "%s%s%s", in_array ? "Slurm array" : "",
             tasks > 1 && i < ENGINES ? ", " : "", i < ENGINES ? engines[i].name : "");
    if (known > 0 && out->engine[0] == '\0')
        return complain(message, "--shard /%zu: nothing in the environment says which of them: write I/%zu", known, known);
    if (known > 0 && out->count != known) return complain(message, "--shard /%zu: %s starts %zu", known, out->engine, out->count);
    return JLT_OK;
}

jlt_status jlt_rank_find(jlt_rank *out, char *message, const char *text)
{
    size_t index = 0, count = 0;
    const char *slash = text != NULL ? strchr(text, '/') : NULL;

    if (text == NULL) return from_environment(out, message, 0);
    if (slash == NULL || !whole(&count, slash + 1, slash + strlen(slash)) || count == 0
        || (slash > text && !whole(&index, text, slash)))
        return complain(message, "--shard: '%s' is no shard (write I/N, as in 3/8)", text);
    if (slash == text) return from_environment(out, message, count);
    if (index == 0 || index > count) return complain(message, "--shard: '%s': shards are counted from 1 to %zu", text, count);
    *out = (jlt_rank){ .index = index, .count = count };
    return JLT_OK;
}
