#include "cli/sweep_rows.h"

#include <stdlib.h>
#include <string.h>

size_t jlt_sweep_rows_of(char *text)
{
    char *to = text;

    for (const char *line = text; *line != '\0';) {
        size_t length = strcspn(line, "\n");
        length += line[length] == '\n';
        if (*line != '#') {
            memmove(to, line, length);
            to += length;
        }
        line += length;
    }
    *to = '\0';
    return (size_t)(to - text);
}

jlt_exit jlt_sweep_rows_check(char **names, const jlt_study *study, const char *rows)
{
    const size_t length = strcspn(rows, "\n");

    if (*names == NULL) {
        if ((*names = strndup(rows, length)) == NULL) return jlt_command_no_memory();
        for (const char *at = *names; *at != '\0'; at += strcspn(at, ","), at += *at == ',')
            for (size_t k = 0; k < study->over_count; k++)
                if (strlen(study->over[k].name) == strcspn(at, ",")
                    && strncmp(at, study->over[k].name, strcspn(at, ",")) == 0)
                    return jlt_command_fail(JLT_EXIT_INPUT, "over: %s is a column of %s already", study->over[k].name,
                                            study->job->what);
    }
    if (strlen(*names) == length && strncmp(*names, rows, length) == 0) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_INPUT, "pieces of the study have different columns, %s and %.*s", *names, (int)length,
                            rows);
}
