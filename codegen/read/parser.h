/* Inside of the parser, which makes a model of tokens. Each ttc_parse_... reads from the current token, parser->tokens[parser->at],
 * and leaves the first one that it has not read. Where something is wrong it reports that to the diagnostics and returns false,
 * NULL or TTC_NONE; ttc_model_parse then goes on at the next record. */
#ifndef TTC_PARSER_H
#define TTC_PARSER_H

#include "base/array.h"
#include "read/model.h"
#include "read/token.h"

enum {
    TTC_NESTING_LIMIT = 256,          /* of parentheses */
    TTC_DIGIT_LIMIT = 1000,           /* of a number */
    TTC_DECIMAL_EXPONENT_LIMIT = 999, /* of a number */
    TTC_SYMBOL_LIMIT = 4096,          /* names of quantities; claims */
    TTC_STATE_LIMIT = 128,
    TTC_REGION_LIMIT = 256,           /* domain records */
    TTC_KERNEL_LIMIT = 256,           /* variants; times; eliminations */
    TTC_REFERENCE_LIMIT = 1 << 14,    /* names of claims within records */
    TTC_EXPANSION_LIMIT = 1000000     /* operands of an expression written out in full */
};

/* A claim's name used by another record; looked up when the whole table is read, so that order is free. */
typedef enum { TTC_REFER_FAMILY, TTC_REFER_MODULO, TTC_REFER_MEMBER, TTC_REFER_ELIMINATION } ttc_reference_role;

typedef struct {
    ttc_reference_role role;
    size_t owner; /* index of the claim or elimination that refers */
    const ttc_token *name;
} ttc_reference;

typedef struct {
    ttc_model *model;
    ttc_diagnostics *diagnostics;
    const ttc_token *tokens;
    size_t at;
    size_t errors_before; /* errors that the diagnostics had before this table */
    bool out_of_memory;

    uint32_t *hashes;    /* hash of the name, by symbol */
    unsigned char *used; /* by symbol: 1 where some record uses it; the others get a warning */
    ttc_reference *references; /* (reference_count,): to be looked up at the end of the table */
    size_t reference_count;

    /* Expressions under construction: one stack has the operands of all sums and products that are open, the inner ones on top. */
    ttc_id *operands;
    long *exponents;
    fmpq *weights; /* 1 or -1: small numbers of FLINT, which need no clearing */
    ttc_place *places;
    size_t operand_count, operand_capacity;
    unsigned nesting;
    bool in_charpoly; /* the record is a `charpoly`, in which `lambda` is the indeterminate */
    bool may_rate;    /* rate(expression) is allowed in this record */

    ttc_id *divisors; /* what the current record divides by, as written */
    size_t divisor_count;
    uint32_t *uses;   /* definitions (let, root, function) that the current record names */
    size_t use_count;

    double *expansions; /* by node of the graph: how many operands it has when all definitions are written out */
    size_t measured, measured_capacity; /* the last node for which that is known; room */
} ttc_parser;

/* Tokens. _at looks whether the current token is this one; _accept reads it where it is; _expect reads it, or reports what was
 * expected, `after` saying behind what. */
const ttc_token *ttc_parse_peek(const ttc_parser *parser);
bool ttc_parse_at_mark(const ttc_parser *parser, char mark);
bool ttc_parse_at_keyword(const ttc_parser *parser, ttc_keyword keyword);
bool ttc_parse_accept_mark(ttc_parser *parser, char mark);
bool ttc_parse_accept_keyword(ttc_parser *parser, ttc_keyword keyword);
bool ttc_parse_expect_mark(ttc_parser *parser, char mark, const char *after);
bool ttc_parse_expect_keyword(ttc_parser *parser, ttc_keyword keyword, const char *after);
const ttc_token *ttc_parse_name(ttc_parser *parser, const char *what); /* NULL after a report */
bool ttc_parse_record_end(ttc_parser *parser); /* reports what is left over */
bool ttc_parse_unexpected(ttc_parser *parser, const char *expected); /* reports; always false */
ttc_place ttc_token_place(const ttc_token *token);
bool ttc_token_is(const ttc_token *token, const char *name);

TTC_PRINTF(3, 4) bool ttc_parse_error(ttc_parser *parser, ttc_place place, const char *format, ...); /* always false */
bool ttc_parse_no_memory(ttc_parser *parser); /* always false */

/* Add a symbol or a claim to a list of the model; false: memory. */
bool ttc_parse_append(ttc_parser *parser, uint32_t **list, size_t *count, uint32_t index);

