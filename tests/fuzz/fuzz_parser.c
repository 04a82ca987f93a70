/* Any bytes as a table: no crash, no leak, bounded memory and time. What parses is printed, and its definitions parse
 * again to the very same nodes. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/model.h"
#include "show/print.h"
#include "show/show.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(bool holds, const char *what)
{
    if (holds) return;
    fprintf(stderr, "fuzz_parser: %s\n", what);
    abort();
}

/* The table with `let again_... = text of the last definition` added. */
static void definition_returns(const ttc_model *model, uint32_t symbol)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (stream == NULL) return;
    fprintf(stream, "%s\nlet printed_again = ", model->text);
    bool printable = ttc_print(stream, model, model->symbols[symbol].definition, TTC_NOTATION_TEXT);
    fputc('\n', stream);
    fclose(stream);
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    if (printable && size < (size_t)1 << 16 && diagnostics != NULL) {
        uint32_t again, original;
        ttc_model *twin = ttc_model_parse(text, size, "again", diagnostics);
        /* The text may be refused where the printed form goes beyond a limit that the parts kept. */
        if (twin != NULL && ttc_model_find_symbol(twin, "printed_again", &again) &&
            ttc_model_find_symbol(twin, model->symbols[symbol].name, &original))
            require(twin->symbols[again].definition == twin->symbols[original].definition, "a definition prints as another");
        ttc_model_destroy(twin);
    }
    ttc_diagnostics_destroy(diagnostics);
    free(text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    FILE *sink = fopen("/dev/null", "w");
    if (diagnostics == NULL || sink == NULL) goto done;
    ttc_model *model = ttc_model_parse((const char *)data, size, "input", diagnostics);
    require((model == NULL) == (ttc_error_count(diagnostics) > 0), "no model and no error, or both");
    ttc_diagnostics_print(diagnostics, sink);
    if (model != NULL) {
        ttc_show_text(sink, model);
        ttc_show_latex(sink, model);
        ttc_show_dot(sink, model);
        for (size_t i = model->symbol_count; i-- > 0;)
            if (model->symbols[i].kind == TTC_LET) {
                definition_returns(model, (uint32_t)i);
                break;
            }
        for (size_t i = 0; i < model->claim_count; i++)
            if (model->claims[i].expression != TTC_NONE) ttc_model_expand(model, model->claims[i].expression);
    }
    ttc_model_destroy(model);
done:
    if (sink != NULL) fclose(sink);
    ttc_diagnostics_destroy(diagnostics);
    return 0;
}
