#include "discover/ansatz.h"

#include <stdlib.h>
#include <string.h>

/* A monomial, with the weight and signs that determine its sector. */
typedef struct {
    long weight;
    uint32_t signs;
    int degree;
    size_t index; /* of its exponents */
} entry;

typedef struct {
    const ttc_flow *flow;
    const ttc_sign_changes *changes;
    size_t change_count;
    const ttc_grading *grading;
    unsigned char *exponents; /* shape (capacity, quantities) */
    entry *entries;
    size_t count, capacity;
} list;

static long weight_of(const ttc_grading *grading, size_t quantity)
{
    return grading == NULL || grading->weights == NULL ? 0 : grading->weights[quantity];
}

static uint32_t signs_of(const ttc_sign_changes *changes, size_t change_count, size_t quantity)
{
    uint32_t signs = 0;
    for (size_t k = 0; k < change_count; k++) signs |= (uint32_t)(changes->changes[k] >> quantity & 1) << k;
    return signs;
}

/* counts, shape (degree + 1, weights, signs): numbers of monomials in the quantities so far. */
void ttc_ansatz_measure(double *total, double *largest, const ttc_flow *flow, int degree, const ttc_sign_changes *changes,
                        size_t change_count, const ttc_grading *grading)
{
    long most = 0;
    for (size_t i = 0; i < flow->count; i++)
        if (weight_of(grading, i) > most) most = weight_of(grading, i);
    const size_t weights = (size_t)(most * degree) + 1, kinds = (size_t)1 << change_count, plane = weights * kinds;
    double *counts = flint_calloc(((size_t)degree + 1) * plane, sizeof *counts), *sector = flint_calloc(plane, sizeof *sector);
    counts[0] = 1;
    for (size_t i = 0; i < flow->count; i++) {
        const int step = flow->degrees[i];
        const size_t weight = (size_t)weight_of(grading, i);
        const uint32_t signs = signs_of(changes, change_count, i);
        for (int at = 0; at + step <= degree; at++) { /* from the highest degree down a root is used once */
            const int from = flow->is_root[i] ? degree - step - at : at;
            const double *below = counts + (size_t)from * plane;
            double *above = counts + (size_t)(from + step) * plane;
            for (size_t w = 0; w + weight < weights; w++)
                for (size_t k = 0; k < kinds; k++) above[(w + weight) * kinds + (k ^ signs)] += below[w * kinds + k];
        }
    }
    *total = *largest = 0;
    for (size_t b = 0; b < plane; b++) {
        for (int at = 0; at <= degree; at++) sector[b] += counts[(size_t)at * plane + b];
        *total += sector[b];
        if (sector[b] > *largest) *largest = sector[b];
    }
    flint_free(sector);
    flint_free(counts);
}

static void add(list *l, const unsigned char *exponents, int degree)
{
    const size_t width = l->flow->count;
    if (l->count == l->capacity) {
        l->capacity = 2 * l->capacity + 64;
        l->exponents = flint_realloc(l->exponents, l->capacity * (width + 1));
        l->entries = flint_realloc(l->entries, l->capacity * sizeof *l->entries);
    }
    entry *e = &l->entries[l->count];
    *e = (entry){ .degree = degree, .index = l->count };
    memcpy(l->exponents + l->count * width, exponents, width);
    for (size_t i = 0; i < width; i++) {
        e->weight += weight_of(l->grading, i) * exponents[i];
        if (exponents[i] % 2 == 1) e->signs ^= signs_of(l->changes, l->change_count, i);
    }
    l->count++;
}

static void extend(list *l, unsigned char *exponents, size_t at, int degree, int left)
{
    if (at == l->flow->count) {
        add(l, exponents, degree);
        return;
    }
    const int step = l->flow->degrees[at];
    for (int k = 0; k * step <= left && (k < 2 || !l->flow->is_root[at]); k++) {
        exponents[at] = (unsigned char)k;
        extend(l, exponents, at + 1, degree + k * step, left - k * step);
    }
    exponents[at] = 0;
}

static int by_sector(const void *left, const void *right)
{
    const entry *a = left, *b = right;
    if (a->weight != b->weight) return a->weight < b->weight ? -1 : 1;
    if (a->signs != b->signs) return a->signs < b->signs ? -1 : 1;
    if (a->degree != b->degree) return a->degree < b->degree ? -1 : 1;
    return a->index < b->index ? -1 : 1;
}

static bool same_sector(const entry *a, const entry *b) { return a->weight == b->weight && a->signs == b->signs; }

void ttc_ansatz_create(ttc_ansatz *out, const ttc_flow *flow, int degree, const ttc_sign_changes *changes, size_t change_count,
                       const ttc_grading *grading)
{
    list l = { .flow = flow, .changes = changes, .change_count = change_count, .grading = grading };
    unsigned char *exponents = flint_calloc(flow->count + 1, 1);
    extend(&l, exponents, 0, 0, degree);
    qsort(l.entries, l.count, sizeof *l.entries, by_sector);
    *out = (ttc_ansatz){ .total = l.count };
    for (size_t i = 0; i < l.count; i++) out->sector_count += i == 0 || !same_sector(&l.entries[i - 1], &l.entries[i]);
    out->sectors = flint_calloc(out->sector_count, sizeof *out->sectors);
    ttc_ansatz_sector *sector = out->sectors;
    for (size_t i = 0; i < l.count; sector++) {
        size_t end = i;
        while (end < l.count && same_sector(&l.entries[i], &l.entries[end])) end++;
        sector->count = end - i;
        sector->exponents = flint_calloc(sector->count, flow->count + 1);
        for (size_t k = 0; i < end; i++, k++)
            memcpy(sector->exponents + k * flow->count, l.exponents + l.entries[i].index * flow->count, flow->count);
        if (sector->count > out->largest) out->largest = sector->count;
    }
    flint_free(exponents);
    flint_free(l.entries);
    flint_free(l.exponents);
}

void ttc_ansatz_clear(ttc_ansatz *ansatz)
{
    for (size_t i = 0; i < ansatz->sector_count; i++) flint_free(ansatz->sectors[i].exponents);
    flint_free(ansatz->sectors);
    *ansatz = (ttc_ansatz){ .total = 0 };
}
