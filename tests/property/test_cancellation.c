/* Digits of kernels where coordinates differ by many orders of magnitude: no digit is lost without a word.
 *
 * Oracle: ball enclosures of the table's own expressions. Tolerance: a running error analysis of the program, in units u of
 * rounding: e(a b) = e(a) + e(b) + 1, e(sqrt a) = e(a)/2 + 1, e(a + b) = (|a| e(a) + |b| e(b))/|a + b| + 1, to first order
 * (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 3.3); terms of second order are below one in a thousand
 * where e u is below 1e-3, and nothing is compared beyond. The analysis must be allowed to lose digits only at additions that
 * the kernel's descriptor names: at all others |a| + |b| may not exceed 4 |a + b|. */
#include "unit/check.h"

#include "ball/ball.h"
#include "core/random.h"
#include "emit/emit.h"
#include "kernels/kernels.h"
#include "optimize/program_cancel.h"
#include "proof/prove_text.h"

#include <float.h>

enum { SAMPLES = 300, MOST_STATES = 32, MOST_PARAMS = 32 };

typedef struct {
    double value, error; /* error: of the value's magnitude, in units of rounding */
} rounded;

/* One table under test. */
typedef struct {
    ttc_model *model;
    ttc_kernels *kernels;
    ttc_ball *ball;
    double x[MOST_STATES], params[MOST_PARAMS];
    unsigned compared;
} fixture;

static fixture open_table(ttc_model *model)
{
    fixture f = { .model = model, .ball = ttc_ball_create(model) };
    ttc_field *field = NULL;
    assert_non_null(f.ball);
    assert_int_equal(ttc_field_create(&field, model, NULL, NULL, NULL), TTC_FIELD_OK);
    f.kernels = ttc_kernels_create(field, TTC_EFFORT_FULL);
    assert_non_null(f.kernels);
    assert_true(ttc_kernels_keep_digits(f.kernels, TTC_EFFORT_FULL));
    assert_true(field->state_count <= MOST_STATES && field->param_count <= MOST_PARAMS);
    return f;
}

static void close_table(fixture *f)
{
    ttc_kernels_destroy(f->kernels);
    ttc_ball_destroy(f->ball);
    ttc_model_destroy(f->model);
}

static rounded sum_of(rounded a, rounded b)
{
    double sum = a.value + b.value, error = fabs(a.value) * a.error + fabs(b.value) * b.error;
    if (error == 0) return (rounded){ sum, sum == 0 ? 0 : 1 };
    return (rounded){ sum, sum == 0 ? INFINITY : error / fabs(sum) + 1 };
}

static bool is_power_of_two(double x)
{
    int exponent;
    return fabs(frexp(x, &exponent)) == 0.5;
}

static rounded product_of(rounded a, rounded b)
{
    bool is_exact = is_power_of_two(a.value) || is_power_of_two(b.value);
    if (a.value * b.value == 0) /* exactly, or nothing is known */
        return (rounded){ 0, (a.value == 0 && a.error == 0) || (b.value == 0 && b.error == 0) ? 0 : INFINITY };
    return (rounded){ a.value * b.value, a.error + b.error + !is_exact };
}

/* An addition that is not named may not cancel, unless its operands are exact. */
static void check_silence(ttc_loss loss, rounded a, rounded b)
{
    if (loss != TTC_KEEPS_DIGITS || (a.error == 0 && b.error == 0)) return;
    assert_below(fabs(a.value) + fabs(b.value), 4.001 * fabs(a.value + b.value));
}

