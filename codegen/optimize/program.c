#include "optimize/program.h"

#include "base/array.h"

#include <stdlib.h>
#include <string.h>

struct ttc_program {
    ttc_instruction *items;
    size_t count, capacity;
    ttc_value *buckets; /* open addressing, TTC_NO_VALUE: empty; size a power of two above twice the count */
    size_t bucket_count;
    ttc_value *outputs;
    size_t output_count;
    bool failed, keeps_duplicates;
};

ttc_program *ttc_program_create(void) { return calloc(1, sizeof(ttc_program)); }

void ttc_program_destroy(ttc_program *program)
{
    if (program == NULL) return;
    for (size_t i = 0; i < program->count; i++) {
        fmpq_clear(program->items[i].constant);
        free(program->items[i].label);
    }
    free(program->items);
    free(program->buckets);
    free(program->outputs);
    free(program);
}

bool ttc_program_failed(const ttc_program *program) { return program->failed; }
void ttc_program_keep_duplicates(ttc_program *program) { program->keeps_duplicates = true; }
size_t ttc_program_size(const ttc_program *program) { return program->count; }
size_t ttc_program_output_count(const ttc_program *program) { return program->output_count; }
ttc_value ttc_program_output_at(const ttc_program *program, size_t index) { return program->outputs[index]; }

void ttc_program_count_uses(uint32_t *uses, const ttc_program *program)
{
    for (size_t k = 0; k < program->count; k++)
        for (unsigned j = 0; j < ttc_op_arity(program->items[k].op); j++) uses[program->items[k].operands[j]]++;
    for (size_t k = 0; k < program->output_count; k++) uses[program->outputs[k]] += 2;
}

const ttc_instruction *ttc_program_at(const ttc_program *program, ttc_value value) { return program->items + value; }

#define COUNTED(member) offsetof(ttc_count, member)

/* Operands, latency, and the member of ttc_count that counts the operation; all 0 for leaves, which are not counted. */
static const struct {
    unsigned arity, latency;
    size_t counted;
} operations[] = {
    [TTC_OP_NEGATE] = { 1, 1, COUNTED(add) },
    [TTC_OP_ADD] = { 2, 1, COUNTED(add) },
    [TTC_OP_SUBTRACT] = { 2, 1, COUNTED(add) },
    [TTC_OP_MULTIPLY] = { 2, 1, COUNTED(multiply) },
    [TTC_OP_DIVIDE] = { 2, 4, COUNTED(divide) },
    [TTC_OP_FMA] = { 3, 1, COUNTED(fma) },
    [TTC_OP_FMS] = { 3, 1, COUNTED(fma) },
    [TTC_OP_FNMA] = { 3, 1, COUNTED(fma) },
    [TTC_OP_ROOT] = { 1, 5, COUNTED(root) },
    [TTC_OP_COSINE] = { 1, 15, COUNTED(elementary) },
    [TTC_OP_SINE] = { 1, 15, COUNTED(elementary) },
    [TTC_OP_EXP] = { 1, 15, COUNTED(elementary) },
    [TTC_OP_LOG] = { 1, 15, COUNTED(elementary) },
    [TTC_OP_PI] = { 0, 0, 0 },
};

unsigned ttc_op_arity(ttc_op op) { return operations[op].arity; }
unsigned ttc_op_latency(ttc_op op) { return operations[op].latency; }
unsigned *ttc_op_counter(ttc_count *count, ttc_op op) { return (unsigned *)(void *)((char *)count + operations[op].counted); }

static uint64_t hash_of(const ttc_instruction *i)
{
    uint64_t hash = (uint64_t)i->op;
    bool is_constant = i->op == TTC_OP_CONSTANT;
    const uint64_t words[] = { i->a, i->b, i->c, i->index,
                               is_constant ? fmpz_fdiv_ui(fmpq_numref(i->constant), 4294967291u) : 0,
                               is_constant ? fmpz_fdiv_ui(fmpq_denref(i->constant), 4294967291u) : 0 };
    for (size_t k = 0; k < sizeof words / sizeof *words; k++) {
        hash = (hash ^ words[k]) * UINT64_C(0x9E3779B97F4A7C15);
        hash ^= hash >> 29;
    }
    return hash;
}

static bool same(const ttc_instruction *i, const ttc_instruction *j)
{
    return i->op == j->op && i->a == j->a && i->b == j->b && i->c == j->c && i->index == j->index
           && fmpq_equal(i->constant, j->constant);
}

