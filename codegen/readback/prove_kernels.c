#include "readback/prove_kernels.h"

#include "emit/emit.h"
#include "readback/program_read.h"
#include "prove/prove_task.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the program's arguments stand for, in one ring. */
typedef struct {
    ttc_valuation *valuation;
    ttc_ring *ring;
    ttc_ratio *inputs, *prepared; /* prepared: parameters, then what `prepare` computes */
    size_t input_count, parameter_count, prepared_count;
} reading;

typedef struct {
    ttc_ratio *items;
    size_t count;
} outputs;

typedef struct {
    const ttc_kernels *kernels;
    const ttc_model *model;
    reading related, free; /* related: lifted roots obey root^2 = radicand; free: they are coordinates */
    outputs values[TTC_KERNEL_KINDS]; /* of the optimized programs, in `free` */
    ttc_proof_status status;  /* of the kernel that is checked */
    char *remainder;
    reading *reading;         /* the reading in use */
    bool out_of_memory;
} proof;

static void free_outputs(reading *r, outputs *o)
{
    for (size_t i = 0; i < o->count; i++) ttc_ratio_clear(r->ring, &o->items[i]);
    free(o->items);
    *o = (outputs){ NULL, 0 };
}

static bool allocate_outputs(reading *r, outputs *o, size_t count)
{
    *o = (outputs){ malloc((count + 1) * sizeof *o->items), 0 };
    if (o->items == NULL) return false;
    while (o->count < count) ttc_ratio_init(r->ring, &o->items[o->count++]);
    return true;
}

static void bind_field(ttc_valuation *valuation, const ttc_field *field, bool lifted_free)
{
    for (size_t i = 0; field->variant != NULL && i < field->variant->bindings.count; i++)
        ttc_valuation_bind(valuation, field->variant->bindings.items[i].symbol,
                           field->variant->bindings.items[i].expression);
    if (field->elimination != NULL) ttc_valuation_bind(valuation, field->elimination->state, field->elimination->solution);
    for (size_t i = 0; lifted_free && field->time != NULL && i < field->time->lifted_count; i++)
        ttc_valuation_free(valuation, field->time->lifted[i]);
}

static bool open_reading(reading *r, const ttc_kernels *kernels, bool lifted_free)
{
    const ttc_field *field = kernels->field;
    r->valuation = ttc_valuation_create(field->model, 0);
    if (r->valuation == NULL) return false;
    r->ring = ttc_valuation_ring(r->valuation);
    bind_field(r->valuation, field, lifted_free);
    outputs inputs, prepared;
    bool ok = allocate_outputs(r, &inputs, field->state_count);
    r->inputs = inputs.items;
    r->input_count = inputs.count;
    ok = allocate_outputs(r, &prepared, field->param_count + ttc_program_output_count(kernels->prepare)) && ok;
    r->prepared = prepared.items;
    r->prepared_count = prepared.count;
    if (!ok) return false;
    r->parameter_count = field->param_count;
    for (size_t i = 0; i < field->state_count; i++)
        ttc_evaluate(r->valuation, &r->inputs[i], field->model->symbols[field->states[i]].node);
    for (size_t i = 0; i < field->param_count; i++)
        ttc_evaluate(r->valuation, &r->prepared[i], field->model->symbols[field->params[i]].node);
    return ttc_program_read(kernels->prepare, r->valuation, r->inputs, r->input_count, r->prepared, r->parameter_count,
                            r->prepared + field->param_count);
}

static void close_reading(reading *r)
{
    outputs inputs = { r->inputs, r->input_count }, prepared = { r->prepared, r->prepared_count };
    if (r->valuation == NULL) return;
    free_outputs(r, &inputs);
    free_outputs(r, &prepared);
    ttc_valuation_destroy(r->valuation);
}

static bool read_program(reading *r, const ttc_program *program, bool is_prepared, outputs *o)
{
    return allocate_outputs(r, o, ttc_program_output_count(program))
           && ttc_program_read(program, r->valuation, r->inputs, r->input_count, r->prepared,
                               is_prepared ? r->prepared_count : r->parameter_count, o->items);
}

/* What the table says of output `index`, in the related ring. Returns false if the output is a derivative, of which it says
 * nothing directly. */
