#include "analysis/transfer_spectrum.h"

#include "core/memory.h"
#include "core/random.h"
#include "ext/arpack.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double rounding = 1e-9; /* relative to the mass */
static const double alike = 1e-3;    /* relative to the eigenvalue */
static const double doubled = 1e-6;  /* a pair with |im| at most this part of |re| is a double real eigenvalue */

enum { SPACE = 24, RESTARTS = 300 };

typedef struct {
    const jlt_transfer *transfer;
    const volatile sig_atomic_t *interrupt;
} problem;

static int apply(void *context, double *out, const double *x)
{
    const problem *p = context;

    if (p->interrupt != NULL && *p->interrupt) return 1;
    jlt_transfer_push(p->transfer, out, x);
    return 0;
}

void jlt_transfer_spectrum_clear(jlt_transfer_spectrum *self)
{
    free(self->re);
    free(self->im);
    free(self->residual);
    free(self->spread);
    free(self->leading);
    free(self->second);
    *self = (jlt_transfer_spectrum){ .count = 0 };
}

/* Whether ARPACK's eigenvalue i is to be listed before k. */
static bool before(const double *re, const double *im, size_t i, size_t k)
{
    const double a = hypot(re[i], im[i]), b = hypot(re[k], im[k]);

    if (a != b) return a > b;
    if (re[i] != re[k]) return re[i] > re[k];
    return im[i] > im[k];
}

/* Sum of |v P - lambda v| over sum of |v|, with v = x + i y the vector of the eigenvalue of a pair with im > 0; y is NULL for a
 * real eigenvalue. work: shape (2, n). */
static double residual_of(const jlt_transfer *transfer, double re, double im, const double *x, const double *y, double *work)
{
    const size_t n = transfer->count;
    double *px = work, *py = work + n, sum = 0, size = 0;

    jlt_transfer_push(transfer, px, x);
    if (y != NULL) jlt_transfer_push(transfer, py, y);
    for (size_t i = 0; i < n; i++) {
        const double yi = y != NULL ? y[i] : 0, pyi = y != NULL ? py[i] : 0;
        sum += hypot(px[i] - re * x[i] + im * yi, pyi - re * yi - im * x[i]);
        size += hypot(x[i], yi);
    }
    return sum / size;
}

/* A copy, scaled to sum |v| = 1, with the sign that makes the larger part of the mass positive; *negative is the rest. */
static double *scaled(const double *v, size_t n, double *negative)
{
    double *copy = jlt_memory_array(n, sizeof *copy), plus = 0, minus = 0;

    if (copy == NULL) return NULL;
    for (size_t i = 0; i < n; i++) {
        if (v[i] > 0) plus += v[i];
        else minus -= v[i];
    }
    for (size_t i = 0; i < n; i++) copy[i] = v[i] / (plus >= minus ? plus + minus : -(plus + minus)) + 0.0; /* no -0 */
    *negative = fmin(plus, minus) / (plus + minus);
    return copy;
}

/* The stationary masses. The eigenvector v of a simple eigenvalue has one sign, except for rounding; that of a multiple one may
 * not, but then |v| is stationary as well, since |v| P >= |v P| in every box, with no more mass in all. */
static double *positive(const double *v, size_t n, double *negative)
{
    double *copy = scaled(v, n, negative);

    for (size_t i = 0; copy != NULL && i < n; i++) copy[i] = *negative > rounding ? fabs(copy[i]) : copy[i] > 0 ? copy[i] : 0;
    return copy;
}

/* The eigenvalues that ARPACK finds. */
typedef struct {
    double *re, *im, *vectors; /* vectors: NULL if not asked for */
    size_t found;
} answer;

static double nearest(const answer *of, double re, double im)
{
    double distance = INFINITY;

    for (size_t i = 0; i < of->found; i++) distance = fmin(distance, hypot(re - of->re[i], im - of->im[i]));
    return distance;
}

/* The number of eigenvalues, by descending magnitude, up to the first that the second computation does not confirm. */
static size_t count_told(const jlt_transfer_spectrum *s)
{
    size_t told = 0;

    while (told < s->count && s->spread[told] <= alike * hypot(s->re[told], s->im[told])) told++;
    return told;
}

