/* ttc discover: finds and proves integrals, factors and densities that a table does not claim. */
#include "base/text.h"
#include "command/command.h"
#include "command/command_discover_json.h"
#include "command/command_guard.h"
#include "discover/discover.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { LIST_MAX = 16, PROGRESS_WIDTH = 78 };

/* One table, with the conditions and denominators of the command line. */
typedef struct {
    const ttc_options *options;
    ttc_model *model;          /* the table's text, then the conditions as a variant, and denominators as lets */
    const char *path, *sha256; /* of the table's file */
    const char *table;         /* the text of the table alone */
    char *when;                /* " when ..." or "" */
    char *denominators[LIST_MAX];
    ttc_id expressions[LIST_MAX];
    size_t denominator_count;
    const ttc_bindings *conditions; /* NULL: none */
    bool shows_progress;
    time_t shown;
    char reason[300];
    json_t *problems, *found;  /* of --json: problems of the table; finds. NULL: text is written */
    int status;
} work;

static void clear_progress(const work *w)
{
    if (w->shows_progress) fprintf(stderr, "\r%*s\r", PROGRESS_WIDTH, "");
}

static void show_progress(void *context, const char *text)
{
    work *w = context;
    const time_t now = time(NULL);
    if (!w->shows_progress || now == w->shown) return;
    w->shown = now;
    fprintf(stderr, "\r%-*.*s", PROGRESS_WIDTH, PROGRESS_WIDTH, text);
}

/* Finds are written at once, whatever ends the program afterwards. */
static void write_line(const work *w, const char *text)
{
    clear_progress(w);
    fputs(text, stdout);
    fflush(stdout);
}

static void say(void *context, const char *text)
{
    const work *w = context;
    if (w->found != NULL) ttc_command_discover_add_claim(w->found, text);
    else write_line(w, text);
}

static void remark(void *context, const char *text)
{
    const work *w = context;
    if (w->found != NULL) ttc_command_discover_add_remark(w->found, text);
    else write_line(w, text);
}

static void settle(void *context, const ttc_discovery_settled *settled)
{
    const work *w = context;
    if (w->found != NULL) ttc_command_discover_add_settled(w->found, settled);
}

static char *joined(const char *a, const char *b, const char *c)
{
    char *text = malloc(strlen(a) + strlen(b) + strlen(c) + 1);
    return text == NULL ? NULL : strcat(strcat(strcpy(text, a), b), c);
}

/* Only claims below the lines of the table are to be proved. */
static bool is_beyond(void *context, const ttc_proof *proof) { return proof->place.line > *(const uint32_t *)context; }

/* The reason of the first claim that is not proved. */
static void keep_reason(work *w, const char *name, const char *reason)
{
    snprintf(w->reason, sizeof w->reason, "%s%s%s", name, *name != '\0' ? ": " : "", reason != NULL
             ? reason : "no reason could be stored");
}

static void complain(void *context, const char *claims)
{
    const work *w = context;
    clear_progress(w);
    fprintf(stderr, "ttc discover: found, but not proved (%s):\n%s", w->reason, claims);
    if (w->found != NULL) ttc_command_discover_add_unproved(w->found, claims, w->reason);
}

static bool prove(void *context, const char *claims, bool *is_smooth)
{
    work *w = context;
    bool proved = false;
    uint32_t lines = 1;
    keep_reason(w, "", "the table cannot be read with it");
    for (const char *c = w->table; *c != '\0'; c++) lines += *c == '\n';
    char *text = joined(w->table, "\n", claims);
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = text == NULL || diagnostics == NULL ? NULL : ttc_model_parse(text, strlen(text), w->model->file,
                                                                                    diagnostics);
    if (model != NULL) {
        ttc_proof_report *report = ttc_prove_some_guarded(model, TTC_GUARD_SECONDS, is_beyond, &lines, ttc_resolve_beside, NULL);
        proved = report != NULL;
        for (size_t i = 0; proved && i < report->proof_count; i++) {
            const ttc_proof *proof = &report->proofs[i];
            if (proof->place.line <= lines) continue;
            proved = proof->status == TTC_PROVED;
            if (!proved) keep_reason(w, proof->name, proof->remainder);
            if (is_smooth != NULL && strcmp(proof->kind, "measure") == 0) *is_smooth = proof->has_smooth_density;
        }
        ttc_proof_report_destroy(report);
    }
    ttc_model_destroy(model);
    ttc_diagnostics_destroy(diagnostics);
    free(text);
    return proved;
}

