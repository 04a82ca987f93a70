/* Allocates and frees the arrays of a batch's images. */
#include "dynamics/map_batch.h"

#include <stdlib.h>

jlt_status jlt_map_batch_images(jlt_map_images *out, unsigned d, size_t count)
{
    double *block = malloc(count * ((size_t)d * (d + 1) + 4) * sizeof *block);

    *out = (jlt_map_images){ .status = malloc(count * sizeof *out->status), .q = block };
    if (block == NULL || out->status == NULL) {
        jlt_map_batch_images_clear(out);
        return JLT_ERR_NOMEM;
    }
    out->slope = block + count * d;
    out->T = out->slope + count * d * d;
    out->determinant = out->T + count;
    out->expansion = out->determinant + count;
    out->defect = out->expansion + count;
    return JLT_OK;
}

void jlt_map_batch_images_clear(jlt_map_images *self)
{
    free(self->q);
    free(self->status);
    *self = (jlt_map_images){ 0 };
}
