/* What simulate does: the state at times, in every tier that serves and by every method. */
#include "stability/random_tops/trial.h"

#include <math.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "scene/course.h"
#include "top/top.h"

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

/* Plain time ends near a pole, and the chart without omega3 near b = 0 as well: the oracle comes there, too. */
static bool may_leave(const trial *t, const family *f, const double *x)
{
    const jlt_top_values *v = &t->top;
    return f->truth.least_s < 1e-2L || (x != NULL && fabs(v->a3 + v->R * x[0]) < 1e-2 * v->R);
}

/* Coordinates of the half of M^2 end where v_slip goes to 0, as its table says; those with a state eliminated where the integral
 * hardly contains it. */
static bool ends_at_edges(const char *tier)
{
    return strcmp(tier, "plane") == 0 || strncmp(tier, "level_omega", strlen("level_omega")) == 0;
}

static void follow(trial *t, const family *f, const jlt_question *question, const jlt_method *method, bool plain)
{
    jlt_plan plan;
    jlt_course *course = NULL;
    jlt_course_row at = { .x = NULL };
    char how[64];
    double row[ROW_SIZE];

    if (jlt_plan_make(&plan, question) != JLT_OK) return;
    snprintf(how, sizeof how, "simulate --tier %s --method %s", question->tier, method->name);
    const jlt_course_options options = { .method = method, .tolerance = t->tolerance, .max_steps = plain ? 100000 : 0 };
    jlt_status st = jlt_course_create(&course, &plan, question, &options);
    for (int k = 1; st == JLT_OK && k <= TIMES; k++) {
        st = jlt_course_to(course, f->question.times[k - 1], &at);
        if (st != JLT_OK) break;
        memcpy(row, at.x, JLT_TOP_STATES * sizeof *row);
        row[ROW_V_TAU] = NAN; /* its s is not told */
        row[ROW_T] = at.t;
        const bool pole = at.end == JLT_END_POLE;
        if (f->truth.end == ORACLE_REST && k > f->truth.count) row[ROW_T] = NAN; /* the same for ever */
        if (f->truth.end == ORACLE_REST && k > f->truth.count + 1) break;
        if (k > f->certain + f->ends) {
            sum.unsure++;
            break;
        }
        if (pole != (k > f->truth.count && f->truth.end != ORACLE_REST)) {
            trial_complain(t, "%s, row %d: %s a pole, and the oracle has %d rows, then %d", how, k, pole ? "at" : "not at",
                           f->truth.count, f->truth.end);
            break;
        }
        if (!family_check(f, t, how, k, row) || pole) break;
    }
    if ((st == JLT_ERR_DOMAIN || st == JLT_ERR_BUDGET) && plain && may_leave(t, f, at.x)) sum.left++;
    else if (st == JLT_ERR_DOMAIN && at.edge != NULL && ends_at_edges(question->tier)) sum.left++;
    else if ((st == JLT_ERR_NONFINITE || st == JLT_ERR_NO_PROGRESS) && t->top.I3 == 0 && f->truth.end != ORACLE_ALIVE)
        sum.left++; /* omega3 = v_tau/(R s) is infinite there */
    else if (st != JLT_OK)
        trial_complain(t, "%s: %s; the oracle has %d rows, then %d", how, jlt_status_text(st), f->truth.count, f->truth.end);
    jlt_course_destroy(course);
}

/* The tiers, with the errors that their states have. */
static const struct {
    const char *name;
    oracle_noise noise;
    bool plain;
} tiers[] = { { "quadrature", ORACLE_LEVEL_NOISE, false }, { "plane", ORACLE_LEVEL_NOISE, false },
              { "balanced", ORACLE_LEVEL_NOISE, false }, { "level", ORACLE_LEVEL_NOISE, false },
              { "level_plain", ORACLE_LEVEL_NOISE, true }, { "five", ORACLE_FIVE_NOISE, false },
              { "five_plain", ORACLE_FIVE_NOISE, true }, { "track", ORACLE_FIVE_NOISE, false },
              { "full", ORACLE_FIVE_NOISE, true }, { "level_omega_n", ORACLE_OMEGA3_NOISE, true },
              { "level_omega3", ORACLE_OMEGA_N_NOISE, true } };

void case_motion(trial *t)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    const jlt_top_values *v = &t->top;
    const double params[] = { v->m, v->R, v->g, v->a3, v->I1, v->I3 };
    double x[JLT_TOP_STATES], times[TIMES];
    static family f;
    oracle_noise noise = ORACLE_LEVEL_NOISE;

    choose(x, times, t);
    t->speed = fmax(t->speed, fmax(fabs(x[1]), v->R * fabs(x[2])));
    const oracle_question q = { .top = trial_top(t), .gamma3 = x[0], .v_nu = x[1], .omega_tau = x[2], .omega_n = x[3],
                                .omega3 = x[4], .time_direction = times[0] < 0 ? -1 : 1, .times = times, .count = TIMES,
                                .tolerance = t->tolerance, .speed = t->speed };
    snprintf(t->options, sizeof t->options, "\n    --start gamma3=%.17g,v_nu=%.17g,omega_tau=%.17g,omega_n=%.17g,omega3=%.17g "
             "--times %.17g,%.17g,%.17g", x[0], x[1], x[2], x[3], x[4], times[0], times[1], times[2]);
    family_follow(&f, t, &q, noise);
    for (size_t i = 0; f.sound && i < sizeof tiers / sizeof *tiers; i++) {
        const jlt_question question = { model, params, x, false, false, tiers[i].name, NULL };
        if (tiers[i].noise == ORACLE_OMEGA_N_NOISE && v->I3 < 1e-3 * v->I1) continue; /* it divides by I3, as its name says */
        if (tiers[i].noise != noise || tiers[i].plain != f.question.plain) {
            f.question.plain = tiers[i].plain;
            family_disturb(&f, t, noise = tiers[i].noise);
        }
        follow(t, &f, &question, jlt_method_at(jlt_random_below(&t->random, 6)), tiers[i].plain);
    }
}
