#include "cli/orbit_losses.h"

#include <math.h>
#include <stdio.h>

#include "cli/section_table.h"
#include "dynamics/section_loss.h"

void jlt_orbit_losses_add(jlt_orbit_losses *self, const jlt_flow *flow, const jlt_periodic *orbit, double value)
{
    jlt_return at;

    self->orbits++;
    if (jlt_section_loss(&at, flow, orbit->points, orbit->period, 1) != JLT_OK || !(at.least <= 0)) return;
    if (self->all++ == 0) self->first = value;
    self->lost[at.lost]++;
}

void jlt_orbit_losses_tell(const jlt_orbit_losses *self, const jlt_observed *observed, const char *where)
{
    char text[512], first[48] = "";

    if (self->all == 0) return;
    jlt_section_table_lost(text, sizeof text, self->lost, self->all, observed);
    if (isfinite(self->first)) snprintf(first, sizeof first, ", first at %.10g,", self->first);
    fprintf(stderr, "jellett: %son %zu of %zu orbits%s %s is lost, and the model does not hold there\n", where, self->all,
            self->orbits, first, text);
}