static bool from_model(proof *p, ttc_ratio *out, ttc_kernel_kind kind, size_t index)
{
    const ttc_field *field = p->kernels->field;
    const ttc_model *model = p->model;
    ttc_valuation *v = p->related.valuation;
    ttc_ring *ring = p->related.ring;
    ttc_ratio factor;
    bool known = true;
    ttc_ratio_init(ring, &factor);
    ttc_ratio_set_integer(ring, &factor, 1);
    if (field->time != NULL) ttc_evaluate(v, &factor, field->time->factor);
    if (kind == TTC_KERNEL_RHS) {
        ttc_id rate = ttc_derive_field(model, model->symbols[field->states[index]].node);
        ttc_evaluate(v, out, rate);
        ttc_ratio_multiply(ring, out, out, &factor);
    } else if (kind == TTC_KERNEL_TIME_FACTOR) {
        ttc_ratio_set(ring, out, &factor);
    } else if (kind == TTC_KERNEL_ELIMINATED) {
        ttc_evaluate(v, out, model->symbols[field->elimination->state].node);
    } else if (kind == TTC_KERNEL_OBSERVE_VALUES) {
        ttc_evaluate(v, out, model->symbols[model->observed[index]].node);
    } else if (kind == TTC_KERNEL_VALID_VALUES) {
        ttc_evaluate(v, out, model->validities[index].expression);
    } else if (kind == TTC_KERNEL_DOMAIN_VALUES) {
        ttc_evaluate(v, out, p->kernels->watched[index].expression);
    } else if (kind == TTC_KERNEL_INTEGRAL_VALUES) {
        ttc_evaluate(v, out, model->claims[p->kernels->integrals[index]].expression);
    } else if (kind == TTC_KERNEL_MEASURE_VALUES) {
        ttc_evaluate(v, out, model->claims[p->kernels->measures[index]].expression);
        ttc_ratio_divide(ring, out, out, &factor);
        if (field->elimination != NULL) { /* on a level of I the density is rho / (dI/dz), z the eliminated state */
            size_t state = 0;
            while (model->states[state] != field->elimination->state) state++;
            ttc_id integral = model->claims[field->elimination->integral].expression;
            ttc_evaluate(v, &factor, ttc_derive_state(model, integral, state));
            ttc_ratio_divide(ring, out, out, &factor);
        }
    } else {
        known = false;
    }
    ttc_ratio_clear(ring, &factor);
    return known;
}

/* The derivatives of the free ring's variables by coordinate j. All functions are evaluated first, so that each has its
 * variable. */
static void coordinate_slopes(proof *p, ttc_ratio *slopes, size_t j)
{
    reading *r = &p->free;
    ttc_ratio met;
    ttc_ratio_init(r->ring, &met);
    for (size_t i = 0; i < p->model->symbol_count; i++) {
        ttc_symbol_kind kind = p->model->symbols[i].kind;
        if (kind == TTC_COSINE || kind == TTC_EXP || kind == TTC_LOG) ttc_evaluate(r->valuation, &met, p->model->symbols[i].node);
    }
    ttc_ratio_clear(r->ring, &met);
    for (size_t v = 0; v < r->ring->variable_count; v++) ttc_ratio_set_integer(r->ring, &slopes[v], 0);
    ttc_ratio_set_integer(r->ring, &slopes[ttc_valuation_variable(r->valuation, p->kernels->field->states[j])], 1);
    ttc_valuation_add_function_rates(r->valuation, slopes);
}

/* out += d(value)/dx_j */
static void add_partial(proof *p, ttc_ratio *out, const ttc_ratio *value, size_t j)
{
    reading *r = &p->free;
    outputs slopes;
    ttc_ratio partial;
    if (!allocate_outputs(r, &slopes, r->ring->variable_count)) {
        p->out_of_memory = true;
        return;
    }
    ttc_ratio_init(r->ring, &partial);
    coordinate_slopes(p, slopes.items, j);
    ttc_ratio_derive(r->ring, &partial, value, slopes.items);
    ttc_ratio_add(r->ring, out, out, &partial);
    ttc_ratio_clear(r->ring, &partial);
    free_outputs(r, &slopes);
}

/* out += div(density f) */
static void add_divergence(proof *p, ttc_ratio *out, const ttc_ratio *density)
{
    ttc_ratio flux;
    ttc_ratio_init(p->free.ring, &flux);
    for (size_t j = 0; j < p->free.input_count; j++) {
        ttc_ratio_multiply(p->free.ring, &flux, density, &p->values[TTC_KERNEL_RHS].items[j]);
        add_partial(p, out, &flux, j);
    }
    ttc_ratio_clear(p->free.ring, &flux);
}

