/** Is there a real point that meets conditions? Found, or shown not to be, or neither. */
#ifndef TTC_SEARCH_H
#define TTC_SEARCH_H

#include "algebra/witness.h"

typedef enum {
    TTC_POINT_FOUND,       /* and checked, exactly or in balls */
    TTC_POINT_IMPOSSIBLE,  /* by the signs of terms */
    TTC_POINT_EXCLUDED,    /* by the word of the solver for nonlinear real arithmetic */
    TTC_POINT_NOT_DECIDED
} ttc_search_result;

/** Small rational numbers are tried first, then the solver is asked, within a fixed amount of work, so that the answer is the
 *  same on every machine. point: initialized for the valuation of the conditions; meaningful when FOUND.
 *  Cosines and sines are to the solver any two numbers with c^2 + s^2 = 1: it may fail to exclude a point, and never excludes
 *  one that is there. */
ttc_search_result ttc_search_point(ttc_witness *point, const ttc_conditions *conditions);

#endif
