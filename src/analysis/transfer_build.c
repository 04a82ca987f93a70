/* Builds the matrix of a transfer operator: maps stratified points of boxes, and adds boxes that images reach. */
#include "analysis/transfer.h"

#include "core/memory.h"
#include "core/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* For images in boxes that are not kept: at most ARRIVALS_MAX are stored per round, and boxes are added for them ROUNDS times. */
enum { BLOCK = 4096, ROUNDS = 16, ARRIVALS_MAX = 1 << 20 };

typedef struct {
    uint32_t box;
    uint32_t number; /* order of arrival */
    double q[JLT_BOXES_DIM_MAX];
} arrival;

/* Rows for one noise. Columns `to` are numbers of boxes until all rows are complete, and indices among kept boxes afterwards. */
typedef struct {
    size_t *row, entries, room;
    uint32_t *to;
    double *weight, *lost;
} rows;

typedef struct {
    const jlt_boxes *boxes;
    const jlt_transfer_map *map;
    const jlt_transfer_options *options;
    size_t all, samples;          /* number of boxes, and of stratified points per box */
    size_t count, stratified, room; /* kept boxes; those of them with stratified points; allocated */
    uint32_t *box, *kept;
    double *share, *time, *known;
    rows *noise;                  /* (options->noise_count,) */
    arrival *arrivals, *come;     /* images that the added boxes get as points, box by box, beginning at `first`; images in boxes
                                   * not kept yet */
    size_t *first, arrival_count, come_count, come_room, groups;
    double *q, *image, *image_time; /* for one block of points */
    unsigned *loss;
    size_t *points;               /* number of points of each box of a block */
    uint32_t *targets;            /* (samples,): boxes of the images of one box */
    size_t done, mapped;
} builder;

