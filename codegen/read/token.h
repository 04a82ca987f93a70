/* Tokens of a table, and the lexer, which also finds where records begin: at a keyword that is the first word of its line. */
#ifndef TTC_TOKEN_H
#define TTC_TOKEN_H

#include "base/diagnostic.h"

/* Keywords that open a record. */
#define TTC_RECORD_LIST(X)                                                                                   \
    X(MODEL, "model") X(TITLE, "title") X(SOURCE, "source") X(PARAM, "param") X(STATE, "state")              \
    X(ROOT, "root") X(ANGLE, "angle") X(LET, "let") X(EQ, "eq") X(VARIANT, "variant") X(TIME, "time")        \
    X(ELIMINATE, "eliminate") X(DEFAULT, "default") X(INTEGRAL, "integral") X(INVARIANT, "invariant")        \
    X(MEASURE, "measure") X(REVERSOR, "reversor") X(EQUILIBRIA, "equilibria") X(TRACE, "trace")              \
    X(CHARPOLY, "charpoly") X(OBSTRUCTS, "obstructs") X(EQUAL, "equal") X(MATRIX, "matrix")                  \
    X(LEFTNULL, "leftnull") X(REDUCTION, "reduction") X(RATE, "rate") X(POSITIVE, "positive")                 \
    X(DOMAIN, "domain") X(EMBEDDING, "embedding")                                               \
    X(SYMMETRY, "symmetry") X(EXP, "exp") X(LOG, "log") X(OBSERVE, "observe") X(VALID, "valid") X(PERIODIC, "periodic") \
    X(POLE, "pole") X(SECTION, "section") X(LIFT, "lift") X(START, "start") X(TURNS, "turns") X(TIER, "tier")

/* Keywords inside a record. */
#define TTC_CLAUSE_LIST(X)                                                                                   \
    X(IN, "in") X(WHEN, "when") X(WHERE, "where") X(WHILE, "while") X(MODULO, "modulo") X(BY, "by")          \
    X(LIFTING, "lifting") X(ONTO, "onto") X(INTO, "into") X(WITH, "with") X(AT, "at") X(BESIDE, "beside")         \
    X(ENDING, "ending") X(ATAN2, "atan2") X(SQRT, "sqrt") X(COS, "cos") X(SIN, "sin")

#define TTC_KEYWORD_ENUM(name, text) TTC_KEYWORD_##name,
typedef enum {
    TTC_RECORD_LIST(TTC_KEYWORD_ENUM)
    TTC_RECORD_COUNT,
    TTC_KEYWORD_LAST_RECORD = TTC_RECORD_COUNT - 1,
    TTC_CLAUSE_LIST(TTC_KEYWORD_ENUM)
    TTC_KEYWORD_NONE
} ttc_keyword;
#undef TTC_KEYWORD_ENUM

typedef enum {
    TTC_TOKEN_END,     /* of the table */
    TTC_TOKEN_RECORD,  /* a keyword that opens a record; keyword NONE: a line that belongs to no record */
    TTC_TOKEN_KEYWORD, /* a reserved keyword that opens no record */
    TTC_TOKEN_NAME,    /* a name, with keyword NONE; or a keyword that is not reserved: the parser decides from its position */
    TTC_TOKEN_NUMBER,
    TTC_TOKEN_STRING,  /* text without the quotes */
    TTC_TOKEN_UNIT,    /* text without the brackets */
    TTC_TOKEN_ARROW,   /* -> */
    TTC_TOKEN_AT_LEAST,  /* >= */
    TTC_TOKEN_NOT_EQUAL, /* != */
    TTC_TOKEN_MARK,    /* one character, text[0] */
    TTC_TOKEN_BAD      /* already reported */
} ttc_token_kind;

typedef struct {
    ttc_token_kind kind;
    ttc_keyword keyword;
    uint32_t line, column;
    uint32_t length;
    const char *text; /* points into the table; not NUL-terminated */
} ttc_token;

enum { TTC_NAME_LIMIT = 63 };

/* Cut a table into tokens; the last one has kind END. text: `length` bytes that passed ttc_source_check; must outlive the tokens.
 * Reports errors, and leaves tokens BAD. Returns an array for the caller to free; NULL when memory is out. Cost: linear. */
ttc_token *ttc_lex(const char *text, size_t length, ttc_diagnostics *diagnostics);

const char *ttc_keyword_text(ttc_keyword keyword); /* "" for NONE */

#endif
