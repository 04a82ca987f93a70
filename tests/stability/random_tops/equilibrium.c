/* Eigenvalues at the equilibria (4.4) of balanced tops, from doubles and in ball arithmetic: each within its own bound. */
#include "stability/random_tops/trial.h"

#include <complex.h>
#include <math.h>

#include "analysis/linearization.h"
#include "kernel/descriptor.h"

/* The quadratic factor of (4.5): lambda^2 + p lambda + q. */
static void roots(long double complex out[2], long double p, long double q)
{
    const long double complex d = csqrtl((long double complex)(p * p / 4 - q));
    out[0] = p > 0 ? -p / 2 - d : -p / 2 + d;
    out[1] = out[0] != 0 ? q / out[0] : 0;
}

static void check(const trial *t, const char *how, const jlt_linearization *r, const long double complex want[2])
{
    for (size_t i = 0; i < r->n; i++) {
        const jlt_eigenvalue *v = &r->eigen.values[i];
        const long double complex got = v->re + (long double complex)v->im * I;
        if (isnan(v->re) || v->source >= 0) continue;
        long double off = cabsl(got); /* from a zero */
        for (int k = 0; k < 2; k++) off = fminl(off, cabsl(got - want[k]));
        sum.rows++;
        /* The formula is rounded to 64 bits. */
        if (off > v->error + 1e-17L * cabsl(got))
            trial_complain(t, "%s: eigenvalue %.17g %+.17gi is off by %.3Lg, with a bound of %.3g", how, v->re, v->im, off,
                           v->error);
    }
    const long double growth = fmaxl(creall(want[0]), creall(want[1]));
    const bool moves = want[0] != 0 && want[1] != 0;
    if (!moves || r->verdict == JLT_UNDECIDED) return;
    const jlt_verdict verdict = growth > 0 ? JLT_UNSTABLE : growth < 0 ? JLT_STABLE : JLT_CENTRE;
    if (r->verdict != verdict)
        trial_complain(t, "%s: %s, and the formula says %s", how, jlt_linearization_verdict(r->verdict),
                       jlt_linearization_verdict(verdict));
}

void case_equilibrium(trial *t)
{
    const jlt_descriptor *model = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    jlt_random *r = &t->random;
    jlt_top_values *v = &t->top;
    const double c = t->q[1], v0 = jlt_random_below(r, 8) == 0 ? 0 : t->speed * (2 * jlt_random_unit(r) - 1);
    const double w0 = t->speed / v->R * jlt_random_magnitude(r, jlt_random_below(r, 4) == 0 ? -12 : -2, 2);
    const double params[] = { v->m, v->R, v->g, v->a3 = 0, v->I1, v->I3 }, x[] = { c, v0, 0, 0, w0 };
    jlt_ball_value ball_params[6], ball_x[5];
    static jlt_linearization result;
    long double complex want[2];

    const long double s = sqrtl((1 - (long double)c) * (1 + (long double)c)), R = v->R, m = v->m, I1 = v->I1, I3 = v->I3;
    const long double Theta = I1 * I3 + I1 * m * R * R * s * s + I3 * m * R * R * c * c;
    roots(want, I3 * m * R * c * v0 / (s * Theta), I3 * I3 * w0 * w0 * (I3 + m * R * R) / (I1 * Theta));
    snprintf(t->options, sizeof t->options, "\n    --at gamma3=%.17g,v_nu=%.17g,omega3=%.17g", c, v0, w0);
    jlt_status st = jlt_linearization_compute(&result, model, params, x, NULL, NULL, NULL);
    if (st == JLT_OK) {
        check(t, "doubles", &result, want);
        for (int i = 0; i < 6; i++) ball_params[i] = (jlt_ball_value){ params[i], NULL };
        for (int i = 0; i < 5; i++) ball_x[i] = (jlt_ball_value){ x[i], NULL };
        st = jlt_linearization_enclose(&result, model, ball_params, ball_x, NULL, 0);
        if (st == JLT_OK) check(t, "balls", &result, want);
    }
    if (st != JLT_OK) trial_complain(t, "eigen: %s", jlt_status_text(st));
}