static int by_box(const void *a, const void *b)
{
    const arrival *x = a, *y = b;

    if (x->box != y->box) return x->box < y->box ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

static int ascending(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

static bool grow(void *array, size_t count, size_t size)
{
    void **at = array, *bigger = count > SIZE_MAX / size ? NULL : realloc(*at, count * size);

    if (bigger != NULL) *at = bigger;
    return bigger != NULL;
}

/* Allocate space for `count` kept boxes. */
static jlt_status reserve(builder *b, size_t count)
{
    if (count <= b->room) return JLT_OK;
    if (!grow(&b->box, count, sizeof *b->box) || !grow(&b->share, count, sizeof *b->share) ||
        !grow(&b->time, count, sizeof *b->time) ||
        !grow(&b->known, count, sizeof *b->known))
        return JLT_ERR_NOMEM;
    for (size_t k = 0; k < b->options->noise_count; k++)
        if (!grow(&b->noise[k].row, count + 1, sizeof *b->noise[k].row) ||
            !grow(&b->noise[k].lost, count * b->map->losses, sizeof *b->noise[k].lost))
            return JLT_ERR_NOMEM;
    for (size_t k = 0; k < b->options->noise_count; k++) b->noise[k].row[0] = 0;
    b->room = count;
    return JLT_OK;
}

/* Keep the boxes that have a stratified point in the space. */
static jlt_status keep_boxes(builder *b)
{
    jlt_status st = JLT_OK;

    for (size_t box = 0; st == JLT_OK && box < b->all; box++) {
        bool holds = false;
        jlt_boxes_sample(b->boxes, b->q, box, b->options->strata, b->options->seed);
        for (size_t i = 0; !holds && i < b->samples; i++) holds = b->map->holds(b->map->context, b->q + i * b->boxes->dim);
        if (!holds) continue;
        if (b->count == b->room) st = reserve(b, b->room == 0 ? 1024 : b->room + b->room / 2);
        if (st != JLT_OK) break;
        b->kept[box] = (uint32_t)b->count;
        b->box[b->count++] = (uint32_t)box;
        if (b->map->interrupt != NULL && *b->map->interrupt) st = JLT_ERR_NO_CONVERGENCE;
    }
    b->stratified = b->count;
    return st == JLT_OK && b->count == 0 ? JLT_ERR_EMPTY : st;
}

/* Write the points of a kept box to q; returns their number. */
static size_t fill(const builder *b, double *q, size_t place)
{
    const unsigned dim = b->boxes->dim;

    if (place < b->stratified) {
        jlt_boxes_sample(b->boxes, q, b->box[place], b->options->strata, b->options->seed);
        return b->samples;
    }
    const size_t group = place - (b->count - b->groups), first = b->first[group];
    const size_t count = b->first[group + 1] - first < b->samples ? b->first[group + 1] - first : b->samples;
    for (size_t i = 0; i < count; i++) memcpy(q + i * dim, b->arrivals[first + i].q, dim * sizeof *q);
    return count;
}

/* Store an image in a box that is not kept. */
static jlt_status remember(builder *b, size_t box, const double *q)
{
    if (b->come_count == ARRIVALS_MAX) return JLT_OK;
    if (b->come_count == b->come_room) {
        const size_t room = b->come_room == 0 ? 64 : 2 * b->come_room;
        if (!grow(&b->come, room, sizeof *b->come)) return JLT_ERR_NOMEM;
        b->come_room = room;
    }
    arrival *at = &b->come[b->come_count];
    *at = (arrival){ .box = (uint32_t)box, .number = (uint32_t)b->come_count };
    memcpy(at->q, q, b->boxes->dim * sizeof *q);
    b->come_count++;
    return JLT_OK;
}

/* Shift q at random, unless that would leave the space. */
static void disturb(const builder *b, double *q, double noise, jlt_random *random)
{
    double moved[JLT_BOXES_DIM_MAX];

    for (unsigned k = 0; k < b->boxes->dim; k++)
        moved[k] = q[k] + noise * (b->boxes->high[k] - b->boxes->low[k]) * jlt_random_between(random, -1, 1);
    if (b->map->holds(b->map->context, moved)) memcpy(q, moved, b->boxes->dim * sizeof *q);
}

/* Append a row: `count` images, whose boxes are in b->targets. */
static jlt_status add_row(builder *b, rows *r, size_t place, size_t count)
{
    if (r->entries + count > r->room) {
        const size_t room = r->room + r->room / 2 + b->samples + 1024;
        if (!grow(&r->to, room, sizeof *r->to) || !grow(&r->weight, room, sizeof *r->weight)) return JLT_ERR_NOMEM;
        r->room = room;
    }
    qsort(b->targets, count, sizeof *b->targets, ascending);
    for (size_t i = 0; i < count;) {
        size_t same = i;
        while (same < count && b->targets[same] == b->targets[i]) same++;
        r->to[r->entries] = b->targets[i];
        r->weight[r->entries++] = (double)(same - i);
        i = same;
    }
    r->row[place + 1] = r->entries;
    return JLT_OK;
}

/* Append the row of a box for one noise, from its points first .. first + points - 1 of the block. */
static jlt_status take_noise(builder *b, size_t index, size_t place, size_t first, size_t points)
{
    const double noise = b->options->noise[index];
    const unsigned dim = b->boxes->dim, losses = b->map->losses;
    rows *r = &b->noise[index];
    double *lost = r->lost + place * losses, q[JLT_BOXES_DIM_MAX];
    size_t count = 0, box;
    jlt_random random;
    jlt_status st = JLT_OK;

    jlt_random_seed(&random, (b->options->seed + 1) * 0xd1342543de82ef95u + b->box[place]);
    memset(lost, 0, losses * sizeof *lost);
    for (size_t i = first; st == JLT_OK && i < first + points; i++) {
        if (b->loss[i] >= losses) continue;
        if (b->loss[i] > 0) {
            lost[b->loss[i]]++;
            continue;
        }
        memcpy(q, b->image + i * dim, dim * sizeof *q);
        if (noise > 0) disturb(b, q, noise, &random);
        if (!jlt_boxes_find(b->boxes, &box, q)) {
            lost[0]++;
            continue;
        }
        b->targets[count++] = (uint32_t)box;
        if (b->kept[box] == JLT_TRANSFER_NONE) st = remember(b, box, q);
    }
    return st == JLT_OK ? add_row(b, r, place, count) : st;
}

/* Record share, time, density and rows of a box from its mapped points. */
static jlt_status take_box(builder *b, size_t place, size_t first, size_t points)
{
    const unsigned dim = b->boxes->dim, losses = b->map->losses;
    size_t whole = 0, back = 0;
    double time = 0, known = 0;
    jlt_status st = JLT_OK;

    for (size_t i = first; i < first + points; i++) {
        if (b->loss[i] >= losses) continue;
        whole++;
        if (b->loss[i] == 0) time += b->image_time[i], back++;
        if (b->map->density != NULL) known += b->map->density(b->map->context, b->q + i * dim);
    }
    b->mapped += whole;
    b->share[place] = place < b->stratified ? (double)whole / (double)b->samples : 0.5 / (double)b->samples;
    b->time[place] = back > 0 ? time / (double)back : NAN;
    b->known[place] = whole > 0 ? known / (double)whole * b->share[place] : 0;
    for (size_t k = 0; st == JLT_OK && k < b->options->noise_count; k++) st = take_noise(b, k, place, first, points);
    return st;
}

/* Map the points of kept boxes from .. to - 1, in blocks of whole boxes. */
static jlt_status map_boxes(builder *b, size_t from, size_t to)
{
    const unsigned dim = b->boxes->dim;
    const size_t block = b->options->block > 0 ? b->options->block : BLOCK;
    jlt_status st = JLT_OK;

    while (st == JLT_OK && from < to) {
        size_t points = 0, count = 0, at = 0;
        for (; from + count < to && points < block; count++) {
            b->points[count] = fill(b, b->q + points * dim, from + count);
            points += b->points[count];
        }
        st = b->map->images(b->map->context, b->image, b->loss, b->image_time, b->q, points);
        if (st == JLT_OK && b->map->interrupt != NULL && *b->map->interrupt) st = JLT_ERR_NO_CONVERGENCE;
        for (size_t i = 0; st == JLT_OK && i < count; at += b->points[i++]) st = take_box(b, from + i, at, b->points[i]);
        from += count;
        b->done += points;
        if (b->options->progress != NULL) b->options->progress(b->options->progress_context, b->done, b->count * b->samples);
    }
    return st;
}

/* Keep the boxes that images have reached without being kept. */
static jlt_status add_boxes(builder *b)
{
    free(b->arrivals);
    b->arrivals = b->come;
    b->arrival_count = b->come_count;
    b->come = NULL;
    b->come_room = b->come_count = 0;
    qsort(b->arrivals, b->arrival_count, sizeof *b->arrivals, by_box);
    if (!grow(&b->first, b->arrival_count + 1, sizeof *b->first)) return JLT_ERR_NOMEM;
    b->groups = 0;
    for (size_t i = 0; i < b->arrival_count; i++)
        if (i == 0 || b->arrivals[i].box != b->arrivals[i - 1].box) b->first[b->groups++] = i;
    b->first[b->groups] = b->arrival_count;
    JLT_PASS(reserve(b, b->count + b->groups));
    for (size_t g = 0; g < b->groups; g++) {
        const uint32_t box = b->arrivals[b->first[g]].box;
        b->kept[box] = (uint32_t)b->count;
        b->box[b->count++] = box;
    }
    return JLT_OK;
}

/* Convert a row from numbers of boxes to indices among kept ones, in ascending order. Images in boxes that are not kept in the end
 * are counted as lost. Counts of points become shares only here, so that all of them is 1 exactly. A box without points is lost. */
static void settle_row(rows *r, const builder *b, size_t place, size_t *end)
{
    const size_t from = r->row[place], to = r->row[place + 1], begin = *end;
    const unsigned losses = b->map->losses;
    double *lost = r->lost + place * losses, whole = 0;

    for (size_t e = from; e < to; e++) {
        const uint32_t kept = b->kept[r->to[e]];
        const double weight = r->weight[e];
        size_t at = *end;
        if (kept == JLT_TRANSFER_NONE) {
            lost[0] += weight;
            continue;
        }
        for (; at > begin && r->to[at - 1] > kept; at--) r->to[at] = r->to[at - 1], r->weight[at] = r->weight[at - 1];
        r->to[at] = kept;
        r->weight[at] = weight;
        whole += weight;
        ++*end;
    }
    for (unsigned k = 0; k < losses; k++) whole += lost[k];
    if (whole == 0) whole = lost[0] = 1;
    for (unsigned k = 0; k < losses; k++) lost[k] /= whole;
    for (size_t e = begin; e < *end; e++) r->weight[e] /= whole;
}

static void *copy_of(const void *from, size_t count, size_t size)
{
    void *copy = jlt_memory_array(count, size);

    if (copy != NULL) memcpy(copy, from, count * size);
    return copy;
}

static jlt_status finish(jlt_transfer **out, builder *b, rows *r)
{
    jlt_transfer *self = calloc(1, sizeof *self);
    double sum = 0;
    size_t end = 0, from = 0;

    if (self == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < b->count; i++) {
        settle_row(r, b, i, &end);
        r->row[i] = from; /* its old value has been read */
        from = end;
        sum += b->known[i];
    }
    r->row[b->count] = end;
    *self = (jlt_transfer){ .boxes = *b->boxes, .count = b->count, .row = r->row, .to = r->to, .weight = r->weight, .lost = r->lost,
                            .losses = b->map->losses };
    self->box = copy_of(b->box, b->count, sizeof *b->box);
    self->kept = copy_of(b->kept, b->all, sizeof *b->kept);
    self->share = copy_of(b->share, b->count, sizeof *b->share);
    self->time = copy_of(b->time, b->count, sizeof *b->time);
    *r = (rows){ 0 }; /* ownership moved to self */
    if (b->map->density != NULL) self->known = copy_of(b->known, b->count, sizeof *b->known);
    for (size_t i = 0; self->known != NULL && i < b->count; i++) self->known[i] /= sum;
    if (self->box == NULL || self->kept == NULL || self->share == NULL || self->time == NULL ||
        (b->map->density != NULL && self->known == NULL)) {
        jlt_transfer_destroy(self);
        return JLT_ERR_NOMEM;
    }
    *out = self;
    return JLT_OK;
}

static jlt_status allocate(builder *b)
{
    const size_t block = b->options->block > 0 ? b->options->block : BLOCK, dim = b->boxes->dim, most = SIZE_MAX / dim;

    if (b->samples > most || block > most - b->samples) return JLT_ERR_NOMEM;
    const size_t points = block + b->samples;
    b->kept = jlt_memory_array(b->all, sizeof *b->kept);
    b->noise = calloc(b->options->noise_count, sizeof *b->noise);
    b->q = jlt_memory_array(points * dim, sizeof *b->q);
    b->image = jlt_memory_array(points * dim, sizeof *b->image);
    b->image_time = jlt_memory_array(points, sizeof *b->image_time);
    b->loss = jlt_memory_array(points, sizeof *b->loss);
    b->points = jlt_memory_array(points, sizeof *b->points);
    b->targets = jlt_memory_array(b->samples, sizeof *b->targets);
    if (b->kept == NULL || b->noise == NULL || b->q == NULL || b->image == NULL || b->image_time == NULL || b->loss == NULL ||
        b->points == NULL || b->targets == NULL)
        return JLT_ERR_NOMEM;
    memset(b->kept, 0xff, b->all * sizeof *b->kept);
    return JLT_OK;
}

static void clear(builder *b)
{
    for (size_t k = 0; b->noise != NULL && k < b->options->noise_count; k++) {
        free(b->noise[k].row);
        free(b->noise[k].to);
        free(b->noise[k].weight);
        free(b->noise[k].lost);
    }
    void *const owned[] = { b->noise, b->box, b->kept, b->share, b->time, b->known, b->arrivals, b->come, b->first,
                            b->q, b->image, b->image_time, b->loss, b->points, b->targets };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
}

jlt_status jlt_transfer_build(jlt_transfer **out, size_t *points, const jlt_boxes *boxes, const jlt_transfer_map *map,
                              const jlt_transfer_options *options)
{
    builder b = { .boxes = boxes, .map = map, .options = options };
    jlt_status st;

    for (size_t k = 0; k < options->noise_count; k++) out[k] = NULL;
    if (options->strata == 0 || options->noise_count == 0 || map->losses == 0) return JLT_ERR_ARG;
    for (size_t k = 0; k < options->noise_count; k++)
        if (!(options->noise[k] >= 0) || options->noise[k] > 1) return JLT_ERR_ARG;
    JLT_TRY(jlt_boxes_count(&b.all, boxes));
    b.samples = jlt_boxes_samples(boxes, options->strata);
    JLT_TRY(allocate(&b));
    JLT_TRY(keep_boxes(&b));
    JLT_TRY(map_boxes(&b, 0, b.count));
    for (int round = 0; round < ROUNDS && b.come_count > 0; round++) {
        const size_t before = b.count;
        JLT_TRY(add_boxes(&b));
        JLT_TRY(map_boxes(&b, before, b.count));
    }
    for (size_t k = 0; k < options->noise_count; k++) JLT_TRY(finish(&out[k], &b, &b.noise[k]));
    *points = b.mapped;
done:
    clear(&b);
    for (size_t k = 0; st != JLT_OK && k < options->noise_count; k++) {
        jlt_transfer_destroy(out[k]);
        out[k] = NULL;
    }
    return st;
}
