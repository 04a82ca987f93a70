#include "base/options.h"

#include <stddef.h>

enum { OPTIONS_MAX = 128, FIRST = 256 };

typedef struct {
    struct argp_option options[OPTIONS_MAX + 1]; /* of the command and all its children */
    const char *values[OPTIONS_MAX];             /* as given; NULL: not yet */
    size_t count;
} options_seen;

static void collect(options_seen *self, const struct argp *parser)
{
    for (const struct argp_option *o = parser->options; o != NULL && (o->name != NULL || o->doc != NULL); o++) {
        if (o->name == NULL || self->count == OPTIONS_MAX) continue;
        self->options[self->count] = *o;
        /* Children may use the same keys; letters are one letter's option. */
        if (o->key >= FIRST || o->key <= 0) self->options[self->count].key = FIRST + (int)self->count;
        self->count++;
    }
    for (const struct argp_child *c = parser->children; c != NULL && c->argp != NULL; c++) collect(self, c->argp);
}

static error_t see(int key, char *value, struct argp_state *state)
{
    options_seen *self = state->input;

    if (key == ARGP_KEY_ARG) return 0;
    for (size_t i = 0; value != NULL && i < self->count; i++) {
        const struct argp_option *o = &self->options[i];
        if (o->key != key || (o->flags & TTC_OPTIONS_REPEATED) != 0) continue;
        if (self->values[i] != NULL)
            argp_failure(NULL, argp_err_exit_status, 0, "--%s is given twice, as '%s' and as '%s': leave one out", o->name,
                         self->values[i], value);
        self->values[i] = value;
    }
    return 0;
}

void ttc_options_parse(const struct argp *parser, int argc, char **argv, void *input)
{
    options_seen seen = { 0 };

    collect(&seen, parser);
    const struct argp flat = { seen.options, see, NULL, NULL, NULL, NULL, NULL };
    /* Other mistakes end this round without a word: the next one tells of them. */
    (void)argp_parse(&flat, argc, argv, ARGP_SILENT, NULL, &seen);
    argp_parse(parser, argc, argv, 0, NULL, input);
}
