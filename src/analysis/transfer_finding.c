#include "analysis/transfer_finding.h"

#include "core/memory.h"

#include <math.h>
#include <stdlib.h>

static const double eigenvalue_tolerance = 1e-12, same_eigenvalue = 1e-8;

enum { NEIGHBOURS = 6561 }; /* 3^JLT_BOXES_DIM_MAX */

void jlt_transfer_finding_clear(jlt_transfer_finding *self) { jlt_transfer_spectrum_clear(&self->spectrum); }

/* Compute all that follows from the eigenvectors. */
static void tell(jlt_transfer_finding *out, const jlt_transfer *transfer, const jlt_chart *chart, double *work)
{
    const jlt_transfer_spectrum *s = &out->spectrum;
    const double lambda = s->re[s->leading_index], lost = jlt_transfer_spectrum_losses(out->lost, transfer, s->leading);

    out->multiplicity = jlt_transfer_spectrum_multiplicity(s, same_eigenvalue);
    out->escape = lost > 0 && lambda < 1 ? -log(lambda) : 0;
    out->balance = fabs(1 - lambda - lost);
    out->time = jlt_transfer_spectrum_time(transfer, s->leading);
    if (jlt_transfer_section_mirror(work, transfer, s->leading, chart))
        out->asymmetry = jlt_transfer_distance(s->leading, work, transfer->count);
    for (int k = 0; s->second != NULL && k < 2; k++)
        jlt_transfer_spectrum_set(&out->set_mass[k], &out->set_kept[k], transfer, s->leading, s->second, k == 0 ? 1 : -1);
    if (transfer->known != NULL && out->multiplicity == 1 && s->count > 1)
        out->distance = jlt_transfer_distance(s->leading, transfer->known, transfer->count);
}

jlt_status jlt_transfer_finding_make(jlt_transfer_finding *out, const jlt_transfer *transfer, const jlt_chart *chart, size_t wanted,
                                     const volatile sig_atomic_t *interrupt)
{
    JLT_FREED double *work = jlt_memory_array(transfer->count, sizeof *work);

    *out = (jlt_transfer_finding){ .escape = NAN, .balance = NAN, .time = NAN, .asymmetry = NAN, .defect = NAN, .distance = NAN,
                                   .set_mass = { NAN, NAN }, .set_kept = { NAN, NAN } };
    if (work == NULL) return JLT_ERR_NOMEM;
    if (transfer->known != NULL) {
        jlt_transfer_push(transfer, work, transfer->known);
        out->defect = jlt_transfer_distance(work, transfer->known, transfer->count);
    }
    if (wanted == 0) return JLT_OK;
    JLT_PASS(jlt_transfer_spectrum_compute(&out->spectrum, transfer, wanted, eigenvalue_tolerance, interrupt));
    tell(out, transfer, chart, work);
    return JLT_OK;
}

double jlt_transfer_finding_density(const jlt_transfer *transfer, const double *v, size_t place)
{
    return v[place] / (transfer->share[place] * jlt_boxes_volume(&transfer->boxes));
}

jlt_status jlt_transfer_finding_peaks(size_t *places, size_t *count, size_t room, const jlt_transfer *transfer, const double *v)
{
    JLT_FREED size_t *neighbours = jlt_memory_array(NEIGHBOURS, sizeof *neighbours);
    double mass = 0, shares = 0;
    size_t found = 0;

    if (neighbours == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < transfer->count; i++) mass += v[i], shares += transfer->share[i];
    const double mean = mass / (shares * jlt_boxes_volume(&transfer->boxes));
    for (size_t i = 0; i < transfer->count; i++) {
        const double density = jlt_transfer_finding_density(transfer, v, i);
        const size_t all = jlt_boxes_neighbours(&transfer->boxes, neighbours, transfer->box[i]);
        bool is_peak = density > mean;
        for (size_t k = 0; is_peak && k < all; k++) {
            const uint32_t other = transfer->kept[neighbours[k]];
            is_peak = other == JLT_TRANSFER_NONE || jlt_transfer_finding_density(transfer, v, other) < density;
        }
        if (!is_peak) continue;
        size_t at = found < room ? found++ : room;
        for (; at > 0 && jlt_transfer_finding_density(transfer, v, places[at - 1]) < density; at--)
            if (at < room) places[at] = places[at - 1];
        if (at < room) places[at] = i;
    }
    *count = found;
    return JLT_OK;
}
