#include "cli/certify_pole.h"

#include "cli/certify_given.h"
#include "kernel/descriptor.h"
#include "read/model.h"
#include "validated/given_pole.h"

#include <string.h>

/* Put all states into the box, as typed. */
static jlt_exit put_box(json_t *box, const jlt_certify_pole_options *o, const jlt_descriptor *d)
{
    jlt_assign_list start = { 0 };
    jlt_exit code = jlt_assign_parse(&start, o->start, "--start");
    size_t index;

    for (size_t i = 0; code == JLT_EXIT_DONE && i < start.count; i++)
        if (!jlt_descriptor_state(d, start.items[i].name, &index))
            code = jlt_command_fail(JLT_EXIT_INPUT, "--start: %s has no state '%s'", d->model, start.items[i].name);
    for (unsigned i = 0; code == JLT_EXIT_DONE && i < d->state_count; i++) {
        const char *name = d->states[i].name, *typed = jlt_assign_fraction(&start, name);
        code = typed == NULL ? jlt_command_fail(JLT_EXIT_INPUT, "--start: give every state of %s; %s has no value", d->model, name)
                             : jlt_certify_put(box, name, name, strdup(typed), o->spread);
    }
    jlt_assign_clear(&start);
    return code;
}

static jlt_exit put_params(json_t *params, const jlt_certify_pole_options *o, const jlt_assign_list *set, const jlt_descriptor *d)
{
    jlt_exit code = JLT_EXIT_DONE;
    size_t index;

    for (size_t i = 0; code == JLT_EXIT_DONE && i < set->count; i++)
        if (!jlt_descriptor_param(d, set->items[i].name, &index))
            code = jlt_command_fail(JLT_EXIT_INPUT, "--set: %s has no parameter '%s'", d->model, set->items[i].name);
    for (unsigned i = 0; code == JLT_EXIT_DONE && i < d->param_count; i++) {
        const char *name = d->params[i].name, *typed = jlt_assign_fraction(set, name);
        code = jlt_certify_put(params, name, name, typed != NULL ? strdup(typed) : jlt_certify_default(d->table, name), o->spread);
    }
    return code;
}

/* Whether the proof succeeds with the instant of `given`, or, if that is absent, with one that is found. Out: that instant, or why
 * the proof does not succeed. */
static bool settles(json_t *given, double *instant, const jlt_descriptor *d, jlt_step_watch *watch,
                    char problem[JLT_GIVEN_PROBLEM_MAX])
{
    jlt_given_pole question;
    jlt_pole_result result;
    bool found = jlt_given_pole_read(&question, given, d, true, problem);

    question.question.watch = watch;
    jlt_pole_result_init(&result, d);
    if (found) {
        const jlt_status st = jlt_pole_prove(&result, &question.question, question.instant);
        found = st == JLT_OK && result.verdict == JLT_POLE_PROVED;
        if (!found) jlt_refuse(problem, "%s", st == JLT_OK ? jlt_given_pole_problem(&result) : jlt_status_text(st));
        *instant = arf_get_d(question.instant, ARF_RND_UP);
    }
    jlt_pole_result_clear(&result);
    jlt_given_pole_clear(&question);
    return found;
}

/* Put an instant from which the motions settle into `given`: if possible four times as late as the first one that is found, since
 * limits are enclosed more tightly there. */
static bool find_instant(json_t *given, const jlt_descriptor *d, jlt_step_watch *watch, char problem[JLT_GIVEN_PROBLEM_MAX])
{
    static const double factors[] = { 4, 2, 1.001 };
    double first = 0, instant;
    char text[32];

    json_object_del(given, "instant");
    if (!settles(given, &first, d, watch, problem)) return false;
    for (unsigned i = 0; i < sizeof factors / sizeof *factors; i++) {
        snprintf(text, sizeof text, "%.3e", factors[i] * first);
        json_object_set_new(given, "instant", json_string(text));
        if (settles(given, &instant, d, watch, problem)) return true;
    }
    return false;
}

/* Try all poles of the table, in all times that lift roots, until the proof succeeds; else say of each why it does not. */
static jlt_exit find_end(json_t *given, const jlt_descriptor *d, jlt_step_watch *watch)
{
    char problem[JLT_GIVEN_PROBLEM_MAX] = "";
    ttc_model *model = ttc_model_again(d->table, d->model);
    json_t *reasons = json_array(), *reason;
    bool found = false;
    size_t index;

    for (unsigned i = 0; !found && i < d->pole_count; i++)
        for (size_t k = 0; !found && model != NULL && k < model->time_count; k++) {
            if (model->times[k].lifted_count == 0) continue;
            json_object_set_new(given, "pole", json_string(d->states[d->poles[i].state].name));
            json_object_set_new(given, "time", json_string(model->times[k].name));
            found = find_instant(given, d, watch, problem);
            json_array_append_new(reasons, json_sprintf("%s [pole %s, time %s]", problem,
                                                        d->states[d->poles[i].state].name, model->times[k].name));
        }
    ttc_model_destroy(model);
    if (d->pole_count > 0 && json_array_size(reasons) == 0)
        json_array_append_new(reasons, json_string("no time of the table lifts a root that is zero at a pole"));
    if (!found)
        json_array_foreach(reasons, index, reason)
            (void)jlt_command_fail(JLT_EXIT_FAILED, "not proved: %s", json_string_value(reason));
    json_decref(reasons);
    if (d->pole_count == 0) return jlt_command_fail(JLT_EXIT_INPUT, "%s has no record `pole`", d->model);
    return found ? JLT_EXIT_DONE : JLT_EXIT_FAILED;
}

jlt_exit jlt_certify_pole(json_t **given, const jlt_certify_pole_options *o, const jlt_assign_list *set, const jlt_descriptor *d)
{
    json_t *params = json_object(), *box = json_object();
    jlt_exit code;

    *given = json_pack("{s:{s:s,s:s},s:o,s:o,s:i}", "table", "name", d->model, "sha256", d->sha256, "parameters", params, "box",
                       box, "digits", (int)o->digits);
    if (*given == NULL) return jlt_command_no_memory();
    code = put_box(box, o, d);
    if (code == JLT_EXIT_DONE) code = put_params(params, o, set, d);
    if (code == JLT_EXIT_DONE) code = jlt_certify_check_spread(o->spread, params, box, "a state");
    if (code == JLT_EXIT_DONE) code = find_end(*given, d, o->watch);
    if (code == JLT_EXIT_DONE) return code;
    json_decref(*given);
    *given = NULL;
    return code;
}