static rounded operation(const ttc_instruction *i, const rounded *values, ttc_loss loss)
{
    if (i->op == TTC_OP_PI) return (rounded){ acos(-1), 1 };
    rounded a = values[i->a], b = ttc_op_arity(i->op) > 1 ? values[i->b] : a, c = ttc_op_arity(i->op) > 2 ? values[i->c] : a;
    switch (i->op) {
    case TTC_OP_NEGATE:
        return (rounded){ -a.value, a.error };
    case TTC_OP_SUBTRACT:
        b.value = -b.value;
        break;
    case TTC_OP_ADD:
        break;
    case TTC_OP_MULTIPLY:
        return product_of(a, b);
    case TTC_OP_DIVIDE:
        return (rounded){ a.value / b.value, a.error == 0 && a.value == 0 ? 0 : a.error + b.error + !is_power_of_two(b.value) };
    case TTC_OP_ROOT:
        return (rounded){ sqrt(a.value), a.error / 2 + 1 };
    case TTC_OP_COSINE: /* one unit in the last place, the library's, is two of rounding */
        return (rounded){ cos(a.value), a.error == 0 ? 2 : fabs(a.value * tan(a.value)) * a.error + 2 };
    case TTC_OP_SINE:
        return (rounded){ sin(a.value), a.error == 0 ? 2 : fabs(a.value / tan(a.value)) * a.error + 2 };
    case TTC_OP_EXP:
        return (rounded){ exp(a.value), a.error == 0 ? 2 : fabs(a.value) * a.error + 2 };
    case TTC_OP_LOG:
        return (rounded){ log(a.value), a.error == 0 ? 2 : a.error / fabs(log(a.value)) + 2 };
    default:
        a = product_of(a, b);
        b = c;
        if (i->op == TTC_OP_FMS) b.value = -b.value;
        if (i->op == TTC_OP_FNMA) a.value = -a.value;
        break;
    }
    check_silence(loss, a, b);
    return sum_of(a, b);
}

/* All values of a program; false where one leaves the range in which rounding errors are relative. */
static bool run(const fixture *f, const ttc_program *program, const rounded *block, const ttc_loss *losses, rounded *values)
{
    for (ttc_value v = 0; v < ttc_program_size(program); v++) {
        const ttc_instruction *i = ttc_program_at(program, v);
        if (i->op == TTC_OP_INPUT) values[v] = (rounded){ f->x[i->index], 0 };
        else if (i->op == TTC_OP_PARAMETER) values[v] = block[i->index];
        else if (i->op == TTC_OP_CONSTANT)
            values[v] = (rounded){ fmpz_get_d(fmpq_numref(i->constant)) / fmpz_get_d(fmpq_denref(i->constant)),
                                   fmpz_is_one(fmpq_denref(i->constant)) ? 0 : 1 };
        else values[v] = operation(i, values, losses == NULL ? TTC_CANCELS : losses[v]);
        double size = fabs(values[v].value);
        if (!isfinite(size) || (size != 0 && (size < 1e-280 || size > 1e280))) return false;
    }
    return true;
}

/* What the table says of an output. */
static ttc_id expression_of(const fixture *f, ttc_kernel_kind kind, size_t index)
{
    const ttc_model *model = f->model;
    size_t n = model->state_count;
    ttc_id sum;
    switch (kind) {
    case TTC_KERNEL_RHS:
        return ttc_model_field(model, index);
    case TTC_KERNEL_JACOBIAN:
        return ttc_model_partial(model, ttc_model_field(model, index / n), model->states[index % n]);
    case TTC_KERNEL_RHS_JACOBIAN:
        return index < n ? expression_of(f, TTC_KERNEL_RHS, index) : expression_of(f, TTC_KERNEL_JACOBIAN, index - n);
    case TTC_KERNEL_DIVERGENCE:
        sum = ttc_integer(model->graph, 0);
        for (size_t i = 0; i < n; i++) sum = ttc_add(model->graph, sum, expression_of(f, TTC_KERNEL_JACOBIAN, i * n + i));
        return sum;
    case TTC_KERNEL_INTEGRAL_VALUES:
        return model->claims[f->kernels->integrals[index]].expression;
    case TTC_KERNEL_INTEGRAL_GRADIENTS:
        return ttc_model_partial(model, model->claims[f->kernels->integrals[index / n]].expression, model->states[index % n]);
    default:
        return TTC_NONE;
    }
}

static void draw_point(fixture *f, jlt_random *random)
{
    const ttc_model *model = f->model;
    for (size_t k = 0; k < model->param_count; k++) {
        const ttc_symbol_entry *p = model->symbols + model->params[k];
        double size = jlt_random_magnitude(random, -3, 3);
        bool has_sign = p->sign == TTC_POSITIVE || p->sign == TTC_NONNEGATIVE;
        f->params[k] = has_sign || jlt_random_between(random, -1, 1) > 0 ? size : -size;
        assert_true(ttc_ball_set(f->ball, model->params[k], f->params[k]));
    }
    for (size_t k = 0; k < model->state_count; k++) {
        const ttc_symbol_entry *s = model->symbols + model->states[k];
        ttc_extent extent = ttc_field_extent(f->kernels->field, s->node);
        double size = jlt_random_magnitude(random, -8, 8), value = jlt_random_between(random, -1, 1) > 0 ? size : -size;
        if (isfinite(extent.low) && isfinite(extent.high)) {
            value = extent.low + (extent.high - extent.low) * jlt_random_between(random, 0, 1);
            if (size < 0.1) value = value < (extent.low + extent.high) / 2 ? extent.low + size : extent.high - size;
        } else if (isfinite(extent.low)) {
            value = extent.low + size;
        }
        if (!(value > extent.low && value < extent.high)) value = (extent.low + extent.high) / 2;
        f->x[k] = value;
        assert_true(ttc_ball_set(f->ball, model->states[k], value));
    }
}

