#include "validated/judge.h"

#include <stdio.h>
#include <string.h>

jlt_certificate_report jlt_judge_say(jlt_certificate_verdict verdict, const char *problem)
{
    jlt_certificate_report report = { .verdict = verdict };
    snprintf(report.problem, sizeof report.problem, "%s", problem);
    return report;
}

static jlt_certificate_report good(void) { return jlt_judge_say(JLT_CERTIFICATE_GOOD, ""); }

static jlt_certificate_report refused(const char *problem) { return jlt_judge_say(JLT_CERTIFICATE_REFUSED, problem); }

/* What cannot be unless this program is wrong. */
static jlt_certificate_report broken(const char *problem)
{
    jlt_certificate_report report = { .verdict = JLT_CERTIFICATE_FAILED };
    snprintf(report.problem, sizeof report.problem, "%s, which is an error of this program", problem);
    return report;
}

jlt_certificate_report jlt_judge_failure(jlt_status status)
{
    return jlt_judge_say(JLT_CERTIFICATE_FAILED, jlt_status_text(status));
}

jlt_certificate_report jlt_judge_failure_along(jlt_status status)
{
    switch (status) {
    case JLT_ERR_DOMAIN:
        return refused("the orbit is not shown to stay in the domain of its table (where it does, try another radius, or more "
                       "digits)");
    case JLT_ERR_NO_CONVERGENCE:
        return refused("a leg of the orbit is not shown to end at one crossing of the section, in its direction (where it does, "
                       "try another radius, or more digits)");
    default: return jlt_judge_failure(status);
    }
}

static const char still[] = "a leg of the orbit is not shown to take time: it may end where it begins (its instant is to lie near "
                            "the next crossing)";

jlt_certificate_report jlt_judge_boxes(const json_t *legs, const jlt_given *given, arb_srcptr y)
{
    return jlt_given_legs_hold(legs, &given->question, y)
               ? good()
               : refused("the orbit is there, but not shown to lie in its boxes as they are written (try another radius)");
}

jlt_certificate_report jlt_judge_cycle(const jlt_cycle_result *result, const char *kind)
{
    switch (result->verdict) {
    case JLT_CYCLE_PROVED: break;
    case JLT_CYCLE_UNSHOWN:
        return refused("Krawczyk's operator does not map the box into itself: no orbit is shown to be there (try another radius, "
                       "or more digits)");
    case JLT_CYCLE_OPEN:
        return refused("the integrals do not determine the states left out, so that the orbit need not close");
    case JLT_CYCLE_STILL: return refused(still);
    default: return broken("the two determinants exclude each other");
    }
    if (strcmp(kind, "sink") == 0 && !result->sink)
        return refused("the orbit is there, but not shown to attract: its multipliers are not all proved to be inside the unit "
                       "circle");
    if (strcmp(kind, "obstruction") == 0 && arb_contains_si(result->determinant, 1))
        return refused("the orbit is there, but its determinant may be 1: it excludes no measure");
    return good();
}

jlt_certificate_report jlt_judge_symmetry(const jlt_symmetry_result *result)
{
    switch (result->verdict) {
    case JLT_SYMMETRY_PROVED: return good();
    case JLT_SYMMETRY_NO_REVERSOR:
        return refused("the orbit is there, but no reversor of the table that is proved without a condition maps the section and "
                       "the levels to themselves");
    default: return refused("the orbit is there, but not shown to be its own mirror image");
    }
}

jlt_certificate_report jlt_judge_elliptic(const jlt_elliptic_result *result, const arb_t trace)
{
    jlt_certificate_report report;

    switch (result->verdict) {
    case JLT_ELLIPTIC_PROVED: return good();
    case JLT_ELLIPTIC_OTHER:
        report = refused("");
        snprintf(report.problem, sizeof report.problem,
                 "the orbit is its own mirror image, but not shown to be elliptic: its trace is %.17g",
                 arf_get_d(arb_midref(trace), ARF_RND_NEAR));
        return report;
    case JLT_ELLIPTIC_RESONANT:
        return refused("the orbit is elliptic, but its trace may be 0 or -1: a resonance of order 4 or 3");
    case JLT_ELLIPTIC_UNTWISTED:
        return refused("the orbit is elliptic, but its twist may be 0 (try more digits, or intervals that are less wide)");
    default: return broken("two enclosures of one number exclude each other");
    }
}

jlt_certificate_report jlt_judge_homoclinic(const jlt_homoclinic_result *result)
{
    static const char *const reasons[] = {
        [JLT_HOMOCLINIC_NO_SADDLE] = "no saddle is shown to be in the box",
        [JLT_HOMOCLINIC_ASYMMETRIC] = "the saddle, or the section, is not shown to be its own mirror image under a proved reversor "
                                      "that flips one coordinate",
        [JLT_HOMOCLINIC_NO_CONE] = "the cone is not mapped into itself (try a smaller distance)",
        [JLT_HOMOCLINIC_UNSHOWN] = "Krawczyk's operator does not map the boxes into themselves: no homoclinic orbit is shown to be "
                                   "there (try a smaller distance, or more digits)",
        [JLT_HOMOCLINIC_STILL] = still,
        [JLT_HOMOCLINIC_OPEN] = "the orbit is not shown to begin on the unstable manifold, or its legs to meet",
        [JLT_HOMOCLINIC_TANGENT] = "the orbit is there, but the manifolds may be tangent",
    };

    if (result->verdict == JLT_HOMOCLINIC_PROVED) return good();
    if (result->verdict == JLT_HOMOCLINIC_CONTRADICTED)
        return broken("enclosures of one orbit exclude each other");
    return refused(reasons[result->verdict]);
}
