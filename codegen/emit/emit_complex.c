/* Writes the field in complex arithmetic on raw parameters, from the table's terms as they stand: without the optimizer and the
 * symbolic derivatives of other kernels. */
#include "emit/emit.h"

#include <stdlib.h>

typedef struct {
    ttc_text *text;
    ttc_field *field;
    unsigned char *declared; /* by symbol of the model */
    bool reads_states, reads_params;
} emitter;

static void write_name(void *context, ttc_text *text, uint32_t symbol)
{
    const emitter *e = context;
    ttc_text_format(text, "v_%s", e->field->model->symbols[symbol].name);
}

static void declare(emitter *e, uint32_t symbol);

static void declare_all(emitter *e, ttc_id id)
{
    const ttc_graph *graph = e->field->graph;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) declare(e, ttc_symbol_of(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) declare_all(e, ttc_part_at(graph, id, i).id);
}

static void define(emitter *e, uint32_t symbol, const char *type, const char *function, ttc_id expression)
{
    declare_all(e, expression);
    ttc_text_format(e->text, "    const %s v_%s = %s(", type, e->field->model->symbols[symbol].name, function);
    ttc_emit_expression(e->text, e->field->graph, expression, write_name, e);
    ttc_text_add(e->text, ");\n");
}

static void declare(emitter *e, uint32_t symbol)
{
    const ttc_field *field = e->field;
    const ttc_symbol_entry *entry = field->model->symbols + symbol;
    const ttc_field_symbol *s = field->symbols + symbol;
    if (e->declared[symbol]) return;
    e->declared[symbol] = 1;
    const ttc_bindings *bound = field->variant == NULL ? NULL : &field->variant->bindings;
    for (size_t i = 0; bound != NULL && i < bound->count; i++)
        if (bound->items[i].symbol == symbol) {
            define(e, symbol, "double", "", bound->items[i].expression);
            return;
        }
    if (field->elimination != NULL && field->elimination->state == symbol) {
        define(e, symbol, "double complex", "", field->elimination->solution);
        return;
    }
    if (s->role == TTC_ROLE_STATE || s->role == TTC_ROLE_PARAM) {
        bool is_state = s->role == TTC_ROLE_STATE;
        *(is_state ? &e->reads_states : &e->reads_params) = true;
        ttc_text_format(e->text, "    const double %sv_%s = %s[%u];\n", is_state ? "complex " : "", entry->name,
                        is_state ? "x" : "params", s->position);
        return;
    }
    if (s->role == TTC_ROLE_PI) {
        ttc_text_format(e->text, "    const double v_%s = " TTC_PI_DOUBLE ";\n", entry->name);
        return;
    }
    const char *function = entry->kind == TTC_ROOT     ? "csqrt"
                           : entry->kind == TTC_COSINE ? "ccos"
                           : entry->kind == TTC_SINE   ? "csin"
                           : entry->kind == TTC_EXP    ? "cexp"
                           : entry->kind == TTC_LOG    ? "clog"
                                                       : "";
    define(e, symbol, "double complex", function, entry->definition);
}

static void emit_equation(emitter *e, const ttc_equation *equation)
{
    const ttc_field *field = e->field;
    const ttc_field_symbol *s = field->symbols + equation->state;
    if (s->role != TTC_ROLE_STATE) return;
    for (size_t k = 0; k < equation->term_count; k++) declare_all(e, equation->terms[k].expression);
    ttc_text_format(e->text, "    out[%u] = ", s->position);
    if (field->time != NULL) {
        ttc_text_add(e->text, "(");
        ttc_emit_expression(e->text, field->graph, field->time->factor, write_name, e);
        ttc_text_add(e->text, ")*(");
    }
    for (size_t k = 0; k < equation->term_count; k++) {
        ttc_text_add(e->text, k == 0 ? "(" : "\n        + (");
        ttc_emit_expression(e->text, field->graph, equation->terms[k].expression, write_name, e);
        ttc_text_add(e->text, ")");
    }
    if (equation->term_count == 0) ttc_text_add(e->text, "0.0");
    ttc_text_add(e->text, field->time != NULL ? ");\n" : ";\n");
}

/* r' = sum_j dq/dx_j x_j' / (2 r), from the derivatives written before. */
static void emit_lifted(emitter *e, uint32_t root)
{
    const ttc_field *field = e->field;
    const ttc_model *model = field->model;
    ttc_text sum = { 0 };
    for (size_t i = 0; i < model->state_count; i++) {
        const ttc_field_symbol *s = field->symbols + model->states[i];
        ttc_id partial = ttc_model_partial(model, model->symbols[root].definition, model->states[i]);
        if (partial == TTC_NONE || s->role != TTC_ROLE_STATE || ttc_is_number(field->graph, partial, 0)) continue;
        declare_all(e, partial);
        ttc_text_add(&sum, sum.length == 0 ? "(" : " + (");
        ttc_emit_expression(&sum, field->graph, partial, write_name, e);
        ttc_text_format(&sum, ")*out[%u]", s->position);
    }
    declare(e, root);
    ttc_text_format(e->text, "    out[%u] = (%s)/(2.0*v_%s);\n", field->symbols[root].position,
                    sum.length == 0 ? "0.0" : ttc_text_string(&sum), model->symbols[root].name);
    e->text->failed |= sum.failed;
    ttc_text_clear(&sum);
}

void ttc_emit_complex(ttc_text *text, ttc_field *field)
{
    const ttc_model *model = field->model;
    ttc_text statements = { 0 };
    emitter e = { .text = &statements, .field = field, .declared = calloc(model->symbol_count + 1, 1) };
    if (e.declared == NULL) {
        text->failed = true;
        return;
    }
    if (field->time != NULL) declare_all(&e, field->time->factor);
    for (size_t i = 0; i < model->state_count; i++) emit_equation(&e, model->equations + i);
    for (size_t i = 0; i < ttc_field_lifted_count(field); i++) emit_lifted(&e, field->time->lifted[i]);
    ttc_text_add(text, "static void rhs_complex(const double complex *restrict x, const double *restrict params,\n"
                       "                        double complex *restrict out)\n{\n");
    if (!e.reads_states) ttc_text_add(text, "    (void)x;\n");
    if (!e.reads_params) ttc_text_add(text, "    (void)params;\n");
    ttc_text_add(text, ttc_text_string(&statements));
    ttc_text_add(text, "}\n");
    text->failed |= statements.failed;
    ttc_text_clear(&statements);
    free(e.declared);
}
