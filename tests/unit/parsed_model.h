/** Parses models from text, and checks the text of their expressions. */
#ifndef TEST_PARSED_MODEL_H
#define TEST_PARSED_MODEL_H

#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "read/model.h"
#include "show/print.h"

static inline ttc_model *parse(const char *text)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    assert_non_null(diagnostics);
    ttc_model *model = ttc_model_parse(text, strlen(text), "t.tt", diagnostics);
    if (model == NULL) ttc_diagnostics_print(diagnostics, stderr);
    ttc_diagnostics_destroy(diagnostics);
    assert_non_null(model);
    return model;
}

static inline void prints(const ttc_model *model, ttc_id id, const char *expected)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    assert_non_null(stream);
    assert_true(ttc_print(stream, model, id, TTC_NOTATION_TEXT));
    fclose(stream);
    assert_string_equal(text, expected);
    free(text);
}

static inline uint32_t symbol(const ttc_model *model, const char *name)
{
    uint32_t found;
    assert_true(ttc_model_find_symbol(model, name, &found));
    return found;
}

/* Check that `head` followed by `line` is not a table, and that a message contains these words. */
static inline void refuses(const char *head, const char *line, const char *words)
{
    char text[2000];
    bool told = false;
    snprintf(text, sizeof text, "%s%s\n", head, line);
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_parse(text, strlen(text), "t.tt", diagnostics);
    for (size_t i = 0; i < ttc_diagnostics_size(diagnostics); i++)
        told |= strstr(ttc_diagnostics_at(diagnostics, i).message, words) != NULL;
    if (model != NULL || !told) print_error("'%s' is not refused with '%s'\n", line, words);
    assert_null(model);
    assert_true(told);
    ttc_diagnostics_destroy(diagnostics);
}

#endif