/* Parts between commas outside of parentheses, without blanks around them. False if too many or empty, or of several lines. */
static bool split(char **parts, size_t *count, const char *list)
{
    int depth = 0;
    *count = 0;
    if (strpbrk(list, "\r\n#") != NULL) return false;
    for (const char *begin = list, *c = list;; c++) {
        depth += (*c == '(') - (*c == ')');
        if (*c != '\0' && (*c != ',' || depth > 0)) continue;
        const char *end = c;
        while (begin < end && isspace((unsigned char)*begin)) begin++;
        while (begin < end && isspace((unsigned char)end[-1])) end--;
        if (begin == end || *count == LIST_MAX) return false;
        parts[*count] = strndup(begin, (size_t)(end - begin));
        if (parts[(*count)++] == NULL) return false;
        if (*c == '\0') return true;
        begin = c + 1;
    }
}

static void free_parts(char **parts, size_t count)
{
    for (size_t i = 0; i < count; i++) free(parts[i]);
}

/* Report a problem of the command line on stderr and, with --json, among the problems. */
TTC_PRINTF(3, 4) static int refuse(const work *w, int status, const char *format, ...)
{
    char message[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    clear_progress(w);
    fprintf(stderr, "ttc discover: %s\n", message);
    if (w->problems != NULL) ttc_command_discover_add_problem(w->problems, w->path, message);
    return status;
}

/* Each part must be PARAM = EXPR, with a parameter of the table. */
static int check_conditions(const work *w, const ttc_model *table, char **parts, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char name[64] = "";
        const size_t length = strcspn(parts[i], " =");
        uint32_t symbol;
        if (strchr(parts[i], '=') == NULL)
            return refuse(w, TTC_EXIT_USAGE, "--when '%s' sets nothing (expected PARAM=EXPR)", parts[i]);
        if (length < sizeof name) memcpy(name, parts[i], length);
        if (ttc_model_find_symbol(table, name, &symbol) && table->symbols[symbol].kind == TTC_PARAM) continue;
        ttc_text names = { 0 };
        for (size_t k = 0; k < table->param_count; k++) ttc_text_format(&names, " %s", table->symbols[table->params[k]].name);
        refuse(w, TTC_EXIT_BAD_TABLE, "--when '%s': %s has no parameter '%.*s' (expected one of%s)", parts[i], table->name,
               (int)length, parts[i], ttc_text_string(&names));
        ttc_text_clear(&names);
        return TTC_EXIT_BAD_TABLE;
    }
    return TTC_EXIT_DONE;
}

/* Parse the table's text, with the conditions and denominators of the command line at its end. */
static int extend(work *w, const ttc_model *table)
{
    const ttc_options *options = w->options;
    ttc_text text = { 0 };
    char *parts[LIST_MAX];
    size_t count = 0;
    ttc_text_format(&text, "%s\n", table->text);
    if (options->when != NULL) {
        int status = split(parts, &count, options->when) ? check_conditions(w, table, parts, count)
                     : refuse(w, TTC_EXIT_USAGE, "--when '%s' is no list (expected PARAM=EXPR,...)", options->when);
        free_parts(parts, count);
        if (status != TTC_EXIT_DONE) return status;
        ttc_text_format(&text, "variant when_ : %s\n", options->when);
    }
    if (options->denominators != NULL) {
        if (!split(w->denominators, &w->denominator_count, options->denominators))
            return refuse(w, TTC_EXIT_USAGE, "--denominator '%s' is no list (expected EXPR,...)", options->denominators);
        for (size_t i = 0; i < w->denominator_count; i++)
            ttc_text_format(&text, "let denominator_%zu = %s\n", i + 1, w->denominators[i]);
    }
    ttc_diagnostics *diagnostics = text.failed ? NULL : ttc_diagnostics_create();
    if (diagnostics != NULL) w->model = ttc_model_parse(ttc_text_string(&text), text.length, table->file, diagnostics);
    const int status = w->model != NULL ? TTC_EXIT_DONE : diagnostics == NULL ? TTC_EXIT_MEMORY : ttc_command_unread(diagnostics);
    if (status == TTC_EXIT_MEMORY) refuse(w, status, "memory is out");
    const char *const option = options->denominators == NULL ? "--when" : "--when or --denominator"; /* the table was read before */
    for (size_t i = 0; status == TTC_EXIT_BAD_TABLE && i < ttc_diagnostics_size(diagnostics); i++)
        if (ttc_diagnostics_at(diagnostics, i).severity != TTC_WARNING)
            refuse(w, status, "%s: %s", option, ttc_diagnostics_at(diagnostics, i).message);
    ttc_diagnostics_destroy(diagnostics);
    ttc_text_clear(&text);
    return status;
}

