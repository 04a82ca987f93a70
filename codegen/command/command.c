#include "command/command.h"

static void raise_status(int *status, int to)
{
    if (*status < to) *status = to;
}

ttc_model *ttc_command_read(const char *path, int *status)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    if (diagnostics == NULL) {
        fprintf(stderr, "ttc: out of memory\n");
        raise_status(status, TTC_EXIT_IO);
        return NULL;
    }
    ttc_model *model = ttc_model_read(path, diagnostics);
    ttc_diagnostics_print(diagnostics, stderr);
    if (model == NULL) raise_status(status, ttc_io_error_count(diagnostics) > 0 ? TTC_EXIT_IO : TTC_EXIT_BAD_TABLE);
    ttc_diagnostics_destroy(diagnostics);
    return model;
}
