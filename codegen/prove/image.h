/** Where points of a model lie in another table, see ttc_image: what gives each of that table's names, in this model's. */
#ifndef TTC_IMAGE_H
#define TTC_IMAGE_H

#include "read/model.h"

/* Index, among the entries of the image, of the table's i-th state, or of one of its names; image->count where it is not given. */
size_t ttc_image_state(const ttc_image *image, const ttc_model *table, size_t i);
size_t ttc_image_name(const ttc_image *image, const char *name);

/** What gives the table's i-th parameter: an entry, the integral that it is a level of, or the parameter of its name here;
 *  *is_root: as the positive root of that. TTC_NONE: nothing does. */
ttc_id ttc_image_param(const ttc_model *model, const ttc_claim *claim, const ttc_image *image, const ttc_model *table, size_t i,
                       bool *is_root);

/* The parameter of that name; UINT32_MAX where there is none. */
uint32_t ttc_param_of(const ttc_model *model, const char *name);

/* The cosine whose argument is a state alone; false: there is none. */
bool ttc_angle_cosine(const ttc_model *table, uint32_t state, uint32_t *cosine);

/** Whether every state of the table is given, and angles can be: the table has a record for them, and no interval. False:
 *  reason, shape (size,), says why not; file: what the table is called there. */
bool ttc_image_has_states(const ttc_image *image, const ttc_model *table, const char *file, char *reason, size_t size);

#endif
