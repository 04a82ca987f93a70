/* Batched kernels against scalar ones, every lane under parameters of its own.
 *
 * The baseline lanes do the scalar kernel's operations in the scalar kernel's order, so they agree bit for bit when both
 * are compiled for the baseline, or for ARM. The wider instruction sets fuse multiply-adds, which rounds once where the scalar code
 * rounds twice: AVX2 and AVX-512 agree with each other bit for bit, and with the scalar kernels to the conditioning of the
 * sums in them. */
#include "unit/check.h"

#include <stdlib.h>

#include "base/random.h"
#include "kernel/batch_isa.h"
#include "registry.h"

enum {
    LANES_MAX = 8,
    ROW_MAX = JLT_BATCH_VECTORS * LANES_MAX,
    OUTPUTS_MAX = 512,
    INPUTS_MAX = 64,
    PREPARED_MAX = 512,
    ROUNDS = 20
};

typedef struct {
    const jlt_kernel *scalar;
    jlt_kernel_lanes lanes[JLT_ISA_COUNT];
} pair;

static double uniform(uint64_t *state)
{
    return (double)(ttc_random_bits(state) >> 11) * 0x1p-53;
}

static unsigned pairs_of(const jlt_descriptor *d, pair *pairs)
{
#define LANES(isa, member) (d->batches[isa] != NULL ? d->batches[isa]->member : NULL)
#define PAIR(member)                                                                                                   \
    (pair)                                                                                                             \
    {                                                                                                                  \
        &d->member, { LANES(0, member), LANES(1, member), LANES(2, member) }                                           \
    }
    const pair all[] = { PAIR(rhs), PAIR(jacobian), PAIR(rhs_jacobian), PAIR(divergence), PAIR(integral_values),
                         PAIR(integral_gradients), PAIR(measure_values), PAIR(measure_divergences), PAIR(time_factor),
                         PAIR(eliminated) };
    memcpy(pairs, all, sizeof all);
    return sizeof all / sizeof *all;
}

static double inside(const jlt_quantity *q, uint64_t *state)
{
    double low = isfinite(q->low) ? q->low : -2, high = isfinite(q->high) ? q->high : 2;
    return low + (high - low) * (0.01 + 0.98 * uniform(state));
}

/* What rounding errors of the outputs are relative to: the outputs themselves; div(rho f) vanishes, and its terms are of the
 * size of rho times the Jacobian. */
static double size_of(const jlt_descriptor *d, const pair *k, const double *x, const double *p, const double *outputs)
{
    double size = 0, rho[OUTPUTS_MAX], jacobian[OUTPUTS_MAX];

    for (unsigned i = 0; i < k->scalar->outputs; i++) size = fmax(size, fabs(outputs[i]));
    if (k->scalar != &d->measure_divergences) return size;
    d->measure_values.call(x, p, rho);
    d->jacobian.call(x, p, jacobian);
    for (unsigned i = 0; i < d->measure_count; i++)
        for (unsigned j = 0; j < d->jacobian.outputs; j++) size = fmax(size, fabs(rho[i] * jacobian[j]));
    return size;
}

/* Bit for bit; of NaN, whose sign no standard determines, only that both are. */
static void assert_same(double a, double b)
{
    if (isnan(a) && isnan(b)) return;
    assert_memory_equal(&a, &b, sizeof a);
}

/* A prepared values of parameters in 0.2 ... 1.2 that the variant serves; the caller frees it. */
static double *make_block(const jlt_descriptor *d, uint64_t *state)
{
    double params[INPUTS_MAX], *p = malloc((d->prepared_count + 1) * sizeof *p);

    assert_non_null(p);
    assert_true(d->param_count <= INPUTS_MAX);
    for (unsigned i = 0; i < d->param_count; i++) params[i] = 0.2 + uniform(state);
    if (d->impose != NULL) {
        double imposed[INPUTS_MAX];
        d->impose(NULL, params, imposed);
        memcpy(params, imposed, d->param_count * sizeof *params);
    }
    d->prepare(params, p);
    return p;
}

/* Prepared values of so many lanes: one's by one's, and as kernels take them. */
typedef struct {
    double *of[ROW_MAX];
    _Alignas(64) double spread[PREPARED_MAX * ROW_MAX];
} blocks;

static void make_blocks(blocks *p, const jlt_descriptor *d, uint64_t *state)
{
    assert_true(d->prepared_count <= PREPARED_MAX);
    for (unsigned lane = 0; lane < ROW_MAX; lane++) p->of[lane] = make_block(d, state);
}

static void free_blocks(blocks *p)
{
    for (unsigned lane = 0; lane < ROW_MAX; lane++) free(p->of[lane]);
}

