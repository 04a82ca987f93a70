/** Certificates: a theorem about an orbit, a family of equilibria, or ends of motions, as a JSON object that is replayed from itself alone.
 *
 *      {"certificate": "jellett 1", "kind": KIND, "theorem": [SENTENCE, ...], "given": {...}, "shown": {...},
 *       "digest": SHA-256}
 *
 *  It has these members and no others. Each number in `shown` contains what a replay encloses there; its words are those that
 *  its numbers make, and what they conclude from a number follows from that number as it is written (said.h).
 *
 *  `given` is described in given.h. `shown` is what was proved of it: the orbit's points, period, determinant, trace and
 *  multipliers as balls, bounds of the model's conditions along it, and the claims of the table that the theorem rests on. The
 *  digest is that of all the rest as compact JSON with sorted keys. Kind `cycle`: there is one such orbit. Kind
 *  `obstruction`: its determinant is not 1. Kind `sink`: it attracts, and a reversor has an image that repels. Kind `homoclinic`:
 *  it is a saddle whose manifolds cross transversally, at a point that a reversor keeps. Kind `symmetric`: it is its own mirror
 *  image under a reversor. Kind `elliptic`: besides, it is elliptic, and stable by a twist. Kind `equilibria`: at a family of
 *  equilibria over a box the trace of the linearization has one sign; its `given` and `shown` are in given_family.h. Kind `pole`: all
 *  motions from a box end at a pole; see given_pole.h. */
#ifndef JLT_VALIDATED_CERTIFICATE_H
#define JLT_VALIDATED_CERTIFICATE_H

#include "validated/given.h"

typedef enum {
    JLT_CERTIFICATE_GOOD,
    JLT_CERTIFICATE_REFUSED, /* it does not prove what it says */
    JLT_CERTIFICATE_MALFORMED, /* it is no certificate, or speaks of a table that is not here */
    JLT_CERTIFICATE_FAILED   /* the proof could not be carried out: `status` says why */
} jlt_certificate_verdict;

typedef struct {
    jlt_certificate_verdict verdict;
    jlt_status status;
    char problem[JLT_GIVEN_PROBLEM_MAX]; /* "" where the verdict is GOOD */
} jlt_certificate_report;

/** Prove, and write. In: kind; given, borrowed; own, a table that is not built in, or NULL. Returns a new reference, NULL where the
 *  report's verdict is not GOOD. Cost: seconds to minutes. */
json_t *jlt_certificate_make(jlt_certificate_report *report, const char *kind, json_t *given, const jlt_descriptor *own);

/** Replay. In: certificate, borrowed; own, as above. */
void jlt_certificate_check(jlt_certificate_report *report, json_t *certificate, const jlt_descriptor *own);

#endif
