#include "validated/certificate.h"

#include "base/sha256.h"
#include "kernel/descriptor.h"
#include "validated/given_family.h"
#include "validated/given_homoclinic.h"
#include "validated/given_pole.h"
#include "validated/said.h"
#include "validated/shown.h"
#include "validated/theorem.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char format_name[] = "jellett 1";

static bool set(json_t *object, const char *key, json_t *value)
{
    return json_object_set_new(object, key, value) == 0;
}

static jlt_certificate_report say(jlt_certificate_verdict verdict, const char *problem)
{
    jlt_certificate_report report = { .verdict = verdict };
    snprintf(report.problem, sizeof report.problem, "%s", problem);
    return report;
}

static const char still[] = "a leg of the orbit is not shown to take time: it may end where it begins (its instant is to lie near "
                            "the next crossing)";

/* Whether the orbit is proved to lie in the boxes as `given` writes them, which may differ by rounding from those of the proof. */
static jlt_certificate_report judge_boxes(const json_t *legs, const jlt_given *given, arb_srcptr y)
{
    return jlt_given_legs_hold(legs, &given->question, y)
               ? say(JLT_CERTIFICATE_GOOD, "")
               : say(JLT_CERTIFICATE_REFUSED, "the orbit is there, but not shown to lie in its boxes as they are written (try "
                                              "another radius)");
}

static jlt_certificate_report judge(const jlt_cycle_result *result, const char *kind)
{
    switch (result->verdict) {
    case JLT_CYCLE_PROVED: break;
    case JLT_CYCLE_UNSHOWN:
        return say(JLT_CERTIFICATE_REFUSED, "Krawczyk's operator does not map the box into itself: no orbit is shown to be there "
                                            "(try another radius, or more digits)");
    case JLT_CYCLE_OPEN:
        return say(JLT_CERTIFICATE_REFUSED, "the integrals do not determine the states left out, so that the orbit need not close");
    case JLT_CYCLE_STILL: return say(JLT_CERTIFICATE_REFUSED, still);
    default: return say(JLT_CERTIFICATE_FAILED, "the two determinants exclude each other, which is an error of this program");
    }
    if (strcmp(kind, "sink") == 0 && !result->sink)
        return say(JLT_CERTIFICATE_REFUSED, "the orbit is there, but not shown to attract: its multipliers are not all proved "
                                            "to be inside the unit circle");
    if (strcmp(kind, "obstruction") == 0 && arb_contains_si(result->determinant, 1))
        return say(JLT_CERTIFICATE_REFUSED, "the orbit is there, but its determinant may be 1: it excludes no measure");
    return say(JLT_CERTIFICATE_GOOD, "");
}

static jlt_certificate_report fail(jlt_status status)
{
    jlt_certificate_report report = say(JLT_CERTIFICATE_FAILED, jlt_status_text(status));

    report.status = status;
    return report;
}

/* The failure of a proof that follows the orbit. */
static jlt_certificate_report fail_along(jlt_status status)
{
    return status != JLT_ERR_DOMAIN
               ? fail(status)
               : say(JLT_CERTIFICATE_REFUSED, "the orbit is not shown to stay in the domain of its table (where "
                                              "it does, try another radius, or more digits)");
}

static jlt_certificate_report judge_symmetry(const jlt_symmetry_result *result)
{
    switch (result->verdict) {
    case JLT_SYMMETRY_PROVED: return say(JLT_CERTIFICATE_GOOD, "");
    case JLT_SYMMETRY_NO_REVERSOR:
        return say(JLT_CERTIFICATE_REFUSED,
                   "the orbit is there, but no reversor of the table that is proved without a condition maps the "
                   "section and the levels to themselves");
    default: return say(JLT_CERTIFICATE_REFUSED, "the orbit is there, but not shown to be its own mirror image");
    }
}

