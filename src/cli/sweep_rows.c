#include "cli/sweep_rows.h"

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

jlt_exit jlt_sweep_rows_check(const jlt_study *study, const char *rows)
{
    for (const char *at = rows; *at != '\n' && *at != '\0'; at += *at == ',') {
        const size_t length = strcspn(at, ",\n");
        for (size_t k = 0; k < study->over_count; k++)
            if (strlen(study->over[k].name) == length && strncmp(at, study->over[k].name, length) == 0)
                return jlt_command_fail(JLT_EXIT_INPUT, "over: %s is a column of %s already", study->over[k].name,
                                        study->job->what);
        at += length;
    }
    return JLT_EXIT_DONE;
}
