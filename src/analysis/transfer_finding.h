/** What one transfer operator of a section tells, in numbers that can be compared between operators. */
#ifndef JLT_ANALYSIS_TRANSFER_FINDING_H
#define JLT_ANALYSIS_TRANSFER_FINDING_H

#include "analysis/transfer_section.h"
#include "analysis/transfer_spectrum.h"

/** Plain data; clear with jlt_transfer_finding_clear. NaN stands for what there is not. Distances are in total
 *  variation, 0 to 1. */
typedef struct {
    jlt_transfer_spectrum spectrum; /* empty where none was asked for */
    size_t multiplicity; /* eigenvalues that are 1e-8 or less from the leading one: above 1, the density that stays is not unique */
    double escape;       /* -ln of the leading eigenvalue: rate at which mass is lost, a return; 0 where none is lost */
    double lost[JLT_TRANSFER_SECTION_LOSSES]; /* by kind, of the density that stays, at each return */
    double balance;      /* |1 - leading eigenvalue - sum of lost|: rounding, and the error of the eigenvector */
    double time;         /* mean time of a return */
    double asymmetry;    /* distance between that density and its mirror image, which stays under the inverse map: 0 where they are
                            the same, 1 where attractor and repeller are apart */
    double set_mass[2], set_kept[2]; /* where the second eigenvector is positive, and negative: part of the mass, and of that what
                            is there after a return too */
    double defect;       /* between the density that the table claims and its image: 0 where it is invariant, but for errors of
                            boxes and of random points */
    double distance;     /* between it and the density that stays; NaN where that is not unique, or not known to be */
} jlt_transfer_finding;

/** Compute it, with `wanted` eigenvalues, 0 for none. In: chart, the section's. Errors: as jlt_transfer_spectrum_compute. */
JLT_CHECKED jlt_status jlt_transfer_finding_make(jlt_transfer_finding *out, const jlt_transfer *transfer, const jlt_chart *chart,
                                                 size_t wanted, const volatile sig_atomic_t *interrupt);
void jlt_transfer_finding_clear(jlt_transfer_finding *self); /* legal when zeroed */

/** Density of mass v over a box: mass over the volume of the box's part on the section. */
double jlt_transfer_finding_density(const jlt_transfer *transfer, const double *v, size_t place);

/** The places of the boxes, at most `room`, whose density is larger than that of all their neighbours, by descending density:
 *  where to look for orbits. Out: places, shape (room,); *count. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_transfer_finding_peaks(size_t *places, size_t *count, size_t room, const jlt_transfer *transfer,
                                                  const double *v);

#endif
