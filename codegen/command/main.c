/* ttc, the term-table compiler: command line and dispatch. */
#include "algebra/qepcad.h"
#include "base/exhaustion.h"
#include "base/options.h"
#include "base/output.h"
#include "base/text.h"
#include "challenge/challenge.h"
#include "command/command.h"

#include <argp.h>
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { DEGREE_MAX = 64, MEMORY_MAX = 1024 };
enum { OPTION_JSON = 'j', OPTION_OUT = 'o', OPTION_FORMAT = 'f', OPTION_MUTATE = 'm', OPTION_KERNELS = 'k',
       OPTION_CHALLENGE = 'c', OPTION_SEED = 's', OPTION_VERBOSE = 'v',
       OPTION_EFFORT = 'e', OPTION_UNPROVED = 'u', OPTION_KEEP = 'K',
       OPTION_LANES = 'l', OPTION_DEGREE = 'd', OPTION_WHEN = 'w', OPTION_DENOMINATOR = 'D',
       OPTION_SEEK = 'S', OPTION_MEMORY = 'M' };

#define JSON_OPTION { "json", OPTION_JSON, NULL, 0, "Write the result as JSON on standard output", 0 }
#define EFFORT_OPTION { "effort", OPTION_EFFORT, "quick|full", 0, \
                        "How long to search for short programs; full also gives proofs six times the time; default quick", 0 }
#define END_OF_OPTIONS { NULL, 0, NULL, 0, NULL, 0 }

static const struct argp_option check_options[] = { JSON_OPTION, END_OF_OPTIONS };
static const struct argp_option prove_options[] = {
    JSON_OPTION,
    { "kernels", OPTION_KERNELS, NULL, 0, "Also prove that every kernel computes what the table says", 0 },
    { "verbose", OPTION_VERBOSE, NULL, 0, "With every verdict, show the point that supports it, and what its proof relies on", 0 },
    { "challenge", OPTION_CHALLENGE, "N", 0, "Test every verdict at N random points of the domain, in ball arithmetic", 0 },
    { "seed", OPTION_SEED, "K", 0, "Seed of the points of --challenge; default 0", 0 },
    EFFORT_OPTION,
    { "mutate", OPTION_MUTATE, NULL, 0, "Flip and drop every term in turn, and report whether some claim is then refuted", 0 },
    END_OF_OPTIONS
};
static const struct argp_option show_options[] = {
    { "format", OPTION_FORMAT, "text|latex|dot", 0,
      "text: as in the table (the default); latex: for LaTeX; dot: the graph of the shared expressions, for Graphviz", 0 },
    END_OF_OPTIONS
};

static const struct argp_option generate_options[] = {
    { "out", OPTION_OUT, "DIR", 0, "Folder for the generated files, made if it is missing", 0 },
    EFFORT_OPTION,
    { "keep", OPTION_KEEP, NULL, 0, "Do not rewrite kernels in DIR whose table, and those it leads to, have not changed, by its "
                                    "files; for the same ttc and options only", 0 },
    { "unproved", OPTION_UNPROVED, NULL, 0, "Also write kernels that rest on claims that are not proved, and mark them", 0 },
    END_OF_OPTIONS
};
static const struct argp_option build_options[] = {
    { "lanes", OPTION_LANES, "2|4|8", 0,
      "Also write kernels on vectors of 2, 4 or 8 numbers, which follow that many orbits at once; 4 needs a processor with AVX2, 8 "
      "with AVX-512", 0 },
    END_OF_OPTIONS
};
static const struct argp_option discover_options[] = {
    JSON_OPTION,
    { "degree", OPTION_DEGREE, "D", 0, "Largest degree of the polynomials, in states, roots and functions; default 4", 0 },
    { "when", OPTION_WHEN, "PARAM=EXPR,...", 0, "Set parameters first, as the clause 'when' of a claim does", 0 },
    { "denominator", OPTION_DENOMINATOR, "EXPR,...", 0,
      "Also look for integrals P/EXPR, with each EXPR, a polynomial, and for products of powers of the factors of EXPR", 0 },
    { "seek", OPTION_SEEK, "KIND,...", 0, "Look only for these: integrals, factors, densities; default all", 0 },
    { "memory", OPTION_MEMORY, "GIB", 0, "Memory that matrices may take; default 8 GiB", 0 },
    END_OF_OPTIONS
};
static const struct argp_option cost_options[] = { JSON_OPTION, EFFORT_OPTION, END_OF_OPTIONS };

