#include "scene/schema.h"

#include <stdio.h>
#include <string.h>

#include "top/balanced.h"

/* A key that is spelled as its option. */
#define KEY(name, kind, allowed) { name, name, JLT_KEY_##kind, allowed }
#define LAST { NULL, NULL, JLT_KEY_TEXT, NULL }
/* Where results go. */
#define OUTPUT                                                                                                           \
    KEY("output", FILE, NULL), KEY("plot", FILE, NULL), KEY("keep", FILE, NULL), KEY("size", TEXT, NULL),                \
        KEY("font", TEXT, NULL), KEY("xrange", TEXT, NULL), KEY("yrange", TEXT, NULL), KEY("title", TEXT, NULL), KEY("style", TEXT, NULL)
/* Of pictures whose axes are a choice. */
#define AXES KEY("axes", TEXT, NULL)
/* Which section: that which tables describe of the model, or one of its table's states. */
#define SECTION_OPTIONS                                                                                                  \
    KEY("section", GROUP, JLT_KEY_STATES), KEY("solve", GROUP, JLT_KEY_STATES), KEY("modulo", GROUP, JLT_KEY_STATES),    \
        { "levels", "level", JLT_KEY_GROUP, JLT_KEY_LEVELS }, KEY("mirror", TEXT, NULL), KEY("direction", TEXT, "up|down|both"), KEY("contact", TEXT, "ignore|report|end"), OUTPUT

static const jlt_key simulate_keys[] = {
    KEY("start", GROUP, JLT_KEY_STATES), KEY("times", NUMBERS, NULL), KEY("until", NUMBER, NULL),
    KEY("every", NUMBER, NULL), KEY("compare", TEXT, NULL), KEY("track", FLAG, NULL), KEY("project", FLAG, NULL),
    OUTPUT, AXES, LAST,
};
static const jlt_key portrait_keys[] = {
    KEY("start", GROUP, JLT_KEY_STATES), KEY("orbits", COUNT, NULL), KEY("until", NUMBER, NULL),
    KEY("trajectories", FILE, NULL), OUTPUT, LAST,
};
static const jlt_key rod_keys[] = {
    KEY("start", GROUP, JLT_KEY_STATES), KEY("sweep", RANGES, JLT_KEY_QUANTITIES), KEY("check", FLAG, NULL), OUTPUT, LAST,
};
static const jlt_key section_keys[] = {
    KEY("start", GROUP, JLT_KEY_COORDINATES), KEY("grid", RANGES, JLT_KEY_COORDINATES), KEY("returns", COUNT, NULL),
    KEY("skip", SEED, NULL), KEY("backward", FLAG, NULL), KEY("check", FLAG, NULL), KEY("batch", FLAG, NULL), KEY("threads", COUNT, NULL),
    KEY("project", FLAG, NULL), SECTION_OPTIONS, AXES, LAST,
};
static const jlt_key orbits_keys[] = {
    KEY("period", COUNT, NULL), KEY("grid", RANGES, JLT_KEY_COORDINATES), KEY("near", NUMBER, NULL),
    KEY("settle", SEED, NULL), KEY("samples", SEED, NULL), KEY("start", GROUP, JLT_KEY_COORDINATES), SECTION_OPTIONS, AXES, LAST,
};
static const jlt_key manifolds_keys[] = {
    KEY("start", GROUP, JLT_KEY_COORDINATES), KEY("period", COUNT, NULL), KEY("length", NUMBER, NULL),
    KEY("spacing", NUMBER, NULL), KEY("turn", NUMBER, NULL), KEY("count", COUNT, NULL), KEY("seed", NUMBER, NULL),
    KEY("crossings", FILE, NULL), KEY("no-crossings", FLAG, NULL), SECTION_OPTIONS, LAST,
};
static const jlt_key fates_keys[] = {
    KEY("start", GROUP, JLT_KEY_COORDINATES), KEY("grid", RANGES, JLT_KEY_COORDINATES), KEY("returns", COUNT, NULL),
    KEY("sweep", RANGES, JLT_KEY_VALUES), SECTION_OPTIONS, AXES, LAST,
};
static const jlt_key continue_keys[] = {
    KEY("along", INTERVAL, JLT_KEY_VALUES), KEY("start", GROUP, JLT_KEY_COORDINATES), KEY("period", COUNT, NULL),
    KEY("step", NUMBER, NULL), KEY("count", COUNT, NULL), KEY("decreasing", FLAG, NULL), KEY("branches", FLAG, NULL),
    SECTION_OPTIONS, AXES, LAST,
};
static const jlt_key lyapunov_keys[] = {
    KEY("start", GROUP, JLT_KEY_COORDINATES), KEY("grid", RANGES, JLT_KEY_COORDINATES), KEY("returns", COUNT, NULL),
    KEY("skip", SEED, NULL), SECTION_OPTIONS, AXES, LAST,
};
static const jlt_key separation_keys[] = {
    KEY("grid", RANGES, JLT_KEY_COORDINATES), KEY("cells", RANGES, JLT_KEY_COORDINATES), KEY("returns", COUNT, NULL),
    KEY("settle", SEED, NULL), SECTION_OPTIONS, LAST,
};
static const jlt_key verify_keys[] = { KEY("seed", SEED, NULL), KEY("samples", COUNT, NULL), LAST };
static const jlt_key eigen_keys[] = {
    KEY("at", GROUP, JLT_KEY_STATES), KEY("sweep", RANGES, JLT_KEY_QUANTITIES), OUTPUT, LAST,
};

