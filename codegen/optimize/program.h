/** Straight-line programs: what a kernel computes, operation by operation, in exact symbolic form.
 *
 *  A program is a list of instructions, each of which uses values made before it (static single assignment), and a list of
 *  outputs. All emitted code is made from programs, which can be read back: their values are rational functions of inputs,
 *  parameters, pi, and of roots, cosines, sines, exponentials and logarithms of such. Equal instructions are one value, constants
 *  are folded, and x + 0, x * 1, x * 0, (x/y) * y, -(-x) and the like vanish while it is built.
 *
 *  Errors: when memory is out, or a constant is divided by the constant zero, the program fails for good: later calls return
 *  TTC_NO_VALUE, and ttc_program_failed() returns true. */
#ifndef TTC_PROGRAM_H
#define TTC_PROGRAM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <flint/fmpq.h>

typedef enum {
    TTC_OP_INPUT,     /* x[index] */
    TTC_OP_PARAMETER, /* p[index], or params[index] */
    TTC_OP_CONSTANT,  /* an exact rational */
    TTC_OP_NEGATE,    /* -a */
    TTC_OP_ADD,       /* a + b */
    TTC_OP_SUBTRACT,  /* a - b */
    TTC_OP_MULTIPLY,  /* a * b */
    TTC_OP_DIVIDE,    /* a / b */
    TTC_OP_FMA,       /* a * b + c, rounded once where the target can */
    TTC_OP_FMS,       /* a * b - c */
    TTC_OP_FNMA,      /* c - a * b */
    TTC_OP_ROOT,      /* sqrt(a) */
    TTC_OP_COSINE,
    TTC_OP_SINE,
    TTC_OP_EXP,
    TTC_OP_LOG,
    TTC_OP_PI         /* pi, rounded as the arithmetic needs */
} ttc_op;

typedef uint32_t ttc_value;
#define TTC_NO_VALUE UINT32_MAX

typedef struct {
    ttc_op op;
    union { /* TTC_NO_VALUE where the operation has none */
        struct {
            ttc_value a, b, c;
        };
        ttc_value operands[3];
    };
    uint32_t index;    /* INPUT, PARAMETER */
    fmpq_t constant;   /* CONSTANT */
    char *label;       /* see ttc_program_label */
} ttc_instruction;

typedef struct ttc_program ttc_program;

typedef struct {
    unsigned add, multiply, fma, divide, root, elementary; /* a negation counts as an addition */
    unsigned depth, live; /* longest chain of operations; most temporaries alive */
} ttc_count;

ttc_program *ttc_program_create(void); /* NULL when memory is out */
void ttc_program_destroy(ttc_program *program); /* legal on NULL */
bool ttc_program_failed(const ttc_program *program);
/* From here on equal operations are not shared, as in a formula evaluated as it stands; equal inputs and constants still are. */
void ttc_program_keep_duplicates(ttc_program *program);

ttc_value ttc_program_input(ttc_program *program, uint32_t index);
ttc_value ttc_program_parameter(ttc_program *program, uint32_t index);
ttc_value ttc_program_pi(ttc_program *program);
ttc_value ttc_program_constant(ttc_program *program, const fmpq_t value);
ttc_value ttc_program_integer(ttc_program *program, long value);
ttc_value ttc_program_apply(ttc_program *program, ttc_op op, ttc_value a, ttc_value b, ttc_value c);
ttc_value ttc_program_negate(ttc_program *program, ttc_value a);
ttc_value ttc_program_add(ttc_program *program, ttc_value a, ttc_value b);
ttc_value ttc_program_subtract(ttc_program *program, ttc_value a, ttc_value b);
ttc_value ttc_program_multiply(ttc_program *program, ttc_value a, ttc_value b);
ttc_value ttc_program_divide(ttc_program *program, ttc_value a, ttc_value b);
ttc_value ttc_program_root(ttc_program *program, ttc_value a);
/* a^exponent by repeated squaring; one division when the exponent is negative. */
ttc_value ttc_program_power(ttc_program *program, ttc_value a, long exponent);
void ttc_program_output(ttc_program *program, ttc_value value);

/* Name a value for readers of the emitted code. The first name stays; leaves take none. */
void ttc_program_label(ttc_program *program, ttc_value value, const char *label);
const char *ttc_program_label_of(const ttc_program *program, ttc_value value); /* NULL when it has none */

size_t ttc_program_size(const ttc_program *program);
const ttc_instruction *ttc_program_at(const ttc_program *program, ttc_value value);
size_t ttc_program_output_count(const ttc_program *program);
ttc_value ttc_program_output_at(const ttc_program *program, size_t index);

/* Count the uses of each value, added to uses, shape (size,); an output counts as two. */
void ttc_program_count_uses(uint32_t *uses, const ttc_program *program);
/* Number of operands of an operation: 0 to 3, in the order a, b, c. */
unsigned ttc_op_arity(ttc_op op);
/* Latency of an operation in multiplications; 0 for leaves. Rough, from tables of processors of the years around 2020: a
 * multiplication takes 4 cycles, a division 13 to 15, a root 13 to 19. */
unsigned ttc_op_latency(ttc_op op);
/* The member of a count for an operation that is no leaf. */
unsigned *ttc_op_counter(ttc_count *count, ttc_op op);

/* Append an operation without folding: for copying from a folded program. */
ttc_value ttc_program_copy(ttc_program *program, ttc_op op, ttc_value a, ttc_value b, ttc_value c);

/** A new program of the values in `order`, operands before users, with the same outputs. Like the three below, NULL when memory is
 *  out. */
ttc_program *ttc_program_reorder(const ttc_program *program, const ttc_value *order, size_t count);

/** The same values in an order in which few temporaries are alive at once. */
ttc_program *ttc_program_schedule(const ttc_program *program);

/** Only the values that outputs need. */
ttc_program *ttc_program_trim(const ttc_program *program);

/* The same values, with parameter i as parameter numbers[i]. */
ttc_program *ttc_program_renumber(const ttc_program *program, const uint32_t *numbers);

/* All counts are 0 when memory is out. */
ttc_count ttc_program_count(const ttc_program *program);
/* Latency of the longest chain, as in ttc_op_latency; UINT_MAX when memory is out. */
unsigned ttc_program_latency(const ttc_program *program);
/* The number of operations, an fma counted as two. */
unsigned ttc_count_flops(ttc_count count);

#endif
