/** A long time as a sum of two numbers: the time at which a clock was set to 0, and its rounding error. Without that error a
 *  million returns of one period might all round in one direction, and add up. */
#ifndef JLT_INTEGRATE_EPOCH_H
#define JLT_INTEGRATE_EPOCH_H

typedef struct {
    double time, low; /* their sum is the better value */
} jlt_epoch;

/** The time at which the clock shows this. */
static inline double jlt_epoch_time(const jlt_epoch *self, double clock)
{
    return self->time + (self->low + clock);
}

/** Make the clock's time the epoch, and the clock 0. */
static inline void jlt_epoch_move(jlt_epoch *self, double *clock)
{
    const double before = self->time, move = self->low + *clock;

    self->time = before + move;
    self->low = (before - self->time) + move;
    *clock = 0;
}

#endif