static void compare_output(fixture *f, ttc_kernel_kind kind, size_t index, rounded computed)
{
    ttc_enclosure exact;
    if (!(computed.error * DBL_EPSILON < 1e-3)) return;
    if (!ttc_ball_estimate(&exact, f->ball, expression_of(f, kind, index))) return;
    double off = fabs((computed.value - exact.value) - exact.rest);
    double bound = (1.001 * computed.error * DBL_EPSILON / 2 + 1e-25) * fabs(exact.value) + exact.radius;
    if (!(off <= bound))
        fail_msg("%s: %s[%zu] = %.17g, true value %.17g, off by %.3g, bound %.3g", f->model->name, ttc_kernel_name(kind), index,
                 computed.value, exact.value, off, bound);
    f->compared++;
}

/* What prepared values lose is said of the expressions that they are. */
static void find_prepared_losses(const fixture *f, ttc_loss *losses)
{
    const ttc_program *prepare = f->kernels->prepare;
    size_t n = ttc_program_size(prepare);
    unsigned char *is_lossy = calloc(n + 1, 1);
    assert_non_null(is_lossy);
    assert_true(ttc_program_losses(losses, prepare, f->kernels->field, NULL));
    for (ttc_value v = 0; v < n; v++) {
        const ttc_instruction *i = ttc_program_at(prepare, v);
        is_lossy[v] = losses[v] != TTC_KEEPS_DIGITS;
        for (unsigned k = 0; k < ttc_op_arity(i->op); k++) is_lossy[v] |= is_lossy[i->operands[k]];
    }
    for (size_t k = 0; k < ttc_program_output_count(prepare); k++)
        if (is_lossy[ttc_program_output_at(prepare, k)])
            assert_true(ttc_expression_cancels(f->kernels->field, f->kernels->prepared.entries[k]));
    free(is_lossy);
}

static void check_kernel(fixture *f, ttc_kernel_kind kind)
{
    const ttc_program *program = f->kernels->kernels[kind].optimized, *prepare = f->kernels->prepare;
    ttc_field *field = f->kernels->field;
    size_t params = field->param_count;
    if (f->kernels->kernels[kind].count == 0) return;
    ttc_loss *losses = calloc(ttc_program_size(program) + 1, sizeof *losses);
    ttc_loss *prepared_losses = calloc(ttc_program_size(prepare) + 1, sizeof *prepared_losses);
    rounded *values = calloc(ttc_program_size(program) + 1, sizeof *values);
    rounded *prepared = calloc(ttc_program_size(prepare) + 1, sizeof *prepared);
    rounded *block = calloc(ttc_prepared_size(&f->kernels->prepared) + 1, sizeof *block);
    jlt_random random;
    assert_true(losses != NULL && prepared_losses != NULL && values != NULL && prepared != NULL && block != NULL);
    assert_true(ttc_program_losses(losses, program, field, &f->kernels->prepared));
    find_prepared_losses(f, prepared_losses);
    jlt_random_seed(&random, 7);
    for (int sample = 0; sample < SAMPLES; sample++) {
        draw_point(f, &random);
        for (size_t k = 0; k < params; k++) block[k] = (rounded){ f->params[k], 0 };
        if (!run(f, prepare, block, prepared_losses, prepared)) continue;
        for (size_t k = 0; k < ttc_program_output_count(prepare); k++)
            block[params + k] = prepared[ttc_program_output_at(prepare, k)];
        if (!run(f, program, block, losses, values)) continue;
        for (size_t k = 0; k < ttc_program_output_count(program); k++)
            compare_output(f, kind, k, values[ttc_program_output_at(program, k)]);
    }
    free(losses);
    free(prepared_losses);
    free(values);
    free(prepared);
    free(block);
}

