#include "challenge/challenge.h"

#include "challenge/subject.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { DRAWS_A_POINT = 12, WIDE_DRAWS = 6, DRAWS_BEFORE_GIVING_UP = 120, POINTS_THAT_TELL = 16, DIGITS = 18 };

static const long precisions[] = { 192, 768, 3072 };

typedef struct {
    ttc_subject subject;
    ttc_random_point point;
    ttc_check check;
    bool violated, wants_witness, has_witness;
    double begun; /* processor time */
} trial;

/* "WHAT at NAME = VALUE ..." with all parameters and states of the point that was drawn, for free(). The probe is placed there
 * again, as a check may have moved it. */
static char *point_text(trial *t, const char *what)
{
    const bool there = t->check.is_at_target;
    const ttc_model *model = there ? t->check.target : t->check.model;
    ttc_probe *probe = there ? t->check.target_probe : t->check.probe;
    char *text = NULL, fault[256];
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (stream == NULL) return NULL;
    fprintf(stream, "%s at", what);
    if (there) fprintf(stream, " the point of %s with", model->name);
    else ttc_random_point_place(probe, &t->point, &t->subject.situation, ttc_probe_precision(probe), fault, sizeof fault);
    for (uint32_t i = 0; i < model->symbol_count; i++) {
        ttc_symbol_kind kind = model->symbols[i].kind;
        if ((kind != TTC_PARAM && kind != TTC_STATE) || !ttc_probe_is_set(probe, i)) continue;
        char *value = arb_get_str(ttc_probe_value(probe, i), DIGITS, 0);
        fprintf(stream, " %s = %s", model->symbols[i].name, value);
        flint_free(value);
    }
    if (fclose(stream) == 0) return text;
    free(text);
    return NULL;
}

/* Check one drawn point at rising precision. Returns UNDEFINED if it is no point of the domain, has no value, or is not decided. */
static ttc_check_outcome try_point(trial *t)
{
    char fault[256];
    for (size_t i = 0; i < sizeof precisions / sizeof *precisions; i++) {
        ttc_place_in_domain place = ttc_random_point_place(t->check.probe, &t->point, &t->subject.situation, precisions[i],
                                                           fault, sizeof fault);
        t->check.outcome = TTC_HOLDS;
        t->check.is_at_target = false;
        t->check.what[0] = '\0';
        if (fault[0] != '\0') ttc_check_violate(&t->check, "the family leaves the domain:", fault);
        else if (place == TTC_OUTSIDE) return TTC_UNDEFINED;
        else if (place == TTC_UNCLEAR) continue;
        else t->subject.checker(&t->check);
        if (t->check.outcome == TTC_HOLDS || t->check.outcome == TTC_VIOLATED) return t->check.outcome;
    }
    return TTC_UNDEFINED;
}

/* Draw until a point decides. Returns false if no draw did. */
static bool find_point(trial *t, bool special, size_t *barren, ttc_check_outcome *outcome)
{
    *outcome = TTC_UNDEFINED;
    for (int draw = 0; draw < DRAWS_A_POINT && *outcome == TTC_UNDEFINED && *barren < DRAWS_BEFORE_GIVING_UP; draw++) {
        const ttc_sample_range range = special ? TTC_SAMPLE_SPECIAL : draw < WIDE_DRAWS ? TTC_SAMPLE_WIDE : TTC_SAMPLE_MODERATE;
        if (!ttc_random_point_draw(&t->point, &t->subject.situation, &t->check.random, range)) {
            *barren = DRAWS_BEFORE_GIVING_UP;
            break;
        }
        *outcome = try_point(t);
        *barren = *outcome == TTC_UNDEFINED ? *barren + 1 : 0;
    }
    return *outcome != TTC_UNDEFINED;
}

static double processor_seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

static bool is_late(const trial *t, const ttc_challenge_extent *extent)
{
    return extent->seconds > 0 && processor_seconds() - t->begun > extent->seconds;
}

/* Try so many points; give up after too many draws in a row that decide nothing. Returns how many points decided. */
static size_t run(trial *t, const ttc_challenge_extent *extent, bool special, ttc_proof_status status)
{
    size_t barren = 0, tried = 0;
    for (size_t i = 0; i < extent->points && barren < DRAWS_BEFORE_GIVING_UP && !is_late(t, extent); i++) {
        ttc_check_outcome outcome;
        if (!find_point(t, special, &barren, &outcome)) continue;
        tried++;
        t->violated = t->violated || outcome == TTC_VIOLATED;
        t->wants_witness = t->wants_witness || t->check.wants_witness;
        if (outcome == TTC_HOLDS) t->has_witness = t->has_witness || t->check.has_witness;
        if (outcome == TTC_VIOLATED && status == TTC_PROVED) break;
    }
    return tried;
}

