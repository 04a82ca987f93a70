/** Finds changes of sign that keep the motion, and weights under which it is homogeneous, from exponents of its exact ratios. They
 *  sort monomials of an ansatz into sectors that are solved separately. */
#ifndef TTC_SYMMETRY_H
#define TTC_SYMMETRY_H

#include "discover/flow.h"

enum { TTC_SIGN_CHANGES_MAX = 16 };

/* Each change of signs is a set of quantities, bit i for quantity i, and maps the motion to itself, the last one possibly
 * backwards in time. They are independent, and all others are products of them if there are fewer than TTC_SIGN_CHANGES_MAX. None
 * are found for more than 62 quantities. */
typedef struct {
    uint64_t changes[TTC_SIGN_CHANGES_MAX];
    size_t count;
    bool last_is_backwards;
} ttc_sign_changes;

void ttc_sign_changes_find(ttc_sign_changes *out, const ttc_flow *flow);

/* Whether each change of signs maps a ratio to itself or its negative. */
bool ttc_sign_changes_keep(const ttc_sign_changes *changes, const ttc_flow *flow, const ttc_ratio *a);

/** Weights w >= 0 of the quantities, not all zero, and of at most one parameter, w > 0, under which each rate x' has the weight of
 *  x plus a constant, and each radicand, free of that parameter, twice that of its root. The leading part of the motion, where
 *  that parameter is 0, is homogeneous in the quantities; all else has smaller weight. */
typedef struct {
    long *weights;  /* by quantity; NULL: there is no grading */
    slong parameter; /* its variable, or -1 */
} ttc_grading;

void ttc_grading_find(ttc_grading *out, const ttc_flow *flow);
void ttc_grading_clear(ttc_grading *grading);

#endif
