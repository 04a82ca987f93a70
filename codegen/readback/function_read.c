#include "readback/function_read.h"

#include "base/array.h"
#include "base/text.h"
#include "emit/emit.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *at;         /* the text that is read next */
    ttc_program *program;
    ttc_value *temporaries; /* t0, t1, ... */
    size_t count;
    ttc_value unset;        /* of outputs that no line sets by themselves */
    bool rounded, failed;
} reader;

static bool take(reader *r, const char *word)
{
    const size_t length = strlen(word);
    if (strncmp(r->at, word, length) != 0) return false;
    r->at += length;
    return true;
}

static void expect(reader *r, const char *word)
{
    if (!take(r, word)) r->failed = true;
}

static size_t read_index(reader *r)
{
    char *end = NULL;
    const unsigned long index = isdigit((unsigned char)*r->at) ? strtoul(r->at, &end, 10) : 0;
    if (end == NULL || index > UINT32_MAX - 1) r->failed = true;
    else r->at = end;
    return index;
}

/* An integer, written as 12.0; 0x1.8p+3 is a rounded number. */
static void read_integer(reader *r, fmpz_t out)
{
    const size_t length = strspn(r->at, "0123456789");
    char digits[32];
    if (strncmp(r->at, "0x", 2) == 0) r->rounded = true;
    if (length == 0 || length >= sizeof digits) r->failed = true;
    if (r->rounded || r->failed) return;
    memcpy(digits, r->at, length);
    digits[length] = '\0';
    r->at += length;
    expect(r, ".0");
    if (fmpz_set_str(out, digits, 10) != 0) r->failed = true;
}

/* Read a constant: 12.0, (-12.0) or (1.0 / 3.0). */
static ttc_value read_constant(reader *r)
{
    fmpq_t value;
    ttc_value out = TTC_NO_VALUE;
    const bool bracket = take(r, "("), negative = bracket && take(r, "-");
    fmpq_init(value);
    read_integer(r, fmpq_numref(value));
    if (bracket && take(r, " / ")) read_integer(r, fmpq_denref(value));
    if (bracket) expect(r, ")");
    if (fmpz_is_zero(fmpq_denref(value))) r->failed = true;
    if (!r->failed && !r->rounded) {
        fmpq_canonicalise(value);
        if (negative) fmpq_neg(value, value);
        out = ttc_program_constant(r->program, value);
    }
    fmpq_clear(value);
    return out;
}

static ttc_value read_operand(reader *r)
{
    ttc_value out = TTC_NO_VALUE;
    if (take(r, TTC_PI_DOUBLE)) return ttc_program_pi(r->program);
    if (take(r, "x[")) out = ttc_program_input(r->program, (uint32_t)read_index(r));
    else if (take(r, "params[")) out = ttc_program_parameter(r->program, (uint32_t)read_index(r));
    else if (*r->at == 't') {
        r->at++;
        const size_t number = read_index(r);
        if (number >= r->count) r->failed = true;
        return r->failed ? TTC_NO_VALUE : r->temporaries[number];
    } else {
        return read_constant(r);
    }
    expect(r, "]");
    return out;
}

static ttc_value apply(reader *r, ttc_op op, ttc_value a, ttc_value b, ttc_value c)
{
    return r->failed || r->rounded ? TTC_NO_VALUE : ttc_program_copy(r->program, op, a, b, c);
}

static ttc_value read_fused(reader *r, ttc_op op)
{
    const ttc_value a = read_operand(r);
    expect(r, ", ");
    const ttc_value b = read_operand(r);
    expect(r, ", ");
    const ttc_value c = read_operand(r);
    expect(r, ")");
    return apply(r, op, a, b, c);
}