/* Sort the first computation's eigenvalues, compare them with the second's, and select the eigenvectors to keep. */
static jlt_status arrange(jlt_transfer_spectrum *out, const jlt_transfer *transfer, const answer *one, const answer *other,
                          size_t wanted, double *work)
{
    const double *re = one->re, *im = one->im, *vectors = one->vectors;
    const size_t n = transfer->count, found = one->found;
    JLT_FREED size_t *order = jlt_memory_array(found, sizeof *order);
    size_t count = found, first, second;
    jlt_status st = order == NULL ? JLT_ERR_NOMEM : JLT_OK;

    for (size_t i = 0; st == JLT_OK && i < found; i++) {
        size_t at = i;
        for (; at > 0 && before(re, im, i, order[at - 1]); at--) order[at] = order[at - 1];
        order[at] = i;
    }
    /* ARPACK may find one more than wanted; it is kept if it completes a pair. */
    if (st == JLT_OK && found > wanted && im[order[wanted - 1]] <= 0) count = wanted;
    first = second = count;
    for (size_t i = 0; st == JLT_OK && i < count; i++) {
        const size_t k = order[i], head = im[k] < 0 ? k - 1 : k; /* the first eigenvalue of a pair has the vector's real part */
        out->re[i] = re[k];
        out->im[i] = fabs(im[k]) > doubled * fabs(re[k]) ? im[k] : 0;
        out->residual[i] = residual_of(transfer, re[k], fabs(im[k]), vectors + head * n,
                                       im[k] != 0 ? vectors + (head + 1) * n : NULL, work);
        out->spread[i] = nearest(other, re[k], im[k]);
    }
    out->count = st == JLT_OK ? count : 0;
    out->told = count_told(out);
    for (size_t i = 0; i < out->count; i++) {
        const size_t k = order[i];
        if (out->im[i] != 0) continue;
        if (first == count || re[k] > out->re[first]) {
            if (first < out->told && out->re[first] > 0) second = first;
            first = i;
        } else if (im[k] == 0 && re[k] > 0 && i < out->told && (second == count || re[k] > out->re[second])) second = i;
    }
    if (st == JLT_OK && first == count) st = JLT_ERR_NO_CONVERGENCE;
    if (st == JLT_OK) {
        out->leading_index = first;
        out->leading = positive(vectors + order[first] * n, n, &out->negative);
        if (second < count) out->second = scaled(vectors + order[second] * n, n, &(double){ 0 });
        out->second_index = second;
        if (out->leading == NULL || (second < count && out->second == NULL)) st = JLT_ERR_NOMEM;
    }
    return st;
}

static bool allocate(answer *out, size_t wanted, size_t n, bool with_vectors)
{
    *out = (answer){ .re = jlt_memory_array(wanted + 1, sizeof(double)), .im = jlt_memory_array(wanted + 1, sizeof(double)),
                     .vectors = with_vectors ? jlt_memory_array((wanted + 1) * n, sizeof(double)) : NULL };
    return out->re != NULL && out->im != NULL && (out->vectors != NULL || !with_vectors);
}

static void release(answer *self)
{
    free(self->re);
    free(self->im);
    free(self->vectors);
}

/* The start vector is near the uniform mass, but random: it lies in no subspace that a symmetry of the map leaves invariant. */
static jlt_status find(answer *out, problem *p, size_t wanted, double tolerance, uint64_t seed, double *start)
{
    const size_t n = p->transfer->count, space = 2 * wanted + SPACE < n ? 2 * wanted + SPACE : n;
    jlt_random random;

    jlt_random_seed(&random, seed);
    for (size_t i = 0; i < n; i++) start[i] = p->transfer->share[i] * jlt_random_between(&random, 0.5, 1.5);
    const jlt_status st = jlt_arpack_leading(out->re, out->im, &out->found, out->vectors, &(jlt_arpack_matrix){ n, apply, p },
                                             &(jlt_arpack_options){ .wanted = wanted, .space = space, .restarts = RESTARTS,
                                                                   .tolerance = tolerance, .start = start });
    return st == JLT_OK && out->found == 0 ? JLT_ERR_NO_CONVERGENCE : st;
}

static jlt_status compute(jlt_transfer_spectrum *out, const jlt_transfer *transfer, size_t wanted, double tolerance,
                          const volatile sig_atomic_t *interrupt)
{
    const size_t n = transfer->count;
    problem p = { transfer, interrupt };
    answer one = { .re = NULL }, other = { .re = NULL };
    JLT_FREED double *work = jlt_memory_array(2 * n, sizeof *work), *start = jlt_memory_array(n, sizeof *start);
    jlt_status st = JLT_ERR_NOMEM;

    *out = (jlt_transfer_spectrum){ .re = jlt_memory_array(wanted + 1, sizeof(double)),
                                    .im = jlt_memory_array(wanted + 1, sizeof(double)),
                                    .residual = jlt_memory_array(wanted + 1, sizeof(double)),
                                    .spread = jlt_memory_array(wanted + 1, sizeof(double)) };
    if (!allocate(&one, wanted, n, true) || !allocate(&other, wanted, n, false) || work == NULL || start == NULL ||
        out->re == NULL || out->im == NULL || out->residual == NULL || out->spread == NULL)
        goto done;
    JLT_TRY(find(&one, &p, wanted, tolerance, 1, start));
    JLT_TRY(find(&other, &p, wanted, tolerance, 2, start));
    st = arrange(out, transfer, &one, &other, wanted, work);
done:
    release(&one);
    release(&other);
    if (st != JLT_OK) jlt_transfer_spectrum_clear(out);
    return st;
}

