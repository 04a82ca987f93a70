#include "validated/certificate.h"

#include "base/sha256.h"
#include "validated/theorem.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char format_name[] = "jellett 1";

json_t *jlt_certificate_ball(const arb_t ball, unsigned digits)
{
    char *text = arb_get_str(ball, (slong)digits, ARB_STR_MORE);
    char *between = strstr(text, " +/- "), *end = strchr(text, ']');
    json_t *out = NULL;

    if (between == NULL || end == NULL) out = json_pack("{s:s,s:s}", "middle", text, "radius", "0");
    else {
        *between = *end = '\0';
        out = json_pack("{s:s,s:s}", "middle", text + 1, "radius", between + 5);
    }
    flint_free(text);
    return out;
}

/* A decimal below the bound. */
static json_t *lower_bound(const arf_t bound)
{
    json_t *out = NULL;
    char text[64];
    double value = arf_get_d(bound, ARF_RND_FLOOR);
    arb_t read;

    arb_init(read);
    for (unsigned i = 0; i < 3; i++) { /* five digits, lowered until they are below */
        snprintf(text, sizeof text, "%.5g", value);
        arb_set_str(read, text, 64);
        arb_get_lbound_arf(arb_midref(read), read, 64);
        if (arf_cmp(arb_midref(read), bound) <= 0) {
            out = json_string(text);
            break;
        }
        value -= 1e-5 * (value < 0 ? -value : value);
    }
    arb_clear(read);
    return out;
}

static bool set(json_t *object, const char *key, json_t *value)
{
    return json_object_set_new(object, key, value) == 0;
}

static json_t *claims_of(const jlt_given *given, const char *kind)
{
    const jlt_reversor *reversor = jlt_theorem_reversor(given->question.descriptor);
    json_t *claims = json_array();
    char text[160];

    for (unsigned i = 0; i < given->question.level_count; i++) {
        snprintf(text, sizeof text, "integral %s", given->levels[i]);
        json_array_append_new(claims, json_string(text));
    }
    if (reversor != NULL && strcmp(kind, "sink") == 0) json_array_append_new(claims, json_string("reversor"));
    return claims;
}

static json_t *shown_by(const jlt_cycle_result *result, const jlt_given *given, const char *kind)
{
    const jlt_descriptor *d = given->question.descriptor;
    const unsigned digits = given->question.digits;
    json_t *shown = json_object(), *orbit = json_object(), *conditions = json_object(), *multipliers = json_array();
    bool good = true;

    for (unsigned i = 0, k = 0; i < d->state_count; i++)
        if (i != given->question.column)
            good = good && set(orbit, d->states[i].name, jlt_certificate_ball(result->solution + k++, digits));
    for (unsigned i = 0; i < result->multipliers && result->multipliers <= 2; i++)
        good = good && json_array_append_new(multipliers,
                   json_pack("{s:o,s:o}", "re", jlt_certificate_ball(acb_realref(result->multiplier + i), digits), "im",
                             jlt_certificate_ball(acb_imagref(result->multiplier + i), digits))) == 0;
    for (unsigned i = 0; i < d->valid_count; i++) good = good && set(conditions, d->valids[i].name, lower_bound(result->least + i));
    good = set(shown, "orbit", orbit) && good;
    good = set(shown, "period", jlt_certificate_ball(result->period, digits)) && good;
    good = set(shown, "determinant", jlt_certificate_ball(result->determinant, digits)) && good;
    good = set(shown, "determinant_of_matrix", jlt_certificate_ball(result->matrix_determinant, digits)) && good;
    good = set(shown, "trace", jlt_certificate_ball(result->trace, digits)) && good;
    good = set(shown, "multipliers", multipliers) && good;
    good = set(shown, "conditions", conditions) && good;
    good = set(shown, "claims", claims_of(given, kind)) && good;
    if (good) return shown;
    json_decref(shown);
    return NULL;
}

static jlt_certificate_report say(jlt_certificate_verdict verdict, const char *problem)
{
    jlt_certificate_report report = { .verdict = verdict };
    snprintf(report.problem, sizeof report.problem, "%s", problem);
    return report;
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
    default: return say(JLT_CERTIFICATE_FAILED, "the two determinants exclude each other, which is an error of this program");
    }
    if (strcmp(kind, "sink") == 0 && !result->sink)
        return say(JLT_CERTIFICATE_REFUSED, "the orbit is there, but not shown to attract: its multipliers are not all proved "
                                            "to be inside the unit circle");
    return say(JLT_CERTIFICATE_GOOD, "");
}