typedef struct {
    const char *name, *summary;
    int (*run)(const ttc_options *options);
    const struct argp_option *options;
    const char *help;
    bool proves;
} command;

static const command commands[] = {
    { "check", "read tables and report what is wrong with them", ttc_command_check, check_options,
      "Read each table and report every error and warning as FILE:LINE:COLUMN, with the line and a caret. Nothing is "
      "proved and nothing is written.", false },
    { "prove", "prove or refute every claim of tables, exactly", ttc_command_prove, prove_options,
      "Prove or refute every claim of each table in exact arithmetic, at all points of its domain at once, and that its "
      "variants, times and eliminations follow from it. A refuted claim is printed with its place and the expression that is "
      "not zero. A claim that holds at no point at all, as on an empty zero level, says nothing, and is not settled.", true },
    { "show", "print equations and Jacobian as text, LaTeX or a graph", ttc_command_show, show_options,
      "Print the right-hand side of each equation and every entry of the Jacobian that is not zero, differentiated "
      "exactly.", false },
    { "generate", "write C kernels", ttc_command_generate, generate_options,
      "Write kernels for every variant, time and elimination of each table, the registry of all of them, a manifest and "
      "operation counts. Claims are proved first: if a kernel rests on a claim that is refuted or not settled, nothing is "
      "written. The output depends on the tables and options alone; after an error no file is changed.", true },
    { "build", "compile a table to a shared object, and print its path", ttc_command_build, build_options,
      "Write kernels by --effort quick and compile them, with the compiler that CC names, else cc. Print the path of the "
      "object. It is kept in $XDG_CACHE_HOME/jellett, else ~/.cache/jellett, under a key of table, ttc, compiler and flags, "
      "and is not compiled again; jellett does this for tables that it is given. Kernels that rest on claims without a proof "
      "are marked.", true },
    { "cost", "print operation counts of all kernels", ttc_command_cost, cost_options,
      "Print the operations, depth and live temporaries of every kernel, as generated and as the table has its terms.", false },
    { "discover", "find integrals and densities that a table does not claim", ttc_command_discover, discover_options,
      "Look for first integrals, for polynomials P that the motion multiplies by a number, P' = c P, for invariant lines, planes "
      "and conics, whose cofactor K in P' = K P may be any ratio, and for invariant densities.\n\n"
      "What is found is printed as claims of the language, each proved as by ttc prove. Comments say which forms were searched, "
      "and that nothing else of these forms exists: a rank proves that, or the factors of one polynomial. What the table claims is "
      "proved first, and products with it are not found again. For example:\n\n"
      "  ttc discover --when a3=0 codegen/models/spherical_top.tt\n"
      "  ttc discover --degree 6 --seek integrals my.tt\n"
      "  ttc discover --denominator x*y,1+z^2 my.tt\n"
      "  ttc discover --json my.tt | jq -r '.[].claims[].text'", true },
};

enum { COMMAND_COUNT = sizeof commands / sizeof *commands };

static const char exit_text[] =
    "\vExit status: 0 done; 1 prove refutes a claim, a mutant survives, or kernels that generate should write rest on a claim that "
    "is not proved; 2 the command line is wrong; 3 a table is wrong, or prove or discover does not settle a claim; 4 memory is "
    "out, or processes are; 5 a file cannot be read or written, or the program qepcad is missing; 70 a point contradicts a "
    "verdict, which is an error of this program.";

static uint64_t parse_number(const char *option, const char *text, uint64_t least, uint64_t most, struct argp_state *state)
{
    char *end = NULL;
    errno = 0;
    unsigned long long value = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != '\0' || errno != 0 || value < least || value > most)
        argp_error(state, "%s: '%s' is no number (expected a whole one from %llu to %llu)", option, text,
                   (unsigned long long)least, (unsigned long long)most);
    return value;
}

