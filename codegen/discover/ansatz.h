/** Monomials in the quantities of a flow up to a degree, in sectors that its symmetries keep apart. */
#ifndef TTC_ANSATZ_H
#define TTC_ANSATZ_H

#include "discover/symmetry.h"

/* Monomials of one weight that change signs alike. exponents: shape (count, quantities). */
typedef struct {
    unsigned char *exponents;
    size_t count;
} ttc_ansatz_sector;

typedef struct {
    ttc_ansatz_sector *sectors;
    size_t sector_count;
    size_t total; /* monomials of all sectors */
    size_t largest;
} ttc_ansatz;

/** Count the monomials up to a degree, and those of the largest sector, without making them; as doubles, for they may be huge.
 *  Arguments as below. */
void ttc_ansatz_measure(double *total, double *largest, const ttc_flow *flow, int degree, const ttc_sign_changes *changes,
                        size_t change_count, const ttc_grading *grading);

/** Make all monomials of degree <= degree, 0 <= degree <= 255, with roots to the first power at most.
 *  Sectors differ in signs under the first `change_count` changes, and in weight, unless grading is NULL or has none. They come in
 *  the order of weights and signs, monomials of a sector by rising degree. */
void ttc_ansatz_create(ttc_ansatz *out, const ttc_flow *flow, int degree, const ttc_sign_changes *changes, size_t change_count,
                       const ttc_grading *grading);
void ttc_ansatz_clear(ttc_ansatz *ansatz);

#endif
