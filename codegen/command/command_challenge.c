#include "command/command_challenge.h"

#include "base/text.h"
#include "challenge/challenge.h"

#include <stdio.h>

/* What a reader must notice: contradictions, doubts, and claims for which no point was found. */
static const char *remark(const ttc_challenge_result *result)
{
    if (result->contradicted) return ", CONTRADICTED";
    if (result->doubtful) return ", no point shows why";
    return result->tried + result->special == 0 ? ", no point found" : "";
}

static void print_text(const ttc_model *model, const ttc_challenge_report *report)
{
    for (size_t i = 0; i < report->count; i++) {
        const ttc_challenge_result *result = &report->results[i];
        printf("challenged %-8s %-11s %s: %zu point%s, %zu special, %zu skipped%s\n", ttc_proof_status_name(result->status),
               result->kind, result->name, result->tried, ttc_text_plural(result->tried), result->special, result->skipped,
               remark(result));
    }
    printf("%s: %zu verdict%s challenged at %zu point%s and %zu special ones, %zu skipped: %zu contradicted\n", model->name,
           report->count, ttc_text_plural(report->count), report->tried, ttc_text_plural(report->tried), report->special,
           report->skipped, report->contradictions);
}

static void put_json(json_t *shown, const ttc_challenge_report *report)
{
    json_t *results = json_array();
    for (size_t i = 0; i < report->count; i++) {
        const ttc_challenge_result *result = &report->results[i];
        json_array_append_new(results, json_pack("{s:s, s:s, s:I, s:I, s:I, s:b, s:b, s:s?}", "name", result->name, "kind",
                                                 result->kind, "tried", (json_int_t)result->tried, "special",
                                                 (json_int_t)result->special, "skipped", (json_int_t)result->skipped,
                                                 "contradicted", (int)result->contradicted, "doubtful",
                                                 (int)result->doubtful, "point", result->text));
    }
    json_object_set_new(shown, "challenge",
                        json_pack("{s:o, s:{s:I, s:I, s:I, s:I, s:I}}", "claims", results, "totals", "claims",
                                  (json_int_t)report->count, "tried", (json_int_t)report->tried, "special",
                                  (json_int_t)report->special, "skipped", (json_int_t)report->skipped, "contradicted",
                                  (json_int_t)report->contradictions));
}

static void complain(const ttc_model *model, const ttc_challenge_report *report)
{
    for (size_t i = 0; i < report->count; i++) {
        const ttc_challenge_result *result = &report->results[i];
        if (result->contradicted)
            fprintf(stderr, "%s:%u:%u: internal error: the %s claim '%s' is %s, and a point contradicts it: %s\n", model->file,
                    (unsigned)result->place.line, (unsigned)result->place.column, result->kind, result->name,
                    ttc_proof_status_name(result->status), result->text != NULL ? result->text : "the point could not be stored");
    }
}

int ttc_command_challenge(const ttc_model *model, const ttc_proof_report *proofs, const ttc_options *options, json_t *shown)
{
    ttc_challenge_report *report = NULL;
    const ttc_challenge_extent extent = { .points = options->challenge, .seed = options->seed };
    if (!ttc_challenge(model, proofs, ttc_resolve_beside, NULL, &extent, &report)) {
        fprintf(stderr, "ttc: out of memory while challenging %s\n", model->file);
        return TTC_EXIT_MEMORY;
    }
    if (shown != NULL) put_json(shown, report);
    else print_text(model, report);
    complain(model, report);
    int status = report->contradictions > 0 ? TTC_EXIT_INTERNAL : TTC_EXIT_DONE;
    ttc_challenge_report_destroy(report);
    return status;
}
