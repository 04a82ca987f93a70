/** The commands of ttc: one file for each, dispatched by the table in main.c. Results go to stdout, all else to stderr.
 *  To add a command: declare its function here, write its file, and add a row to the table. */
#ifndef TTC_COMMAND_H
#define TTC_COMMAND_H

#include "kernels/catalogue.h"
#include "prove/prove.h"

#include <jansson.h>

typedef enum {
    TTC_EXIT_DONE = 0,
    TTC_EXIT_REFUTED = 1,   /* a claim is false */
    TTC_EXIT_USAGE = 2,
    TTC_EXIT_BAD_TABLE = 3,
    TTC_EXIT_MEMORY = 4,    /* memory is out */
    TTC_EXIT_IO = 5,
    TTC_EXIT_INTERNAL = 70 /* a point contradicts a verdict */
} ttc_exit_status;

typedef enum { TTC_DISCOVER_INTEGRALS = 1, TTC_DISCOVER_FACTORS = 2, TTC_DISCOVER_DENSITIES = 4 } ttc_discover_kind;

/* The command line. Options that a command does not list in the table of commands are refused before it runs. */
typedef struct {
    char **files; /* tables, at least one */
    size_t file_count;
    bool json;
    bool mutate;
    bool kernels;
    bool verbose;
    size_t challenge; /* points for each claim; 0: none */
    uint64_t seed;
    bool seeded; /* --seed was given */
    bool keep;     /* leave kernels as they are if the manifest in `out` names the same table */
    bool unproved; /* write also kernels that rest on claims without a proof */
    unsigned lanes; /* compile also kernels on vectors of 2, 4 or 8 numbers; 0: none */
    ttc_effort effort;
    ttc_catalogue_extent extent;
    int degree;        /* of an ansatz */
    int memory;        /* GiB that its matrices may take */
    unsigned kinds;    /* what to look for: bits of ttc_discover_kind */
    const char *when, *denominators; /* lists, or NULL */
    const char *out;    /* directory */
    const char *format; /* "text", "latex" or "dot" */
    const char *command_line; /* "ttc COMMAND OPTIONS..." without directories of files, for headers of what is written */
} ttc_options;

/* Each command returns a ttc_exit_status: the largest over all tables. */
int ttc_command_check(const ttc_options *options);
int ttc_command_prove(const ttc_options *options);
int ttc_command_generate(const ttc_options *options);
int ttc_command_build(const ttc_options *options);
int ttc_command_cost(const ttc_options *options);
int ttc_command_show(const ttc_options *options);
int ttc_command_discover(const ttc_options *options);

/* Raise *status to `to` if that is larger. */
void ttc_command_raise(int *status, int to);

/** Read a table and print its diagnostics on stderr. Returns NULL when it is wrong or cannot be read, and raises *status to
 *  TTC_EXIT_BAD_TABLE, TTC_EXIT_IO or TTC_EXIT_MEMORY. problems: an array to which errors and warnings are added as well; may be
 *  NULL. The caller destroys the model. */
ttc_model *ttc_command_read(const char *path, int *status, json_t *problems);

/* Report an error at a place of a table that was read: on stderr, and in `problems` unless that is NULL. */
TTC_PRINTF(4, 5) void ttc_command_complain(const ttc_model *model, ttc_place place, json_t *problems, const char *format, ...);

/* Report a warning at a place of a table that was read, on stderr. */
TTC_PRINTF(3, 4) void ttc_command_warn(const ttc_model *model, ttc_place place, const char *format, ...);

/* A JSON string. Where the bytes are no UTF-8, as in a path, or in a message cut within a character, those beyond ASCII become
 * '?'. */
json_t *ttc_command_string(const char *bytes);

/* Add errors and warnings to an array, as objects with severity, file, line, column, message. */
void ttc_command_add_problems(json_t *array, const ttc_diagnostics *diagnostics);

/* The JSON object for a table that the command cannot work on: file, ok: false, problems. Takes ownership of `problems`. */
json_t *ttc_command_failure(const char *path, json_t *problems);

/** Make the catalogue of a table. If fields cannot be made, reports why, raises *status and returns false; there is then no
 *  catalogue. */
bool ttc_command_catalogue(ttc_catalogue *catalogue, const ttc_model *model, const ttc_options *options, int *status,
                           json_t *problems);

/* Whether to skip a table of coordinates among several tables: its kernels are written with those of its model. */
bool ttc_command_passes_over(const ttc_model *model, const ttc_options *options);

/** Prove a table in a process of its own, so that proofs do not change kernels, within bounds of processor time, which are six
 *  times as wide with --effort full. Returns NULL when memory is out, reports that, and raises *status. */
ttc_proof_report *ttc_command_prove_guarded(const ttc_model *model, const ttc_options *options, int *status);

#endif
