#include "fields/dimensions.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "fields/ends.h"

enum {
    UNITS = 3,
    WHOLE = 1 << 10,            /* stands for the exponent 1, so that roots can halve it ten times */
    LARGEST = 1 << 10,          /* exponent of kg, m or s in a dimension; beyond it is WRONG */
    PARENTHESES_LIMIT = 1 << 10 /* one in another in the text of a unit; with more it is WRONG */
};

typedef struct {
    enum { UNSEEN, KNOWN, OF_ZERO, WRONG } state; /* zero has every dimension */
    int of[UNITS];                                /* exponents of kg, m, s, times WHOLE */
} dimension;

typedef struct {
    ttc_field *field;
    dimension *nodes; /* by id; nodes that are created later have no entry */
    size_t count;
} reader;

static const dimension number = { .state = KNOWN }, zero = { .state = OF_ZERO }, wrong = { .state = WRONG };

static void multiply(dimension *product, const dimension *by, long exponent)
{
    if (product->state == WRONG || by->state == WRONG) *product = wrong;
    else if (product->state == OF_ZERO || by->state == OF_ZERO) *product = zero;
    for (int i = 0; product->state == KNOWN && i < UNITS; i++) {
        const int64_t of = product->of[i] + (int64_t)exponent * by->of[i];
        if (of < -LARGEST * WHOLE || of > LARGEST * WHOLE) *product = wrong;
        else product->of[i] = (int)of;
    }
}

static dimension sum(const dimension *a, const dimension *b)
{
    if (a->state == WRONG || b->state == WRONG) return wrong;
    if (a->state == OF_ZERO) return *b;
    if (b->state == OF_ZERO) return *a;
    return memcmp(a->of, b->of, sizeof a->of) == 0 ? *a : wrong;
}

/* ---- texts of units: kg*m^2/s^2, kg m^2, 1/(m*s^2), rad/s ---- */

static dimension unit_of_name(const char *name, size_t length)
{
    static const char *const names[UNITS] = { "kg", "m", "s" };
    dimension unit = number;
    for (int i = 0; i < UNITS; i++)
        if (strlen(names[i]) == length && memcmp(names[i], name, length) == 0) unit.of[i] = WHOLE;
    return unit;
}

/* Dimension of the product that begins at *at, inside `depth` parentheses. Moves *at to its end, which is the end of the text or a
 * closing parenthesis. */
static dimension read_product(const char **at, unsigned depth)
{
    dimension product = number;
    int sign = 1;
    if (depth > PARENTHESES_LIMIT) {
        *at += strlen(*at);
        return wrong;
    }
    while (**at != '\0' && **at != ')') {
        if (strchr("*/ ", **at) != NULL) {
            sign = **at == '/' ? -1 : **at == '*' ? 1 : sign;
            ++*at;
            continue;
        }
        dimension factor;
        if (**at == '(') {
            ++*at;
            factor = read_product(at, depth + 1);
            if (**at == ')') ++*at;
        } else {
            const size_t length = strcspn(*at, "*/ ^()");
            factor = unit_of_name(*at, length);
            *at += length;
        }
        long power = 1;
        if (**at == '^') {
            char *end;
            power = strtol(*at + 1, &end, 10);
            *at = end;
            if (power < -TTC_EXPONENT_LIMIT || power > TTC_EXPONENT_LIMIT) {
                factor = wrong;
                power = 1;
            }
        }
        multiply(&product, &factor, sign * power);
        sign = 1;
    }
    return product;
}

static dimension of_unit(const char *unit)
{
    dimension product = number;
    while (unit != NULL && *unit != '\0') {
        const dimension part = read_product(&unit, 0);
        multiply(&product, &part, 1);
        if (*unit == ')') unit++; /* an unmatched parenthesis is ignored */
    }
    return product;
}

/* ---- expressions ---- */

static dimension visit(reader *self, ttc_id id);

static dimension half_of(dimension square)
{
    for (int i = 0; square.state == KNOWN && i < UNITS; i++) {
        if (square.of[i] % 2 != 0) return wrong;
        square.of[i] /= 2;
    }
    return square;
}

static dimension of_function(reader *self, ttc_id argument)
{
    const dimension of = visit(self, argument), sum_with_one = sum(&of, &number);
    return sum_with_one.state == KNOWN ? number : wrong;
}

