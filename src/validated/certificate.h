/** Certificates: a theorem about an orbit, a family of equilibria, or motions that end at a pole, as a JSON object from which
 *  alone the proof can be replayed.
 *
 *      {"certificate": "jellett 1", "kind": KIND, "theorem": [SENTENCE, ...], "given": {...}, "shown": {...},
 *       "digest": SHA-256}
 *
 *  It has exactly these members. Each number in `shown` contains the enclosure that a replay computes there. The sentences are
 *  those that the numbers determine, and what they conclude from a number follows from that number as it is written (said.h).
 *
 *  `given`, the input of the proof, is described in given.h. `shown` is its result: the orbit's points, period, determinant, trace
 *  and multipliers as balls, lower bounds of the model's conditions along it, and the claims of the table that the theorem rests
 *  on. The digest is that of all other members as compact JSON with sorted keys. The kinds are:
 *  `cycle`: there is exactly one such orbit.
 *  `obstruction`: its determinant is not 1.
 *  `sink`: it attracts; its image under a reversor of the table, if there is one, repels.
 *  `homoclinic`: it is a saddle whose manifolds cross transversally, at a point that a reversor fixes.
 *  `symmetric`: it is its own mirror image under a reversor.
 *  `elliptic`: it is symmetric, elliptic, and stable by a twist.
 *  `equilibria`: the trace of the linearization has one sign on a family of equilibria over a box; see given_family.h.
 *  `pole`: all motions from a box end at a pole; see given_pole.h. */
#ifndef JLT_VALIDATED_CERTIFICATE_H
#define JLT_VALIDATED_CERTIFICATE_H

#include "validated/given.h"

typedef enum {
    JLT_CERTIFICATE_GOOD,
    JLT_CERTIFICATE_REFUSED, /* the certificate does not prove what it says */
    JLT_CERTIFICATE_MALFORMED, /* not a certificate, or one without its table, or of a kind that does not fit `given` */
    JLT_CERTIFICATE_FAILED   /* the proof could not be carried out */
} jlt_certificate_verdict;

typedef struct {
    jlt_certificate_verdict verdict;
    char problem[JLT_GIVEN_PROBLEM_MAX]; /* "" if the verdict is GOOD */
} jlt_certificate_report;

/** Prove a theorem and write its certificate. In: kind; given, borrowed; own, a table that is not built in, or NULL; watch, as in
 *  jlt_step_create. Returns a new reference, NULL if the report's verdict is not GOOD. Cost: seconds to minutes. */
json_t *jlt_certificate_make(jlt_certificate_report *report, const char *kind, json_t *given, const jlt_descriptor *own,
                             jlt_step_watch *watch);

/** Replay a certificate: prove it again, and compare. In: certificate, borrowed; own, watch, as above. */
void jlt_certificate_check(jlt_certificate_report *report, json_t *certificate, const jlt_descriptor *own, jlt_step_watch *watch);

#endif
