#include "stability/random_tops/trial.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>
#include <time.h>

tally sum;

static bool one_in(jlt_random *r, unsigned count)
{
    return jlt_random_below(r, count) == 0;
}

static double sign(jlt_random *r)
{
    return one_in(r, 2) ? -1 : 1;
}

/* Masses over four orders, shapes from a ring's to a rod's, and every special case that the table knows. */
void trial_choose(trial *t)
{
    static const double pi = 3.14159265358979323846;
    jlt_random *r = &t->random;
    jlt_top_values *v = &t->top;

    v->m = jlt_random_magnitude(r, -2, 2);
    v->R = jlt_random_magnitude(r, -1.5, 1.5);
    v->g = one_in(r, 6) ? 0 : one_in(r, 2) ? 9.81 : jlt_random_magnitude(r, -2, 2);
    v->I1 = v->m * v->R * v->R * jlt_random_magnitude(r, -2, 0.3);
    v->I3 = one_in(r, 6)   ? 0
            : one_in(r, 6) ? v->I1
            : one_in(r, 6) ? v->I1 * jlt_random_magnitude(r, -12, -3)
                           : v->I1 * jlt_random_magnitude(r, -1, one_in(r, 3) ? 1 : 0.3);
    v->a3 = one_in(r, 6) ? 0 : v->R * sign(r) * (one_in(r, 6) ? 1 + 2 * jlt_random_unit(r) : jlt_random_unit(r));
    if (one_in(r, 12)) v->a3 = sign(r) * v->R * jlt_random_magnitude(r, -9, -3);
    const double froude = jlt_random_magnitude(r, -1.5, 1.5), W = v->g > 0 ? sqrt(froude * v->g * v->R) : v->R * froude;
    t->q[0] = one_in(r, 10) ? (double[]){ 0, pi, pi / 2, -pi / 2 }[jlt_random_below(r, 4)] : pi * (2 * jlt_random_unit(r) - 1);
    t->q[1] = one_in(r, 10) ? sign(r) * (1 - jlt_random_magnitude(r, -9, -1)) : 2 * jlt_random_unit(r) - 1;
    const double b = v->a3 + v->R * t->q[1], s2 = (1 - t->q[1]) * (1 + t->q[1]);
    const double K = v->I1 * v->R * v->R * s2 + v->I3 * b * b;
    v->G = one_in(r, 6) ? 0 : sign(r) * sqrt(v->m * K) * W * jlt_random_magnitude(r, one_in(r, 8) ? -10 : -1.5, 0.5);
    v->E = v->m * W * W / 2 + v->m * v->g * v->a3 * t->q[1] + v->G * v->G / K / 2;
    t->speed = sqrt(2 * (v->E / v->m + v->g * fabs(v->a3)));
    t->tolerance = jlt_random_magnitude(r, -12.5, -5);
}

oracle_top trial_top(const trial *t)
{
    return (oracle_top){ t->top.m, t->top.R, t->top.g, t->top.I1, t->top.I3, t->top.a3 };
}

void trial_complain(const trial *t, const char *format, ...)
{
    const jlt_top_values *v = &t->top;
    va_list arguments;

    sum.broken++;
    printf("seed %lu case %lu (%s): ", t->seed, t->number, t->kind);
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    printf("\n    --set m=%.17g,R=%.17g,g=%.17g,I1=%.17g,I3=%.17g,a3=%.17g --level E=%.17g,G=%.17g "
           "--start eta=%.17g,gamma3=%.17g --tol %.17g%s\n",
           v->m, v->R, v->g, v->I1, v->I3, v->a3, v->E, v->G, t->q[0], t->q[1], t->tolerance, t->options);
    fflush(stdout);
}

static long double velocity_along(const oracle_top *top, const long double *x)
{
    return (top->a3 + top->R * x[ORACLE_GAMMA3]) * x[ORACLE_OMEGA_N] + top->R * x[ORACLE_S] * x[ORACLE_OMEGA3];
}

/* The largest difference, each in scale: velocities in `speed`, spins and time in themselves where they are larger. */
static long double distance(const family *f, const long double *a, long double v_tau, const long double *x)
{
    const long double U = f->question.speed, W = U / f->question.top.R, turn = 1 / W;
    const long double worst = fmaxl(fmaxl(fabsl(a[ROW_GAMMA3] - x[ORACLE_GAMMA3]), fabsl(a[ROW_V_NU] - x[ORACLE_V_NU]) / U),
                                    fmaxl(fabsl(a[ROW_OMEGA_TAU] - x[ORACLE_OMEGA_TAU]) / fmaxl(W, fabsl(x[ORACLE_OMEGA_TAU])),
                                          fabsl(v_tau - velocity_along(&f->question.top, x)) / U));
    const long double n = fabsl(a[ROW_OMEGA_N] - x[ORACLE_OMEGA_N]) / fmaxl(W, fabsl(x[ORACLE_OMEGA_N]));
    const long double three = fabsl(a[ROW_OMEGA3] - x[ORACLE_OMEGA3]) / fmaxl(W, fabsl(x[ORACLE_OMEGA3]));
    const long double time = fabsl(a[ROW_T] - x[ORACLE_T]) / fmaxl(turn, fabsl(x[ORACLE_T]));
    return fmaxl(fmaxl(worst, time), fmaxl(n, three)); /* NaN: not told, and passed over */
}

