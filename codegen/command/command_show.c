/* ttc show: prints equations and Jacobian for readers. */
#include "command/command.h"

#include <string.h>

#include "show/show.h"

int ttc_command_show(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    for (size_t i = 0; i < options->file_count; i++) {
        ttc_model *model = ttc_command_read(options->files[i], &status, NULL);
        if (model == NULL) continue;
        ttc_show_writer write = strcmp(options->format, "latex") == 0 ? ttc_show_latex
                                : strcmp(options->format, "dot") == 0 ? ttc_show_dot
                                                                      : ttc_show_text;
        if (!write(stdout, model)) {
            fprintf(stderr, "%s: error: %s\n", options->files[i], ttc_graph_status_text(ttc_graph_error(model->graph)));
            if (status < TTC_EXIT_BAD_TABLE) status = TTC_EXIT_BAD_TABLE;
        }
        ttc_model_destroy(model);
    }
    return status;
}
