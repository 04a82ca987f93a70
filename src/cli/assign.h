/** Lists of assignments as typed on the command line: NAME=VALUE,NAME=VALUE,... with exact values. */
#ifndef JLT_CLI_ASSIGN_H
#define JLT_CLI_ASSIGN_H

#include "cli/command.h"
#include "kernel/region.h"

#include <stdbool.h>

typedef struct {
    char *name;
    double value;     /* correctly rounded */
    char *fraction;   /* the exact value, "p/q" */
} jlt_assignment;

typedef struct {
    jlt_assignment *items;
    size_t count;
} jlt_assign_list;

/** Add the assignments in `text` to a list, which must be zeroed before its first use and cleared after its last one. Messages name
 *  `option`. On failure the list keeps its items, and may have some of the new ones. */
jlt_exit jlt_assign_parse(jlt_assign_list *list, const char *text, const char *option);

/** The same, but a new value replaces the one that the list has for that name. */
jlt_exit jlt_assign_replace(jlt_assign_list *list, const char *text, const char *option);
void jlt_assign_clear(jlt_assign_list *list);

/** Store the list's values in `values`, shape (count,), by the names of quantities, shape (count,); of two values for one name the
 *  later one wins, and values without an assignment stay as they are. given: shape (count,), set to 1 where a value was stored, or
 *  NULL. For messages: what, "parameter" or "state"; where, the model's name. */
jlt_exit jlt_assign_apply(double *values, unsigned char *given, const jlt_assign_list *list,
                          const jlt_quantity *quantities, size_t count, const char *what, const char *where);

/** Whether `text`, NAME=ANYTHING,NAME=ANYTHING,..., assigns to this name. Returns false if text is NULL. */
bool jlt_assign_names(const char *text, const char *name);

/* The exact value of a name as a fraction "p/q", owned by the list; NULL when the list has no value for it. */
const char *jlt_assign_fraction(const jlt_assign_list *list, const char *name);

/** Print that `what`, an option or a start, lies outside the table's domain, because the condition `region` has this value there.
 *  Returns JLT_EXIT_INPUT. */
jlt_exit jlt_assign_refuse_region(const char *what, const jlt_descriptor *descriptor, const jlt_region *region, double value);

/** Say that the value of `what` for a quantity is outside its open interval. */
jlt_exit jlt_assign_refuse_interval(const char *what, const jlt_quantity *quantity);

/** Out: the first and the last value that a sweep, NAME=LOW:HIGH:COUNT,... or NAME=VALUE,..., gives to a name. Returns false if it
 *  gives none, or is NULL. */
bool jlt_assign_ends(double ends[2], const char *sweep, const char *name);

/** The parameters of a model: the table's defaults, then the list's values, then, where there is neither, a value that `sweep`
 *  (NULL: none) gives, the last if the table does not allow the first; checked against the table's domain. Out: *params, shape
 *  (param_count,), in the table's units; the caller frees it. */
jlt_exit jlt_assign_params(double **params, const jlt_descriptor *descriptor, const jlt_assign_list *list, const char *sweep);

#endif