/* Whether an operation is never shared. */
static bool stays_apart(const ttc_program *program, const ttc_instruction *i)
{
    return program->keeps_duplicates && ttc_op_arity(i->op) > 0;
}

static void place(ttc_program *program, ttc_value value)
{
    if (stays_apart(program, program->items + value)) return;
    size_t at = (size_t)hash_of(program->items + value) & (program->bucket_count - 1);
    while (program->buckets[at] != TTC_NO_VALUE) at = (at + 1) & (program->bucket_count - 1);
    program->buckets[at] = value;
}

static bool grow(ttc_program *program)
{
    if (program->count < program->capacity) return true;
    size_t capacity = program->capacity == 0 ? 64 : 2 * program->capacity;
    ttc_instruction *items = realloc(program->items, capacity * sizeof *items);
    if (items == NULL) return false;
    program->items = items;
    ttc_value *buckets = malloc(4 * capacity * sizeof *buckets);
    if (buckets == NULL) return false;
    free(program->buckets);
    program->buckets = buckets;
    program->bucket_count = 4 * capacity;
    program->capacity = capacity;
    for (size_t i = 0; i < program->bucket_count; i++) buckets[i] = TTC_NO_VALUE;
    for (size_t i = 0; i < program->count; i++) place(program, (ttc_value)i);
    return true;
}

/* The value of an equal instruction, or a new one. Takes ownership of the constant. */
static ttc_value intern(ttc_program *program, ttc_instruction *instruction)
{
    if (!program->failed && !grow(program)) program->failed = true;
    if (program->failed) {
        fmpq_clear(instruction->constant);
        return TTC_NO_VALUE;
    }
    if (stays_apart(program, instruction)) {
        program->items[program->count] = *instruction;
        return (ttc_value)program->count++;
    }
    size_t at = (size_t)hash_of(instruction) & (program->bucket_count - 1);
    for (; program->buckets[at] != TTC_NO_VALUE; at = (at + 1) & (program->bucket_count - 1))
        if (same(program->items + program->buckets[at], instruction)) {
            fmpq_clear(instruction->constant);
            return program->buckets[at];
        }
    program->items[program->count] = *instruction;
    program->buckets[at] = (ttc_value)program->count;
    return (ttc_value)program->count++;
}

static ttc_value leaf(ttc_program *program, ttc_op op, uint32_t index)
{
    ttc_instruction i = { .op = op, .a = TTC_NO_VALUE, .b = TTC_NO_VALUE, .c = TTC_NO_VALUE, .index = index };
    fmpq_init(i.constant);
    return intern(program, &i);
}

ttc_value ttc_program_input(ttc_program *program, uint32_t index) { return leaf(program, TTC_OP_INPUT, index); }
ttc_value ttc_program_parameter(ttc_program *program, uint32_t index) { return leaf(program, TTC_OP_PARAMETER, index); }
ttc_value ttc_program_pi(ttc_program *program) { return leaf(program, TTC_OP_PI, 0); }

ttc_value ttc_program_constant(ttc_program *program, const fmpq_t value)
{
    ttc_instruction i = { .op = TTC_OP_CONSTANT, .a = TTC_NO_VALUE, .b = TTC_NO_VALUE, .c = TTC_NO_VALUE };
    fmpq_init(i.constant);
    fmpq_set(i.constant, value);
    return intern(program, &i);
}

ttc_value ttc_program_integer(ttc_program *program, long value)
{
    fmpq_t q;
    fmpq_init(q);
    fmpq_set_si(q, value, 1);
    ttc_value v = ttc_program_constant(program, q);
    fmpq_clear(q);
    return v;
}

static const fmpq *constant_of(const ttc_program *program, ttc_value value)
{
    const ttc_instruction *i = program->items + value;
    return i->op == TTC_OP_CONSTANT ? i->constant : NULL;
}

static bool is_integer(const ttc_program *program, ttc_value value, long integer)
{
    const fmpq *q = constant_of(program, value);
    return q != NULL && fmpz_is_one(fmpq_denref(q)) && fmpz_equal_si(fmpq_numref(q), integer);
}

static ttc_value negated_operand(const ttc_program *program, ttc_value value)
{
    return program->items[value].op == TTC_OP_NEGATE ? program->items[value].a : TTC_NO_VALUE;
}

