/** Checks the prover's verdicts at random points of the domain, in ball arithmetic. Of the prover's code it uses the expression
 *  graph and nothing more: derivatives are dual balls, conditions are met point by point.
 *
 *  A claim that is proved must hold at every point that is tried. One that is refuted must fail at one of them, where the
 *  claim is an identity on an open set; where it speaks of zero levels or of signs, failures may be too thin to be met, and
 *  that no point shows one is only noted. */
#ifndef TTC_CHALLENGE_H
#define TTC_CHALLENGE_H

#include "prove/prove.h"

enum { TTC_CHALLENGE_POINT_LIMIT = 1000000 };

typedef struct {
    const char *kind;
    const char *name; /* of the proof report, which must outlive this */
    ttc_place place;
    ttc_proof_status status;
    size_t tried, skipped;  /* points; those skipped met no point of the domain, or had no value, or told nothing */
    bool contradicted, doubtful; /* doubtful: refuted, and no point shows why */
    char *text;             /* contradicted: what, and at which point */
} ttc_challenge_result;

typedef struct {
    ttc_challenge_result *results; /* one a proof that is known here, in the report's order */
    size_t count, contradictions, doubts, tried, skipped;
} ttc_challenge_report;

/** Challenge every verdict of `proofs`, a report on `model`, with that many points each. The same seed gives the same points.
 *  resolver: as for ttc_prove. The report is the caller's, for ttc_challenge_report_destroy.
 *  Returns false, and no report, when memory is out. */
bool ttc_challenge(const ttc_model *model, const ttc_proof_report *proofs, ttc_resolver resolver, void *context, size_t points,
                   uint64_t seed, ttc_challenge_report **report);
void ttc_challenge_report_destroy(ttc_challenge_report *report); /* legal on NULL */

#endif
