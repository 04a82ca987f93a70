/* Measures the cost and error of eigenvalues at equilibria by each method. */
#include "bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/charpoly.h"
#include "analysis/deflation.h"
#include "analysis/quadratic.h"
#include "spectrum/oracle.h"
#include "core/random.h"
#include "ext/eigen.h"
#include "kernel/descriptor.h"

enum { POINTS = 256, N = 5, INTEGRALS = 3, PARAMS = 6 };

/* A fixed point (4.4) of the balanced sphere, its matrix a, the gradients of integrals that are left null vectors of a, and the
 * true eigenvalues. */
typedef struct {
    double params[PARAMS], x[N], a[N * N], gradients[INTEGRALS * N], truth_re[N], truth_im[N];
} point;

typedef struct {
    const jlt_equilibria *family;
    jlt_status (*of)(double *re, double *im, const point *p, const jlt_equilibria *family);
    double re[POINTS][N], im[POINTS][N];
    point points[POINTS];
} eigen_run;

/* Solve the table's characteristic polynomial, which is lambda^3 times a quadratic. */
static jlt_status closed_form(double *re, double *im, const point *p, const jlt_equilibria *family)
{
    static const double exact[4] = { 0 };
    double c[N + 1], error[2];

    memset(re, 0, N * sizeof *re);
    memset(im, 0, N * sizeof *im);
    family->charpoly(p->x, p->params, c);
    return jlt_quadratic_eigenvalues(re + 3, im + 3, error, (const double[]){ -c[1] / c[0], -c[2] / c[0], 1, 0 }, exact);
}

static jlt_status deflated(double *re, double *im, const point *p, const jlt_equilibria *family)
{
    jlt_deflation result;
    const jlt_status st = jlt_deflation_solve(&result, p->a, NULL, N, p->gradients, NULL, INTEGRALS);

    (void)family;
    for (int i = 0; st == JLT_OK && i < N; i++) re[i] = result.values[i].re, im[i] = result.values[i].im;
    return st;
}

static jlt_status francis(double *re, double *im, const point *p, const jlt_equilibria *family)
{
    (void)family;
    return jlt_eigen_values(re, im, p->a, N);
}

static jlt_status polynomial(double *re, double *im, const point *p, const jlt_equilibria *family)
{
    double c[N + 1];
    const jlt_status st = jlt_charpoly_faddeev_leverrier(c, NULL, p->a, NULL, N);

    (void)family;
    return st == JLT_OK ? jlt_eigen_polynomial_roots(re, im, c, N) : st;
}

/* The two eigenvalues that the integrals do not make zero: the roots of lambda^2 - trace lambda + minors, in extended precision,
 * from enclosures of the matrix. In the sum of principal 2 x 2 minors only one product is not zero, so nothing cancels. */
static void true_pair(point *p, const ttc_enclosure *a, const ttc_enclosure *trace)
{
    long double minors = 0;
    const long double half = ((long double)trace->value + trace->rest) / 2;

    for (int i = 0; i < N; i++)
        for (int j = i + 1; j < N; j++) {
            const int at[] = { i * N + i, j * N + j, i * N + j, j * N + i };
            long double v[4];
            for (int k = 0; k < 4; k++) v[k] = (long double)a[at[k]].value + a[at[k]].rest;
            minors += v[0] * v[1] - v[2] * v[3];
        }
    const long double discriminant = half * half - minors;
    memset(p->truth_re, 0, sizeof p->truth_re);
    memset(p->truth_im, 0, sizeof p->truth_im);
    if (discriminant < 0) {
        p->truth_re[3] = p->truth_re[4] = (double)half;
        p->truth_im[3] = -(double)sqrtl(-discriminant);
        p->truth_im[4] = -p->truth_im[3];
        return;
    }
    const long double larger = half + copysignl(sqrtl(discriminant), half);
    p->truth_re[3] = (double)larger;
    p->truth_re[4] = larger == 0 ? 0 : (double)(minors / larger);
}

/* Change to randomly rotated coordinates, so that no entry of the matrix is zero, as in a model that was not written with its
 * integrals in view. The rotation is a Householder reflection, E - 2 v v^T/|v|^2. */
static void turn(point *p, jlt_random *random)
{
    double v[N], length = 0, a[N * N];

    for (int i = 0; i < N; i++) v[i] = jlt_random_between(random, -1, 1), length += v[i] * v[i];
    for (int side = 0; side < 2; side++) { /* A -> (Q A)^T twice */
        for (int j = 0; j < N; j++) {
            double along = 0;
            for (int i = 0; i < N; i++) along += v[i] * p->a[i * N + j];
            for (int i = 0; i < N; i++) a[j * N + i] = p->a[i * N + j] - 2 * v[i] * along / length;
        }
        memcpy(p->a, a, sizeof a);
    }
    for (int k = 0; k < INTEGRALS; k++) {
        double along = 0;
        for (int i = 0; i < N; i++) along += v[i] * p->gradients[k * N + i];
        for (int i = 0; i < N; i++) p->gradients[k * N + i] -= 2 * v[i] * along / length;
    }
}

enum { GOOD, NEARLY_DEFECTIVE, DEFECTIVE, DEFECTIVE_TURNED, KINDS };

static const char *const kinds[] = { "good", "nearly_defective", "defective", "defective_turned" };

/* Draw omega3: with omega3 = 0 zero is a defective eigenvalue of multiplicity four. */
static double draw_omega3(jlt_random *random, int kind)
{
    if (kind == GOOD) return jlt_random_between(random, 0.2, 2);
    return kind == NEARLY_DEFECTIVE ? jlt_random_magnitude(random, -9, -3) : 0;
}

