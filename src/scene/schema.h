/** What a scene may say: the keys of every command it can ask for, and the kind of value each takes. */
#ifndef JLT_SCENE_SCHEMA_H
#define JLT_SCENE_SCHEMA_H

#include <stdbool.h>
#include <stddef.h>

typedef enum {
    JLT_KEY_NUMBER,  /* 0.51, 2, "1/3" */
    JLT_KEY_COUNT,   /* a whole number > 0 */
    JLT_KEY_SEED,    /* a whole number >= 0 */
    JLT_KEY_TEXT,
    JLT_KEY_FILE,    /* a text: where results go */
    JLT_KEY_FLAG,    /* true or false */
    JLT_KEY_NUMBERS, /* (0, 0.5, "1/3") -> 0,0.5,1/3 */
    JLT_KEY_GROUP,   /* { a = 1; b = 2; } -> a=1,b=2 */
    JLT_KEY_RANGES,  /* { a = 1; b = (-1, 1, 21); } -> a=1,b=-1:1:21 (first, last, how many); or a text such as "24x16" */
    JLT_KEY_INTERVAL /* { a = (0, 1); } -> a=0:1 */
} jlt_key_kind;

/** What may stand in a text or name a member of a group: words separated by '|', or one of these. NULL: anything. */
#define JLT_KEY_STATES "@states"           /* of the scene's model */
#define JLT_KEY_PARAMS "@params"
#define JLT_KEY_QUANTITIES "@quantities"   /* either */
#define JLT_KEY_METHODS "@methods"         /* of integration */
#define JLT_KEY_COORDINATES "@coordinates" /* of a section: of the known one, or the states */
#define JLT_KEY_LEVELS "@levels"           /* of the section that tables describe, or the model's integrals */
#define JLT_KEY_VALUES "@values"           /* parameters and levels */

typedef struct {
    const char *key;    /* in the scene */
    const char *option; /* on the command line, without dashes */
    jlt_key_kind kind;
    const char *allowed;
} jlt_key;

typedef struct {
    const char *what;
    const jlt_key *keys;     /* of its own; ends with a NULL key */
    bool parameters;         /* the scene's parameters apply */
    const char *levels;      /* names of the scene's levels that it knows, as `allowed`; NULL: none apply */
    const char *accuracy;    /* keys of the scene's accuracy that apply, separated by '|' */
    bool model;              /* takes the model as operand even where it is the default */
} jlt_schema;

/** NULL when no command of that name can be asked for. */
const jlt_schema *jlt_schema_find(const char *what);

const jlt_key *jlt_schema_key(const jlt_schema *schema, const char *name); /* NULL when unknown */

/** The keys of `accuracy`: tolerance, method, tier. NULL when unknown. */
const jlt_key *jlt_schema_accuracy(const char *name);

/** Whether `word` is one of the words in `list`, separated by '|'. */
bool jlt_schema_listed(const char *list, const char *word);

/** Names separated by commas, for messages; out has `size` bytes. */
void jlt_schema_names(char *out, size_t size);
void jlt_schema_key_names(char *out, size_t size, const jlt_schema *schema);

#endif