static jlt_certificate_report judge_elliptic(const jlt_elliptic_result *result, const arb_t trace)
{
    jlt_certificate_report report;

    switch (result->verdict) {
    case JLT_ELLIPTIC_PROVED: return say(JLT_CERTIFICATE_GOOD, "");
    case JLT_ELLIPTIC_OTHER:
        report = say(JLT_CERTIFICATE_REFUSED, "");
        snprintf(report.problem, sizeof report.problem,
                 "the orbit is its own mirror image, but not shown to be elliptic: its trace is %.17g",
                 arf_get_d(arb_midref(trace), ARF_RND_NEAR));
        return report;
    case JLT_ELLIPTIC_RESONANT:
        return say(JLT_CERTIFICATE_REFUSED, "the orbit is elliptic, but its trace may be 0 or -1: a resonance of order 4 or 3");
    case JLT_ELLIPTIC_UNTWISTED:
        return say(JLT_CERTIFICATE_REFUSED,
                   "the orbit is elliptic, but its twist may be 0 (try more digits, or intervals that are less wide)");
    default:
        return say(JLT_CERTIFICATE_FAILED, "two enclosures of one number exclude each other, which is an error of this program");
    }
}

/* Prove that a cycle which is its own mirror image is elliptic and stable by a twist; add this to `shown`. */
static jlt_certificate_report add_twist(json_t *shown, const jlt_given *given, jlt_cycle *cycle, const jlt_cycle_result *of,
                                        jlt_symmetry_type type)
{
    jlt_certificate_report report;
    jlt_elliptic_result result;
    jlt_status st;

    jlt_elliptic_result_init(&result);
    st = jlt_elliptic_prove(cycle, &result, of, type, given->legs.instants, given->kept);
    report = st == JLT_OK ? judge_elliptic(&result, of->trace) : fail_along(st);
    if (report.verdict == JLT_CERTIFICATE_GOOD && !set(shown, "twist", jlt_shown_twist(&result, given)))
        report = fail(JLT_ERR_NOMEM);
    jlt_elliptic_result_clear(&result);
    return report;
}

/* Prove that a proved cycle is its own mirror image; add this to `shown`. For kind `elliptic`, prove stability as well. */
static jlt_certificate_report add_symmetry(json_t *shown, const char *kind, const jlt_given *given, jlt_cycle *cycle,
                                           const jlt_cycle_result *of)
{
    jlt_certificate_report report;
    jlt_symmetry_result result;
    jlt_status st;

    if (given->kept_count != 2) return say(JLT_CERTIFICATE_MALFORMED, "symmetric: two coordinates on the levels are served");
    jlt_symmetry_result_init(&result);
    st = jlt_symmetry_prove(cycle, &result, of, given->legs.box, given->legs.instants);
    report = st == JLT_OK ? judge_symmetry(&result) : fail_along(st);
    if (report.verdict == JLT_CERTIFICATE_GOOD && !set(shown, "symmetry", jlt_shown_symmetry(&result, given)))
        report = fail(JLT_ERR_NOMEM);
    if (report.verdict == JLT_CERTIFICATE_GOOD && strcmp(kind, "elliptic") == 0)
        report = add_twist(shown, given, cycle, of, result.type);
    jlt_symmetry_result_clear(&result);
    return report;
}

/* Whether a kind admits orbits that close only up to periods of states. The other kinds compare states as numbers. */
static bool serves_turns(const char *kind)
{
    return strcmp(kind, "cycle") == 0 || strcmp(kind, "obstruction") == 0 || strcmp(kind, "sink") == 0;
}

/* Prove the cycle, and what else its kind of certificate says; returns a new object `shown`, NULL unless the report is GOOD. */
static json_t *prove_cycle(jlt_certificate_report *report, const char *kind, const json_t *json, const jlt_given *given,
                           jlt_cycle *cycle)
{
    jlt_cycle_result result;
    const bool is_symmetric = strcmp(kind, "symmetric") == 0 || strcmp(kind, "elliptic") == 0;
    json_t *shown = NULL;
    jlt_status st;

    jlt_cycle_result_init(&result, cycle, given->legs.count);
    st = jlt_cycle_prove(cycle, &result, given->legs.box, given->legs.instants, given->kept);
    *report = st == JLT_OK ? judge(&result, kind) : fail_along(st);
    if (report->verdict == JLT_CERTIFICATE_GOOD) *report = judge_boxes(json_object_get(json, "legs"), given, result.solution);
    if (report->verdict == JLT_CERTIFICATE_GOOD) {
        shown = jlt_shown_cycle(&result, given, is_symmetric || strcmp(kind, "sink") == 0);
        if (shown == NULL) *report = fail(JLT_ERR_NOMEM);
        else if (is_symmetric) *report = add_symmetry(shown, kind, given, cycle, &result);
    }
    if (report->verdict != JLT_CERTIFICATE_GOOD) {
        json_decref(shown);
        shown = NULL;
    }
    jlt_cycle_result_clear(&result);
    return shown;
}

