/* Internals of the parser, which makes a model from tokens. Each ttc_parse_... reads from the current token,
 * parser->tokens[parser->at], and makes the first token that it did not read the current one. On an error it reports to the
 * diagnostics and returns false, NULL or TTC_NONE; ttc_model_parse then goes on at the next record. */
#ifndef TTC_PARSER_H
#define TTC_PARSER_H

#include "base/array.h"
#include "read/model.h"
#include "read/token.h"

enum {
    TTC_NESTING_LIMIT = 256,          /* of parentheses */
    TTC_DIGIT_LIMIT = 1000,           /* of a number */
    TTC_DECIMAL_EXPONENT_LIMIT = 999, /* of a number */
    TTC_SYMBOL_LIMIT = 4096,          /* of quantities, and of claims */
    TTC_STATE_LIMIT = 128,
    TTC_REGION_LIMIT = 256,           /* of `domain` records, of `valid` records, of starts, and of inequalities in one list */
    TTC_KERNEL_LIMIT = 256,           /* of variants, of times, and of eliminations */
    TTC_REFERENCE_LIMIT = 1 << 14,    /* names of claims within records */
    TTC_EXPANSION_LIMIT = 1000000     /* operands of an expression with its lets, or powers, written out */
};

/* The name of a claim in another record. It is looked up after the whole table has been read, so that the claim may stand below. */
typedef enum { TTC_REFER_FAMILY, TTC_REFER_MODULO, TTC_REFER_MEMBER, TTC_REFER_ELIMINATION } ttc_reference_role;

/* How many operands a node has. */
typedef struct {
    double with_lets;   /* when lets are written out */
    double with_powers; /* when powers of what is in parentheses are written out, as in C */
} ttc_expansion;

typedef struct {
    ttc_reference_role role;
    size_t owner; /* index of the claim or elimination that contains the name */
    const ttc_token *name;
} ttc_reference;

typedef struct {
    ttc_model *model;
    ttc_diagnostics *diagnostics;
    const ttc_token *tokens;
    size_t at;
    size_t errors_before; /* errors that the diagnostics had before this table */
    bool out_of_memory;

    uint32_t *hashes;    /* hash of the name, for each symbol */
    unsigned char *used; /* for each symbol, 1 if some record uses it; unused ones get a warning */
    ttc_reference *references; /* to be looked up at the end of the table */
    size_t reference_count;

    /* A stack of the operands of all sums and products under construction; those of inner expressions are on top. */
    ttc_id *operands;
    long *exponents;
    fmpq *weights; /* 1 or -1, which FLINT stores without allocation */
    ttc_place *places;
    size_t operand_count, operand_capacity;
    unsigned nesting;
    bool in_charpoly; /* the record is a `charpoly`, in which `lambda` is the indeterminate */
    bool may_rate;    /* rate(expression) is allowed in this record */

    ttc_id *divisors; /* what the current record divides by, as written */
    size_t divisor_count;
    uint32_t *uses;   /* symbols with a definition (let, root, function) that the current record names */
    size_t use_count;

    ttc_expansion *expansions; /* by node of the graph */
    size_t measured, measured_capacity; /* last node for which this number is known; allocated length */
} ttc_parser;

/* Tokens. _at tells if the current token is this one; _accept reads it if so; _expect reads it, or reports it missing. */
const ttc_token *ttc_parse_peek(const ttc_parser *parser);
bool ttc_parse_at_mark(const ttc_parser *parser, char mark);
bool ttc_parse_at_keyword(const ttc_parser *parser, ttc_keyword keyword);
bool ttc_parse_accept_mark(ttc_parser *parser, char mark);
bool ttc_parse_accept_keyword(ttc_parser *parser, ttc_keyword keyword);
bool ttc_parse_expect_mark(ttc_parser *parser, char mark, const char *after);
bool ttc_parse_expect_keyword(ttc_parser *parser, ttc_keyword keyword, const char *after);
const ttc_token *ttc_parse_name(ttc_parser *parser, const char *what); /* NULL after a report */
bool ttc_parse_record_end(ttc_parser *parser); /* reports a token that is left over in the record */
bool ttc_parse_unexpected(ttc_parser *parser, const char *expected); /* reports; always false */
ttc_place ttc_token_place(const ttc_token *token);
bool ttc_token_is(const ttc_token *token, const char *name);

TTC_PRINTF(3, 4) bool ttc_parse_error(ttc_parser *parser, ttc_place place, const char *format, ...); /* always false */
bool ttc_parse_no_memory(ttc_parser *parser); /* always false */

/* Append a symbol, an expression or the index of a claim to a list. Returns false when memory is out. */
bool ttc_parse_append(ttc_parser *parser, uint32_t **list, size_t *count, uint32_t index);