static jlt_status draw(eigen_run *run, jlt_oracle *oracle, jlt_random *random, const jlt_descriptor *d, int kind)
{
    const jlt_descriptor *balanced = jlt_descriptor_sibling(d, "balanced", NULL, NULL);
    jlt_status st = JLT_OK;
    double block[512];

    if (balanced == NULL || balanced->integral_count != INTEGRALS || balanced->prepared_count > 512) return JLT_ERR_UNSUPPORTED;
    for (int k = 0; k < POINTS; k++) {
        point *p = &run->points[k];
        ttc_enclosure a[N * N], trace;
        for (int i = 0; i < PARAMS; i++) p->params[i] = i == 3 ? 0 : jlt_random_between(random, 0.2, 2); /* a3 is the fourth */
        memset(p->x, 0, sizeof p->x);
        p->x[0] = jlt_random_between(random, -0.9, 0.9);
        p->x[1] = jlt_random_between(random, -2, 2);
        p->x[4] = draw_omega3(random, kind);
        balanced->prepare(p->params, block);
        balanced->jacobian.call(p->x, block, p->a);
        balanced->integral_gradients.call(p->x, block, p->gradients);
        jlt_oracle_set_params(oracle, p->params, NULL);
        jlt_oracle_set_states(oracle, p->x, NULL);
        JLT_TRY(jlt_oracle_enclose(oracle, a, oracle->jacobian, N * N));
        JLT_TRY(jlt_oracle_enclose(oracle, &trace, &oracle->trace, 1));
        true_pair(p, a, &trace);
        if (kind == DEFECTIVE_TURNED) turn(p, random);
    }
done:
    return st;
}

static jlt_status pass(void *context, bool first)
{
    eigen_run *run = context;
    jlt_status st = JLT_OK;

    (void)first;
    for (int k = 0; k < POINTS; k++) {
        const jlt_status one = run->of(run->re[k], run->im[k], &run->points[k], run->family);
        if (one == JLT_ERR_NOMEM) st = one;
        else if (one != JLT_OK) run->re[k][0] = INFINITY;
    }
    return st;
}

static double farthest(const double *re, const double *im, const double *other_re, const double *other_im)
{
    double worst = 0;

    for (int i = 0; i < N; i++) {
        double nearest = INFINITY;
        for (int j = 0; j < N; j++) nearest = fmin(nearest, hypot(re[i] - other_re[j], im[i] - other_im[j]));
        worst = fmax(worst, nearest);
    }
    return worst;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void write_row(FILE *table, const eigen_run *run, const char *name, const char *points, const jlt_bench_time *time)
{
    const double unit = 1e9 / POINTS;
    double errors[POINTS];
    int failed = 0;

    for (int k = 0; k < POINTS; k++) {
        const point *p = &run->points[k];
        double size = 0;
        for (int e = 0; e < N * N; e++) size = fmax(size, fabs(p->a[e]));
        failed += isinf(run->re[k][0]);
        errors[k] = fmax(farthest(run->re[k], run->im[k], p->truth_re, p->truth_im),
                         farthest(p->truth_re, p->truth_im, run->re[k], run->im[k])) / size;
    }
    qsort(errors, POINTS, sizeof *errors, ascending); /* failures are INFINITY, so they come last */
    const int made = failed < POINTS ? POINTS - failed : 1;
    fprintf(table, "jellett,%s,%s,%.3e,%.3e,%.3e,%.4g,%.4g,%.4g,%d\n", name, points, errors[made / 2], errors[0], errors[made - 1],
            unit * time->median, unit * time->least, unit * time->largest, failed);
}

static jlt_exit run(FILE *table, const jlt_bench_options *options)
{
    static const struct {
        const char *name;
        jlt_status (*of)(double *, double *, const point *, const jlt_equilibria *);
    } ways[] = {
        { "closed form", closed_form }, { "deflated", deflated }, { "QR", francis }, { "characteristic polynomial", polynomial }
    };
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    eigen_run *run = calloc(1, sizeof *run);
    jlt_oracle *oracle = NULL;
    jlt_random random;
    jlt_status st = run == NULL ? JLT_ERR_NOMEM : JLT_OK;

    if (st == JLT_OK) st = jlt_oracle_create(&oracle, d, NULL);
    jlt_random_seed(&random, 1);
    for (int kind = 0; kind < KINDS && st == JLT_OK; kind++) {
        run->family = &d->equilibria[0]; /* (4.4) */
        JLT_TRY(draw(run, oracle, &random, d, kind));
        for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
            jlt_bench_time time;
            run->of = ways[i].of;
            JLT_TRY(jlt_bench_clock(&time, options->repeats, 1, pass, run));
            write_row(table, run, ways[i].name, kinds[kind], &time);
        }
    }
done:
    jlt_oracle_destroy(oracle);
    free(run);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_command_fail(jlt_command_exit(st), "eigenvalues: %s", jlt_status_text(st));
}

const jlt_bench_kind jlt_bench_eigenvalues = {
    "eigenvalues",
    "all five at fixed points (4.4), 256 random ones of each kind,\n    the matrix being given; error relative to its largest "
    "entry;\n    defective: omega3 = 0; turned: in rotated coordinates",
    "program,method,points,error,error_least,error_largest,ns_per_matrix,ns_least,ns_largest,failed", "kqo", run,
};
