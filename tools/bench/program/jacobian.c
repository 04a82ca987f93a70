/* Measures the cost and error of the reduced system's Jacobian by each method. */
#include "bench.h"

#include <complex.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "spectrum/oracle.h"
#include "core/random.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"

enum { POINTS = 256, ROUNDS = 16, N = 5, ENTRIES = N * N };

/* Points of the reduced system (3.2), the true Jacobians there, and one method to compute them. */
typedef struct way way;
struct way {
    const char *name;
    void (*of)(const way *self, double *jacobian, const double *x);
    const jlt_kernel_batch *batch; /* NULL: scalar */
    double *spread;                /* for the batch: the prepared values, copied to every lane */
    double step;                   /* of differences, relative to max(|x_i|, 1) */
    const jlt_instance *instance;
    double x[POINTS][N], truth[POINTS][ENTRIES];
    _Alignas(64) double by_columns[N * POINTS]; /* x transposed, (N, POINTS), for the batch */
    double (*found)[ENTRIES], *lanes_out;       /* Jacobians, (POINTS, ENTRIES); the batch's output, (ENTRIES, POINTS) */
};

static void generated(const way *self, double *jacobian, const double *x)
{
    self->instance->descriptor->jacobian.call(x, self->instance->prepared, jacobian);
}

/* Complex step: Im f(x + i h e_j)/h. No difference is formed, so h may be arbitrarily small. */
static void complex_step(const way *self, double *jacobian, const double *x)
{
    static const double h = 1e-100;
    double complex z[N], f[N];

    for (int i = 0; i < N; i++) z[i] = x[i];
    for (int j = 0; j < N; j++) {
        z[j] = x[j] + h * I;
        self->instance->descriptor->rhs_complex(z, self->instance->params, f);
        for (int i = 0; i < N; i++) jacobian[i * N + j] = cimag(f[i]) / h;
        z[j] = x[j];
    }
}

static void central(const way *self, double *jacobian, const double *x)
{
    const jlt_kernel_function f = self->instance->descriptor->rhs.call;
    double z[N], up[N], down[N];

    memcpy(z, x, sizeof z);
    for (int j = 0; j < N; j++) {
        const double h = self->step * fmax(1, fabs(x[j])), high = x[j] + h, low = x[j] - h;
        z[j] = high;
        f(z, self->instance->prepared, up);
        z[j] = low;
        f(z, self->instance->prepared, down);
        for (int i = 0; i < N; i++) jacobian[i * N + j] = (up[i] - down[i]) / (high - low);
        z[j] = x[j];
    }
}

static void forward(const way *self, double *jacobian, const double *x)
{
    const jlt_kernel_function f = self->instance->descriptor->rhs.call;
    double z[N], up[N], here[N];

    memcpy(z, x, sizeof z);
    f(x, self->instance->prepared, here);
    for (int j = 0; j < N; j++) {
        z[j] = x[j] + self->step * fmax(1, fabs(x[j]));
        f(z, self->instance->prepared, up);
        for (int i = 0; i < N; i++) jacobian[i * N + j] = (up[i] - here[i]) / (z[j] - x[j]);
        z[j] = x[j];
    }
}

/* Draw the points: at a distance 1 - gamma3 from 1e-10 to 1e-2 of the upper pole, or at least 0.05 away from both poles. */
static void draw(way *w, jlt_random *random, bool near_pole)
{
    for (int k = 0; k < POINTS; k++) {
        w->x[k][0] = near_pole ? 1 - jlt_random_magnitude(random, -10, -2) : jlt_random_between(random, -0.95, 0.95);
        for (int i = 1; i < N; i++) w->x[k][i] = jlt_random_between(random, -2, 2);
        for (int i = 0; i < N; i++) w->by_columns[i * POINTS + k] = w->x[k][i];
    }
}

static jlt_status find_truth(way *w, jlt_oracle *oracle)
{
    jlt_status st = JLT_OK;
    ttc_enclosure exact[ENTRIES];

    for (int k = 0; k < POINTS; k++) {
        jlt_oracle_set_params(oracle, w->instance->params, NULL);
        jlt_oracle_set_states(oracle, w->x[k], NULL);
        JLT_TRY(jlt_oracle_enclose(oracle, exact, oracle->jacobian, ENTRIES));
        for (int e = 0; e < ENTRIES; e++) w->truth[k][e] = exact[e].value;
    }
done:
    return st;
}

