/** Lists of assignments as typed on the command line: NAME=VALUE,NAME=VALUE,... with exact values. */
#ifndef JLT_CLI_ASSIGN_H
#define JLT_CLI_ASSIGN_H

#include "cli/command.h"
#include "kernel/region.h"

#include <stdbool.h>

typedef struct {
    char *name;
    double value;     /* correctly rounded */
    char *fraction;   /* exactly, "p/q" */
} jlt_assignment;

typedef struct {
    jlt_assignment *items;
    size_t count;
} jlt_assign_list;

/** Add the assignments in `text` to a list (zeroed before first use). Says what is wrong on standard error, naming `option`;
 *  the list then keeps what it had or some of the new items, and is still to be cleared. */
jlt_exit jlt_assign_parse(jlt_assign_list *list, const char *text, const char *option);

/** The same, in place of what the list has for these names. */
jlt_exit jlt_assign_replace(jlt_assign_list *list, const char *text, const char *option);
void jlt_assign_clear(jlt_assign_list *list);

/** Give values to quantities by name; later ones win. `given`, shape (count,), or NULL, is set to 1 where a value was
 *  given. `what` names them in messages: "parameter" or "state". `where` is the model's name. */
jlt_exit jlt_assign_apply(double *values, unsigned char *given, const jlt_assign_list *list,
                          const jlt_quantity *quantities, size_t count, const char *what, const char *where);

/* The exact value given to a name, or NULL when there is none. */
const char *jlt_assign_fraction(const jlt_assign_list *list, const char *name);

/** Say that `what` lies outside the table's domain, and by which condition. */
jlt_exit jlt_assign_refuse_region(const char *what, const jlt_descriptor *descriptor, const jlt_region *region, double value);

/** Say that parameter number `index` must not have this value, and which the table allows. */
jlt_exit jlt_assign_refuse(const jlt_descriptor *descriptor, size_t index, double value);

/** A model's parameters: defaults of the table, then the list. Checks the table's conditions. Out: params, for the caller to
 *  free(). */
jlt_exit jlt_assign_params(double **params, const jlt_descriptor *descriptor, const jlt_assign_list *list);

#endif