/* Vectors one behind the other. Returns those of the vector that begins at lane `at`, the length of a vector times a whole
 * number. */
static const double *spread(blocks *p, const jlt_kernel_batch *kernels, unsigned at)
{
    for (unsigned lane = 0; lane < ROW_MAX; lane++)
        for (unsigned i = 0; i < kernels->prepared; i++)
            p->spread[(lane / kernels->lanes * kernels->prepared + i) * kernels->lanes + lane % kernels->lanes] = p->of[lane][i];
    return p->spread + (size_t)kernels->prepared * at;
}

static void check_kernel(const jlt_descriptor *d, const pair *k, uint64_t *state)
{
    static double x[INPUTS_MAX * LANES_MAX] __attribute__((aligned(64)));
    static double out[JLT_ISA_COUNT][OUTPUTS_MAX * LANES_MAX] __attribute__((aligned(64)));
    static blocks p;
    double one[INPUTS_MAX], expected[OUTPUTS_MAX];

    make_blocks(&p, d, state);
    assert_true(k->scalar->outputs <= OUTPUTS_MAX && d->state_count <= INPUTS_MAX);
    for (unsigned i = 0; i < d->state_count; i++)
        for (unsigned lane = 0; lane < LANES_MAX; lane++) x[i * LANES_MAX + lane] = inside(&d->states[i], state);
    for (unsigned isa = 0; isa < JLT_ISA_COUNT; isa++) {
        if (!jlt_batch_isa_runs(d->batches[isa])) continue;
        assert_true((k->scalar->call == NULL) == (k->lanes[isa] == NULL));
        for (unsigned lane = 0; k->lanes[isa] != NULL && lane < LANES_MAX; lane += d->batches[isa]->lanes)
            k->lanes[isa](x + lane, spread(&p, d->batches[isa], lane), out[isa] + lane, LANES_MAX);
    }
    for (unsigned lane = 0; k->scalar->call != NULL && lane < LANES_MAX; lane++) {
        for (unsigned i = 0; i < d->state_count; i++) one[i] = x[i * LANES_MAX + lane];
        k->scalar->call(one, p.of[lane], expected);
        const double size = size_of(d, k, one, p.of[lane], expected);
        for (unsigned i = 0; i < k->scalar->outputs; i++) {
            unsigned at = i * LANES_MAX + lane;
#if !defined(FP_FAST_FMA) || defined(__aarch64__)
            assert_same(out[0][at], expected[i]);
#endif
            if (jlt_batch_isa_runs(d->batches[1]) && jlt_batch_isa_runs(d->batches[2]))
                assert_same(out[1][at], out[2][at]);
            /* At most a few hundred roundings, each amplified by at most 1e4: denominators and radicands are above
             * 1e-2 at these points, and enter squared. Beyond the domain (a negative radicand) both are not finite. */
            if (jlt_batch_isa_runs(d->batches[1]) && !isfinite(expected[i])) assert_true(!isfinite(out[1][at]));
            else if (jlt_batch_isa_runs(d->batches[1]))
                assert_true(fabs(out[1][at] - expected[i]) <= 300 * 1e4 * 0x1p-53 * size);
        }
    }
    free_blocks(&p);
}

static void lanes_agree_with_scalar_kernels(void **unused)
{
    uint64_t state = 20231;

    (void)unused;
    for (unsigned i = 0; i < jlt_registry_count; i++) {
        pair pairs[16];
        unsigned count = pairs_of(jlt_registry[i], pairs);
        for (unsigned k = 0; k < count; k++)
            for (int round = 0; round < ROUNDS; round++) check_kernel(jlt_registry[i], &pairs[k], &state);
    }
}

/* Every slope is the field, bit for bit, at the argument of its stage; and that is x + h times the weighted sum, each lane with
 * its own h: count + 1 roundings of terms of the size of the largest. */
