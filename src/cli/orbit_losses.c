#include "cli/orbit_losses.h"

#include <math.h>
#include <stdio.h>

#include "cli/section_table.h"
#include "dynamics/section_loss.h"

/* Multipliers nearer to the unit circle than this are on it, for types of orbits and bifurcations. */
static const double blurred = 1e-7;

static void watch_defect(jlt_orbit_losses *self, double defect, double value)
{
    if (!(defect > fmax(self->defect, blurred))) return;
    if (self->defect == 0) self->blurred_at = value;
    self->defect = defect;
}

void jlt_orbit_losses_add(jlt_orbit_losses *self, const jlt_flow *flow, const jlt_periodic *orbit, double value)
{
    jlt_return at;

    self->orbits++;
    /* A DP that contracts by all its digits is 0, whatever it is of its own size. */
    watch_defect(self, fmin(fabs(orbit->defect), fabs(orbit->determinant_slope - orbit->determinant)), value);
    if (jlt_section_loss(&at, flow, orbit->points, orbit->period, 1) != JLT_OK) return;
    if (isnan(at.least)) self->unknown++;
    if (!(at.least <= 0)) return;
    if (self->all++ == 0) self->first = value;
    self->lost[at.lost]++;
}

static void tell_conditions(const jlt_orbit_losses *self, const jlt_observed *observed, const char *where)
{
    char text[512], first[48] = "";

    if (self->unknown > 0)
        fprintf(stderr,
                "jellett: %sof %zu of %zu orbits it is not known whether the model holds: a condition of it has no value there\n",
                where, self->unknown, self->orbits);
    if (self->all == 0) return;
    jlt_section_table_lost(text, sizeof text, self->lost, self->all, observed);
    if (isfinite(self->first)) snprintf(first, sizeof first, ", first at %.10g,", self->first);
    fprintf(stderr, "jellett: %son %zu of %zu orbits%s %s is lost, and the model does not hold there\n", where, self->all,
            self->orbits, first, text);
}

static void tell_defect(const jlt_orbit_losses *self, const char *where)
{
    char first[48] = "";

    if (self->defect == 0) return;
    if (isfinite(self->blurred_at)) snprintf(first, sizeof first, "from %.10g on ", self->blurred_at);
    fprintf(stderr, "jellett: %s%sdet DP differs from what flux and divergence make it by up to %.2g of its terms: multipliers are "
            "known no better there: a stiff motion, or a pass close to a singularity, where T is known no better either\n",
            where, first, self->defect);
}

void jlt_orbit_losses_tell(const jlt_orbit_losses *self, const jlt_observed *observed, const char *where)
{
    tell_conditions(self, observed, where);
    tell_defect(self, where);
}