/* What output `index` must be, from the values that the optimized programs themselves compute, in the free ring. */
static void from_values(proof *p, ttc_ratio *out, ttc_kernel_kind kind, size_t index)
{
    size_t n = p->free.input_count;
    ttc_ratio one;
    ttc_ratio_init(p->free.ring, &one);
    ttc_ratio_set_integer(p->free.ring, &one, 1);
    ttc_ratio_set_integer(p->free.ring, out, 0);
    switch (kind) {
    case TTC_KERNEL_RHS_JACOBIAN:
        if (index < n) ttc_ratio_set(p->free.ring, out, &p->values[TTC_KERNEL_RHS].items[index]);
        else ttc_ratio_set(p->free.ring, out, &p->values[TTC_KERNEL_JACOBIAN].items[index - n]);
        break;
    case TTC_KERNEL_JACOBIAN: add_partial(p, out, &p->values[TTC_KERNEL_RHS].items[index / n], index % n); break;
    case TTC_KERNEL_INTEGRAL_GRADIENTS:
        add_partial(p, out, &p->values[TTC_KERNEL_INTEGRAL_VALUES].items[index / n], index % n);
        break;
    case TTC_KERNEL_DOMAIN_GRADIENTS: add_partial(p, out, &p->values[TTC_KERNEL_DOMAIN_VALUES].items[index / n], index % n); break;
    case TTC_KERNEL_DIVERGENCE: add_divergence(p, out, &one); break;
    case TTC_KERNEL_MEASURE_DIVERGENCES: add_divergence(p, out, &p->values[TTC_KERNEL_MEASURE_VALUES].items[index]); break;
    default: ttc_ratio_set(p->free.ring, out, &p->values[kind].items[index]); break;
    }
    ttc_ratio_clear(p->free.ring, &one);
}

static void use(proof *p, reading *r) { p->reading = r; }

/* Nothing speaks against the kernel so far, and the ring in use has not failed. */
static bool is_open(const proof *p) { return p->status == TTC_PROVED && p->reading->ring->status == TTC_RING_OK; }

TTC_PRINTF(3, 4) static void settle_as(proof *p, ttc_proof_status status, const char *format, ...)
{
    enum { REMAINDER_LIMIT = 4400 };
    va_list arguments;
    p->status = status;
    free(p->remainder);
    p->remainder = malloc(REMAINDER_LIMIT);
    if (p->remainder == NULL) return;
    va_start(arguments, format);
    vsnprintf(p->remainder, REMAINDER_LIMIT, format, arguments);
    va_end(arguments);
}

static void compare(proof *p, reading *r, const ttc_ratio *found, ttc_ratio *expected, const char *which, size_t index)
{
    ttc_ratio_subtract(r->ring, expected, found, expected);
    if (!is_open(p) || ttc_ratio_is_zero(r->ring, expected)) return;
    char *value = ttc_ratio_text(r->ring, expected);
    settle_as(p, TTC_REFUTED, "%s, output %zu, kernel - table = %.4000s", which, index, value == NULL ? "" : value);
    free(value);
}

/* Outputs that the table gives directly, where roots obey their relations. */
static void check_against_model(proof *p, ttc_kernel_kind kind, const ttc_program *program, bool is_prepared)
{
    reading *r = &p->related;
    ttc_ratio expected;
    outputs found = { NULL, 0 };
    use(p, r);
    ttc_ratio_init(r->ring, &expected);
    bool direct = p->kernels->kernels[kind].count > 0 && from_model(p, &expected, kind, 0);
    if (direct && !read_program(r, program, is_prepared, &found)) p->out_of_memory = true;
    for (size_t i = 0; i < found.count && is_open(p); i++) {
        from_model(p, &expected, kind, i);
        compare(p, r, &found.items[i], &expected, is_prepared ? "optimized" : "reference", i);
    }
    free_outputs(r, &found);
    ttc_ratio_clear(r->ring, &expected);
}

/* Outputs that are derivatives of others, and the reference program against the optimized one. */
static void check_against_values(proof *p, ttc_kernel_kind kind, const outputs *found, const char *which)
{
    reading *r = &p->free;
    ttc_ratio expected;
    use(p, r);
    ttc_ratio_init(r->ring, &expected);
    for (size_t i = 0; i < found->count && is_open(p) && !p->out_of_memory; i++) {
        from_values(p, &expected, kind, i);
        compare(p, r, &found->items[i], &expected, which, i);
    }
    ttc_ratio_clear(r->ring, &expected);
}

