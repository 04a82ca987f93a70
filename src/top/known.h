/** Sections that are known by name: what can be said of one beyond the states and levels of a table.
 *
 *  A plane section shows the states of its table. A section that is known has parameters and levels by name, coordinates of its own
 *  with the interval on which it has points, quantities beside them in rows, and starts to begin with. Commands take all they say of
 *  such a section from this record. */
#ifndef JLT_TOP_KNOWN_H
#define JLT_TOP_KNOWN_H

#include "dynamics/section.h"
#include "dynamics/system.h"

enum { JLT_KNOWN_VALUES_MAX = 16, JLT_KNOWN_SHOWN_MAX = 8 };

/* Starts with the default values: of a regular orbit, of a chaotic one, and near a saddle. */
typedef enum { JLT_START_REGULAR, JLT_START_CHAOTIC, JLT_START_SADDLE, JLT_STARTS } jlt_known_start;

/* Quantities beside the coordinates of a row, in the table's units; names: shape (count,). */
typedef struct {
    unsigned count;
    const char *const *names;
    void (*values)(double *out, const jlt_system *system, const double *x);
} jlt_known_columns;

typedef struct jlt_known {
    const char *subject; /* whose section it is, for messages */
    const char *table;   /* the model of its kernel: claims must lead there, and levels be those of integrals that are proved */
    const char *plane;   /* the section without levels, as --section takes it */
    unsigned count, params;   /* of values: the parameters stand first, levels after them */
    const char *const *names; /* (count,) */
    const double *defaults;   /* (count,) */
    const char *const *coordinates; /* (dim,) */
    unsigned coordinate_count;
    const char *starts[JLT_STARTS];
    const char *const *units;       /* (dim,): of coordinates */
    const double *frame;            /* (dim, 2): from where to where the whole section lies */
    const char *domain;             /* what a start must be that has no orbit, for a message */
    jlt_known_columns at_return, at_end;

    /* Errors: as jlt_system_plane; EMPTY, no state has these levels. */
    jlt_status (*make)(jlt_system **out, const double *values, const jlt_flow *options);

    /* Why that failed, into text. */
    void (*refuse)(char *text, size_t size, const double *values, jlt_status status);

    /* Where the section has points in a coordinate that is no angle; false: it is one, or there are none. */
    bool (*interval)(const jlt_system *system, unsigned coordinate, double *low, double *high);

    /* What is known of the coordinates at a state off the section; the rest is NaN. */
    void (*off_section)(double *q, const double *x);

    /* Orbits that begin low, what that is called, and the end at which they have turned over. */
    const char *low;
    bool (*is_low)(const jlt_system *system, const double *q);
    jlt_fate (*turned_at)(const jlt_system *system);
} jlt_known;

extern const jlt_known jlt_known_top;

/** The section that is known of tables of this name; NULL: none. */
const jlt_known *jlt_known_of(const jlt_descriptor *descriptor);

/** The index of a value, known->count where there is none of this name. */
unsigned jlt_known_value(const jlt_known *known, const char *name);

#endif