/* Rows on which all agree that they exist; an orbit that is slower than a thousand tolerances is at rest for whoever asks, and
 * a crossing goes ten tolerances to either side. */
static void agree(family *f)
{
    const oracle_orbit *truth = &f->truth;

    f->certain = truth->count;
    f->ends = f->sound && truth->end != ORACLE_ALIVE;
    for (int k = 0; k < ORACLE_SHADOWS; k++) {
        if (f->shadows[k].count < f->certain) f->certain = f->shadows[k].count;
        f->ends &= f->shadows[k].end == truth->end && f->shadows[k].count == truth->count;
    }
    for (int n = f->certain; n > 0; n--)
        if (truth->pace[n] < 1e3L * f->question.tolerance
            || (f->question.times == NULL && truth->depth[n] < 10 * f->question.tolerance)) f->certain = n - 1, f->ends = false;
}

void family_disturb(family *f, trial *t, oracle_noise noise)
{
    for (int k = 0; k < ORACLE_SHADOWS; k++) oracle_follow(&f->shadows[k], &f->question, noise, &t->random);
    agree(f);
    f->stray[0] = 0;
    for (int n = 1; n <= f->certain + f->ends; n++) {
        f->stray[n] = f->stray[n - 1];
        for (int k = 0; k < ORACLE_SHADOWS; k++) {
            const long double *x = f->shadows[k].rows[n];
            const long double row[ROW_SIZE] = { x[ORACLE_GAMMA3], x[ORACLE_V_NU], x[ORACLE_OMEGA_TAU], x[ORACLE_OMEGA_N],
                                                x[ORACLE_OMEGA3], 0, x[ORACLE_T] };
            f->stray[n] = fmaxl(f->stray[n], distance(f, row, velocity_along(&f->question.top, x), f->truth.rows[n]));
        }
    }
}

void family_follow(family *out, trial *t, const oracle_question *question, oracle_noise noise)
{
    const oracle_orbit *truth = &out->truth;

    out->question = *question;
    out->slack = 0;
    oracle_follow(&out->truth, question, ORACLE_EXACT, NULL);
    sum.ends[truth->end]++;
    out->sound = truth->end != ORACLE_BUDGET && truth->drift < 1e-16L;
    if (!out->sound) sum.undecided++;
    family_disturb(out, t, noise);
}

bool family_may_lose_v_tau(const family *f, const trial *t, int number)
{
    return t->top.a3 == 0 && t->top.G == 0 && (number > f->certain || 3 * f->stray[number] > 1e-3L);
}

bool family_check(const family *f, const trial *t, const char *how, int number, const double row[ROW_SIZE])
{
    long double wide[ROW_SIZE];
    for (int i = 0; i < ROW_SIZE; i++) wide[i] = row[i];
    const long double error = distance(f, wide, row[ROW_V_TAU], f->truth.rows[number]);
    /* errors of some thirty steps make the strays */
    const long double bound = 3 * f->stray[number] + 10 * f->question.tolerance + f->slack;
    /* Ten tolerances in omega_tau, which near rest methods have at their limit of stability whatever it is there, move its zero
     * along the orbit. */
    const bool crossing = f->question.times == NULL && number <= f->truth.count;
    const long double along = crossing ? 10 * f->question.tolerance * f->truth.lean[number] : 0;

    sum.rows++;
    if (bound > 1e-3L) {
        sum.chaotic++;
        return true;
    }
    if (error > bound && error <= bound + along) sum.along++;
    else sum.worst = fmaxl(sum.worst, error / bound);
    if (error <= bound + along) return true;
    trial_complain(t, "%s, row %d: off by %.3Lg, with a bound of %.3Lg", how, number, error, bound + along);
    return false;
}

static void do_case(unsigned long seed, unsigned long number)
{
    static const struct {
        const char *name;
        void (*run)(trial *);
        unsigned share; /* of 20 */
    } kinds[] = { { "section", case_section, 8 }, { "simulate", case_motion, 7 }, { "orbits", case_periodic, 1 },
                  { "eigen", case_equilibrium, 3 }, { "command", case_command, 1 } };
    trial t = { .seed = seed, .number = number };

    jlt_random_seed(&t.random, seed * 1000003 + number);
    trial_choose(&t);
    unsigned long at = jlt_random_below(&t.random, 20);
    size_t k = 0;
    for (; at >= kinds[k].share; k++) at -= kinds[k].share;
    t.kind = kinds[k].name;
    kinds[k].run(&t);
    sum.cases++;
}

int trial_run(unsigned long seed, unsigned long count, unsigned long first)
{
    const clock_t begin = clock();

    for (unsigned long i = first; i < first + count; i++) do_case(seed, i);
    printf("%lu cases from seed %lu in %.0f s: %lu broken; %lu rows within their bounds, the worst at %.2Lg of it, %lu of them "
           "chaotic, %lu off along the orbit alone; orbits: %lu alive, %lu + %lu at poles, %lu at rest; unsure ends %lu, "
           "coordinates left %lu, steps spent %lu, oracle undecided %lu\n",
           sum.cases, seed, (double)(clock() - begin) / CLOCKS_PER_SEC, sum.broken, sum.rows, sum.worst, sum.chaotic, sum.along,
           sum.ends[ORACLE_ALIVE], sum.ends[ORACLE_POLE_PLUS], sum.ends[ORACLE_POLE_MINUS], sum.ends[ORACLE_REST], sum.unsure,
           sum.left, sum.spent, sum.undecided);
    return sum.broken > 0;
}
