#include "validated/certificate.h"

#include "base/sha256.h"
#include "core/memory.h"
#include "kernel/descriptor.h"
#include "validated/given_family.h"
#include "validated/given_homoclinic.h"
#include "validated/given_pole.h"
#include "validated/judge.h"
#include "validated/said.h"
#include "validated/shown.h"
#include "validated/theorem.h"

#include <stdio.h>
#include <string.h>

static const char format_name[] = "jellett 1";

static bool set(json_t *object, const char *key, json_t *value)
{
    return json_object_set_new(object, key, value) == 0;
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
    report = st == JLT_OK ? jlt_judge_elliptic(&result, of->trace) : jlt_judge_failure_along(st);
    if (report.verdict == JLT_CERTIFICATE_GOOD && !set(shown, "twist", jlt_shown_twist(&result, given)))
        report = jlt_judge_failure(JLT_ERR_NOMEM);
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

    if (given->kept_count != 2)
        return jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "symmetric: two coordinates on the levels are served");
    jlt_symmetry_result_init(&result);
    st = jlt_symmetry_prove(cycle, &result, of, given->legs.box, given->legs.instants);
    report = st == JLT_OK ? jlt_judge_symmetry(&result) : jlt_judge_failure_along(st);
    if (report.verdict == JLT_CERTIFICATE_GOOD && !set(shown, "symmetry", jlt_shown_symmetry(&result, given)))
        report = jlt_judge_failure(JLT_ERR_NOMEM);
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
    *report = st == JLT_OK ? jlt_judge_cycle(&result, kind) : jlt_judge_failure_along(st);
    if (report->verdict == JLT_CERTIFICATE_GOOD) *report = jlt_judge_boxes(json_object_get(json, "legs"), given, result.solution);
    if (report->verdict == JLT_CERTIFICATE_GOOD) {
        shown = jlt_shown_cycle(&result, given, is_symmetric || strcmp(kind, "sink") == 0);
        if (shown == NULL) *report = jlt_judge_failure(JLT_ERR_NOMEM);
        else if (is_symmetric) *report = add_symmetry(shown, kind, given, cycle, &result);
    }
    if (report->verdict != JLT_CERTIFICATE_GOOD) {
        json_decref(shown);
        shown = NULL;
    }
    jlt_cycle_result_clear(&result);
    return shown;
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
        *report = st == JLT_OK ? jlt_judge_homoclinic(&result) : jlt_judge_failure_along(st);
        if (report->verdict == JLT_CERTIFICATE_GOOD)
            *report = jlt_judge_boxes(json_object_get(json, "legs"), given, result.saddle.solution);
        if (report->verdict == JLT_CERTIFICATE_GOOD)
            *report = jlt_judge_boxes(json_object_get(json_object_get(json, "homoclinic"), "legs"), given, result.solution);
        if (report->verdict == JLT_CERTIFICATE_GOOD) {
            shown = jlt_shown_homoclinic(&result, given);
            if (shown == NULL) *report = jlt_judge_failure(JLT_ERR_NOMEM);
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

    *report = jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "");
    if (jlt_given_family_read(&given, json, d, report->problem)) {
        jlt_family_result_init(&result, &given.question);
        st = jlt_family_prove(&result, &given.question);
        if (st == JLT_OK && result.verdict == JLT_FAMILY_PROVED) shown = jlt_given_family_shown(&given, &result);
        if (st != JLT_OK) *report = jlt_judge_failure(st);
        else if (shown != NULL) *report = jlt_judge_say(JLT_CERTIFICATE_GOOD, "");
        else if (result.verdict == JLT_FAMILY_PROVED) *report = jlt_judge_failure(JLT_ERR_NOMEM);
        else {
            report->verdict = result.verdict == JLT_FAMILY_LEFT ? JLT_CERTIFICATE_FAILED : JLT_CERTIFICATE_REFUSED;
            jlt_given_family_problem(report->problem, &given, &result);
        }
        jlt_family_result_clear(&result);
    }
    jlt_given_family_clear(&given);
    return shown;
}

static json_t *prove_pole(jlt_certificate_report *report, const json_t *json, const jlt_descriptor *d, bool replays,
                          jlt_step_watch *watch)
{
    jlt_given_pole given;
    jlt_pole_result result;
    json_t *shown = NULL;
    jlt_status st;

    *report = jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "");
    if (jlt_given_pole_read(&given, json, d, false, report->problem)) {
        given.question.watch = watch;
        given.replays = replays;
        jlt_pole_result_init(&result, d);
        st = jlt_pole_prove(&result, &given.question, given.instant);
        if (st == JLT_ERR_UNSUPPORTED)
            *report = jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "time: the table has no such time that lifts a root");
        else if (st != JLT_OK) *report = jlt_judge_failure(st);
        else if (result.verdict != JLT_POLE_PROVED)
            *report = jlt_judge_say(JLT_CERTIFICATE_REFUSED, jlt_given_pole_problem(&result));
        else if ((shown = jlt_given_pole_shown(&given, &result)) == NULL) *report = jlt_judge_failure(JLT_ERR_NOMEM);
        else *report = jlt_judge_say(JLT_CERTIFICATE_GOOD, "");
        jlt_pole_result_clear(&result);
    }
    jlt_given_pole_clear(&given);
    return shown;
}

