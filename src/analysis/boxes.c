#include "analysis/boxes.h"

#include "core/random.h"

#include <math.h>

static const double slack = 1e-6; /* of a box's width */

static bool is_whole(const jlt_boxes *b, unsigned k)
{
    return b->period[k] != 0 && b->high[k] - b->low[k] > b->period[k] * (1 - 1e-12);
}

jlt_status jlt_boxes_count(size_t *all, const jlt_boxes *b)
{
    size_t count = 1;

    if (b->dim == 0 || b->dim > JLT_BOXES_DIM_MAX) return JLT_ERR_ARG;
    for (unsigned k = 0; k < b->dim; k++) {
        const double width = b->high[k] - b->low[k];
        if (!(width > 0) || !isfinite(width) || b->count[k] == 0 || b->count[k] > JLT_BOXES_MAX / count) return JLT_ERR_ARG;
        if (b->period[k] != 0 && !(width <= b->period[k] * (1 + 1e-12) && isfinite(b->period[k]))) return JLT_ERR_ARG;
        count *= b->count[k];
    }
    *all = count;
    return JLT_OK;
}

/* Find the box along coordinate k. */
static bool place(size_t *at, const jlt_boxes *b, unsigned k, double value)
{
    const double width = (b->high[k] - b->low[k]) / (double)b->count[k];
    double boxes = (value - b->low[k]) / width;

    if (b->period[k] != 0) {
        const double turn = b->period[k] / width;
        boxes -= turn * floor(boxes / turn);
        if (boxes > turn - slack && !is_whole(b, k)) boxes -= turn;
    }
    if (!(boxes >= -slack && boxes <= (double)b->count[k] + slack)) return false;
    *at = boxes <= 0 ? 0 : (size_t)boxes;
    if (*at >= b->count[k]) *at = b->count[k] - 1;
    return true;
}

bool jlt_boxes_find(const jlt_boxes *b, size_t *index, const double *q)
{
    size_t number = 0, stride = 1, at;

    for (unsigned k = 0; k < b->dim; k++) {
        if (!place(&at, b, k, q[k])) return false;
        number += at * stride;
        stride *= b->count[k];
    }
    *index = number;
    return true;
}

void jlt_boxes_centre(const jlt_boxes *b, double *q, size_t index)
{
    for (unsigned k = 0; k < b->dim; k++) {
        q[k] = b->low[k] + (b->high[k] - b->low[k]) * ((double)(index % b->count[k]) + 0.5) / (double)b->count[k];
        index /= b->count[k];
    }
}

double jlt_boxes_volume(const jlt_boxes *b)
{
    double volume = 1;

    for (unsigned k = 0; k < b->dim; k++) volume *= (b->high[k] - b->low[k]) / (double)b->count[k];
    return volume;
}

size_t jlt_boxes_samples(const jlt_boxes *b, size_t strata)
{
    size_t count = 1;

    for (unsigned k = 0; k < b->dim; k++) count = strata == 0 ? 0 : count > SIZE_MAX / strata ? SIZE_MAX : count * strata;
    return count;
}

void jlt_boxes_sample(const jlt_boxes *b, double *q, size_t index, size_t strata, uint64_t seed)
{
    const size_t samples = jlt_boxes_samples(b, strata);
    jlt_random random;

    jlt_random_seed(&random, seed * 0x9e3779b97f4a7c15u + index);
    for (size_t i = 0; i < samples; i++) {
        size_t cell = i, box = index;
        for (unsigned k = 0; k < b->dim; k++) {
            const double part = ((double)(cell % strata) + jlt_random_unit(&random)) / (double)strata;
            q[i * b->dim + k] = b->low[k] + (b->high[k] - b->low[k]) * ((double)(box % b->count[k]) + part) / (double)b->count[k];
            cell /= strata;
            box /= b->count[k];
        }
    }
}

jlt_status jlt_boxes_coarser(jlt_boxes *out, const jlt_boxes *fine, size_t factor)
{
    jlt_boxes coarse = *fine;

    if (factor == 0) return JLT_ERR_ARG;
    for (unsigned k = 0; k < fine->dim; k++) {
        if (fine->count[k] == 1) continue;
        if (fine->count[k] % factor != 0) return JLT_ERR_ARG;
        coarse.count[k] = fine->count[k] / factor;
    }
    *out = coarse;
    return JLT_OK;
}

size_t jlt_boxes_parent(const jlt_boxes *fine, const jlt_boxes *coarse, size_t index)
{
    size_t number = 0, stride = 1;

    for (unsigned k = 0; k < fine->dim; k++) {
        number += index % fine->count[k] / (fine->count[k] / coarse->count[k]) * stride;
        stride *= coarse->count[k];
        index /= fine->count[k];
    }
    return number;
}

/* Find the box that is `step` (-1, 0, 1) further along coordinate k. Returns false if there is none. */
static bool step_to(size_t *number, const jlt_boxes *b, unsigned k, size_t at, int step)
{
    const size_t count = b->count[k];

    if ((step < 0 && at == 0) || (step > 0 && at + 1 == count)) {
        if (!is_whole(b, k) || count < 3) return false;
        *number = at == 0 ? count - 1 : 0;
    } else *number = step < 0 ? at - 1 : at + (size_t)step;
    return true;
}

size_t jlt_boxes_neighbours(const jlt_boxes *b, size_t *neighbours, size_t index)
{
    const size_t all = jlt_boxes_samples(b, 3);
    size_t found = 0;

    for (size_t i = 0; i < all; i++) {
        size_t step = i, box = index, number = 0, stride = 1, at;
        bool is_there = true;
        for (unsigned k = 0; is_there && k < b->dim; k++) {
            is_there = step_to(&at, b, k, box % b->count[k], (int)(step % 3) - 1);
            if (is_there) number += at * stride;
            stride *= b->count[k];
            step /= 3;
            box /= b->count[k];
        }
        if (is_there && number != index) neighbours[found++] = number;
    }
    return found;
}
