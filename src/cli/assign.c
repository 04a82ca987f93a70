#include "cli/assign.h"

#include "cli/grid.h"
#include "core/digits.h"
#include "core/memory.h"
#include "ext/number.h"
#include "kernel/descriptor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static jlt_exit add(jlt_assign_list *list, const char *name, size_t name_length, const char *value, size_t length,
                    const char *option)
{
    for (size_t i = 0; i < list->count; i++)
        if (strlen(list->items[i].name) == name_length && memcmp(list->items[i].name, name, name_length) == 0)
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: '%s' is given twice", option, list->items[i].name);
    jlt_assignment item = { 0 };
    jlt_status st = JLT_MEMORY_GROW(list->items, list->count) ? JLT_OK : JLT_ERR_NOMEM;

    if (st == JLT_OK) st = jlt_number_parse(&item.value, value, length);
    if (st == JLT_OK) st = jlt_number_fraction(&item.fraction, value, length);
    if (st == JLT_OK && (item.name = strndup(name, name_length)) == NULL) st = JLT_ERR_NOMEM;
    if (st == JLT_OK) {
        list->items[list->count++] = item;
        return JLT_EXIT_DONE;
    }
    free(item.fraction);
    return jlt_grid_judge(st, value, length, option);
}

jlt_exit jlt_assign_parse(jlt_assign_list *list, const char *text, const char *option)
{
    while (*text != '\0') {
        const size_t length = strcspn(text, ",");
        const char *equals = memchr(text, '=', length);
        const size_t name_length = equals == NULL ? 0 : (size_t)(equals - text);

        if (name_length == 0 || name_length + 1 == length)
            return jlt_command_fail(JLT_EXIT_USAGE, "%s: '%.*s' is no assignment (write NAME=VALUE,NAME=VALUE)", option,
                                    (int)length, text);
        JLT_PASS(add(list, text, name_length, equals + 1, length - name_length - 1, option));
        text += length;
        if (*text == ',') text++;
    }
    return JLT_EXIT_DONE;
}

bool jlt_assign_names(const char *text, const char *name)
{
    const size_t length = strlen(name);

    for (const char *at = text; at != NULL; at = strchr(at, ',')) {
        at += *at == ',';
        if (strncmp(at, name, length) == 0 && at[length] == '=') return true;
    }
    return false;
}

jlt_exit jlt_assign_replace(jlt_assign_list *list, const char *text, const char *option)
{
    size_t kept = 0;

    for (size_t i = 0; i < list->count; i++) {
        if (!jlt_assign_names(text, list->items[i].name)) {
            list->items[kept++] = list->items[i];
            continue;
        }
        free(list->items[i].name);
        free(list->items[i].fraction);
    }
    list->count = kept;
    return jlt_assign_parse(list, text, option);
}

void jlt_assign_clear(jlt_assign_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        free(list->items[i].name);
        free(list->items[i].fraction);
    }
    free(list->items);
    *list = (jlt_assign_list){ 0 };
}

static jlt_exit unknown(const char *name, const jlt_quantity *quantities, size_t count, const char *what,
                        const char *where)
{
    fprintf(stderr, "jellett: %s has no %s '%s'; it has", where, what, name);
    for (size_t i = 0; i < count; i++) fprintf(stderr, "%s %s", i == 0 ? "" : ",", quantities[i].name);
    fputs(count == 0 ? " none\n" : "\n", stderr);
    return JLT_EXIT_INPUT;
}

jlt_exit jlt_assign_apply(double *values, unsigned char *given, const jlt_assign_list *list,
                          const jlt_quantity *quantities, size_t count, const char *what, const char *where)
{
    for (size_t i = 0; i < list->count; i++) {
        size_t at = 0;
        while (at < count && strcmp(quantities[at].name, list->items[i].name) != 0) at++;
        if (at == count) return unknown(list->items[i].name, quantities, count, what, where);
        values[at] = list->items[i].value;
        if (given != NULL) given[at] = 1;
    }
    return JLT_EXIT_DONE;
}

const char *jlt_assign_fraction(const jlt_assign_list *list, const char *name)
{
    for (size_t i = list->count; i-- > 0;)
        if (strcmp(list->items[i].name, name) == 0) return list->items[i].fraction;
    return NULL;
}

/* Print that parameter number `index` must not have this value, and which values the table allows. Returns JLT_EXIT_INPUT. */
static jlt_exit refuse(const jlt_descriptor *descriptor, size_t index, double value)
{
    const jlt_quantity *q = &descriptor->params[index];
    char digits[JLT_DIGITS_SIZE];

    jlt_digits_shortest(digits, value);
    return jlt_command_fail(JLT_EXIT_INPUT, "parameter %s = %s: %s needs %s%s", q->name, digits, descriptor->model, q->name,
                            jlt_descriptor_condition(q));
}

jlt_exit jlt_assign_refuse_region(const char *what, const jlt_descriptor *descriptor, const jlt_region *region, double value)
{
    return jlt_command_fail(JLT_EXIT_INPUT, "%s: outside the domain of %s: %s needs %s, and it is %.10g here", what,
                            descriptor->model, region->name, region->text, value);
}

jlt_exit jlt_assign_refuse_interval(const char *what, const jlt_quantity *quantity)
{
    const double low = quantity->low, high = quantity->high;

    if (isinf(low) || isinf(high))
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: %s must lie %s %.10g", what, quantity->name, isinf(low) ? "below" : "above",
                                isinf(low) ? high : low);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s: %s must lie strictly between %.10g and %.10g", what, quantity->name, low, high);
}

bool jlt_assign_ends(double ends[2], const char *sweep, const char *name)
{
    char found[64];

    for (const char *at = sweep; at != NULL && jlt_grid_ends(&at, found, sizeof found, &ends[0], &ends[1]);) {
        if (strcmp(found, name) != 0) continue;
        if (isnan(ends[1])) ends[1] = ends[0];
        return true;
    }
    return false;
}

jlt_exit jlt_assign_params(double **params, const jlt_descriptor *d, const jlt_assign_list *list, const char *sweep)
{
    const jlt_region *region;
    double *values, value, ends[2];
    size_t index = 0;
    jlt_exit code;

    *params = NULL;
    values = jlt_memory_array(d->param_count, sizeof *values);
    if (values == NULL) return jlt_command_no_memory();
    for (unsigned i = 0; i < d->param_count; i++) values[i] = d->params[i].value;
    code = jlt_assign_apply(values, NULL, list, d->params, d->param_count, "parameter", d->model);
    for (unsigned i = 0; code == JLT_EXIT_DONE && i < d->param_count; i++) {
        if (isnan(values[i]) && jlt_assign_ends(ends, sweep, d->params[i].name))
            values[i] = ends[!jlt_descriptor_allows(&d->params[i], ends[0])];
        if (isnan(values[i]))
            code = jlt_command_fail(JLT_EXIT_INPUT, "parameter %s has no default in %s: add --set %s=VALUE",
                                    d->params[i].name, d->model, d->params[i].name);
    }
    if (code == JLT_EXIT_DONE && jlt_descriptor_check_params(d, values, &index) != JLT_OK)
        code = refuse(d, index, values[index]);
    if (code == JLT_EXIT_DONE && jlt_region_check(&region, &value, d, values, NULL) != JLT_OK)
        code = region == NULL ? jlt_command_no_memory() : jlt_assign_refuse_region("parameters", d, region, value);
    if (code != JLT_EXIT_DONE) {
        free(values);
        return code;
    }
    *params = values;
    return JLT_EXIT_DONE;
}
