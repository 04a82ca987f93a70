#include "base/options.h"

#include "base/text.h"

#include <string.h>

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

/* The known name that a mistyped one resembles; NULL: none does, or the name is that of an option or the beginning of one. */
static const char *meant(const options_seen *self, const char *name, size_t length)
{
    const char *near = NULL;

    for (size_t i = 0; i < self->count; i++) {
        const char *known = self->options[i].name;
        if (strncmp(known, name, length) == 0) return NULL;
        if (near == NULL && ttc_text_resembles(known, strlen(known), name, length)) near = known;
    }
    return near;
}

/* End the program at the first unknown option that resembles a known one. */
static void stop_at_unknown(const options_seen *self, int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        const char *name = argv[i] + 2;
        const size_t length = strncmp(argv[i], "--", 2) == 0 ? strcspn(name, "=") : 0;
        const char *near = length > 0 ? meant(self, name, length) : NULL;
        if (near != NULL)
            argp_failure(NULL, argp_err_exit_status, 0, "unrecognized option '--%.*s'; did you mean '--%s'?", (int)length, name,
                         near);
    }
}

void ttc_options_parse(const struct argp *parser, int argc, char **argv, void *input)
{
    options_seen seen = { 0 };

    collect(&seen, parser);
    const struct argp flat = { seen.options, see, NULL, NULL, NULL, NULL, NULL };
    /* This first pass reports repeated options alone; the second one below reports all other mistakes. */
    if (argp_parse(&flat, argc, argv, ARGP_SILENT, NULL, &seen) != 0) stop_at_unknown(&seen, argc, argv);
    argp_parse(parser, argc, argv, 0, NULL, input);
}