static jlt_certificate_report judge_homoclinic(const jlt_homoclinic_result *result)
{
    static const char *const reasons[] = {
        [JLT_HOMOCLINIC_NO_SADDLE] = "no saddle is shown to be in the box",
        [JLT_HOMOCLINIC_ASYMMETRIC] =
            "the saddle, or the section, is not shown to be its own mirror image under a proved reversor that "
            "flips one coordinate",
        [JLT_HOMOCLINIC_NO_CONE] = "the cone is not mapped into itself (try a smaller distance)",
        [JLT_HOMOCLINIC_UNSHOWN] = "Krawczyk's operator does not map the boxes into themselves: no homoclinic orbit is shown to be "
                                   "there (try a smaller distance, or more digits)",
        [JLT_HOMOCLINIC_STILL] = still,
        [JLT_HOMOCLINIC_OPEN] = "the orbit is not shown to begin on the unstable manifold, or its legs to meet",
        [JLT_HOMOCLINIC_TANGENT] = "the orbit is there, but the manifolds may be tangent",
    };

    if (result->verdict == JLT_HOMOCLINIC_PROVED) return say(JLT_CERTIFICATE_GOOD, "");
    if (result->verdict == JLT_HOMOCLINIC_CONTRADICTED)
        return say(JLT_CERTIFICATE_FAILED, "enclosures of one orbit exclude each other, which is an error of this program");
    return say(JLT_CERTIFICATE_REFUSED, reasons[result->verdict]);
}

static json_t *prove_homoclinic(jlt_certificate_report *report, const json_t *json, const jlt_given *given, jlt_cycle *cycle)
{
    jlt_given_homoclinic homoclinic;
    jlt_homoclinic_result result;
    json_t *shown = NULL;
    jlt_status st;

    if (jlt_given_homoclinic_read(&homoclinic, given, json, report->problem)) {
        jlt_homoclinic_result_init(&result, cycle, homoclinic.question.legs);
        st = jlt_homoclinic_prove(cycle, &result, &homoclinic.question);
        *report = st == JLT_OK ? judge_homoclinic(&result) : fail_along(st);
        if (report->verdict == JLT_CERTIFICATE_GOOD)
            *report = judge_boxes(json_object_get(json, "legs"), given, result.saddle.solution);
        if (report->verdict == JLT_CERTIFICATE_GOOD)
            *report = judge_boxes(json_object_get(json_object_get(json, "homoclinic"), "legs"), given, result.solution);
        if (report->verdict == JLT_CERTIFICATE_GOOD) {
            shown = jlt_shown_homoclinic(&result, given);
            if (shown == NULL) *report = fail(JLT_ERR_NOMEM);
        }
        jlt_homoclinic_result_clear(&result);
    }
    jlt_given_homoclinic_clear(&homoclinic);
    return shown;
}