/* Expressions. */
bool ttc_parse_uses(ttc_parser *parser, uint32_t symbol); /* records in parser->uses that the current record names the symbol */
ttc_id ttc_parse_expression(ttc_parser *parser);
/* Read the terms of a sum onto the stack of operands. Returns the index of the first; SIZE_MAX after a report. */
size_t ttc_parse_terms(ttc_parser *parser);
ttc_id ttc_parse_number(ttc_parser *parser, const ttc_token *token);
ttc_id ttc_parse_graph_error(ttc_parser *parser, ttc_place place); /* reports the graph's error; always TTC_NONE */
/* Returns false, after a report, if the expression has more than TTC_EXPANSION_LIMIT operands, counted in either way. */
bool ttc_parse_measure(ttc_parser *parser, ttc_id id, ttc_place place);

/* Names. */
/* Find a symbol of the table; the indeterminate lambda is none. */
bool ttc_parse_find(const ttc_parser *parser, const ttc_token *name, uint32_t *symbol);
bool ttc_parse_known(ttc_parser *parser, const ttc_token *name, uint32_t *symbol); /* the same, with a report */
bool ttc_parse_define(ttc_parser *parser, const ttc_token *name, ttc_symbol_kind kind, ttc_id definition, uint32_t *symbol);
/* If the name is pi, and no record param, state, root, angle, exp, log or let of the table defines it, above or below, define it as
 * the number pi; otherwise return false without a report. */
bool ttc_parse_pi(ttc_parser *parser, const ttc_token *name, uint32_t *symbol);
void ttc_parse_unknown(ttc_parser *parser, const ttc_token *name); /* reports a name that stands for nothing, with a likely cause */
bool ttc_parse_refer(ttc_parser *parser, ttc_reference_role role, size_t owner, const ttc_token *name);
char *ttc_parse_copy(ttc_parser *parser, const char *text, size_t length); /* NULL when memory is out */

/* The text of the tokens from number `first` up to the current one, exclusive; each gap between tokens becomes one blank. */
char *ttc_parse_text_since(ttc_parser *parser, size_t first); /* NULL when memory is out */

/* Lists shared by records. */
/* NAME = expr, ... for symbols of these kinds, a mask of 1 << ttc_symbol_kind. */
bool ttc_parse_bindings(ttc_parser *parser, ttc_bindings *bindings, unsigned kinds, const char *expected);
/* Warn of numbers that violate the sign condition of the parameter which they replace. */
void ttc_parse_check_constants(ttc_parser *parser, const ttc_bindings *bindings);
/* FILE.tt, a table beside this one. */
bool ttc_parse_target_file(ttc_parser *parser, char **file);
/* NAME = expr, ... with names of that table, one for each binding. They are looked up later, when that table is read. */
bool ttc_parse_target_bindings(ttc_parser *parser, ttc_bindings *bindings, char ***names, const char *expected);
/* NAME = expr | atan2(expr, expr) | sqrt(expr) | INTEGRAL, ... with names of another table. forms: the allowed ones, a mask of
 * 1 << ttc_given_form; integrals are allowed unless only the plain form is. Adds entries and members to `claim`. */
bool ttc_parse_image(ttc_parser *parser, ttc_image *image, ttc_claim *claim, unsigned forms, const char *expected);
/* Report a symbol set by `bound` on which expressions of `in`, after the substitutions of `first` unless NULL, depend. */
bool ttc_parse_check_circle(ttc_parser *parser, const ttc_bindings *bound, const ttc_bindings *in, const ttc_bindings *first);

/* Records. The current token is the one after the keyword. */
bool ttc_parse_title(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_quantity(ttc_parser *parser, const ttc_token *keyword); /* param, state, root, angle, exp, log, let */
bool ttc_parse_equation(ttc_parser *parser);
bool ttc_parse_default(ttc_parser *parser);
bool ttc_parse_kernel(ttc_parser *parser, const ttc_token *keyword); /* variant, time, eliminate */
bool ttc_parse_claim(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_way(ttc_parser *parser, ttc_claim *claim); /* reduction NAME : by ..., lift NAME : into ...; after the colon */
bool ttc_parse_tier(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_region(ttc_parser *parser); /* domain */
bool ttc_parse_observe(ttc_parser *parser);
bool ttc_parse_valid(ttc_parser *parser);
bool ttc_parse_pole(ttc_parser *parser);
bool ttc_parse_section(ttc_parser *parser, ttc_claim *claim); /* after the colon */
bool ttc_parse_lift(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_start(ttc_parser *parser);
bool ttc_parse_turns(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_unit_and_meaning(ttc_parser *parser, char **unit, char **meaning); /* [unit] "meaning", both optional */
bool ttc_parse_meaning(ttc_parser *parser, char **meaning); /* "meaning", optional */
bool ttc_parse_positive(ttc_parser *parser, const char *rule); /* > 0; rule: what the condition means, for an error */

/* After all records: look up references, solve eliminations, check that the table is complete, and warn. */
void ttc_parse_resolve(ttc_parser *parser);
void ttc_parse_warn(ttc_parser *parser); /* of unused names, defaults outside the domain, units that count as numbers */

#endif
