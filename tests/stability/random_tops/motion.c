/* What simulate does: the state at times, in every tier that serves and by every method. */
#include "stability/random_tops/trial.h"

#include <math.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "scene/course.h"

enum { TIMES = 3 };

/* Speeds of the size that the trial's levels make, in all three planes. */
static void choose(double x[JLT_TOP_STATES], double times[TIMES], trial *t)
{
    jlt_random *r = &t->random;
    const jlt_top_values *v = &t->top;
    const double U = t->speed, W = U / v->R;

    x[JLT_TOP_GAMMA3] = t->q[1];
    x[JLT_TOP_V_NU] = jlt_random_below(r, 12) == 0 ? 0 : U * (2 * jlt_random_unit(r) - 1);
    for (int i = JLT_TOP_OMEGA_TAU; i <= JLT_TOP_OMEGA3; i++)
        x[i] = jlt_random_below(r, 12) == 0 ? 0 : W * jlt_random_magnitude(r, -1, 0.7) * (2 * jlt_random_unit(r) - 1);
    const double end = (jlt_random_below(r, 4) == 0 ? -1 : 1) / W * jlt_random_magnitude(r, -1, 1);
    for (int i = 0; i < TIMES; i++) times[i] = end * (i + 1) / TIMES;
}

static void row_of(double row[ROW_SIZE], const trial *t, const double *x, double at)
{
    const jlt_top_values *v = &t->top;
    const double s = sqrt((1 - x[0]) * (1 + x[0]));

    memcpy(row, x, JLT_TOP_STATES * sizeof *row);
    row[ROW_T] = at;
    row[ROW_V_TAU] = (v->a3 + v->R * x[0]) * x[JLT_TOP_OMEGA_N] + v->R * s * x[JLT_TOP_OMEGA3];
}

static void follow(trial *t, const family *f, const jlt_question *question, const jlt_method *method)
{
    jlt_plan plan;
    jlt_course *course = NULL;
    jlt_course_row at;
    char how[64];
    double row[ROW_SIZE];

    if (jlt_plan_make(&plan, question) != JLT_OK) return;
    snprintf(how, sizeof how, "simulate --tier %s --method %s", question->tier, method->name);
    const bool plain = strstr(question->tier, "plain") != NULL || strstr(question->tier, "omega") != NULL
                       || strcmp(question->tier, "full") == 0;
    jlt_status st = jlt_course_create(&course, &plan, question, &(jlt_course_options){ .method = method, .tolerance = t->tolerance });
    for (int k = 1; st == JLT_OK && k <= TIMES; k++) {
        st = jlt_course_to(course, f->question.times[k - 1], &at);
        if (st != JLT_OK) break;
        row_of(row, t, at.x, at.t);
        const bool pole = at.end == JLT_END_POLE;
        if (k > f->certain + f->ends) {
            sum.unsure++;
            break;
        }
        if (pole != (k > f->truth.count)) {
            trial_complain(t, "%s, row %d: %s a pole, and the oracle has %d rows, then %d", how, k, pole ? "at" : "not at",
                           f->truth.count, f->truth.end);
            break;
        }
        if (!family_check(f, t, how, k, row) || pole) break;
    }
    if (st == JLT_ERR_DOMAIN && plain) sum.ends[ORACLE_ENDS - 1] += 0; /* its coordinates end there */
    else if (st != JLT_OK) trial_complain(t, "%s: %s; the oracle has %d rows, then %d", how, jlt_status_text(st), f->truth.count, f->truth.end);
    jlt_course_destroy(course);
}

void case_motion(trial *t)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    const jlt_top_values *v = &t->top;
    const double params[] = { v->m, v->R, v->g, v->a3, v->I1, v->I3 };
    double x[JLT_TOP_STATES], times[TIMES];
    static family level, five;

    choose(x, times, t);
    t->speed = fmax(t->speed, fmax(fabs(x[1]), v->R * fabs(x[2])));
    const oracle_question q = { .top = trial_top(t), .gamma3 = x[0], .v_nu = x[1], .omega_tau = x[2], .omega_n = x[3], .omega3 = x[4],
                                .time_direction = times[0] < 0 ? -1 : 1, .times = times, .count = TIMES,
                                .tolerance = t->tolerance, .speed = t->speed };
    snprintf(t->options, sizeof t->options, "\n    --start gamma3=%.17g,v_nu=%.17g,omega_tau=%.17g,omega_n=%.17g,omega3=%.17g "
             "--times %.17g,%.17g,%.17g", x[0], x[1], x[2], x[3], x[4], times[0], times[1], times[2]);
    family_follow(&level, t, &q, ORACLE_LEVEL_NOISE);
    if (!level.sound) return;
    family_follow(&five, t, &q, ORACLE_FIVE_NOISE);
    for (size_t i = 0; jlt_tier_at(i) != NULL; i++) {
        const char *tier = jlt_tier_at(i)->name;
        const jlt_question question = { model, params, x, false, false, tier };
        const bool on_level = i < 4;
        follow(t, on_level ? &level : &five, &question, jlt_method_at(jlt_random_below(&t->random, 6)));
    }
}