static json_t *prove_family(jlt_certificate_report *report, const json_t *json, const jlt_descriptor *d)
{
    jlt_given_family given;
    jlt_family_result result;
    json_t *shown = NULL;
    jlt_status st;

    *report = say(JLT_CERTIFICATE_MALFORMED, "");
    if (jlt_given_family_read(&given, json, d, report->problem)) {
        jlt_family_result_init(&result, &given.question);
        st = jlt_family_prove(&result, &given.question);
        if (st == JLT_OK && result.verdict == JLT_FAMILY_PROVED) shown = jlt_given_family_shown(&given, &result);
        if (st != JLT_OK) *report = fail(st);
        else if (result.verdict == JLT_FAMILY_PROVED) *report = shown == NULL ? fail(JLT_ERR_NOMEM) : say(JLT_CERTIFICATE_GOOD, "");
        else {
            report->verdict = result.verdict == JLT_FAMILY_LEFT ? JLT_CERTIFICATE_FAILED : JLT_CERTIFICATE_REFUSED;
            jlt_given_family_problem(report->problem, &given, &result);
        }
        jlt_family_result_clear(&result);
    }
    jlt_given_family_clear(&given);
    return shown;
}

static json_t *prove_pole(jlt_certificate_report *report, const json_t *json, const jlt_descriptor *d)
{
    jlt_given_pole given;
    jlt_pole_result result;
    json_t *shown = NULL;
    jlt_status st;

    *report = say(JLT_CERTIFICATE_MALFORMED, "");
    if (jlt_given_pole_read(&given, json, d, false, report->problem)) {
        jlt_pole_result_init(&result, d);
        st = jlt_pole_prove(&result, &given.question, given.instant);
        if (st == JLT_ERR_UNSUPPORTED)
            *report = say(JLT_CERTIFICATE_MALFORMED, "time: the table has no such time that lifts a root");
        else if (st != JLT_OK) *report = fail(st);
        else if (result.verdict != JLT_POLE_PROVED) *report = say(JLT_CERTIFICATE_REFUSED, jlt_given_pole_problem(&result));
        else if ((shown = jlt_given_pole_shown(&given, &result)) == NULL) *report = fail(JLT_ERR_NOMEM);
        else *report = say(JLT_CERTIFICATE_GOOD, "");
        jlt_pole_result_clear(&result);
    }
    jlt_given_pole_clear(&given);
    return shown;
}

/* Prove what follows from `given`; returns a new object `shown`, NULL unless the report is GOOD. */
static json_t *prove(jlt_certificate_report *report, const char *kind, const json_t *json, const jlt_descriptor *d)
{
    jlt_given given;
    jlt_cycle *cycle = NULL;
    json_t *shown = NULL;
    jlt_status st;

    if (strcmp(kind, "equilibria") == 0) return prove_family(report, json, d);
    if (strcmp(kind, "pole") == 0) return prove_pole(report, json, d);
    *report = say(JLT_CERTIFICATE_MALFORMED, "");
    if (jlt_given_read(&given, json, d, report->problem) && jlt_given_read_legs(&given, json, report->problem)) {
        const bool serves = given.legs.turns == NULL || serves_turns(kind);
        st = serves ? jlt_cycle_create(&cycle, &given.question) : JLT_OK;
        if (!serves)
            *report = say(JLT_CERTIFICATE_MALFORMED, "orbits that close up to periods of states are served as cycle, obstruction "
                                                     "and sink");
        else if (st != JLT_OK) *report = fail(st);
        else if (strcmp(kind, "homoclinic") == 0) shown = prove_homoclinic(report, json, &given, cycle);
        else shown = prove_cycle(report, kind, json, &given, cycle);
    }
    jlt_cycle_destroy(cycle);
    jlt_given_clear(&given);
    return shown;
}

/* Whether every root and logarithm of the table is proved to have a value. Certificates of orbits require it, since proofs of
 * periods, integrals and reversors assume it; those of equilibria prove it themselves, over their box. */
static bool is_defined(jlt_certificate_report *report, jlt_certificate_verdict otherwise, const char *kind, const jlt_descriptor *d)
{
    const jlt_claim *doubted = strcmp(kind, "equilibria") == 0 ? NULL : jlt_descriptor_doubted_field(d);

    if (doubted == NULL) return true;
    *report = say(otherwise, "");
    return jlt_refuse_claim(report->problem, doubted);
}