static jlt_status pass(void *context, bool first)
{
    way *w = context;

    (void)first;
    for (int round = 0; round < ROUNDS; round++) {
        if (w->batch != NULL)
            for (unsigned k = 0; k < POINTS; k += w->batch->lanes)
                w->batch->jacobian(w->by_columns + k, w->spread, w->lanes_out + k, POINTS);
        else
            for (int k = 0; k < POINTS; k++) w->of(w, w->found[k], w->x[k]);
    }
    for (int k = 0; w->batch != NULL && k < POINTS; k++)
        for (int e = 0; e < ENTRIES; e++) w->found[k][e] = w->lanes_out[e * POINTS + k];
    return JLT_OK;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The largest error of an entry, relative to the largest true entry of its column; INFINITY if an entry is not finite. */
static double error_at(const double *found, const double *truth)
{
    double worst = 0;

    for (int j = 0; j < N; j++) {
        double off = 0, size = 0;
        for (int i = 0; i < N; i++) {
            const double d = fabs(found[i * N + j] - truth[i * N + j]);
            if (!(d <= off)) off = isfinite(d) ? d : INFINITY;
            size = fmax(size, fabs(truth[i * N + j]));
        }
        worst = fmax(worst, off / size);
    }
    return worst;
}

static void write_row(FILE *table, const way *w, const char *points, const jlt_bench_time *time)
{
    const double unit = 1e9 / (POINTS * ROUNDS);
    double errors[POINTS];

    for (int k = 0; k < POINTS; k++) errors[k] = error_at(w->found[k], w->truth[k]);
    qsort(errors, POINTS, sizeof *errors, ascending);
    fprintf(table, "jellett,%s,%s,%.0e,%.3e,%.3e,%.3e,%.4g,%.4g,%.4g\n", w->name, points, w->step, errors[POINTS / 2], errors[0],
            errors[POINTS - 1], unit * time->median, unit * time->least, unit * time->largest);
}

static jlt_status measure(FILE *table, const jlt_bench_options *options, way *w, const char *points)
{
    jlt_bench_time time;
    const jlt_status st = jlt_bench_clock(&time, options->repeats, 1, pass, w);

    if (st == JLT_OK) write_row(table, w, points, &time);
    return st;
}

static jlt_status all_ways(FILE *table, const jlt_bench_options *options, way *w, const char *points)
{
    static const struct {
        const char *name;
        void (*of)(const way *, double *, const double *);
        int last; /* exponent of ten of the smallest step; 0: the method has no step */
    } scalar[] = {
        { "generated", generated, 0 }, { "complex step", complex_step, 0 }, { "central", central, -10 }, { "forward", forward, -12 }
    };
    jlt_status st = JLT_OK;

    w->batch = NULL;
    for (size_t i = 0; i < sizeof scalar / sizeof *scalar; i++)
        for (int power = scalar[i].last == 0 ? 0 : -2; power >= scalar[i].last; power--) {
            w->name = scalar[i].name;
            w->of = scalar[i].of;
            w->step = power == 0 ? 0 : pow(10, power);
            JLT_TRY(measure(table, options, w, points));
        }
    for (int isa = 0; isa < JLT_ISA_COUNT; isa++) {
        char name[64];
        w->batch = w->instance->descriptor->batches[isa];
        if (!jlt_batch_isa_runs(w->batch)) continue;
        snprintf(name, sizeof name, "generated %sx%u", w->batch->isa, w->batch->lanes);
        w->name = name;
        w->step = 0;
        w->spread = jlt_batch_isa_spread(w->batch, w->instance->prepared);
        st = w->spread != NULL ? measure(table, options, w, points) : JLT_ERR_NOMEM;
        free(w->spread);
        if (st != JLT_OK) goto done;
    }
done:
    return st;
}

static jlt_exit run(FILE *table, const jlt_bench_options *options)
{
    static const double params[] = { 1.3, 0.7, 9.81, -0.12, 0.29, 0.21 }; /* m, R, g, a3, I1, I3 */
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top", NULL, NULL, NULL);
    jlt_instance *instance = NULL;
    jlt_oracle *oracle = NULL;
    jlt_random random;
    way *w = aligned_alloc(64, (sizeof *w + 63) / 64 * 64);
    jlt_status st = JLT_ERR_NOMEM;

    if (w == NULL) goto done;
    *w = (way){ .found = calloc(POINTS, sizeof *w->found), .lanes_out = aligned_alloc(64, sizeof(double[ENTRIES * POINTS])) };
    if (w->found == NULL || w->lanes_out == NULL) goto done;
    JLT_TRY(jlt_instance_create(&instance, d, params));
    JLT_TRY(jlt_oracle_create(&oracle, d, NULL));
    w->instance = instance;
    jlt_random_seed(&random, 1);
    for (int near_pole = 0; near_pole < 2; near_pole++) {
        draw(w, &random, near_pole);
        JLT_TRY(find_truth(w, oracle));
        JLT_TRY(all_ways(table, options, w, near_pole ? "near_pole" : "generic"));
    }
done:
    if (w != NULL) {
        free(w->found);
        free(w->lanes_out);
    }
    free(w);
    jlt_oracle_destroy(oracle);
    jlt_instance_destroy(instance);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_command_fail(jlt_command_exit(st), "Jacobians: %s", jlt_status_text(st));
}

const jlt_bench_kind jlt_bench_jacobian = {
    "jacobian",
    "Jacobian of (3.2) at 256 random points, generic and near a pole,\n    against ball arithmetic; error relative to the largest "
    "entry of the\n    column, inf where a difference leaves the domain",
    "program,method,points,step,error,error_least,error_largest,ns_per_jacobian,ns_least,ns_largest", "kqo", run,
};