/* Parse a list of the kinds to look for. Returns them as bits. */
static unsigned parse_kinds(const char *list, struct argp_state *state)
{
    static const struct {
        const char *name;
        ttc_discover_kind kind;
    } kinds[] = {
        { "integrals", TTC_DISCOVER_INTEGRALS },
        { "factors", TTC_DISCOVER_FACTORS },
        { "densities", TTC_DISCOVER_DENSITIES },
    };
    unsigned chosen = 0;
    for (const char *at = list;; at++) {
        const size_t length = strcspn(at, ",");
        unsigned kind = 0;
        for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
            if (strlen(kinds[i].name) == length && strncmp(kinds[i].name, at, length) == 0) kind = kinds[i].kind;
        if (kind == 0) argp_error(state, "unknown kind '%.*s' (expected integrals, factors or densities)", (int)length, at);
        chosen |= kind;
        at += length;
        if (*at == '\0') return chosen;
    }
}

static error_t parse_option(int key, char *argument, struct argp_state *state)
{
    ttc_options *options = state->input;
    switch (key) {
    case OPTION_JSON: options->json = true; return 0;
    case OPTION_KERNELS: options->kernels = true; return 0;
    case OPTION_VERBOSE: options->verbose = true; return 0;
    case OPTION_MUTATE: options->mutate = true; return 0;
    case OPTION_CHALLENGE:
        options->challenge = parse_number("--challenge", argument, 1, TTC_CHALLENGE_POINT_LIMIT, state);
        return 0;
    case OPTION_SEED:
        options->seed = parse_number("--seed", argument, 0, UINT64_MAX, state);
        options->seeded = true;
        return 0;
    case OPTION_KEEP: options->keep = true; return 0;
    case OPTION_UNPROVED: options->unproved = true; return 0;
    case OPTION_LANES:
        options->lanes = (unsigned)parse_number("--lanes", argument, 2, 8, state);
        if (options->lanes != 2 && options->lanes != 4 && options->lanes != 8)
            argp_error(state, "there are no vectors of %s (expected 2, 4 or 8)", argument);
        return 0;
    case OPTION_OUT: options->out = argument; return 0;
    case OPTION_DEGREE: options->degree = (int)parse_number("--degree", argument, 1, DEGREE_MAX, state); return 0;
    case OPTION_MEMORY: options->memory = (int)parse_number("--memory", argument, 1, MEMORY_MAX, state); return 0;
    case OPTION_WHEN: options->when = argument; return 0;
    case OPTION_DENOMINATOR: options->denominators = argument; return 0;
    case OPTION_SEEK: options->kinds = parse_kinds(argument, state); return 0;
    case OPTION_FORMAT:
        if (strcmp(argument, "text") != 0 && strcmp(argument, "latex") != 0 && strcmp(argument, "dot") != 0)
            argp_error(state, "unknown format '%s' (expected text, latex or dot)", argument);
        options->format = argument;
        return 0;
    case OPTION_EFFORT:
        if (strcmp(argument, "quick") != 0 && strcmp(argument, "full") != 0)
            argp_error(state, "unknown effort '%s' (expected quick or full)", argument);
        options->effort = strcmp(argument, "full") == 0 ? TTC_EFFORT_FULL : TTC_EFFORT_QUICK;
        return 0;
    case ARGP_KEY_ARG: options->files[options->file_count++] = argument; return 0;
    case ARGP_KEY_END:
        if (options->file_count == 0) argp_error(state, "no table is given (expected FILE.tt)");
        if (options->mutate && (options->challenge > 0 || options->kernels || options->verbose))
            argp_error(state, "--mutate looks at changed terms alone: leave out --challenge, --kernels and --verbose");
        if (options->seeded && options->challenge == 0) argp_error(state, "--seed is of the points of --challenge: say how many");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

/* Print a text in lines as long as those that argp makes of a command's text. */
static void print_wrapped(FILE *stream, const char *text)
{
    for (size_t width = 79; strlen(text) > width; width = 79) {
        while (text[width] != ' ') width--;
        fprintf(stream, "%.*s\n", (int)width, text);
        text += width + 1;
    }
    fprintf(stream, "%s\n", text);
}

static void print_help(FILE *stream)
{
    fprintf(stream, "Usage: ttc COMMAND [OPTION...] FILE.tt...\n"
                    "Compile term tables: readable models of mechanics with claims that are proved.\n\n"
                    "Commands:\n");
    for (size_t i = 0; i < COMMAND_COUNT; i++) fprintf(stream, "  %-10s %s\n", commands[i].name, commands[i].summary);
    fprintf(stream, "\nA table names parameters, states and equations, one term a line:\n\n"
                    "    model oscillator\n"
                    "    param k > 0\n"
                    "    state x\n"
                    "    state v\n"
                    "    eq x = v\n"
                    "    eq v =\n"
                    "        - k*x\n"
                    "    integral E = v^2/2 + k*x^2/2\n\n"
                    "  ttc check oscillator.tt\n"
                    "  ttc show --format latex oscillator.tt\n\n"
                    "'ttc COMMAND --help' explains a command; 'ttc --version' prints the version.\n");
    print_wrapped(stream, exit_text + 1);
}

static int run_command(const command *chosen, int argc, char **argv)
{
    char name[64];
    int status = TTC_EXIT_USAGE;
    ttc_options options = { .format = "text", .degree = 4, .memory = 8,
                            .kinds = TTC_DISCOVER_INTEGRALS | TTC_DISCOVER_FACTORS | TTC_DISCOVER_DENSITIES };
    char *help = malloc(strlen(chosen->help) + sizeof exit_text);
    options.files = calloc((size_t)argc, sizeof *options.files);
    if (help == NULL || options.files == NULL) {
        fprintf(stderr, "ttc: out of memory\n");
        status = TTC_EXIT_MEMORY;
        goto done;
    }
    snprintf(name, sizeof name, "ttc %s", chosen->name);
    strcpy(help, chosen->help);
    strcat(help, exit_text);
    struct argp argp = { chosen->options, parse_option, "FILE.tt...", help, NULL, NULL, NULL };
    argv[1] = name;
    argp_err_exit_status = TTC_EXIT_USAGE;
    setenv("ARGP_HELP_FMT", "no-dup-args-note", 0); /* the note is about short options, which help here does not show with values */
    ttc_options_parse(&argp, argc - 1, argv + 1, &options);
    if (chosen->proves && !ttc_qepcad_is_there()) {
        fprintf(stderr, "%s: the program qepcad is not in PATH: install it (Debian's package qepcad), for that conditions have no "
                        "real point is believed only if it agrees with Z3\n", name);
        status = TTC_EXIT_IO;
        goto done;
    }
    status = chosen->run(&options);
done:
    free(options.files);
    free(help);
    return status;
}

static void end_without_memory(void)
{
    static const char text[] = "ttc: out of memory\n";
    ssize_t written = write(STDERR_FILENO, text, sizeof text - 1);
    (void)written; /* there is nowhere else to say it */
    _exit(TTC_EXIT_MEMORY);
}

int main(int argc, char **argv)
{
    if (!ttc_output_standard("ttc", TTC_EXIT_IO)) return TTC_EXIT_IO;
    signal(SIGXFSZ, SIG_IGN); /* writing beyond the limit then fails, and is reported */
    signal(SIGCHLD, SIG_DFL); /* where it is ignored, as some parents leave it, no child keeps its status and time for this one */
    ttc_exhaustion_handle(end_without_memory);
    setenv("PATH", "/usr/bin:/bin", 0); /* as a shell has it: a C compiler, too, looks there for its parts */
    if (argc > 2 && strcmp(argv[1], "help") == 0) {
        argv[1] = argv[2];
        argv[2] = "--help";
    }
    const char *word = argc > 1 ? argv[1] : "";
    if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0 || strcmp(word, "-?") == 0 || strcmp(word, "help") == 0) {
        print_help(stdout);
        return TTC_EXIT_DONE;
    }
    if (strcmp(word, "--version") == 0 || strcmp(word, "-V") == 0) {
        puts("ttc " JLT_VERSION);
        return TTC_EXIT_DONE;
    }
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(commands[i].name, word) == 0) return run_command(commands + i, argc, argv);
    if (argc > 1) fprintf(stderr, "ttc: unknown command '%s'", word);
    else fprintf(stderr, "ttc: no command is given");
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (ttc_text_resembles(commands[i].name, strlen(commands[i].name), word, strlen(word)))
            fprintf(stderr, " (did you mean '%s'?)", commands[i].name);
    fputc('\n', stderr);
    fprintf(stderr, "Commands:");
    for (size_t i = 0; i < COMMAND_COUNT; i++) fprintf(stderr, " %s", commands[i].name);
    fprintf(stderr, ". Try 'ttc --help'.\n");
    return TTC_EXIT_USAGE;
}