/* SHA-256 of the certificate without `digest`. Returns false if memory is out. */
static bool digest_of(char digest[65], json_t *certificate)
{
    json_t *copy = json_copy(certificate);
    char *text = NULL;

    if (copy != NULL) {
        json_object_del(copy, "digest");
        text = json_dumps(copy, JSON_COMPACT | JSON_SORT_KEYS);
    }
    if (text != NULL) ttc_sha256(digest, text, strlen(text));
    free(text);
    json_decref(copy);
    return text != NULL;
}

/* The theorem is proved, but the numbers as written are too wide to imply it. */
static jlt_certificate_report too_wide(const char *problem)
{
    jlt_certificate_report report = say(JLT_CERTIFICATE_REFUSED, "");

    snprintf(report.problem, sizeof report.problem, "%s (try more digits)", problem);
    return report;
}

json_t *jlt_certificate_make(jlt_certificate_report *report, const char *kind, json_t *given, const jlt_descriptor *own)
{
    const jlt_descriptor *d;
    json_t *shown = NULL, *certificate = NULL;
    const char *problem;
    char digest[65];

    *report = say(JLT_CERTIFICATE_MALFORMED, "");
    d = jlt_given_table(given, own, report->problem);
    if (d != NULL && is_defined(report, JLT_CERTIFICATE_MALFORMED, kind, d)) shown = prove(report, kind, given, d);
    if (shown == NULL) return NULL;
    problem = jlt_said_problem(kind, given, shown);
    if (problem != NULL) {
        *report = too_wide(problem);
        json_decref(shown);
        return NULL;
    }
    certificate = json_pack("{s:s,s:s,s:o,s:O,s:o}", "certificate", format_name, "kind", kind, "theorem",
                            jlt_theorem_words(kind, d, given, shown), "given", given, "shown", shown);
    if (certificate == NULL || !digest_of(digest, certificate) || !set(certificate, "digest", json_string(digest))) {
        *report = fail(JLT_ERR_NOMEM);
        json_decref(certificate);
        certificate = NULL;
    }
    return certificate;
}

void jlt_certificate_check(jlt_certificate_report *report, json_t *certificate, const jlt_descriptor *own)
{
    const char *form = json_string_value(json_object_get(certificate, "certificate"));
    const char *kind = json_string_value(json_object_get(certificate, "kind"));
    const char *digest = json_string_value(json_object_get(certificate, "digest"));
    const json_t *given = json_object_get(certificate, "given"), *said = json_object_get(certificate, "shown");
    const jlt_descriptor *d;
    json_t *proved = NULL, *words = NULL;
    const char *problem;
    char found[65];

    *report = say(JLT_CERTIFICATE_MALFORMED, "it is no certificate of this program's form");
    if (form == NULL || strcmp(form, format_name) != 0 || kind == NULL || !jlt_theorem_is_kind(kind) || digest == NULL
        || !json_is_object(given) || !json_is_object(said))
        return;
    *report = say(JLT_CERTIFICATE_MALFORMED, "it has members that a certificate of its kind has not");
    if (json_object_size(certificate) != 6 || !jlt_said_is_form(kind, given)) return;
    d = jlt_given_table(given, own, report->problem);
    if (d == NULL) return;
    *report = say(JLT_CERTIFICATE_REFUSED, "its digest is not that of its text: it was changed after it was made");
    if (!digest_of(found, certificate) || strcmp(found, digest) != 0) return;
    if (!is_defined(report, JLT_CERTIFICATE_REFUSED, kind, d)) return;
    proved = prove(report, kind, given, d);
    if (proved == NULL) return;
    if (!jlt_said_follows(said, proved))
        *report = say(JLT_CERTIFICATE_REFUSED, "what it says to be shown does not follow: the replay gives something else");
    else if ((problem = jlt_said_problem(kind, given, said)) != NULL) *report = say(JLT_CERTIFICATE_REFUSED, problem);
    /* The theorem's words are made only from members that have the form of what was proved. */
    else if ((words = jlt_theorem_words(kind, d, given, said)) == NULL) *report = fail(JLT_ERR_NOMEM);
    else if (!json_equal(words, json_object_get(certificate, "theorem")))
        *report = say(JLT_CERTIFICATE_REFUSED, "its theorem is not what its numbers say");
    json_decref(proved);
    json_decref(words);
}