static void stages_are_fields_of_weighted_sums(void **unused)
{
    static _Alignas(64) double x[INPUTS_MAX * 16], z[INPUTS_MAX * 16], k[4 * INPUTS_MAX * 16], f[INPUTS_MAX * 16], h[16];
    static const jlt_stage_sum sums[] = { { 1, { 0 }, { 0.25 } },
                                          { 2, { 0, 1 }, { -0.5, 1.25 } },
                                          { 2, { 1, 2 }, { 0.75, 0.125 } } };
    static blocks p;
    uint64_t state = 20232;

    (void)unused;
    for (unsigned index = 0; index < jlt_registry_count; index++) {
        const jlt_descriptor *d = jlt_registry[index];
        make_blocks(&p, d, &state);
        for (int isa = 0; isa < JLT_ISA_COUNT; isa++) {
            const jlt_kernel_batch *kernels = d->batches[isa];
            if (!jlt_batch_isa_runs(kernels)) continue;
            const unsigned n = d->state_count, row = JLT_BATCH_VECTORS * kernels->lanes;
            for (unsigned i = 0; i < n * row; i++) x[i] = inside(&d->states[i / row], &state);
            for (unsigned j = 0; j < row; j++) h[j] = 1e-3 * (j + 1);
            for (unsigned at = 0; at < row; at += kernels->lanes) kernels->rhs(x + at, spread(&p, kernels, at), k + at, row);
            for (unsigned count = 1; count <= 3; count++) {
                const jlt_stage_sum *sum = &sums[count - 1];
                kernels->stages(x, k, sums, count, h, spread(&p, kernels, 0), z);
                for (unsigned at = 0; at < row; at += kernels->lanes) kernels->rhs(z + at, spread(&p, kernels, at), f + at, row);
                for (unsigned i = 0; i < n * row; i++) {
                    double total = x[i], size = fabs(x[i]);
                    for (unsigned l = 0; l < sum->count; l++) {
                        const double term = h[i % row] * sum->weight[l] * k[sum->slope[l] * n * row + i];
                        total += term;
                        size = fmax(size, fabs(term));
                    }
                    if (!isfinite(total)) continue; /* beyond the domain, as a negative radicand */
                    assert_true(fabs(z[i] - total) <= 8 * 0x1p-53 * size);
                    assert_same(k[count * n * row + i], f[i]);
                }
            }
        }
        free_blocks(&p);
    }
}

/* With the clock the states go the same way bit for bit, and t is a sum of dt/dtau at the stages: 4 roundings. */
static void the_clock_is_carried_beside_the_same_stages(void **unused)
{
    enum { ROW = 16, COUNT = 3 };
    static _Alignas(64) double x[(INPUTS_MAX + 1) * ROW], z[(INPUTS_MAX + 1) * ROW], k[(COUNT + 1) * (INPUTS_MAX + 1) * ROW],
        plain_z[INPUTS_MAX * ROW], plain_k[(COUNT + 1) * INPUTS_MAX * ROW], rate[ROW], h[ROW];
    static const jlt_stage_sum sums[COUNT] = { { 1, { 0 }, { 0.25 } },
                                               { 2, { 0, 1 }, { -0.5, 1.25 } },
                                               { 3, { 0, 1, 2 }, { 0.75, 0.5, 0.125 } } };
    static blocks p;
    uint64_t state = 20233;

    (void)unused;
    for (unsigned index = 0; index < jlt_registry_count; index++) {
        const jlt_descriptor *d = jlt_registry[index];
        make_blocks(&p, d, &state);
        for (int isa = 0; isa < JLT_ISA_COUNT; isa++) {
            const jlt_kernel_batch *kernels = d->batches[isa];
            if (!jlt_batch_isa_runs(kernels)) continue;
            const unsigned n = d->state_count, row = JLT_BATCH_VECTORS * kernels->lanes, slopes = (n + 1) * row;
            for (unsigned j = 0; j < row; j++) {
                for (unsigned i = 0; i < n; i++) x[i * row + j] = inside(&d->states[i], &state);
                x[n * row + j] = 10 * uniform(&state);
                h[j] = 1e-3 * (j + 1);
                k[n * row + j] = 0.5;
            }
            for (unsigned at = 0; at < row; at += kernels->lanes) kernels->rhs(x + at, spread(&p, kernels, at), k + at, row);
            memcpy(plain_k, k, n * row * sizeof *k);
            kernels->stages(x, plain_k, sums, COUNT, h, spread(&p, kernels, 0), plain_z);
            kernels->stages_clock(x, k, sums, COUNT, h, spread(&p, kernels, 0), z);
            for (unsigned i = 0; i < n * row; i++) {
                assert_same(z[i], plain_z[i]);
                for (unsigned s = 1; s <= COUNT; s++) assert_same(k[s * slopes + i], plain_k[s * n * row + i]);
            }
            for (unsigned j = 0; j < row; j++) rate[j] = 1;
            for (unsigned at = 0; d->time_factor.call != NULL && at < row; at += kernels->lanes)
                kernels->time_factor(z + at, spread(&p, kernels, at), rate + at, row);
            for (unsigned j = 0; j < row; j++) {
                const double *clock = k + n * row + j, last = clock[COUNT * slopes];
                const double t = x[n * row + j] + h[j] * (0.75 * clock[0] + 0.5 * clock[slopes] + 0.125 * clock[2 * slopes]);
                assert_same(last, rate[j]);
                if (isfinite(t)) assert_true(fabs(z[n * row + j] - t) <= 4 * 0x1p-53 * fmax(fabs(t), x[n * row + j]));
            }
        }
        free_blocks(&p);
    }
}