/* Prove what follows from `given`; returns a new object `shown`, NULL unless the report is GOOD. replays: it is compared with that
 * of a certificate. */
static json_t *prove(jlt_certificate_report *report, const char *kind, const json_t *json, const jlt_descriptor *d, bool replays,
                     jlt_step_watch *watch)
{
    jlt_given given;
    jlt_cycle *cycle = NULL;
    json_t *shown = NULL;
    jlt_status st;

    if (strcmp(kind, "equilibria") == 0) return prove_family(report, json, d);
    if (strcmp(kind, "pole") == 0) return prove_pole(report, json, d, replays, watch);
    *report = jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "");
    if (jlt_given_read(&given, json, d, watch, report->problem) && jlt_given_read_legs(&given, json, report->problem)) {
        given.replays = replays;
        const bool serves = given.legs.turns == NULL || serves_turns(kind);
        st = serves ? jlt_cycle_create(&cycle, &given.question) : JLT_OK;
        if (!serves)
            *report = jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "orbits that close up to periods of states are served as cycle, "
                                                               "obstruction and sink: ask for 'certify cycle' with these options");
        else if (st != JLT_OK) *report = jlt_judge_failure(st);
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
    *report = jlt_judge_say(otherwise, "");
    return jlt_refuse_claim(report->problem, doubted);
}

/* SHA-256 of the certificate without `digest`. Returns false if memory is out. */
static bool digest_of(char digest[65], json_t *certificate)
{
    json_auto_t *copy = json_copy(certificate);
    JLT_FREED char *text = NULL;

    if (copy != NULL) {
        json_object_del(copy, "digest");
        text = json_dumps(copy, JSON_COMPACT | JSON_SORT_KEYS);
    }
    if (text != NULL) ttc_sha256(digest, text, strlen(text));
    return text != NULL;
}

/* The theorem is proved, but the numbers as written are too wide to imply it. */
static jlt_certificate_report too_wide(const char *problem)
{
    jlt_certificate_report report = jlt_judge_say(JLT_CERTIFICATE_REFUSED, "");

    snprintf(report.problem, sizeof report.problem, "%s (try more digits)", problem);
    return report;
}

json_t *jlt_certificate_make(jlt_certificate_report *report, const char *kind, json_t *given, const jlt_descriptor *own,
                             jlt_step_watch *watch)
{
    const jlt_descriptor *d;
    json_t *shown = NULL, *certificate = NULL;
    const char *problem;
    char digest[65];

    *report = jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "");
    d = jlt_given_table(given, own, report->problem);
    if (d != NULL && is_defined(report, JLT_CERTIFICATE_MALFORMED, kind, d)) shown = prove(report, kind, given, d, false, watch);
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
        *report = jlt_judge_failure(JLT_ERR_NOMEM);
        json_decref(certificate);
        certificate = NULL;
    }
    return certificate;
}

void jlt_certificate_check(jlt_certificate_report *report, json_t *certificate, const jlt_descriptor *own, jlt_step_watch *watch)
{
    const char *form = json_string_value(json_object_get(certificate, "certificate"));
    const char *kind = json_string_value(json_object_get(certificate, "kind"));
    const char *digest = json_string_value(json_object_get(certificate, "digest"));
    const json_t *given = json_object_get(certificate, "given"), *said = json_object_get(certificate, "shown");
    const jlt_descriptor *d;
    const char *problem;
    char found[65];

    *report = jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "it is no certificate of this program's form");
    if (form == NULL || strcmp(form, format_name) != 0 || kind == NULL || !jlt_theorem_is_kind(kind) || digest == NULL
        || !json_is_object(given) || !json_is_object(said))
        return;
    *report = jlt_judge_say(JLT_CERTIFICATE_MALFORMED, "its members are not those of a certificate of its kind");
    if (json_object_size(certificate) != 6 || !jlt_said_is_form(kind, given)) return;
    d = jlt_given_table(given, own, report->problem);
    if (d == NULL) return;
    *report = jlt_judge_say(JLT_CERTIFICATE_REFUSED, "its digest is not that of its text: it was changed after it was made");
    if (!digest_of(found, certificate) || strcmp(found, digest) != 0) return;
    if (!is_defined(report, JLT_CERTIFICATE_REFUSED, kind, d)) return;
    json_auto_t *proved = prove(report, kind, given, d, true, watch), *words = NULL;
    if (proved == NULL) return;
    if (!jlt_said_follows(said, proved))
        *report = jlt_judge_say(JLT_CERTIFICATE_REFUSED,
                                "what it says to be shown does not follow: the replay gives something else");
    else if ((problem = jlt_said_problem(kind, given, said)) != NULL) *report = jlt_judge_say(JLT_CERTIFICATE_REFUSED, problem);
    /* The theorem's words are made only from members that have the form of what was proved. */
    else if ((words = jlt_theorem_words(kind, d, given, said)) == NULL) *report = jlt_judge_failure(JLT_ERR_NOMEM);
    else if (!json_equal(words, json_object_get(certificate, "theorem")))
        *report = jlt_judge_say(JLT_CERTIFICATE_REFUSED, "its theorem is not what its numbers say in the words of this version: "
                                                         "'jellett certify' writes one anew");
}
