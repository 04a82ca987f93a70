#include "report/extent.h"

void jlt_extent_add(jlt_extent *self, double value)
{
    if (!isfinite(value)) return;
    self->low = fmin(self->low, value);
    self->high = fmax(self->high, value);
}

jlt_extent jlt_extent_wider(jlt_extent self)
{
    const double size = fmax(fabs(self.low), fabs(self.high)), length = self.high - self.low;
    /* tick labels do not have the digits that a shorter interval would need */
    const double more = length > 1e-9 * size ? length / 20 : size > 0 ? size / 10 : 1;

    return self.high >= self.low ? (jlt_extent){ self.low - more, self.high + more } : JLT_EXTENT_OPEN;
}
