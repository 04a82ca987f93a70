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
    size_t tried, skipped;  /* points; skipped: where no draw could be judged */
    bool contradicted, doubtful; /* doubtful: refuted, and no point shows why */
    char *text;             /* if contradicted: by what, and at which point */
} ttc_challenge_result;

typedef struct {
    ttc_challenge_result *results; /* one for each proof known here, in the report's order */
    size_t count, contradictions, tried, skipped;
} ttc_challenge_report;

/** Challenge every verdict of `proofs`, a report on `model`, at so many points each. The same seed gives the same points.
 *  resolver: as for ttc_prove. The report is the caller's, for ttc_challenge_report_destroy.
 *  Returns false, and no report, when memory is out. */
bool ttc_challenge(const ttc_model *model, const ttc_proof_report *proofs, ttc_resolver resolver, void *context, size_t points,
                   uint64_t seed, ttc_challenge_report **report);
void ttc_challenge_report_destroy(ttc_challenge_report *report); /* legal on NULL */

#endif