/* Returns EMPTY if no box leads back to itself in any number of steps, so that all eigenvalues are 0: boxes that no box leads to
 * are removed until there are none (A. B. Kahn, Comm. ACM 5, 1962). */
static jlt_status check_recurrent(const jlt_transfer *transfer)
{
    const size_t n = transfer->count;
    JLT_FREED size_t *into = jlt_memory_array(n, sizeof *into), *free_of = jlt_memory_array(n, sizeof *free_of);
    size_t last = 0, next = 0;
    const bool is_out = into == NULL || free_of == NULL;

    for (size_t e = 0; !is_out && e < transfer->row[n]; e++) into[transfer->to[e]]++;
    for (size_t i = 0; !is_out && i < n; i++)
        if (into[i] == 0) free_of[last++] = i;
    for (; next < last; next++)
        for (size_t e = transfer->row[free_of[next]]; e < transfer->row[free_of[next] + 1]; e++)
            if (--into[transfer->to[e]] == 0) free_of[last++] = transfer->to[e];
    return is_out ? JLT_ERR_NOMEM : last == n ? JLT_ERR_EMPTY : JLT_OK;
}

jlt_status jlt_transfer_spectrum_compute(jlt_transfer_spectrum *out, const jlt_transfer *transfer, size_t wanted, double tolerance,
                                         const volatile sig_atomic_t *interrupt)
{
    jlt_status st;

    *out = (jlt_transfer_spectrum){ .count = 0 };
    if (transfer->count < 3 || wanted == 0) return JLT_ERR_ARG;
    if (wanted > transfer->count - 2) wanted = transfer->count - 2;
    if ((st = check_recurrent(transfer)) != JLT_OK) return st;
    st = compute(out, transfer, wanted, tolerance, interrupt);
    if (st == JLT_ERR_NO_CONVERGENCE && wanted > 1 && (interrupt == NULL || !*interrupt))
        st = compute(out, transfer, 1, tolerance, interrupt);
    return st;
}

size_t jlt_transfer_spectrum_multiplicity(const jlt_transfer_spectrum *self, double distance)
{
    size_t count = 0;

    for (size_t i = 0; i < self->count; i++)
        count += hypot(self->re[i] - self->re[self->leading_index], self->im[i]) <= distance;
    return count;
}

double jlt_transfer_spectrum_losses(double *lost, const jlt_transfer *transfer, const double *v)
{
    const unsigned losses = transfer->losses;
    double whole = 0, sum = 0;

    memset(lost, 0, losses * sizeof *lost);
    for (size_t i = 0; i < transfer->count; i++) {
        whole += v[i];
        for (unsigned k = 0; k < losses; k++) lost[k] += v[i] * transfer->lost[i * losses + k];
    }
    for (unsigned k = 0; k < losses; k++) sum += lost[k] /= whole;
    return sum;
}

double jlt_transfer_spectrum_time(const jlt_transfer *transfer, const double *v)
{
    double sum = 0, mass = 0;

    for (size_t i = 0; i < transfer->count; i++) {
        double back = 0;
        for (size_t e = transfer->row[i]; e < transfer->row[i + 1]; e++) back += transfer->weight[e];
        if (back > 0) sum += v[i] * back * transfer->time[i], mass += v[i] * back;
    }
    return sum / mass;
}

void jlt_transfer_spectrum_set(double *mass, double *kept, const jlt_transfer *transfer, const double *v, const double *second,
                               int sign)
{
    double whole = 0, stays = 0, in = 0;

    for (size_t i = 0; i < transfer->count; i++) {
        whole += v[i];
        if (second[i] * sign <= 0) continue;
        in += v[i];
        for (size_t e = transfer->row[i]; e < transfer->row[i + 1]; e++)
            if (second[transfer->to[e]] * sign > 0) stays += v[i] * transfer->weight[e];
    }
    *mass = in / whole;
    *kept = in > 0 ? stays / in : NAN;
}
