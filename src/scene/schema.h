/** The keys that an entry of a scene may have: the options of its command, taken from its argp tables. The name of an option's
 *  argument in --help decides what kind of value the key takes. */
#ifndef JLT_SCENE_SCHEMA_H
#define JLT_SCENE_SCHEMA_H

#include <stdbool.h>
#include <stddef.h>

struct argp;

typedef enum {
    JLT_KEY_TEXT,
    JLT_KEY_FILE,    /* a text: where results go */
    JLT_KEY_FLAG,    /* true or false */
    JLT_KEY_NUMBER,  /* 0.51, 2, "1/3" */
    JLT_KEY_COUNT,   /* a whole number > 0 */
    JLT_KEY_WHOLE,   /* a whole number >= 0 */
    JLT_KEY_NUMBERS, /* (0, 0.5, "1/3") -> 0,0.5,1/3 */
    JLT_KEY_GROUP,   /* { a = 1; b = 2; } -> a=1,b=2 */
    JLT_KEY_POINT,   /* the same, with multiples of pi: { a = "2*pi/3"; } -> a=2*pi/3; of coordinates also the name of a start */
    JLT_KEY_RANGES,  /* { a = 1; b = (-1, 1, 21); } -> a=1,b=-1:1:21 (first, last, count); or a text such as "24x16" */
    JLT_KEY_INTERVAL /* { a = (0, 1); } -> a=0:1 */
} jlt_key_kind;

/** Which names a text may be, or the members of a group may have. */
typedef enum {
    JLT_NAMES_ANY = 0,
    JLT_NAMES_STATES = 1,      /* of the scene's model */
    JLT_NAMES_PARAMS = 2,
    JLT_NAMES_LEVELS = 4,      /* of the section that tables describe; on a plane section, the model's integrals */
    JLT_NAMES_COORDINATES = 8, /* of the section that tables describe; on a plane section, the states that are not fixed */
    JLT_NAMES_METHODS = 16     /* of integration */
} jlt_names;

typedef struct {
    const char *key;    /* in the scene */
    const char *option; /* on the command line, without dashes */
    jlt_key_kind kind;
    unsigned names;     /* several of jlt_names */
    const char *words;  /* further names, separated by '|', as in "up|down", or by ',', as in "E=VALUE,G=VALUE"; NULL: none */
} jlt_key;

/** Find a key by its name in a scene. Returns false if the command has no such option. */
bool jlt_schema_key(jlt_key *key, const struct argp *options, const char *name);

/** The names of all keys separated by commas, for messages; out has `size` bytes. */
void jlt_schema_key_names(char *out, size_t size, const struct argp *options);

/** Append a name to the list in `out`, which has `size` bytes; does nothing if there is no room. */
void jlt_schema_add_name(char *out, size_t size, const char *name);

#endif