/* Columns of stages_varied after its last stage: sums, each of whose terms goes through five roundings at most, there and here;
 * slopes of states from the same program as rhs_jacobian, bit for bit; of tangent vectors the Jacobian times them, a rounding a
 * term and one for its product; of the integrals the trace and dt/dtau. */
static void check_varied(const jlt_kernel_batch *kernels, const jlt_descriptor *d, blocks *p, unsigned tangents, uint64_t *state)
{
    enum { ROW = 16, COUNT = 3, COLUMNS_MAX = 4 * 32 + 2 };
    static _Alignas(64) double x[COLUMNS_MAX * ROW], z[COLUMNS_MAX * ROW], k[(COUNT + 1) * COLUMNS_MAX * ROW], h[ROW], rate[ROW],
        linear[OUTPUTS_MAX * ROW];
    static const jlt_stage_sum sums[COUNT] = { { 1, { 0 }, { 0.25 } },
                                               { 2, { 0, 1 }, { -0.5, 1.25 } },
                                               { 3, { 0, 1, 2 }, { 0.75, 0.5, 0.125 } } };
    const unsigned n = d->state_count, columns = n * (1 + tangents) + 2, row = JLT_BATCH_VECTORS * kernels->lanes;

    assert_true(columns <= COLUMNS_MAX && n * (n + 1) <= OUTPUTS_MAX);
    for (unsigned j = 0; j < row; j++) {
        for (unsigned i = 0; i < columns; i++) {
            x[i * row + j] = i < n ? inside(&d->states[i], state) : 2 * uniform(state) - 1;
            k[i * row + j] = 2 * uniform(state) - 1;
        }
        h[j] = 1e-3 * (j + 1);
        rate[j] = 1;
    }
    kernels->stages_varied(x, k, sums, COUNT, h, spread(p, kernels, 0), z, tangents);
    for (unsigned i = 0; i < columns * row; i++) {
        double total = x[i], size = fabs(x[i]);
        for (unsigned l = 0; l < COUNT; l++) {
            const double term = h[i % row] * sums[COUNT - 1].weight[l] * k[l * columns * row + i];
            total += term;
            size += fabs(term);
        }
        if (isfinite(total)) assert_true(fabs(z[i] - total) <= 2 * 5 * 0x1p-53 * size);
    }
    for (unsigned at = 0; at < row; at += kernels->lanes) kernels->rhs_jacobian(z + at, spread(p, kernels, at), linear + at, row);
    for (unsigned at = 0; d->time_factor.call != NULL && at < row; at += kernels->lanes)
        kernels->time_factor(z + at, spread(p, kernels, at), rate + at, row);
    for (unsigned j = 0; j < row; j++) {
        const double *slope = k + (size_t)COUNT * columns * row + j, *jacobian = linear + n * row + j;
        double trace = 0, size = 0;
        for (unsigned i = 0; i < n; i++) {
            assert_same(slope[i * row], linear[i * row + j]);
            trace += jacobian[(i * n + i) * row];
            size = fmax(size, fabs(jacobian[(i * n + i) * row]));
        }
        if (isfinite(trace)) assert_true(fabs(slope[(columns - 2) * row] - trace) <= 2 * n * n * 0x1p-53 * size);
        assert_same(slope[(columns - 1) * row], rate[j]);
        for (unsigned i = n; i < columns - 2; i++) {
            const double *vector = z + (i - i % n) * row + j;
            double sum = 0;
            size = 0;
            for (unsigned l = 0; l < n; l++) {
                const double term = jacobian[(i % n * n + l) * row] * vector[l * row];
                sum += term;
                size = fmax(size, fabs(term));
            }
            if (isfinite(sum)) assert_true(fabs(slope[i * row] - sum) <= 2 * n * n * 0x1p-53 * size);
        }
    }
}

static void variational_equations_are_the_jacobian_times_their_vectors(void **unused)
{
    static blocks p;
    uint64_t state = 20234;

    (void)unused;
    for (unsigned index = 0; index < jlt_registry_count; index++) {
        const jlt_descriptor *d = jlt_registry[index];
        make_blocks(&p, d, &state);
        for (int isa = 0; isa < JLT_ISA_COUNT; isa++)
            for (unsigned tangents = 0; jlt_batch_isa_runs(d->batches[isa]) && tangents <= 3; tangents++)
                check_varied(d->batches[isa], d, &p, tangents, &state);
        free_blocks(&p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lanes_agree_with_scalar_kernels),
        cmocka_unit_test(stages_are_fields_of_weighted_sums),
        cmocka_unit_test(the_clock_is_carried_beside_the_same_stages),
        cmocka_unit_test(variational_equations_are_the_jacobian_times_their_vectors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
