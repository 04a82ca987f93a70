#include "dynamics/settling.h"

#include <math.h>

static const size_t few_steps = 1024;
static const double patience = 4;

bool jlt_settling_step(jlt_settling *self, double distance, double time)
{
    if (!(distance <= 1)) {
        *self = (jlt_settling){ 0 };
        return false;
    }
    if (self->steps++ == 0) self->since = time;
    self->farthest = fmax(self->farthest, distance);
    if ((self->steps & (self->steps - 1)) == 0) {
        self->grows = self->farthest > self->earlier;
        self->earlier = self->farthest;
        self->farthest = 0;
    }
    return self->steps > few_steps && !self->grows && time - self->since > patience * self->since;
}