static ttc_value read_expression(reader *r)
{
    static const struct {
        const char *text;
        ttc_op op;
    } fused[] = { { "JLT_FMA(", TTC_OP_FMA }, { "JLT_FMS(", TTC_OP_FMS }, { "JLT_FNMA(", TTC_OP_FNMA } },
      functions[] = { { "sqrt(", TTC_OP_ROOT }, { "cos(", TTC_OP_COSINE }, { "sin(", TTC_OP_SINE }, { "exp(", TTC_OP_EXP },
                      { "log(", TTC_OP_LOG } },
      between[] = { { " + ", TTC_OP_ADD }, { " - ", TTC_OP_SUBTRACT }, { "*", TTC_OP_MULTIPLY }, { "/", TTC_OP_DIVIDE } };
    for (size_t i = 0; i < sizeof fused / sizeof *fused; i++)
        if (take(r, fused[i].text)) return read_fused(r, fused[i].op);
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        if (!take(r, functions[i].text)) continue;
        const ttc_value a = read_operand(r);
        expect(r, ")");
        return apply(r, functions[i].op, a, TTC_NO_VALUE, TTC_NO_VALUE);
    }
    if (take(r, "-")) return apply(r, TTC_OP_NEGATE, read_operand(r), TTC_NO_VALUE, TTC_NO_VALUE);
    const ttc_value a = read_operand(r);
    for (size_t i = 0; i < sizeof between / sizeof *between; i++)
        if (take(r, between[i].text)) return apply(r, between[i].op, a, read_operand(r), TTC_NO_VALUE);
    r->failed = true;
    return TTC_NO_VALUE;
}

/* Read one line. outputs, shape (count,), has TTC_NO_VALUE where none was set. Returns false when memory is out. */
static bool read_line(reader *r, ttc_value *outputs, size_t count)
{
    expect(r, "    ");
    if (take(r, "(void)")) {
        r->at += strcspn(r->at, ";\n");
    } else if (take(r, "const double t")) {
        if (read_index(r) != r->count) r->failed = true;
        expect(r, " = ");
        const ttc_value value = read_expression(r);
        if (!TTC_ARRAY_GROW(r->temporaries, r->count)) return false;
        r->temporaries[r->count++] = value;
    } else if (take(r, "for (size_t i = 0; i < ")) { /* before any output is set: those that no later line sets are 0 */
        if (read_index(r) != count) r->failed = true;
        expect(r, "; i++) out[i] = ");
        for (size_t i = 0; i < count; i++)
            if (outputs[i] != TTC_NO_VALUE) r->failed = true;
        r->unset = read_operand(r);
    } else {
        expect(r, "out[");
        const size_t index = read_index(r);
        expect(r, "] = ");
        const ttc_value value = read_operand(r);
        if (r->failed || index >= count || outputs[index] != TTC_NO_VALUE) r->failed = true;
        else outputs[index] = value;
    }
    expect(r, ";");
    if (take(r, " /* ")) { /* a comment that ends where its line does */
        const char *close = strstr(r->at, "*/");
        if (close == NULL || close + 2 != r->at + strcspn(r->at, "\n")) r->failed = true;
        else r->at = close + 2;
    }
    expect(r, "\n");
    return true;
}

/* The text after the function's head; NULL unless there is exactly one such head. */
static const char *find_body(const char *text, const char *name)
{
    ttc_text head = { 0 };
    ttc_text_format(&head, "static void %s(const double *restrict x, const double *restrict params, double *restrict out)\n{\n",
                    name);
    const char *at = head.failed ? NULL : strstr(text, ttc_text_string(&head));
    if (at != NULL) at += head.length;
    if (at != NULL && strstr(at, ttc_text_string(&head)) != NULL) at = NULL;
    ttc_text_clear(&head);
    return at;
}

ttc_function_status ttc_function_read(ttc_program **out, const char *text, const char *name, size_t outputs)
{
    reader r = { .at = find_body(text, name), .program = ttc_program_create(), .unset = TTC_NO_VALUE };
    ttc_value *set = malloc((outputs + 1) * sizeof *set);
    bool memory = r.program != NULL && set != NULL;
    *out = NULL;
    if (r.at == NULL) r.failed = true;
    if (memory) ttc_program_keep_duplicates(r.program);
    for (size_t i = 0; memory && i < outputs; i++) set[i] = TTC_NO_VALUE;
    while (memory && !r.failed && !r.rounded && !take(&r, "}\n")) memory = read_line(&r, set, outputs);
    for (size_t i = 0; memory && !r.failed && !r.rounded && i < outputs; i++) {
        const ttc_value value = set[i] != TTC_NO_VALUE ? set[i] : r.unset;
        if (value == TTC_NO_VALUE) r.failed = true;
        else ttc_program_output(r.program, value);
    }
    free(set);
    free(r.temporaries);
    if (memory && !r.failed && !r.rounded) *out = r.program;
    else ttc_program_destroy(r.program);
    return !memory ? TTC_FUNCTION_NO_MEMORY : r.rounded ? TTC_FUNCTION_ROUNDED : r.failed ? TTC_FUNCTION_ABSENT : TTC_FUNCTION_READ;
}
