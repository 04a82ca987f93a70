#include "scene/schema.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* Where results go; every command that computes rows knows these. */
#define OUTPUT_KEYS                                                                              \
    { "output", "output", JLT_KEY_TEXT }, { "plot", "plot", JLT_KEY_TEXT }, { "keep", "keep", JLT_KEY_TEXT }

static const jlt_key simulate_keys[] = {
    { "start", "start", JLT_KEY_GROUP },   { "times", "times", JLT_KEY_NUMBERS }, { "until", "until", JLT_KEY_NUMBER },
    { "every", "every", JLT_KEY_NUMBER },  { "track", "track", JLT_KEY_FLAG },    { "compare", "compare", JLT_KEY_TEXT },
    OUTPUT_KEYS,                           { NULL, NULL, JLT_KEY_TEXT },
};
static const jlt_key portrait_keys[] = {
    { "orbits", "orbits", JLT_KEY_COUNT }, { "until", "until", JLT_KEY_NUMBER }, OUTPUT_KEYS, { NULL, NULL, JLT_KEY_TEXT },
};
static const jlt_key rod_keys[] = {
    { "start", "start", JLT_KEY_GROUP }, OUTPUT_KEYS, { NULL, NULL, JLT_KEY_TEXT },
};
static const jlt_key section_keys[] = {
    { "start", "start", JLT_KEY_GROUP },   { "grid", "grid", JLT_KEY_RANGES },      { "returns", "returns", JLT_KEY_COUNT },
    { "direction", "direction", JLT_KEY_TEXT }, OUTPUT_KEYS,                        { NULL, NULL, JLT_KEY_TEXT },
};
static const jlt_key orbits_keys[] = {
    { "period", "period", JLT_KEY_COUNT }, { "grid", "grid", JLT_KEY_RANGES }, OUTPUT_KEYS, { NULL, NULL, JLT_KEY_TEXT },
};
static const jlt_key manifolds_keys[] = {
    { "start", "start", JLT_KEY_GROUP }, { "length", "length", JLT_KEY_NUMBER }, OUTPUT_KEYS, { NULL, NULL, JLT_KEY_TEXT },
};
static const jlt_key fates_keys[] = {
    { "grid", "grid", JLT_KEY_RANGES }, { "returns", "returns", JLT_KEY_COUNT }, { "direction", "direction", JLT_KEY_TEXT },
    OUTPUT_KEYS,                        { NULL, NULL, JLT_KEY_TEXT },
};
static const jlt_key verify_keys[] = {
    { "seed", "seed", JLT_KEY_SEED }, { "samples", "samples", JLT_KEY_COUNT }, { NULL, NULL, JLT_KEY_TEXT },
};
static const jlt_key eigen_keys[] = {
    { "at", "at", JLT_KEY_GROUP }, { "sweep", "sweep", JLT_KEY_RANGES }, OUTPUT_KEYS, { NULL, NULL, JLT_KEY_TEXT },
};

static const jlt_schema schemas[] = {
    { "simulate", simulate_keys, true, false, { "tolerance", "method", "tier", NULL }, true },
    { "portrait", portrait_keys, true, true, { "tolerance", "method", NULL }, false },
    { "rod", rod_keys, true, false, { "tolerance", NULL }, false },
    { "section", section_keys, true, true, { "tolerance", "method", NULL }, false },
    { "orbits", orbits_keys, true, true, { "tolerance", "method", NULL }, false },
    { "manifolds", manifolds_keys, true, true, { "tolerance", "method", NULL }, false },
    { "fates", fates_keys, true, true, { "tolerance", "method", NULL }, false },
    { "verify", verify_keys, false, false, { NULL }, true },
    { "eigen", eigen_keys, true, false, { NULL }, true },
};

static const jlt_key accuracy_keys[] = {
    { "tolerance", "tol", JLT_KEY_NUMBER }, { "method", "method", JLT_KEY_TEXT }, { "tier", "tier", JLT_KEY_TEXT },
};

enum { SCHEMAS = sizeof schemas / sizeof *schemas, ACCURACY = sizeof accuracy_keys / sizeof *accuracy_keys };

const jlt_schema *jlt_schema_find(const char *what)
{
    for (size_t i = 0; i < SCHEMAS; i++)
        if (strcmp(schemas[i].what, what) == 0) return &schemas[i];
    return NULL;
}

const jlt_key *jlt_schema_key(const jlt_schema *schema, const char *name)
{
    for (const jlt_key *key = schema->keys; key->key != NULL; key++)
        if (strcmp(key->key, name) == 0) return key;
    return NULL;
}

const jlt_key *jlt_schema_accuracy(const char *name)
{
    for (size_t i = 0; i < ACCURACY; i++)
        if (strcmp(accuracy_keys[i].key, name) == 0) return &accuracy_keys[i];
    return NULL;
}

static size_t add_name(char *out, size_t size, size_t used, const char *name)
{
    const int more = snprintf(out + used, size - used, used > 0 ? ", %s" : "%s", name);
    return more < 0 || used + (size_t)more >= size ? used : used + (size_t)more;
}

void jlt_schema_names(char *out, unsigned long size)
{
    size_t used = 0;

    *out = '\0';
    for (size_t i = 0; i < SCHEMAS; i++) used = add_name(out, size, used, schemas[i].what);
}

void jlt_schema_key_names(char *out, unsigned long size, const jlt_schema *schema)
{
    size_t used = add_name(out, size, 0, "what");

    for (const jlt_key *key = schema->keys; key->key != NULL; key++) used = add_name(out, size, used, key->key);
}
