#include <argp.h>
#include <stdlib.h>
#include <string.h>

#include "cli/session.h"
#include "cli/table.h"
#include "scene/scene.h"

static error_t parse(int key, char *value, struct argp_state *state)
{
    const char **scene = state->input;

    switch (key) {
    case ARGP_KEY_ARG:
        if (*scene != NULL) argp_error(state, "one scene at a time: '%s' is too many", value);
        *scene = value;
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    NULL, parse, "[SCENE]",
    "Which model each part of a scene gets, and why: the tiers from the smallest up, with the most special kernel for the "
    "parameters and the operations of one call of its right-hand side. Without a scene: the tiers there are.",
    NULL, NULL, NULL,
};

static void print_tiers(void)
{
    printf("%-14s %5s  %s\n", "tier", "dim", "what");
    for (size_t i = 0; jlt_tier_at(i) != NULL; i++) {
        const jlt_tier *tier = jlt_tier_at(i);
        printf("%-14s %5u  %s%s\n", tier->name, tier->dimension, tier->meaning,
               tier->by_name ? " (a comparison: by name only)" : "");
    }
    printf("%-14s %5s  %s\n", "model", "-", "any model's own field, in t");
}

static void kernel_name(char *out, size_t size, const jlt_descriptor *d)
{
    if (d == NULL) snprintf(out, size, "-");
    else
        snprintf(out, size, "%s%s%s%s%s%s%s", d->model, d->variant[0] != '\0' ? " " : "", d->variant,
                 d->time[0] != '\0' ? " in " : "", d->time, d->elimination[0] != '\0' ? " on " : "", d->elimination);
}

static void print_candidate(const jlt_plan *plan, unsigned index)
{
    const jlt_candidate *c = &plan->candidates[index];
    const char *name = c->tier != NULL ? c->tier->name : "model";
    const unsigned dimension = c->tier != NULL ? c->tier->dimension : c->descriptor->state_count;
    char kernel[128], counts[64] = "", refusal[1024];

    kernel_name(kernel, sizeof kernel, c->descriptor);
    if (c->descriptor != NULL) {
        const jlt_operation_count *n = &c->descriptor->rhs.optimized;
        snprintf(counts, sizeof counts, "%u+ %ux %ufma %u/ %uroot %uelem", n->add, n->multiply, n->fma, n->divide, n->root,
                 n->elementary);
    }
    printf("  %c %-13s %3u  %-52s %-36s ", index == plan->chosen ? '*' : ' ', name, dimension, kernel, counts);
    if (index == plan->chosen)
        puts(plan->forced ? "taken: asked for by name" : plan->count == 1 ? "taken: the model's own field"
                                                                          : "taken: the smallest that answers");
    else if (c->refusal != NULL) {
        jlt_plan_refusal(refusal, sizeof refusal, c);
        printf("no: %s\n", refusal);
    }
    else if (c->tier != NULL && c->tier->by_name) puts("would answer: a comparison, by name only");
    else puts(index > plan->chosen ? "would answer, but is larger" : "would answer, and is smaller");
}

static jlt_exit bind(jlt_session *session, const jlt_scene_job *job)
{
    const char *set = jlt_scene_value(job, "set"), *start = jlt_scene_value(job, "start");
    const bool whole = strcmp(job->what, "simulate") == 0 || strcmp(job->what, "portrait") == 0;
    jlt_exit code = JLT_EXIT_DONE;

    session->common.model = job->model;
    if (set != NULL) code = jlt_assign_parse(&session->common.set, set, "parameters");
    if (code == JLT_EXIT_DONE && start != NULL && whole) code = jlt_assign_parse(&session->start, start, "start");
    if (code == JLT_EXIT_DONE) code = jlt_session_open(session);
    if (code == JLT_EXIT_DONE && start != NULL && whole) code = jlt_session_start(session);
    return code;
}

static bool has_flag(const jlt_scene_job *job, const char *name)
{
    for (size_t i = 0; i < job->count; i++)
        if (strcmp(job->options[i].name, name) == 0) return true;
    return false;
}

static bool is_motion(const char *what)
{
    static const char *const still[] = { "verify", "eigen", "rod" };

    for (size_t i = 0; i < sizeof still / sizeof *still; i++)
        if (strcmp(still[i], what) == 0) return false;
    return true;
}

static jlt_exit plan_job(const jlt_scene *scene, size_t index)
{
    const jlt_scene_job *job = &scene->jobs[index];
    const bool whole = strcmp(job->what, "simulate") == 0 || strcmp(job->what, "portrait") == 0;
    jlt_session session;
    jlt_plan plan;
    jlt_status st;
    jlt_exit code;

    printf("%zu. %s (%s:%u)\n", index + 1, job->what, scene->file, job->line);
    if (!is_motion(job->what)) {
        puts(strcmp(job->what, "rod") == 0 ? "  * quadrature: nothing is integrated in time" : "  nothing moves: no tier is needed");
        return JLT_EXIT_DONE;
    }
    jlt_session_begin(&session, 0, NULL);
    code = bind(&session, job);
    if (code != JLT_EXIT_DONE) goto done;
    const jlt_question question = { session.descriptor, session.params, session.x, has_flag(job, "track"), !whole,
                                    jlt_tier_has(session.descriptor) && jlt_scene_value(job, "section") != NULL ? "model"
                                                                                                               : jlt_scene_value(job, "tier") };
    st = jlt_plan_make(&plan, &question);
    if (st == JLT_ERR_ARG)
        code = jlt_command_fail(JLT_EXIT_INPUT, "%s:%u: error: there is no tier '%s'", scene->file, job->line, question.tier);
    else if (st == JLT_ERR_UNSUPPORTED)
        code = jlt_command_fail(JLT_EXIT_INPUT, "%s:%u: error: no tier can answer%s%s", scene->file, job->line,
                                question.tier != NULL ? ": " : "",
                                question.tier != NULL ? plan.candidates[plan.chosen].refusal : "");
    else if (st != JLT_OK) code = jlt_session_fail(st, job->what);
    for (unsigned k = 0; code == JLT_EXIT_DONE && k < plan.count; k++) print_candidate(&plan, k);
done:
    jlt_session_end(&session);
    return code;
}

static jlt_exit run(int argc, char **argv)
{
    const char *path = NULL;
    char message[JLT_SCENE_MESSAGE_MAX];
    jlt_scene *scene = NULL;
    jlt_exit code = JLT_EXIT_DONE;
    jlt_status st;

    argp_parse(&parser, argc, argv, 0, NULL, &path);
    if (path == NULL) {
        print_tiers();
        return JLT_EXIT_DONE;
    }
    st = jlt_scene_read(&scene, message, path, jlt_table_of);
    if (st != JLT_OK) {
        fprintf(stderr, "%s\n", message);
        return st == JLT_ERR_IO ? JLT_EXIT_IO : st == JLT_ERR_NOMEM ? JLT_EXIT_NUMERICAL : JLT_EXIT_INPUT;
    }
    if (scene->title[0] != '\0') printf("%s\n", scene->title);
    for (size_t k = 0; code == JLT_EXIT_DONE && k < scene->count; k++) code = plan_job(scene, k);
    jlt_scene_destroy(scene);
    return code;
}

const jlt_command jlt_command_plan = { "plan", "[SCENE]", "Which model each part of a scene gets, and why", run };
