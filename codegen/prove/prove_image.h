/** Steps of proofs about images in another table, which the provers of sections and of ways share. */
#ifndef TTC_PROVE_IMAGE_H
#define TTC_PROVE_IMAGE_H

#include "prove/image.h"
#include "prove/prove_task.h"

/** Take a spare symbol that no solution of a level has. In/out: spares, how many were taken or passed over, at first 0. Returns
 *  false if none is left. */
bool ttc_prove_take_spare(uint32_t *spare, const ttc_task *task, uint32_t *spares);

/** Bind the states and parameters of the other table, in `map`, to what the image gives for them in the task's model. Adds the
 *  condition that angles have values; requires that radicands are positive. Not settled if no point is known that meets these. */
void ttc_prove_bind_image(ttc_task *task, ttc_valuation *map, const ttc_claim *claim, const ttc_image *image);

/** In a task of the other table, with the model evaluated in `map`: require that the image of the model's point has in state number
 *  `state` the task's own value. where_angles: that an angle has a value is added as a condition, not required. */
void ttc_prove_return(ttc_task *task, ttc_valuation *map, const ttc_claim *claim, const ttc_image *image, size_t state,
                      bool where_angles);

/* Require that no divisor of a claim is zero, nor one of the first `use_count` definitions that it names, whether or not they
 * cancel from it. where: added to messages. */
void ttc_prove_divisors(ttc_task *task, ttc_valuation *valuation, uint32_t claim, size_t use_count, const char *where);

#endif
