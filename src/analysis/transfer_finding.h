/** Computes the quantities that one transfer operator of a section determines, for comparison between operators. */
#ifndef JLT_ANALYSIS_TRANSFER_FINDING_H
#define JLT_ANALYSIS_TRANSFER_FINDING_H

#include "analysis/transfer_section.h"
#include "analysis/transfer_spectrum.h"

/** Plain data; clear with jlt_transfer_finding_clear. NaN marks what does not exist or was not computed. The stationary density is
 *  the leading eigenvector (quasi-stationary if mass is lost). Distances are in total variation, 0 to 1. */
typedef struct {
    jlt_transfer_spectrum spectrum; /* empty if no eigenvalues were asked for */
    size_t multiplicity; /* number of eigenvalues within 1e-8 of the leading one; the density is unique if it is 1 */
    double escape;       /* -ln of the leading eigenvalue: the escape rate per return; 0 if no mass is lost */
    double lost[JLT_TRANSFER_SECTION_LOSSES]; /* by kind: the share of the stationary density that is lost at each return */
    double balance;      /* |1 - leading eigenvalue - sum of lost|, due to rounding and the error of the eigenvector */
    double time;         /* mean time of a return */
    double asymmetry;    /* distance between the stationary density and its mirror image, which is stationary under the inverse
                          * map: 0 if they are the same, 1 if attractor and repeller are disjoint */
    double set_mass[2], set_kept[2]; /* of the sets where the second eigenvector is positive, and negative: share of the stationary
                                      * mass, and the part of it that is in the set after a return too */
    double defect;       /* distance between the density that the table claims and its image: 0 if it is invariant, except for
                          * errors due to boxes and random points */
    double distance;     /* distance between the claimed and the stationary density; NaN unless the latter is known to be unique */
} jlt_transfer_finding;

/** Compute the finding, with `wanted` eigenvalues, or 0 for none. In: chart, the section's. Errors: as
 *  jlt_transfer_spectrum_compute. */
JLT_CHECKED jlt_status jlt_transfer_finding_make(jlt_transfer_finding *out, const jlt_transfer *transfer, const jlt_chart *chart,
                                                 size_t wanted, const volatile sig_atomic_t *interrupt);
void jlt_transfer_finding_clear(jlt_transfer_finding *self); /* legal when zeroed */

/** The density of masses v in a kept box: mass over the volume of the part of the box in the space. */
double jlt_transfer_finding_density(const jlt_transfer *transfer, const double *v, size_t place);

/** Find the boxes whose density exceeds the mean and that of all their neighbours, at most `room` of them, by descending density:
 *  places to look for periodic orbits. Out: places, shape (room,), indices among kept boxes; *count. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_transfer_finding_peaks(size_t *places, size_t *count, size_t room, const jlt_transfer *transfer,
                                                  const double *v);

#endif