static void bind(work *w)
{
    uint32_t symbol;
    char name[40];
    if (w->options->when != NULL) w->conditions = &w->model->variants[w->model->variant_count - 1].bindings;
    for (size_t i = 0; i < w->denominator_count; i++) {
        snprintf(name, sizeof name, "denominator_%zu", i + 1);
        if (ttc_model_find_symbol(w->model, name, &symbol)) w->expressions[i] = w->model->symbols[symbol].definition;
    }
}

/* Whether a claim holds under the conditions asked for, which imply all that it sets. */
static bool holds_here(ttc_discovery *d, const ttc_claim *claim)
{
    bool holds = claim->modulo_count == 0;
    ttc_ratio left, right;
    ttc_ratio_init(d->flow->ring, &left);
    ttc_ratio_init(d->flow->ring, &right);
    for (size_t i = 0; i < claim->when.count && holds; i++) {
        holds = ttc_discovery_value(d, &left, d->flow->model->symbols[claim->when.items[i].symbol].node)
                && ttc_discovery_value(d, &right, claim->when.items[i].expression)
                && ttc_ratio_equal(d->flow->ring, &left, &right);
    }
    ttc_ratio_clear(d->flow->ring, &right);
    ttc_ratio_clear(d->flow->ring, &left);
    return holds;
}

static bool is_quantity(void *context, const ttc_proof *proof)
{
    (void)context;
    return strcmp(proof->kind, "integral") == 0 || strcmp(proof->kind, "measure") == 0;
}

/* Whether a point of the domain is known to meet the conditions, without which nothing could be proved; else w->reason says why. */
static bool have_a_point(work *w)
{
    char *claim = joined("equal when_ : 0 = 0", w->when, "\n");
    const bool have = *w->when == '\0' || (claim != NULL && prove(w, claim, NULL));
    free(claim);
    return have;
}

/* Add what the table claims and is proved. Returns false when memory is out. */
static bool learn(work *w, ttc_discovery *d)
{
    ttc_text known = { 0 };
    ttc_proof_report *report = ttc_prove_some_guarded(w->model, TTC_GUARD_SECONDS, is_quantity, NULL, ttc_resolve_beside, NULL);
    for (size_t i = 0; report != NULL && i < w->model->claim_count; i++) {
        const ttc_claim *claim = &w->model->claims[i];
        if (report->proofs[i].status != TTC_PROVED || !holds_here(d, claim)) continue;
        if (claim->kind != TTC_CLAIM_INTEGRAL && claim->kind != TTC_CLAIM_MEASURE) continue;
        ttc_knowns *knowns = claim->kind == TTC_CLAIM_INTEGRAL ? &d->integrals : &d->densities;
        if (!ttc_discovery_know(d, knowns, claim->name, claim->expression)) continue;
        ttc_text_format(&known, "%s%s", known.length > 0 ? ", " : "", claim->name);
        if (w->found != NULL) json_array_append_new(json_object_get(w->found, "known"), json_string(claim->name));
    }
    if (known.length > 0) ttc_discovery_remark(d, "claimed by the table, proved: %s", ttc_text_string(&known));
    ttc_text_clear(&known);
    ttc_proof_report_destroy(report);
    return report != NULL;
}

/* Look for integrals over the denominators Q of the command line, if asked to. Returns false if one is zero, or no polynomial, so
 * that the product K Q/Q, K an integral, is no P/Q. */
static bool divide(work *w, ttc_discovery *d, bool looks)
{
    bool divides = true;
    ttc_ratio denominator;
    ttc_ratio_init(d->flow->ring, &denominator);
    for (size_t i = 0; divides && i < w->denominator_count; i++) {
        const bool is_ratio = ttc_discovery_value(d, &denominator, w->expressions[i])
                              && !fmpz_mpoly_is_zero(denominator.numerator, d->flow->ring->context);
        divides = is_ratio && ttc_flow_degree(d->flow, denominator.denominator) == 0;
        if (!divides) w->status = refuse(w, TTC_EXIT_BAD_TABLE, "--denominator '%s' %s", w->denominators[i],
                                         is_ratio ? "divides by what moves (expected a polynomial)" : "is zero, or no ratio");
        else if (looks) ttc_discover_integrals(d, &denominator, w->denominators[i]);
    }
    ttc_ratio_clear(d->flow->ring, &denominator);
    return divides;
}