static ttc_value fold(ttc_program *program, ttc_op op, const fmpq *a, const fmpq *b)
{
    fmpq_t q;
    fmpq_init(q);
    ttc_value value = TTC_NO_VALUE;
    if (op == TTC_OP_ADD) fmpq_add(q, a, b);
    else if (op == TTC_OP_SUBTRACT) fmpq_sub(q, a, b);
    else if (op == TTC_OP_MULTIPLY) fmpq_mul(q, a, b);
    else if (fmpq_is_zero(b)) program->failed = true;
    else fmpq_div(q, a, b);
    if (!program->failed) value = ttc_program_constant(program, q);
    fmpq_clear(q);
    return value;
}

static ttc_value raw(ttc_program *program, ttc_op op, ttc_value a, ttc_value b, ttc_value c)
{
    ttc_instruction i = { .op = op, .a = a, .b = b, .c = c };
    if ((op == TTC_OP_ADD || op == TTC_OP_MULTIPLY || op == TTC_OP_FMA || op == TTC_OP_FMS || op == TTC_OP_FNMA)
        && i.a > i.b) {
        i.a = b;
        i.b = a;
    }
    fmpq_init(i.constant);
    return intern(program, &i);
}

ttc_value ttc_program_copy(ttc_program *program, ttc_op op, ttc_value a, ttc_value b, ttc_value c)
{
    return program->failed ? TTC_NO_VALUE : raw(program, op, a, b, c);
}

ttc_value ttc_program_negate(ttc_program *program, ttc_value a)
{
    if (program->failed) return TTC_NO_VALUE;
    if (negated_operand(program, a) != TTC_NO_VALUE) return negated_operand(program, a);
    if (constant_of(program, a) != NULL) {
        ttc_value minus_one = ttc_program_integer(program, -1); /* may move the instructions */
        if (program->failed) return TTC_NO_VALUE;
        return fold(program, TTC_OP_MULTIPLY, constant_of(program, a), constant_of(program, minus_one));
    }
    if (program->items[a].op == TTC_OP_SUBTRACT)
        return raw(program, TTC_OP_SUBTRACT, program->items[a].b, program->items[a].a, TTC_NO_VALUE);
    return raw(program, TTC_OP_NEGATE, a, TTC_NO_VALUE, TTC_NO_VALUE);
}

ttc_value ttc_program_add(ttc_program *program, ttc_value a, ttc_value b)
{
    if (program->failed) return TTC_NO_VALUE;
    if (constant_of(program, a) != NULL && constant_of(program, b) != NULL)
        return fold(program, TTC_OP_ADD, constant_of(program, a), constant_of(program, b));
    if (is_integer(program, a, 0)) return b;
    if (is_integer(program, b, 0)) return a;
    if (negated_operand(program, b) != TTC_NO_VALUE)
        return ttc_program_subtract(program, a, negated_operand(program, b));
    if (negated_operand(program, a) != TTC_NO_VALUE)
        return ttc_program_subtract(program, b, negated_operand(program, a));
    return raw(program, TTC_OP_ADD, a, b, TTC_NO_VALUE);
}

ttc_value ttc_program_subtract(ttc_program *program, ttc_value a, ttc_value b)
{
    if (program->failed) return TTC_NO_VALUE;
    if (constant_of(program, a) != NULL && constant_of(program, b) != NULL)
        return fold(program, TTC_OP_SUBTRACT, constant_of(program, a), constant_of(program, b));
    if (a == b) return ttc_program_integer(program, 0);
    if (is_integer(program, a, 0)) return ttc_program_negate(program, b);
    if (is_integer(program, b, 0)) return a;
    if (negated_operand(program, b) != TTC_NO_VALUE) return ttc_program_add(program, a, negated_operand(program, b));
    return raw(program, TTC_OP_SUBTRACT, a, b, TTC_NO_VALUE);
}

static bool is_quotient_by(const ttc_program *program, ttc_value value, ttc_value divisor)
{
    return program->items[value].op == TTC_OP_DIVIDE && program->items[value].b == divisor;
}

