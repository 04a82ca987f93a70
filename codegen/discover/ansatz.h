/** Monomials in the quantities of a flow up to a degree, in sectors that its symmetries keep apart. */
#ifndef TTC_ANSATZ_H
#define TTC_ANSATZ_H

#include "discover/symmetry.h"

/* exponents: shape (count, quantities). Monomials of a sector change signs alike, and have one weight. */
typedef struct {
    unsigned char *exponents;
    size_t count;
} ttc_ansatz_sector;

typedef struct {
    ttc_ansatz_sector *sectors;
    size_t sector_count;
    size_t width; /* quantities */
    size_t total; /* monomials of all sectors */
    size_t largest;
} ttc_ansatz;

/** The number of monomials up to a degree, and that of the largest sector, without making any: as floating-point numbers, for they
 *  may be beyond others. Arguments as below. */
void ttc_ansatz_measure(double *total, double *largest, const ttc_flow *flow, int degree, const ttc_sign_changes *changes,
                        size_t change_count, const ttc_grading *grading);

/** All monomials of degree <= degree, 0 <= degree <= 255; of roots in the first power at most.
 *  changes: the first `change_count` tell sectors apart. grading: so does the weight; NULL, or one without weights: it does not.
 *  Sectors come in the order of their weights and signs, monomials of a sector by rising degree. */
void ttc_ansatz_create(ttc_ansatz *out, const ttc_flow *flow, int degree, const ttc_sign_changes *changes, size_t change_count,
                       const ttc_grading *grading);
void ttc_ansatz_clear(ttc_ansatz *ansatz);

#endif
