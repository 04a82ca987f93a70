/** Commands of ttc: one file a command, dispatched by the table in main.c. Results go to stdout, all else to stderr. To add one: a
 *  function here, its file, and a row of the table. */
#ifndef TTC_COMMAND_H
#define TTC_COMMAND_H

#include "kernels/catalogue.h"
#include "prove/prove.h"

#include <jansson.h>

typedef enum {
    TTC_EXIT_DONE = 0,
    TTC_EXIT_REFUTED = 1,   /* a claim is false, a mutant survives, or kernels would rest on a claim that is not proved */
    TTC_EXIT_USAGE = 2,
    TTC_EXIT_BAD_TABLE = 3, /* a table is wrong, or a claim is not settled */
    TTC_EXIT_MEMORY = 4,    /* memory is out */
    TTC_EXIT_IO = 5,
    TTC_EXIT_INTERNAL = 70 /* a point contradicts a verdict */
} ttc_exit_status;

typedef enum { TTC_DISCOVER_INTEGRALS = 1, TTC_DISCOVER_FACTORS = 2, TTC_DISCOVER_DENSITIES = 4 } ttc_discover_kind;

/* The command line. Options that the table does not list for a command are refused before it runs. */
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
    bool keep;     /* leave kernels of tables in the manifest of `out` as they are */
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
} ttc_options;

/* Each returns a ttc_exit_status: the largest of all tables. */
int ttc_command_check(const ttc_options *options);
int ttc_command_prove(const ttc_options *options);
int ttc_command_generate(const ttc_options *options);
int ttc_command_build(const ttc_options *options);
int ttc_command_cost(const ttc_options *options);
int ttc_command_show(const ttc_options *options);
int ttc_command_discover(const ttc_options *options);

/* Write kernels of tables that are read, into the folder options->out. Returns a ttc_exit_status. Out: *passing, whether the system
 * ended a proof, so that another run may come to another verdict; may be NULL. */
int ttc_command_generate_models(ttc_model *const *models, size_t count, const ttc_options *options, bool *passing);

/* Raise *status to `to` if that is larger. */
void ttc_command_raise(int *status, int to);

/** Read a table and print its diagnostics on stderr. Returns NULL on failure, and raises *status to TTC_EXIT_BAD_TABLE,
 *  TTC_EXIT_IO or TTC_EXIT_MEMORY. problems: an array that errors and warnings are added to; may be NULL. The caller destroys the
 *  model. */
ttc_model *ttc_command_read(const char *path, int *status, json_t *problems);

/* The exit status where a table could not be read, from what was reported of it. */
int ttc_command_unread(const ttc_diagnostics *diagnostics);

/* Report an error at a place of a table: on stderr, and in `problems` unless NULL. */
TTC_PRINTF(4, 5) void ttc_command_complain(const ttc_model *model, ttc_place place, json_t *problems, const char *format, ...);

/* Report a warning at a place of a table, on stderr. */
TTC_PRINTF(3, 4) void ttc_command_warn(const ttc_model *model, ttc_place place, const char *format, ...);

/* Bytes as JSON. If they are no UTF-8, as a path, or a message cut within a character, those beyond ASCII become '?'. */
json_t *ttc_command_string(const char *bytes);

/* Add errors and warnings to an array, as objects with severity, file, line, column, message. */
void ttc_command_add_problems(json_t *array, const ttc_diagnostics *diagnostics);

/* The JSON of a table that the command cannot work on: file, ok: false, problems. Takes ownership of `problems`. */
json_t *ttc_command_failure(const char *path, json_t *problems);

/** Make the catalogue of a table. Returns false if fields cannot be made, reports why, and raises *status. */
bool ttc_command_catalogue(ttc_catalogue *catalogue, const ttc_model *model, const ttc_options *options, int *status,
                           json_t *problems);

/* Whether to skip a table of coordinates among several: its kernels are written with those of its model. */
bool ttc_command_passes_over(const ttc_model *model, const ttc_options *options);

/** Prove a table in a process of its own, so that kernels stay the same, within bounds, six times as wide with --effort full.
 *  Returns NULL when memory is out, and reports that. */
ttc_proof_report *ttc_command_prove_guarded(const ttc_model *model, const ttc_options *options, int *status);

#endif