static dimension of_symbol(reader *self, uint32_t index)
{
    const ttc_field_symbol *symbol = &self->field->symbols[index];
    const ttc_model *model = self->field->model;
    switch (symbol->role) {
    case TTC_ROLE_PARAM:
    case TTC_ROLE_STATE: return of_unit(index < model->symbol_count ? model->symbols[index].unit : NULL);
    case TTC_ROLE_PI: return number;
    case TTC_ROLE_UNIT: return visit(self, symbol->definition);
    case TTC_ROLE_ROOT: return half_of(visit(self, symbol->definition));
    case TTC_ROLE_COSINE:
    case TTC_ROLE_SINE:
    case TTC_ROLE_EXP:
    case TTC_ROLE_LOG: return of_function(self, symbol->definition);
    case TTC_ROLE_ABSENT: break;
    }
    return wrong;
}

static dimension compute(reader *self, ttc_id id)
{
    const ttc_graph *graph = self->field->graph;
    const ttc_kind kind = ttc_kind_of(graph, id);
    if (kind == TTC_SYMBOL) return of_symbol(self, ttc_symbol_of(graph, id));
    dimension result = fmpq_is_zero(ttc_coefficient(graph, id)) ? zero : number;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        const ttc_part part = ttc_part_at(graph, id, i);
        const dimension of = visit(self, part.id);
        if (kind == TTC_PRODUCT) multiply(&result, &of, part.exponent);
        else result = sum(&result, &of);
    }
    return result;
}

static dimension visit(reader *self, ttc_id id)
{
    if (id >= self->count) return compute(self, id);
    if (self->nodes[id].state == UNSEEN) self->nodes[id] = compute(self, id);
    return self->nodes[id];
}

/* Dimension of an expression of the model, such as a condition, an end of an interval or an integral. */
static dimension of_record(reader *self, ttc_id expression)
{
    const ttc_id own = ttc_field_specialise(self->field, expression);
    if (own == TTC_NONE) ttc_graph_clear_error(self->field->graph);
    return own == TTC_NONE ? wrong : visit(self, own);
}

/* Whether some field of the model has a condition for this end. All fields are to agree on whether they may be scaled. */
static bool is_condition(const ttc_model *model, uint32_t state, ttc_id end)
{
    bool is = ttc_end_is_condition(model, NULL, NULL, state, end);
    for (size_t i = 0; i < model->time_count; i++) is |= ttc_end_is_condition(model, model->times + i, NULL, state, end);
    for (size_t i = 0; i < model->elimination_count; i++)
        is |= ttc_end_is_condition(model, NULL, model->eliminations + i, state, end);
    return is;
}

/* A number to which callers compare a state is scaled with it; one in a condition is not. */
static bool ends_agree(reader *self, uint32_t state)
{
    const ttc_symbol_entry *entry = &self->field->model->symbols[state];
    const dimension own = of_unit(entry->unit);
    const ttc_id ends[] = { entry->low, entry->high };
    for (int i = 0; i < 2; i++) {
        if (!is_condition(self->field->model, state, ends[i])) continue;
        const dimension end = of_record(self, ends[i]);
        if (sum(&own, &end).state == WRONG) return false;
    }
    return true;
}

static bool equations_agree(reader *self)
{
    const ttc_field *field = self->field;
    const dimension second = unit_of_name("s", 1), factor = visit(self, field->factor);
    for (size_t i = 0; i < field->state_count; i++) {
        dimension wanted = of_symbol(self, field->states[i]);
        const dimension rate = visit(self, field->rhs[i]);
        multiply(&wanted, &second, -1);
        multiply(&wanted, &factor, 1);
        if (sum(&wanted, &rate).state == WRONG) return false;
    }
    for (size_t i = 0; i < field->model->state_count; i++)
        if (!ends_agree(self, field->model->states[i])) return false;
    return true;
}

bool ttc_dimensions_agree(ttc_field *field, const uint32_t *claims, size_t count)
{
    const ttc_model *model = field->model;
    reader self = { .field = field, .count = ttc_graph_size(field->graph) + 1 };
    self.nodes = calloc(self.count, sizeof *self.nodes);
    bool agree = self.nodes != NULL && equations_agree(&self);
    for (size_t i = 0; agree && i < model->region_count; i++) agree = of_record(&self, model->regions[i].expression).state != WRONG;
    for (size_t i = 0; agree && i < count; i++) agree = of_record(&self, model->claims[claims[i]].expression).state != WRONG;
    free(self.nodes);
    return agree;
}