static void contradict(trial *t, ttc_challenge_result *result, const char *what)
{
    result->contradicted = true;
    result->text = point_text(t, what);
}

static void judge(trial *t, ttc_challenge_result *result)
{
    const bool many = result->tried >= POINTS_THAT_TELL;
    if (result->status == TTC_PROVED) {
        if (t->violated) contradict(t, result, t->check.what);
        else if (many && t->wants_witness && !t->has_witness)
            contradict(t, result, "proved, though it says nothing: all is zero, as");
    } else if (result->status == TTC_REFUTED && !t->violated) {
        if (t->subject.refuted_by_witness) {
            if (t->has_witness) contradict(t, result, "refuted, though the trace is not zero, as");
        } else if (many && t->subject.fails_on_open_set) {
            contradict(t, result, "refuted, though it holds at every point that was tried, as");
        } else {
            result->doubtful = many;
        }
    }
}

bool ttc_challenge_proof(const ttc_model *model, const ttc_proof *proof, ttc_resolver resolver, void *context,
                         const ttc_challenge_extent *extent, ttc_challenge_result *result)
{
    trial t = { .check = { .model = model }, .begun = processor_seconds() };
    ttc_diagnostics *diagnostics = NULL;
    ttc_model *target = NULL;
    bool ok = false;
    *result = (ttc_challenge_result){ .kind = proof->kind, .name = proof->name, .place = proof->place, .status = proof->status };
    if (proof->status != TTC_PROVED && proof->status != TTC_REFUTED) return true;
    if (!ttc_subject_find(&t.subject, model, result->kind, result->name, result->place)) return true;
    t.check.claim = t.subject.claim;
    t.check.index = t.subject.index;
    t.check.has_smooth_density = proof->has_smooth_density;
    t.check.random.state = extent->seed;
    t.check.probe = ttc_probe_create(model);
    if (t.check.probe == NULL || !ttc_random_point_init(&t.point, &t.subject.situation)) goto done;
    if (t.subject.claim != NULL && t.subject.claim->target != NULL && resolver != NULL) {
        diagnostics = ttc_diagnostics_create();
        if (diagnostics == NULL) goto done;
        target = resolver(context, model, t.subject.claim->target, diagnostics);
        t.check.target = target;
        t.check.target_probe = target != NULL ? ttc_probe_create(target) : NULL;
        if (target != NULL && t.check.target_probe == NULL) goto done;
    }
    result->tried = run(&t, extent, false, result->status);
    if (!t.violated || result->status != TTC_PROVED) {
        result->skipped = extent->points - result->tried;
        result->special = run(&t, extent, true, result->status);
    }
    result->violated = t.violated;
    judge(&t, result);
    ok = true;
done:
    ttc_probe_destroy(t.check.target_probe);
    ttc_model_destroy(target);
    ttc_diagnostics_destroy(diagnostics);
    ttc_random_point_clear(&t.point);
    ttc_probe_destroy(t.check.probe);
    return ok;
}

bool ttc_challenge(const ttc_model *model, const ttc_proof_report *proofs, ttc_resolver resolver, void *context,
                   const ttc_challenge_extent *extent, ttc_challenge_report **report)
{
    *report = NULL;
    ttc_challenge_report *made = calloc(1, sizeof *made);
    if (made == NULL) return false;
    made->results = calloc(proofs->proof_count + 1, sizeof *made->results);
    bool ok = made->results != NULL;
    for (size_t i = 0; ok && i < proofs->proof_count; i++) {
        ttc_challenge_extent own = *extent;
        ttc_challenge_result *result = &made->results[made->count];
        own.seed += UINT64_C(0x100000001b3) * (i + 1);
        ok = ttc_challenge_proof(model, &proofs->proofs[i], resolver, context, &own, result);
        if (!ok || result->tried + result->special + result->skipped == 0) continue;
        made->count++;
        made->tried += result->tried;
        made->special += result->special;
        made->skipped += result->skipped;
        made->contradictions += result->contradicted;
    }
    if (ok) *report = made;
    else ttc_challenge_report_destroy(made);
    return ok;
}

void ttc_challenge_report_destroy(ttc_challenge_report *report)
{
    if (report == NULL) return;
    for (size_t i = 0; i < report->count; i++) free(report->results[i].text);
    free(report->results);
    free(report);
}
