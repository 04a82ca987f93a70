/** Lookup in a map from points of a model to those of another table, see ttc_image, and checks that it is complete. */
#ifndef TTC_IMAGE_H
#define TTC_IMAGE_H

#include "base/text.h"
#include "read/model.h"

/* Index, in image->names, of the table's i-th state, or of a name; image->count if it is not there. */
size_t ttc_image_state(const ttc_image *image, const ttc_model *table, size_t i);
size_t ttc_image_name(const ttc_image *image, const char *name);

/** The expression that gives the table's i-th parameter: an entry of the image, the integral whose level it is, or the model's
 *  parameter of this name. *is_root: the parameter is the positive root of the expression. TTC_NONE: nothing gives it. */
ttc_id ttc_image_param(const ttc_model *model, const ttc_claim *claim, const ttc_image *image, const ttc_model *table, size_t i,
                       bool *is_root);

/* The parameter of that name; UINT32_MAX if there is none. */
uint32_t ttc_param_of(const ttc_model *model, const char *name);

/* Find the cosine whose argument is this state. Returns false if there is none. */
bool ttc_angle_cosine(const ttc_model *table, uint32_t state, uint32_t *cosine);

/* Write reason, shape (size,), as printf does, and return false. */
TTC_PRINTF(3, 4) bool ttc_refuse(char *reason, size_t size, const char *format, ...);

/** Returns true if the image gives every state of the table, and the table has a record `angle`, and no interval, for those given
 *  as angles. Otherwise reason, shape (size,), says why not; file: the name of the table in it. */
bool ttc_image_has_states(const ttc_image *image, const ttc_model *table, const char *file, char *reason, size_t size);

#endif