/* Expressions. */
bool ttc_parse_uses(ttc_parser *parser, uint32_t symbol); /* notes that the current record names this definition */
ttc_id ttc_parse_expression(ttc_parser *parser);
/* Read the terms of a sum, and leave them on the stack of operands, from the index that is returned on; SIZE_MAX after a report. */
size_t ttc_parse_terms(ttc_parser *parser);
ttc_id ttc_parse_number(ttc_parser *parser, const ttc_token *token);
ttc_id ttc_parse_graph_error(ttc_parser *parser, ttc_place place); /* reports the graph's error; always TTC_NONE */
/* Report an expression that has more than TTC_EXPANSION_LIMIT operands when written out; false then. */
bool ttc_parse_measure(ttc_parser *parser, ttc_id id, ttc_place place);

/* Names. */
bool ttc_parse_find(const ttc_parser *parser, const ttc_token *name, uint32_t *symbol); /* lambda excluded */
bool ttc_parse_define(ttc_parser *parser, const ttc_token *name, ttc_symbol_kind kind, ttc_id definition, uint32_t *symbol);
/* The number pi, where no record of the table defines that name. */
bool ttc_parse_pi(ttc_parser *parser, const ttc_token *name, uint32_t *symbol);
void ttc_parse_unknown(ttc_parser *parser, const ttc_token *name);
bool ttc_parse_refer(ttc_parser *parser, ttc_reference_role role, size_t owner, const ttc_token *name);
char *ttc_parse_copy(ttc_parser *parser, const char *text, size_t length); /* NULL when memory is out */

/* The tokens from `first` up to the one at hand, as they are written, with one blank where there is any. */
char *ttc_parse_text_since(ttc_parser *parser, size_t first); /* NULL when memory is out */

/* Lists shared by records. */
/* NAME = expr, ... of symbols of these kinds, a mask of 1 << ttc_symbol_kind. */
bool ttc_parse_bindings(ttc_parser *parser, ttc_bindings *bindings, unsigned kinds, const char *expected);
void ttc_parse_check_constants(ttc_parser *parser, const ttc_bindings *bindings); /* warns of excluded values */
/* FILE.tt, a table beside this one. */
bool ttc_parse_target_file(ttc_parser *parser, char **file);
/* NAME = expr, ... with names of that table, which are looked up when it is read; names, one a binding. */
bool ttc_parse_target_bindings(ttc_parser *parser, ttc_bindings *bindings, char ***names, const char *expected);
/* NAME = expr, or what else may give it, ... with names of another table. forms: a mask of 1 << ttc_given_form; PARAM =
 * INTEGRAL goes with any but the plain one. The entries and members go to the claim at hand. */
bool ttc_parse_image(ttc_parser *parser, ttc_image *image, ttc_claim *claim, unsigned forms, const char *expected);
/* The symbols set in `bound` must not stand, through definitions, in the expressions of `in` (after `first` is substituted
 * into them, when it is not NULL). */
bool ttc_parse_check_circle(ttc_parser *parser, const ttc_bindings *bound, const ttc_bindings *in, const ttc_bindings *first);

/* Records: the token at hand is the one after the keyword. */
bool ttc_parse_title(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_quantity(ttc_parser *parser, const ttc_token *keyword); /* param, state, root, angle, exp, log, let */
bool ttc_parse_equation(ttc_parser *parser);
bool ttc_parse_default(ttc_parser *parser);
bool ttc_parse_kernel(ttc_parser *parser, const ttc_token *keyword); /* variant, time, eliminate */
bool ttc_parse_claim(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_way(ttc_parser *parser, ttc_claim *claim); /* after the colon: a reduction by a table, or a lift into one */
bool ttc_parse_tier(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_region(ttc_parser *parser); /* domain */
bool ttc_parse_observe(ttc_parser *parser);
bool ttc_parse_valid(ttc_parser *parser);
bool ttc_parse_pole(ttc_parser *parser);
bool ttc_parse_section(ttc_parser *parser, ttc_claim *claim); /* what stands after the colon */
bool ttc_parse_lift(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_start(ttc_parser *parser);
bool ttc_parse_turns(ttc_parser *parser, const ttc_token *keyword);
bool ttc_parse_unit_and_meaning(ttc_parser *parser, char **unit, char **meaning); /* [unit] "meaning", both optional */
bool ttc_parse_meaning(ttc_parser *parser, char **meaning); /* a text in quotes, which may be missing */
bool ttc_parse_positive(ttc_parser *parser, const char *rule); /* > 0 */

/* When every record is read: references, eliminations, completeness, names never used. */
void ttc_parse_resolve(ttc_parser *parser);

#endif
