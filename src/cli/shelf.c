#include "cli/shelf.h"

#include <stdint.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "cli/program.h"

static void drop(jlt_shelf_place *place, const jlt_work *work)
{
    if (place->run != NULL) work->command->together->drop(place->run);
    place->run = NULL;
    if (place->argv != NULL) place->argv[0] = place->first;
    jlt_command_free(place->argv, place->argc);
    place->argv = NULL;
    place->argc = 0;
}

static void clear(jlt_shelf *self, const jlt_work *work)
{
    for (size_t i = self->taken; i < self->count; i++) drop(&self->places[i], work);
    self->count = self->taken = 0;
}

/* Begin the run of a place whose piece is set. */
static jlt_exit begin(jlt_shelf_place *place, const jlt_work *work)
{
    jlt_exit code = JLT_EXIT_DONE;

    place->argv = work->arguments(work->context, place->piece, &place->argc);
    if (place->argv == NULL) return jlt_command_no_memory();
    snprintf(place->name, sizeof place->name, "jellett %s", work->command->name); /* argp takes the program's name from argv[0] */
    place->first = place->argv[0];
    place->argv[0] = place->name;
    place->run = work->command->together->begin(&code, place->argc, place->argv);
    return code;
}

/* Begin a run before its turn. If it writes to standard error or ends, undo that and drop it: it is begun again in its turn. */
static void begin_ahead(jlt_shelf_place *place, const jlt_work *work)
{
    const off_t before = lseek(STDERR_FILENO, 0, SEEK_CUR);
    const jlt_exit code = begin(place, work);
    const off_t after = lseek(STDERR_FILENO, 0, SEEK_CUR);

    if (code == JLT_EXIT_DONE && before == after && before >= 0) return;
    if (before >= 0 && after > before && ftruncate(STDERR_FILENO, before) == 0) (void)lseek(STDERR_FILENO, before, SEEK_SET);
    drop(place, work);
}

static size_t list(const jlt_shelf *self, void **runs)
{
    size_t count = 0;

    for (size_t i = 0; i < self->count; i++)
        if (self->places[i].run != NULL) runs[count++] = self->places[i].run;
    return count;
}

/* Begin runs after the first place until there are enough, and do their common work. */
static void fill(jlt_shelf *self, const jlt_work *work)
{
    void *runs[JLT_SHELF_RUNS];
    size_t count = list(self, runs);

    while (self->count < JLT_SHELF_RUNS && !work->command->together->are_enough(runs, count)) {
        const size_t piece = work->next(work->context, self->places[self->count - 1].piece);
        if (piece == SIZE_MAX) break;
        self->places[self->count] = (jlt_shelf_place){ .piece = piece };
        begin_ahead(&self->places[self->count++], work);
        count = list(self, runs);
    }
    work->command->together->follow(runs, count);
}

static jlt_exit run_one(const jlt_work *work, size_t piece)
{
    int argc = 0;
    char **argv = work->arguments(work->context, piece, &argc);
    const jlt_exit code = argv != NULL ? jlt_program_run(work->command, argc, argv) : jlt_command_no_memory();

    jlt_command_free(argv, argc);
    return code;
}

jlt_exit jlt_shelf_run(jlt_shelf *self, const jlt_work *work, size_t piece, bool alone)
{
    jlt_exit code = JLT_EXIT_DONE;

    if (work->command->together == NULL) return run_one(work, piece);
    if (self->taken == self->count || self->places[self->taken].piece != piece) {
        clear(self, work);
        self->places[self->count++] = (jlt_shelf_place){ .piece = piece };
        code = begin(&self->places[0], work);
        if (self->places[0].run != NULL && !alone) fill(self, work);
    }
    jlt_shelf_place *place = &self->places[self->taken];
    if (place->run == NULL && place->argv == NULL) code = begin(place, work);
    if (place->run != NULL) code = work->command->together->finish(place->run);
    drop(place, work);
    self->taken++;
    jlt_interrupt_obey();
    return code;
}
