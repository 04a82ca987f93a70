/* The list of all commands. */
#include "cli/command.h"

#include <string.h>

static const jlt_command *const commands[] = {
    &jlt_command_verify,   &jlt_command_eigen,    &jlt_command_measure,    &jlt_command_models,   &jlt_command_run,
    &jlt_command_plan,     &jlt_command_sweep,    &jlt_command_merge,      &jlt_command_simulate, &jlt_command_portrait,
    &jlt_command_rod,      &jlt_command_section,  &jlt_command_orbits,     &jlt_command_fates,    &jlt_command_manifolds,
    &jlt_command_continue, &jlt_command_lyapunov, &jlt_command_separation, &jlt_command_drift,    &jlt_command_transfer,
    &jlt_command_certify,  &jlt_command_check,    &jlt_command_bench,
};

const jlt_command *jlt_command_at(size_t index)
{
    return index < sizeof commands / sizeof *commands ? commands[index] : NULL;
}

const jlt_command *jlt_command_find(const char *name)
{
    const jlt_command *command;

    for (size_t i = 0; (command = jlt_command_at(i)) != NULL; i++)
        if (strcmp(command->name, name) == 0) break;
    return command;
}