/* The program of the Taylor recurrences: the field, then dt/dtau. */
static void check_jet(proof *p, outputs *found)
{
    ttc_ratio expected;
    use(p, &p->free);
    ttc_ratio_init(p->free.ring, &expected);
    for (size_t i = 0; i < found->count; i++) {
        bool is_factor = i == p->free.input_count;
        from_values(p, &expected, is_factor ? TTC_KERNEL_TIME_FACTOR : TTC_KERNEL_RHS, is_factor ? 0 : i);
        compare(p, &p->free, &found->items[i], &expected, "jet", i);
    }
    ttc_ratio_clear(p->free.ring, &expected);
}

static void check_kernel(proof *p, ttc_kernel_kind kind)
{
    const ttc_kernel *kernel = &p->kernels->kernels[kind];
    outputs found = { NULL, 0 };
    check_against_model(p, kind, kernel->optimized, true);
    check_against_model(p, kind, kernel->reference, false);
    if (!is_open(p) || p->out_of_memory) return;
    check_against_values(p, kind, &p->values[kind], "optimized");
    if (!read_program(&p->free, kernel->reference, false, &found)) p->out_of_memory = true;
    check_against_values(p, kind, &found, "reference");
    free_outputs(&p->free, &found);
    if (kind != TTC_KERNEL_RHS) return;
    if (!read_program(&p->free, p->kernels->jet, true, &found)) p->out_of_memory = true;
    check_jet(p, &found);
    free_outputs(&p->free, &found);
}

static void settle(proof *p, const reading *r)
{
    if (r->ring->status == TTC_RING_OK && r->ring->choice_count == 0) return;
    settle_as(p, TTC_UNSETTLED, "%s", r->ring->status != TTC_RING_OK ? ttc_ring_status_text(r->ring->status)
                                                                   : "a root becomes rational with either sign");
}

static char *kernel_name(const ttc_field *field, ttc_kernel_kind kind)
{
    ttc_text text = { 0 };
    ttc_emit_stem(&text, field);
    ttc_text_format(&text, " %s", ttc_kernel_name(kind));
    const char *string = text.failed ? NULL : ttc_text_string(&text);
    char *name = string == NULL ? NULL : malloc(strlen(string) + 1);
    if (name != NULL) strcpy(name, string);
    ttc_text_clear(&text);
    return name;
}

static ttc_place place_of(const ttc_field *field)
{
    if (field->elimination != NULL) return field->elimination->place;
    if (field->time != NULL) return field->time->place;
    if (field->variant != NULL) return field->variant->place;
    return field->model->equations[0].place;
}

static bool append(ttc_proof_report *report, proof *p, ttc_kernel_kind kind)
{
    ttc_proof *grown = realloc(report->proofs, (report->proof_count + 1) * sizeof *grown);
    if (grown == NULL) return false;
    report->proofs = grown;
    ttc_proof *made = &report->proofs[report->proof_count];
    *made = (ttc_proof){ .name = kernel_name(p->kernels->field, kind), .kind = "kernel", .status = p->status,
                         .place = place_of(p->kernels->field), .remainder = p->remainder };
    p->remainder = NULL;
    if (made->name == NULL) return false;
    report->proof_count++;
    report->proved += made->status == TTC_PROVED;
    report->refuted += made->status == TTC_REFUTED;
    report->unsettled += made->status == TTC_UNSETTLED;
    return true;
}

static bool prove_field(const ttc_kernels *kernels, ttc_proof_report *report)
{
    proof p = { .kernels = kernels, .model = kernels->field->model };
    bool ok = open_reading(&p.related, kernels, false) && open_reading(&p.free, kernels, true);
    for (int kind = 0; ok && kind < TTC_KERNEL_KINDS; kind++)
        if (kernels->kernels[kind].count > 0)
            ok = read_program(&p.free, kernels->kernels[kind].optimized, true, &p.values[kind]);
    for (int kind = 0; ok && kind < TTC_KERNEL_KINDS; kind++) {
        if (kernels->kernels[kind].count == 0) continue;
        p.status = TTC_PROVED;
        check_kernel(&p, (ttc_kernel_kind)kind);
        settle(&p, &p.related);
        settle(&p, &p.free);
        ok = !p.out_of_memory && append(report, &p, (ttc_kernel_kind)kind);
    }
    free(p.remainder);
    for (int kind = 0; kind < TTC_KERNEL_KINDS; kind++) free_outputs(&p.free, &p.values[kind]);
    close_reading(&p.free);
    close_reading(&p.related);
    return ok;
}

bool ttc_prove_kernels(const ttc_catalogue *catalogue, ttc_proof_report *report)
{
    for (size_t i = 0; i < catalogue->count; i++)
        if (catalogue->fields[i].kernels != NULL && !prove_field(catalogue->fields[i].kernels, report)) return false;
    return true;
}