ttc_value ttc_program_multiply(ttc_program *program, ttc_value a, ttc_value b)
{
    if (program->failed) return TTC_NO_VALUE;
    if (constant_of(program, a) != NULL && constant_of(program, b) != NULL)
        return fold(program, TTC_OP_MULTIPLY, constant_of(program, a), constant_of(program, b));
    if (is_integer(program, a, 0) || is_integer(program, b, 1)) return a;
    if (is_integer(program, b, 0) || is_integer(program, a, 1)) return b;
    if (is_integer(program, a, -1)) return ttc_program_negate(program, b);
    if (is_integer(program, b, -1)) return ttc_program_negate(program, a);
    if (is_quotient_by(program, a, b)) return program->items[a].a;
    if (is_quotient_by(program, b, a)) return program->items[b].a;
    ttc_value plain_a = negated_operand(program, a), plain_b = negated_operand(program, b);
    if (plain_a == TTC_NO_VALUE && plain_b == TTC_NO_VALUE) return raw(program, TTC_OP_MULTIPLY, a, b, TTC_NO_VALUE);
    ttc_value product = ttc_program_multiply(program, plain_a == TTC_NO_VALUE ? a : plain_a,
                                             plain_b == TTC_NO_VALUE ? b : plain_b);
    if (plain_a != TTC_NO_VALUE && plain_b != TTC_NO_VALUE) return product;
    return program->failed ? TTC_NO_VALUE : ttc_program_negate(program, product);
}

ttc_value ttc_program_divide(ttc_program *program, ttc_value a, ttc_value b)
{
    if (program->failed) return TTC_NO_VALUE;
    if (constant_of(program, a) != NULL && constant_of(program, b) != NULL)
        return fold(program, TTC_OP_DIVIDE, constant_of(program, a), constant_of(program, b));
    if (is_integer(program, a, 0) || is_integer(program, b, 1)) return a;
    if (is_integer(program, b, -1)) return ttc_program_negate(program, a);
    if (negated_operand(program, a) != TTC_NO_VALUE) {
        ttc_value quotient = ttc_program_divide(program, negated_operand(program, a), b);
        return program->failed ? TTC_NO_VALUE : ttc_program_negate(program, quotient);
    }
    return raw(program, TTC_OP_DIVIDE, a, b, TTC_NO_VALUE);
}

ttc_value ttc_program_root(ttc_program *program, ttc_value a)
{
    if (program->failed) return TTC_NO_VALUE;
    if (is_integer(program, a, 0) || is_integer(program, a, 1)) return a;
    return raw(program, TTC_OP_ROOT, a, TTC_NO_VALUE, TTC_NO_VALUE);
}

ttc_value ttc_program_power(ttc_program *program, ttc_value a, long exponent)
{
    ttc_value result = ttc_program_integer(program, 1);
    unsigned long n = exponent < 0 ? 0ul - (unsigned long)exponent : (unsigned long)exponent;
    for (ttc_value square = a; n != 0 && !program->failed; n >>= 1) {
        if (n & 1) result = ttc_program_multiply(program, result, square);
        if (n > 1) square = ttc_program_multiply(program, square, square);
    }
    if (exponent < 0) result = ttc_program_divide(program, ttc_program_integer(program, 1), result);
    return result;
}

ttc_value ttc_program_apply(ttc_program *program, ttc_op op, ttc_value a, ttc_value b, ttc_value c)
{
    if (program->failed) return TTC_NO_VALUE;
    switch (op) {
    case TTC_OP_NEGATE: return ttc_program_negate(program, a);
    case TTC_OP_ADD: return ttc_program_add(program, a, b);
    case TTC_OP_SUBTRACT: return ttc_program_subtract(program, a, b);
    case TTC_OP_MULTIPLY: return ttc_program_multiply(program, a, b);
    case TTC_OP_DIVIDE: return ttc_program_divide(program, a, b);
    case TTC_OP_ROOT: return ttc_program_root(program, a);
    default: return raw(program, op, a, b, c);
    }
}

void ttc_program_output(ttc_program *program, ttc_value value)
{
    if (program->failed || value == TTC_NO_VALUE) {
        program->failed = true;
        return;
    }
    program->failed |= !TTC_ARRAY_GROW(program->outputs, program->output_count);
    if (program->failed) return;
    program->outputs[program->output_count++] = value;
}

void ttc_program_label(ttc_program *program, ttc_value value, const char *label)
{
    if (program->failed || program->items[value].label != NULL || ttc_op_arity(program->items[value].op) == 0) return;
    size_t length = strlen(label) + 1;
    char *copy = malloc(length);
    if (copy != NULL) memcpy(copy, label, length);
    program->failed |= copy == NULL;
    program->items[value].label = copy;
}

const char *ttc_program_label_of(const ttc_program *program, ttc_value value) { return program->items[value].label; }
