/** Parts of proofs about images in another table, which provers of sections and of reductions, embeddings and lifts share. */
#ifndef TTC_PROVE_IMAGE_H
#define TTC_PROVE_IMAGE_H

#include "prove/image.h"
#include "prove/prove_task.h"

/* out -= the value of an expression. */
void ttc_prove_take_off(ttc_task *task, ttc_ratio *out, ttc_valuation *valuation, ttc_id id);

/** The other table seen from the task's model: states and parameters as the image gives them. That every angle has a value
 *  is then a condition; a root must have one, which is positive. Not settled where no point is known that meets the
 *  conditions. */
void ttc_prove_bind_image(ttc_task *task, ttc_valuation *map, const ttc_claim *claim, const ttc_image *image);

/** In the other table, with the model seen through `map`: the image of the point that `map` stands for is the point itself,
 *  in the state number `state`. where_angles: only where an angle has a value, which is then a condition. */
void ttc_prove_return(ttc_task *task, ttc_valuation *map, const ttc_claim *claim, const ttc_image *image, size_t state,
                      bool where_angles);

#endif