static size_t check_model(ttc_model *model)
{
    fixture f = open_table(model);
    for (int kind = 0; kind <= TTC_KERNEL_INTEGRAL_GRADIENTS; kind++) check_kernel(&f, (ttc_kernel_kind)kind);
    size_t compared = f.compared;
    print_message("%s: %zu outputs compared\n", model->name, compared);
    assert_true(compared > 100);
    close_table(&f);
    return compared;
}

/* Tables in which every difference can be written without cancellation; of those in `first_order`, not in derivatives. */
static const char *const first_order[] = { "centres", "squares" };
static const char *const repaired[] = {
    "model plane\nstate x\nstate y\nroot r = sqrt(x^2 + y^2)\neq x = x/r\neq y = y/r\n",
    "model space\nstate x\nstate y\nstate z\nroot r = sqrt(x^2 + y^2 + z^2)\neq x = x/r\neq y = y/r\neq z = z/r\n",
    "model four\nstate x\nstate y\nstate z\nstate w\nroot r = sqrt(x^2 + y^2 + z^2 + w^2)\n"
    "eq x = x/r\neq y = y/r\neq z = z/r\neq w = w/r\n",
    "model weighted\nparam a > 0\nparam b > 0\nparam c > 0\nstate x\nstate y\nroot r = sqrt(a*x^2 + b*y^2 + c)\n"
    "eq x = x/r\neq y = y/r\n",
    "model shifted\nparam a\nparam b\nstate x\nstate y\nstate z\nroot r = sqrt((x - a)^2 + (y - b)^2 + z^2)\n"
    "eq x = (x - a)/r\neq y = (y - b)/r\neq z = z/r\n",
    "model lets\nparam a\nstate x\nstate y\nstate z\nlet u = x - a\nlet p = y^2 + z^2\nlet q = u^2 + p\nroot r = sqrt(q)\n"
    "eq x = u/r\neq y = y/r\neq z = z/r\n",
    "model nested\nstate x\nstate y\nstate z\nroot r = sqrt(x^2 + y^2)\nroot R = sqrt(r^2 + z^2)\n"
    "eq x = x/R\neq y = y/r\neq z = z/R\n",
    "model circle\nstate x in (-1, 1)\nstate y\nroot s = sqrt(1 - x^2)\neq x = x/s\neq y = y*s\n",
    "model radius\nparam a > 0\nstate x in (-a, a)\nroot s = sqrt(a^2 - x^2)\neq x = x/s\n",
    "model product\nstate x\nstate y\nstate z\nroot r = sqrt(x^2 + y^2)\nroot q = sqrt(1 + z^2)\n"
    "eq x = x/(r*q)\neq y = y/(r*q)\neq z = z/q\n",
    "model conjugate\nstate x in (-1, 1)\nstate y in (0, inf)\nroot s = sqrt(1 - x^2)\nroot r = sqrt(1 + y^2)\n"
    "eq x = 1 - s\neq y = r - y\n",
    "model centres\nstate x\nstate y\nroot r = sqrt((x - 1)^2 + y^2)\nroot q = sqrt((x + 1)^2 + y^2)\n"
    "eq x = y*(r - q)\neq y = x^2\n",
    "model fraction\nstate x in (0, inf)\nstate y in (0, inf)\neq x = x/(1 + x + y)\neq y = y/(1 + x + y)\n",
    "model squares\nparam a\nparam b\nstate x\nstate y\nstate z\n"
    "eq x = a*x*y^2 - a*x*z^2\neq y = x^4 - y^4\neq z = b^2*z - z^3\n",
};

/* Tables with true changes of sign. */
static const char *const named[] = {
    "model gravity\nstate x\nstate y\nstate z\nroot r = sqrt(x^2 + y^2 + z^2)\neq x = x/r^3\neq y = y/r^3\neq z = z/r^3\n",
    ("model attraction\nstate x\nstate y\nroot r = sqrt((x - 1)^2 + y^2)\nroot q = sqrt((x + 1)^2 + y^2)\n"
    "eq x = (x - 1)/r^3 + (x + 1)/q^3\neq y = y/r^3 + y/q^3\n"),
    "model linear\nparam a\nparam b\nstate x\nstate y\neq x = a*x + b*y\neq y = (a - b)*x - x*y + 1\n",
    "model turning\nstate x\nstate y\nangle c s = cos(x + y) sin(x + y)\neq x = c\neq y = s\n",
    "model sphere\nstate x\nstate y\nroot s = sqrt(1 - x^2 - y^2)\neq x = s\neq y = x*s\n",
};