static void look(work *w, ttc_discovery *d)
{
    const unsigned kinds = w->options->kinds;
    if ((kinds & TTC_DISCOVER_INTEGRALS) != 0) {
        ttc_discover_integrals(d, NULL, NULL);
        ttc_discover_fractions(d);
        divide(w, d, true);
    }
    if ((kinds & TTC_DISCOVER_FACTORS) != 0) ttc_discover_factors(d, w->expressions, w->denominator_count);
    if ((kinds & TTC_DISCOVER_DENSITIES) != 0) ttc_discover_densities(d);
    if (d->left_out) w->status = TTC_EXIT_MEMORY;
}

static void seek(work *w)
{
    const ttc_options *options = w->options;
    const char *why = NULL;
    size_t columns = 0;
    const ttc_discovery_host host = { w, prove, complain, say, remark, settle, show_progress };
    ttc_discovery *d = ttc_discovery_create(w->model, w->conditions, w->when, options->degree, (size_t)options->memory << 30,
                                            host, &why);
    if (d == NULL) {
        w->status = refuse(w, TTC_EXIT_BAD_TABLE, "%s%s: %s", w->model->name, w->when, why);
        return;
    }
    if (!have_a_point(w)) {
        w->status = refuse(w, TTC_EXIT_BAD_TABLE, "--when '%s': no point of the domain of %s is known to be so (%s)", options->when,
                           w->model->name, w->reason);
    } else if (!ttc_discovery_fits(d, &columns)) {
        w->status = refuse(w, TTC_EXIT_MEMORY, "degree %d takes a matrix of %zu columns, %.3g GiB (expected at most %d GiB: take a "
                           "smaller --degree, or allow for more by --memory)",
                           options->degree, columns, d->too_large / (1 << 30), options->memory);
    } else if (divide(w, d, false)) {
        if (w->problems != NULL) w->found = ttc_command_discover_json(d, w->path, w->sha256, options->when);
        else ttc_discovery_introduce(d);
        if (learn(w, d)) look(w, d);
        else w->status = TTC_EXIT_MEMORY;
    }
    clear_progress(w);
    if (d->unproved > 0) {
        fprintf(stderr, "ttc discover: %zu more %s found at numbers, but not proved as %s of the parameters\n", d->unproved,
                d->unproved == 1 ? "was" : "were", d->unproved == 1 ? "a function" : "functions");
        w->status = TTC_EXIT_BAD_TABLE;
    }
    if (w->found != NULL) json_object_set_new(w->found, "unlifted", json_integer((json_int_t)d->unproved));
    ttc_discovery_destroy(d);
}

/* One table. Returns its JSON; NULL if text is written. */
static json_t *discover(const char *path, const ttc_options *options, int *status)
{
    work w = { .options = options, .shows_progress = isatty(STDERR_FILENO) != 0, .path = path,
               .problems = options->json ? json_array() : NULL };
    ttc_model *table = ttc_command_read(path, &w.status, w.problems);
    if (table != NULL) {
        w.table = table->text;
        w.sha256 = table->sha256;
        w.when = options->when == NULL ? strdup("") : joined(" when ", options->when, "");
        if (w.when == NULL) w.status = TTC_EXIT_MEMORY;
        else if (table->equation_count == 0) {
            ttc_command_complain(table, table->lift.place, w.problems,
                                 "a table of coordinates has no equations (expected the table of a motion)");
            w.status = TTC_EXIT_BAD_TABLE;
        } else w.status = extend(&w, table);
    }
    if (table != NULL && w.status == TTC_EXIT_DONE) {
        bind(&w);
        seek(&w);
    }
    ttc_command_raise(status, w.status);
    free_parts(w.denominators, w.denominator_count);
    free(w.when);
    ttc_model_destroy(w.model);
    ttc_model_destroy(table);
    if (w.found == NULL && w.problems != NULL) return ttc_command_failure(path, w.problems);
    if (w.found != NULL) json_object_set_new(w.found, "problems", w.problems);
    return w.found;
}

int ttc_command_discover(const ttc_options *options)
{
    int status = TTC_EXIT_DONE;
    json_t *results = options->json ? json_array() : NULL;
    for (size_t i = 0; i < options->file_count; i++) {
        json_t *result = discover(options->files[i], options, &status);
        if (result != NULL) json_array_append_new(results, result);
    }
    if (results != NULL) {
        json_dumpf(results, stdout, JSON_INDENT(2));
        putchar('\n');
        json_decref(results);
    }
    return status;
}