/* What follows from `given`, as an object `shown`; NULL where the report is not GOOD. */
static json_t *prove(jlt_certificate_report *report, const char *kind, const json_t *json, const jlt_descriptor *d)
{
    jlt_given given;
    jlt_cycle *cycle = NULL;
    jlt_cycle_result result;
    json_t *shown = NULL;
    bool has_result = false;

    *report = say(JLT_CERTIFICATE_MALFORMED, "");
    if (!jlt_given_read(&given, json, d, report->problem) || !jlt_given_read_box(&given, json, report->problem)) goto done;
    report->status = jlt_cycle_create(&cycle, &given.question);
    if (report->status == JLT_OK) {
        jlt_cycle_result_init(&result, cycle);
        has_result = true;
        report->status = jlt_cycle_prove(cycle, &result, given.box, given.instant, given.kept);
    }
    if (report->status != JLT_OK) {
        const jlt_status status = report->status;
        *report = say(JLT_CERTIFICATE_FAILED, jlt_status_text(status));
        report->status = status;
        goto done;
    }
    *report = judge(&result, kind);
    if (report->verdict != JLT_CERTIFICATE_GOOD) goto done;
    shown = shown_by(&result, &given, kind);
    if (shown == NULL) {
        *report = say(JLT_CERTIFICATE_FAILED, jlt_status_text(JLT_ERR_NOMEM));
        report->status = JLT_ERR_NOMEM;
    }
done:
    if (has_result) jlt_cycle_result_clear(&result);
    jlt_cycle_destroy(cycle);
    jlt_given_clear(&given);
    return shown;
}

/* Of all members but `digest`. */
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

static bool is_kind(const char *kind)
{
    return kind != NULL && (strcmp(kind, "sink") == 0 || strcmp(kind, "cycle") == 0);
}

json_t *jlt_certificate_make(jlt_certificate_report *report, const char *kind, json_t *given, const jlt_descriptor *own)
{
    const jlt_descriptor *d;
    json_t *shown = NULL, *certificate = NULL;
    char digest[65];

    *report = say(JLT_CERTIFICATE_MALFORMED, "");
    d = jlt_given_table(given, own, report->problem);
    if (d != NULL) shown = prove(report, kind, given, d);
    if (shown == NULL) return NULL;
    certificate = json_pack("{s:s,s:s,s:o,s:O,s:o}", "certificate", format_name, "kind", kind, "theorem",
                            jlt_theorem_words(kind, d, given, shown), "given", given, "shown", shown);
    if (certificate == NULL || !digest_of(digest, certificate) || !set(certificate, "digest", json_string(digest))) {
        *report = say(JLT_CERTIFICATE_FAILED, jlt_status_text(JLT_ERR_NOMEM));
        report->status = JLT_ERR_NOMEM;
        json_decref(certificate);
        certificate = NULL;
    }
    return certificate;
}

/* Everything said holds of everything recomputed: the same form, balls that contain balls, bounds below bounds, other text alike.
 * */
static bool covers(const json_t *said, const json_t *proved)
{
    const char *name;
    json_t *part;
    bool good = true;

    if (json_typeof(said) != json_typeof(proved)) return false;
    if (json_is_array(said)) {
        good = json_array_size(said) == json_array_size(proved);
        for (size_t i = 0; good && i < json_array_size(said); i++)
            good = covers(json_array_get(said, i), json_array_get(proved, i));
        return good;
    }
    if (!json_is_object(said)) return json_equal(said, proved);
    if (json_object_size(said) != json_object_size(proved)) return false;
    if (json_object_get(said, "middle") != NULL) {
        const slong bits = 64 + 4 * (slong)strlen(json_string_value(json_object_get(proved, "middle")));
        arb_t outer, inner;
        arb_init(outer);
        arb_init(inner);
        good = json_equal(said, proved)
               || (jlt_given_ball(outer, said, bits) && jlt_given_ball(inner, proved, bits) && arb_contains(outer, inner));
        arb_clear(outer);
        arb_clear(inner);
        return good;
    }
    json_object_foreach((json_t *)(uintptr_t)said, name, part) {
        const json_t *other = json_object_get(proved, name);
        good = good && other != NULL && covers(part, other);
    }
    return good;
}

void jlt_certificate_check(jlt_certificate_report *report, json_t *certificate, const jlt_descriptor *own)
{
    const char *form = json_string_value(json_object_get(certificate, "certificate"));
    const char *kind = json_string_value(json_object_get(certificate, "kind"));
    const char *digest = json_string_value(json_object_get(certificate, "digest"));
    const json_t *given = json_object_get(certificate, "given"), *said = json_object_get(certificate, "shown");
    const jlt_descriptor *d;
    json_t *proved = NULL, *words = NULL;
    char found[65];

    *report = say(JLT_CERTIFICATE_MALFORMED, "it is no certificate of this program's form");
    if (form == NULL || strcmp(form, format_name) != 0 || !is_kind(kind) || digest == NULL || !json_is_object(given)
        || !json_is_object(said))
        return;
    d = jlt_given_table(given, own, report->problem);
    if (d == NULL) return;
    *report = say(JLT_CERTIFICATE_REFUSED, "its digest is not that of its text: it was changed after it was made");
    if (!digest_of(found, certificate) || strcmp(found, digest) != 0) return;
    proved = prove(report, kind, given, d);
    if (proved == NULL) return;
    words = jlt_theorem_words(kind, d, given, said);
    if (!covers(said, proved))
        *report = say(JLT_CERTIFICATE_REFUSED, "what it says to be shown does not follow: the replay gives something else");
    else if (!json_equal(words, json_object_get(certificate, "theorem")))
        *report = say(JLT_CERTIFICATE_REFUSED, "its theorem is not what its numbers say");
    json_decref(proved);
    json_decref(words);
}
