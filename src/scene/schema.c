#include "scene/schema.h"

#include <argp.h>
#include <stdio.h>
#include <string.h>

/* Keys that are spelled differently from their options. */
static const struct {
    const char *key, *option;
} spelled[] = { { "parameters", "set" }, { "levels", "level" }, { "tolerance", "tol" } };

/* The kind of a value by the name of the option's argument in --help. Arguments not listed here are texts, unless they have '=' or
 * '|'. */
static const struct {
    const char *argument;
    jlt_key_kind kind;
    unsigned names;
} arguments[] = {
    { "FILE", JLT_KEY_FILE, JLT_NAMES_ANY },
    { "METHOD", JLT_KEY_TEXT, JLT_NAMES_METHODS },
    { "N", JLT_KEY_COUNT, JLT_NAMES_ANY },
    { "N|0", JLT_KEY_WHOLE, JLT_NAMES_ANY },
    { "VALUE", JLT_KEY_NUMBER, JLT_NAMES_ANY },
    { "DISTANCE", JLT_KEY_NUMBER, JLT_NAMES_ANY },
    { "T", JLT_KEY_NUMBER, JLT_NAMES_ANY },
    { "DT", JLT_KEY_NUMBER, JLT_NAMES_ANY },
    { "T,T,...", JLT_KEY_NUMBERS, JLT_NAMES_ANY },
    { "PARAM=VALUE,...", JLT_KEY_GROUP, JLT_NAMES_PARAMS },
    { "LEVEL=VALUE,...", JLT_KEY_GROUP, JLT_NAMES_LEVELS },
    { "STATE=VALUE,...", JLT_KEY_GROUP, JLT_NAMES_STATES },
    { "STATE=VALUE|NAME", JLT_KEY_POINT, JLT_NAMES_STATES },
    { "STATE=GUESS,...", JLT_KEY_POINT, JLT_NAMES_STATES },
    { "STATE=PERIOD,...", JLT_KEY_POINT, JLT_NAMES_STATES },
    { "NAME=VALUE,...", JLT_KEY_POINT, JLT_NAMES_COORDINATES },
    { "NAME=LOW:HIGH:COUNT", JLT_KEY_RANGES, JLT_NAMES_COORDINATES },
    { "COUNTxCOUNT", JLT_KEY_RANGES, JLT_NAMES_COORDINATES },
    { "PARAM|LEVEL=LOW:HIGH", JLT_KEY_INTERVAL, JLT_NAMES_PARAMS | JLT_NAMES_LEVELS },
    { "PARAM|LEVEL=LOW:HIGH:COUNT,...", JLT_KEY_RANGES, JLT_NAMES_PARAMS | JLT_NAMES_LEVELS },
    { "STATE|PARAM=LOW:HIGH:COUNT,...", JLT_KEY_RANGES, JLT_NAMES_STATES | JLT_NAMES_PARAMS },
};

static const struct argp_option *find(const struct argp *options, const char *name)
{
    const struct argp_option *found = NULL;

    for (const struct argp_option *o = options->options; o != NULL && (o->name != NULL || o->doc != NULL); o++)
        if (o->name != NULL && (o->flags & OPTION_HIDDEN) == 0 && strcmp(o->name, name) == 0) return o;
    for (const struct argp_child *c = options->children; found == NULL && c != NULL && c->argp != NULL; c++)
        found = find(c->argp, name);
    return found;
}

static const char *key_of(const char *option)
{
    for (size_t i = 0; i < sizeof spelled / sizeof *spelled; i++)
        if (strcmp(spelled[i].option, option) == 0) return spelled[i].key;
    return option;
}

bool jlt_schema_key(jlt_key *key, const struct argp *options, const char *name)
{
    const struct argp_option *option;
    const char *sought = name;
    size_t k = 0;

    for (size_t i = 0; i < sizeof spelled / sizeof *spelled; i++)
        if (strcmp(spelled[i].key, name) == 0) sought = spelled[i].option;
    option = find(options, sought);
    if (option == NULL || strcmp(key_of(option->name), name) != 0) return false;
    *key = (jlt_key){ .key = key_of(option->name), .option = option->name };
    if (option->arg == NULL) {
        key->kind = JLT_KEY_FLAG;
        return true;
    }
    while (k < sizeof arguments / sizeof *arguments && strcmp(arguments[k].argument, option->arg) != 0) k++;
    if (k < sizeof arguments / sizeof *arguments) {
        key->kind = arguments[k].kind;
        key->names = arguments[k].names;
    } else if (strchr(option->arg, '=') != NULL) { /* E=VALUE,G=VALUE */
        key->kind = JLT_KEY_GROUP;
        key->words = option->arg;
    } else if (strchr(option->arg, '|') != NULL) key->words = option->arg; /* up|down|both */
    return true;
}

void jlt_schema_add_name(char *out, size_t size, const char *name)
{
    const size_t used = strlen(out);

    if (used + strlen(name) + 3 <= size) snprintf(out + used, size - used, used > 0 ? ", %s" : "%s", name);
}

void jlt_schema_key_names(char *out, size_t size, const struct argp *options)
{
    for (const struct argp_option *o = options->options; o != NULL && (o->name != NULL || o->doc != NULL); o++)
        if (o->name != NULL && (o->flags & OPTION_HIDDEN) == 0) jlt_schema_add_name(out, size, key_of(o->name));
    for (const struct argp_child *c = options->children; c != NULL && c->argp != NULL; c++)
        jlt_schema_key_names(out, size, c->argp);
}
