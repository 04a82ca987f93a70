/** For tests of the prover: takes tables as text, and checks verdicts. */
#ifndef TEST_PROVE_TEXT_H
#define TEST_PROVE_TEXT_H

#include <dirent.h>
#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "prove/prove.h"

static inline ttc_model *parse_text(const char *text)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(text, strlen(text), JLT_SOURCE_DIR "/codegen/models/test.tt", diagnostics);
    if (model == NULL) ttc_diagnostics_print(diagnostics, stderr);
    ttc_diagnostics_destroy(diagnostics);
    assert_non_null(model);
    return model;
}

/* Check the verdict on the claim of this kind and name in a table. reason: a phrase that its remainder, point or note must contain;
 * NULL: any. */
static inline void expect(const char *text, const char *kind, const char *name, ttc_proof_status status, const char *reason)
{
    ttc_proof_report *report = NULL;
    bool found = false;
    ttc_model *model = parse_text(text);
    assert_true(ttc_prove(model, ttc_resolve_beside, NULL, TTC_PROVE_ALL, &report));
    for (size_t i = 0; i < report->proof_count; i++) {
        const ttc_proof *proof = &report->proofs[i];
        if (strcmp(proof->kind, kind) != 0 || strcmp(proof->name, name) != 0) continue;
        found = true;
        const char *words[] = { proof->remainder, proof->point, proof->note };
        bool explained = reason == NULL;
        for (size_t k = 0; k < 3; k++) explained |= words[k] != NULL && reason != NULL && strstr(words[k], reason) != NULL;
        if (proof->status != status || !explained)
            print_error("%s %s: %s (expected %s): %s\n", kind, name, ttc_proof_status_name(proof->status),
                        ttc_proof_status_name(status), proof->remainder != NULL ? proof->remainder : "");
        assert_int_equal(proof->status, status);
        assert_true(explained);
    }
    assert_true(found);
    ttc_proof_report_destroy(report);
    ttc_model_destroy(model);
}

/* Call check(path) for all tables of a folder, at least four. Returns the sum of its results. */
static inline size_t check_tables(const char *folder, size_t (*check)(const char *path))
{
    size_t sum = 0, tables = 0;
    char path[4096];
    DIR *directory = opendir(folder);
    assert_non_null(directory);
    for (struct dirent *entry = readdir(directory); entry != NULL; entry = readdir(directory)) {
        const char *dot = strrchr(entry->d_name, '.');
        if (dot == NULL || strcmp(dot, ".tt") != 0) continue;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        sum += check(path);
        tables++;
    }
    closedir(directory);
    assert_true(tables >= 4);
    return sum;
}

#endif