static const jlt_schema schemas[] = {
    { "simulate", simulate_keys, true, NULL, "tolerance|method|tier", true },
    { "portrait", portrait_keys, true, jlt_balanced_level_names, "tolerance|method", false },
    { "rod", rod_keys, true, NULL, "", false },
    { "section", section_keys, true, JLT_KEY_LEVELS, "tolerance|method", false },
    { "orbits", orbits_keys, true, JLT_KEY_LEVELS, "tolerance|method", false },
    { "manifolds", manifolds_keys, true, JLT_KEY_LEVELS, "tolerance|method", false },
    { "fates", fates_keys, true, JLT_KEY_LEVELS, "tolerance|method", false },
    { "continue", continue_keys, true, JLT_KEY_LEVELS, "tolerance|method", false },
    { "lyapunov", lyapunov_keys, true, JLT_KEY_LEVELS, "tolerance|method", false },
    { "separation", separation_keys, true, JLT_KEY_LEVELS, "tolerance|method", false },
    { "verify", verify_keys, false, NULL, "", true },
    { "eigen", eigen_keys, true, NULL, "", true },
};

static const jlt_key accuracy_keys[] = {
    { "tolerance", "tol", JLT_KEY_NUMBER, NULL },
    { "method", "method", JLT_KEY_TEXT, JLT_KEY_METHODS },
    { "tier", "tier", JLT_KEY_TEXT, NULL },
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

bool jlt_schema_listed(const char *list, const char *word)
{
    const size_t length = strlen(word);

    for (const char *at = list; *at != '\0'; at += at[strcspn(at, "|")] == '|' ? strcspn(at, "|") + 1 : strcspn(at, "|"))
        if (strcspn(at, "|") == length && strncmp(at, word, length) == 0) return true;
    return false;
}

static size_t add_name(char *out, size_t size, size_t used, const char *name)
{
    const int more = snprintf(out + used, size - used, used > 0 ? ", %s" : "%s", name);
    return more < 0 || used + (size_t)more >= size ? used : used + (size_t)more;
}

void jlt_schema_names(char *out, size_t size)
{
    size_t used = 0;

    *out = '\0';
    for (size_t i = 0; i < SCHEMAS; i++) used = add_name(out, size, used, schemas[i].what);
}

void jlt_schema_key_names(char *out, size_t size, const jlt_schema *schema)
{
    size_t used = add_name(out, size, 0, "what");

    for (const jlt_key *key = schema->keys; key->key != NULL; key++) used = add_name(out, size, used, key->key);
}