static void kernels_err_by_roundings_alone_or_say_where_they_lose_digits(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof repaired / sizeof *repaired; i++) check_model(parse_text(repaired[i]));
    for (size_t i = 0; i < sizeof named / sizeof *named; i++) check_model(parse_text(named[i]));
}

static size_t check_path(const char *path)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    ttc_model *model = ttc_model_read(path, diagnostics);
    ttc_diagnostics_destroy(diagnostics);
    assert_non_null(model);
    if (model->lift.file == NULL) return check_model(model);
    ttc_model_destroy(model); /* coordinates of a section, which have no field */
    return 0;
}

static void kernels_of_the_shipped_tables_err_by_roundings_alone_or_say_where(void **unused)
{
    (void)unused;
    assert_true(check_tables(JLT_SOURCE_DIR "/codegen/models", check_path) > 10000);
}

static bool says_so(fixture *f, ttc_kernel_kind kind, const char *phrase)
{
    ttc_text text = { 0 };
    ttc_emit_losses(&text, f->kernels, kind);
    assert_false(text.failed);
    bool found = strstr(ttc_text_string(&text), phrase) != NULL;
    ttc_text_clear(&text);
    return found;
}

static void differences_are_written_without_cancellation_where_algebra_allows(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof repaired / sizeof *repaired; i++) {
        fixture f = open_table(parse_text(repaired[i]));
        bool is_silent = !says_so(&f, TTC_KERNEL_RHS, "digits are lost");
        bool is_first_order = false;
        for (size_t k = 0; k < sizeof first_order / sizeof *first_order; k++)
            is_first_order |= strcmp(f.model->name, first_order[k]) == 0;
        is_silent &= is_first_order || !says_so(&f, TTC_KERNEL_RHS_JACOBIAN, "digits are lost");
        if (!is_silent) print_error("%s loses digits\n", f.model->name);
        assert_true(is_silent);
        close_table(&f);
    }
}

/* x/r at (3, 1e-8, 1e-9): (y^2 + z^2)/r^3 there is 3.74e-18, and 1/r - x^2/r^3 rounds to 0. */
static void the_slope_of_a_direction_keeps_its_digits_near_the_axis(void **unused)
{
    (void)unused;
    fixture f = open_table(parse_text(repaired[1]));
    const ttc_program *program = f.kernels->kernels[TTC_KERNEL_JACOBIAN].optimized;
    rounded *values = calloc(ttc_program_size(program), sizeof *values);
    assert_non_null(values);
    f.x[0] = 3;
    f.x[1] = 1e-8;
    f.x[2] = 1e-9;
    assert_true(run(&f, program, NULL, NULL, values));
    double slope = values[ttc_program_output_at(program, 0)].value;
    assert_near(slope, (1e-16 + 1e-18) / 27, 8 * DBL_EPSILON * slope);
    free(values);
    close_table(&f);
}

static void true_changes_of_sign_are_named(void **unused)
{
    (void)unused;
    fixture f = open_table(parse_text(named[0]));
    assert_true(says_so(&f, TTC_KERNEL_JACOBIAN, "digits are lost"));
    assert_true(says_so(&f, TTC_KERNEL_JACOBIAN, "d(d(x)/dt)/d(x)"));
    assert_false(says_so(&f, TTC_KERNEL_JACOBIAN, "d(d(x)/dt)/d(y)"));
    assert_false(says_so(&f, TTC_KERNEL_RHS, "digits are lost"));
    assert_int_equal(ttc_program_latency(f.kernels->kernels[TTC_KERNEL_DIVERGENCE].optimized), 0); /* it is zero */
    close_table(&f);
    for (size_t i = 1; i < sizeof named / sizeof *named; i++) {
        f = open_table(parse_text(named[i]));
        bool is_said = says_so(&f, TTC_KERNEL_RHS_JACOBIAN, "digits are lost");
        if (!is_said) print_error("%s is silent\n", f.model->name);
        assert_true(is_said);
        close_table(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_slope_of_a_direction_keeps_its_digits_near_the_axis),
        cmocka_unit_test(differences_are_written_without_cancellation_where_algebra_allows),
        cmocka_unit_test(true_changes_of_sign_are_named),
        cmocka_unit_test(kernels_err_by_roundings_alone_or_say_where_they_lose_digits),
        cmocka_unit_test(kernels_of_the_shipped_tables_err_by_roundings_alone_or_say_where),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
