/** Checks the prover's verdicts at random points of the domain, in ball arithmetic. Of the prover's code it uses the expression
 *  graph and nothing more: derivatives are dual balls, conditions are met point by point.
 *
 *  A proved claim must hold at every point that is tried. A refuted one must fail at one of them if it is an identity on an open
 *  set; if it speaks of zero levels or of signs, points where it fails may be too few to be met, and that none was met is only
 *  noted. */
#ifndef TTC_CHALLENGE_H
#define TTC_CHALLENGE_H

#include "prove/prove.h"

enum { TTC_CHALLENGE_POINT_LIMIT = 1000000 };

typedef struct {
    const char *kind;
    const char *name; /* of the proof report, which must outlive this */
    ttc_place place;
    ttc_proof_status status;
    size_t tried, skipped;  /* generic points; skipped: those left out, because no draw could be judged or time was up */
    size_t special;         /* special points that were tried, at zeros of quantities and of sums */
    bool violated;          /* the claim fails at a point that was tried */
    bool contradicted, doubtful; /* doubtful: refuted, and no point shows why */
    char *text;             /* if contradicted: by what, and at which point; for free() */
} ttc_challenge_result;

typedef struct {
    size_t points; /* at most so many generic ones, and at most so many special ones */
    uint64_t seed; /* the same seed gives the same points */
    double seconds; /* of processor time a verdict, after which no other point is tried; 0: any */
} ttc_challenge_extent;

typedef struct {
    ttc_challenge_result *results; /* one for each proof known here, in the report's order */
    size_t count, contradictions, tried, skipped, special;
} ttc_challenge_report;

/** Challenge one verdict on `model`; a result without points is one that cannot be challenged.
 *  resolver: as for ttc_prove. Returns false when memory is out. */
bool ttc_challenge_proof(const ttc_model *model, const ttc_proof *proof, ttc_resolver resolver, void *context,
                         const ttc_challenge_extent *extent, ttc_challenge_result *result);

/** Challenge every verdict of `proofs`, a report on `model`. The report is the caller's, for ttc_challenge_report_destroy.
 *  Returns false, and no report, when memory is out. */
bool ttc_challenge(const ttc_model *model, const ttc_proof_report *proofs, ttc_resolver resolver, void *context,
                   const ttc_challenge_extent *extent, ttc_challenge_report **report);
void ttc_challenge_report_destroy(ttc_challenge_report *report); /* legal on NULL */

#endif
