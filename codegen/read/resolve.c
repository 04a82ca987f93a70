/* Steps that need the whole table: looking up references, solving eliminations, and checks that the table is complete. */
#include "read/parser.h"

#include <stdlib.h>
#include <string.h>

static bool find_claim(const ttc_model *model, const ttc_token *name, uint32_t *claim)
{
    char text[TTC_NAME_LIMIT + 1];
    memcpy(text, name->text, name->length);
    text[name->length] = '\0';
    return ttc_model_find_claim(model, text, claim);
}

static void resolve_reference(ttc_parser *parser, const ttc_reference *reference)
{
    ttc_model *model = parser->model;
    const ttc_token *name = reference->name;
    ttc_place place = ttc_token_place(name);
    uint32_t found;
    if (reference->role != TTC_REFER_ELIMINATION && reference->owner >= model->claim_count) return;
    const char *expected = reference->role == TTC_REFER_FAMILY   ? "an 'equilibria' record"
                           : reference->role == TTC_REFER_MODULO ? "an 'integral' or 'invariant' record"
                                                                 : "an 'integral' record";
    if (!find_claim(model, name, &found)) {
        ttc_parse_error(parser, place, "unknown claim '%.*s' (expected the name of %s)", (int)name->length, name->text, expected);
        return;
    }
    ttc_claim_kind kind = model->claims[found].kind;
    bool fits = reference->role == TTC_REFER_FAMILY   ? kind == TTC_CLAIM_EQUILIBRIA
                : reference->role == TTC_REFER_MODULO ? kind == TTC_CLAIM_INTEGRAL || kind == TTC_CLAIM_INVARIANT
                                                      : kind == TTC_CLAIM_INTEGRAL;
    if (!fits) {
        ttc_parse_error(parser, place, "'%.*s' is the name of '%s' (expected that of %s)", (int)name->length, name->text,
                        ttc_claim_kind_name(kind), expected);
        return;
    }
    ttc_claim *owner = model->claims + reference->owner;
    switch (reference->role) {
    case TTC_REFER_FAMILY: owner->family = found; break;
    case TTC_REFER_MODULO: ttc_parse_append(parser, &owner->modulo, &owner->modulo_count, found); break;
    case TTC_REFER_MEMBER: ttc_parse_append(parser, &owner->members, &owner->member_count, found); break;
    case TTC_REFER_ELIMINATION: model->eliminations[reference->owner].integral = found; break;
    }
}

/* Report claims that rest on their own zero level through a chain of `modulo`. */
static void check_modulo_circles(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    unsigned char *settled = calloc(model->claim_count + 1, 1);
    if (settled == NULL) {
        ttc_parse_no_memory(parser);
        return;
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t i = 0; i < model->claim_count; i++) {
            bool free_of_doubt = !settled[i];
            for (size_t k = 0; free_of_doubt && k < model->claims[i].modulo_count; k++)
                free_of_doubt = settled[model->claims[i].modulo[k]];
            if (!free_of_doubt) continue;
            settled[i] = 1;
            changed = true;
        }
    }
    for (size_t i = 0; i < model->claim_count; i++)
        if (!settled[i])
            ttc_parse_error(parser, model->claims[i].place, "'%s' rests on itself through 'modulo': a circle",
                            model->claims[i].name);
    free(settled);
}

typedef struct {
    const ttc_model *model;
    uint32_t state;
} chart;

static ttc_id let_definition(void *context, uint32_t symbol)
{
    const ttc_symbol_entry *entry = ((const chart *)context)->model->symbols + symbol;
    return entry->kind == TTC_LET ? entry->definition : TTC_NONE;
}

/* The value of a symbol at state = 0. A let that does not depend on the state stays a symbol. */
static ttc_id at_zero(void *context, uint32_t symbol, ttc_id definition_value)
{
    const chart *c = context;
    const ttc_symbol_entry *entry = c->model->symbols + symbol;
    if (symbol == c->state) return ttc_integer(c->model->graph, 0);
    return definition_value == TTC_NONE || definition_value == entry->definition ? TTC_NONE : definition_value;
}

/* Solve integral = slope * state + rest for the state: state = (level - rest)/slope. */
static void solve_elimination(ttc_parser *parser, ttc_elimination *elimination)
{
    const ttc_model *model = parser->model;
    const ttc_claim *integral = model->claims + elimination->integral;
    const char *state = model->symbols[elimination->state].name;
    if (integral->when.count > 0 || integral->modulo_count > 0) {
        ttc_parse_error(parser, elimination->place, "'%s' is an integral under a condition only (expected one that always holds)",
                        integral->name);
        return;
    }
    chart c = { model, elimination->state };
    ttc_id slope = ttc_model_partial(model, integral->expression, elimination->state);
    if (slope != TTC_NONE && ttc_model_depends(model, slope, elimination->state)) slope = ttc_model_expand(model, slope);
    if (slope != TTC_NONE && ttc_model_depends(model, slope, elimination->state)) {
        ttc_parse_error(parser, elimination->place, "the integral '%s' is not linear in '%s' (expected a state in which it is)",
                        integral->name, state);
        return;
    }
    if (slope != TTC_NONE && ttc_is_number(model->graph, slope, 0)) {
        ttc_parse_error(parser, elimination->place, "the integral '%s' does not depend on '%s' (expected a state on which it does)",
                        integral->name, state);
        return;
    }
    ttc_id rest = ttc_substitute_through(model->graph, integral->expression, let_definition, at_zero, &c);
    ttc_id level = model->symbols[elimination->level].node;
    elimination->slope = slope;
    elimination->solution = ttc_divide(model->graph, ttc_subtract(model->graph, level, rest), slope);
    if (elimination->solution == TTC_NONE) ttc_parse_graph_error(parser, elimination->place);
}

/* Report an error if one level is used for two integrals. Several eliminations by one integral may share a level. */
static void check_levels(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    for (size_t i = 0; i < model->elimination_count; i++)
        for (size_t k = 0; k < i; k++)
            if (model->eliminations[i].level == model->eliminations[k].level &&
                model->eliminations[i].integral != model->eliminations[k].integral) {
                ttc_parse_error(parser, model->eliminations[i].place, "'%s' is already the level of '%s'",
                                model->symbols[model->eliminations[i].level].name,
                                model->claims[model->eliminations[k].integral].name);
                break;
            }
}

static void check_equations(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    bool is_right = ttc_error_count(parser->diagnostics) == parser->errors_before; /* else `state` may have failed */
    if (model->state_count == 0 && is_right)
        ttc_parse_error(parser, (ttc_place){ 1, 1 }, "the model has no state (expected at least one)");
    for (size_t i = 0; i < model->state_count; i++) {
        const ttc_symbol_entry *state = model->symbols + model->states[i];
        const bool has_equation = i < model->equation_count && model->equations[i].place.line != 0;
        if (has_equation && model->lift.file != NULL)
            ttc_parse_error(parser, model->equations[i].place, "an equation for '%s' in a table of coordinates, whose points are "
                            "lifted (expected 'lift', or equations, not both)", state->name);
        if (!has_equation && model->lift.place.line == 0)
            ttc_parse_error(parser, state->place, "the state '%s' has no equation (expected 'eq %s = ...')", state->name,
                            state->name);
    }
}

/* Report records about motion in a table of coordinates, and `start` and `turns` in any other table. */
static void check_coordinates(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    const ttc_lift *lift = &model->lift;
    if (lift->file == NULL) {
        if (lift->place.line == 0 && (model->start_count > 0 || model->turn != TTC_NONE))
            ttc_parse_error(parser, model->start_count > 0 ? model->starts->place : (ttc_place){ 1, 1 },
                            "'start' and 'turns' belong to a table of coordinates (expected 'lift into FILE.tt with ...')");
        return;
    }
    if (model->variant_count + model->time_count + model->elimination_count + model->pole_count + model->observed_count +
            model->validity_count + (model->tier.name != NULL) > 0)
        ttc_parse_error(parser, lift->place,
                        "a table of coordinates asks for no kernels, has no poles and no tier and observes nothing "
                        "(expected these records in %s)", lift->file);
    for (size_t i = 0; i < model->claim_count; i++)
        if (model->claims[i].kind != TTC_CLAIM_EQUAL && model->claims[i].kind != TTC_CLAIM_POSITIVE)
            ttc_parse_error(parser, model->claims[i].place,
                            "a table of coordinates claims no '%s', as nothing moves in it (expected "
                            "'equal' or 'positive')",
                            ttc_claim_kind_name(model->claims[i].kind));
}

/* Report levels of a section, or of a smaller table, that are values of an integral with a condition. */
static void check_levels_hold(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    for (size_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *claim = model->claims + i;
        if (claim->kind != TTC_CLAIM_SECTION && claim->kind != TTC_CLAIM_DESCENT) continue;
        for (size_t k = 0; k < claim->member_count; k++)
            if (model->claims[claim->members[k]].when.count + model->claims[claim->members[k]].modulo_count > 0)
                ttc_parse_error(parser, claim->place, "'%s' is an integral under a condition only (expected one that always holds)",
                                model->claims[claim->members[k]].name);
    }
}

/* Report integrals with the name of a parameter, as commands refer to both by name. */
static void check_integrals(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    for (size_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *claim = model->claims + i;
        uint32_t symbol;
        if (claim->kind != TTC_CLAIM_INTEGRAL || !ttc_model_find_symbol(model, claim->name, &symbol)) continue;
        if (model->symbols[symbol].kind == TTC_PARAM)
            ttc_parse_error(parser, claim->place,
                            "the integral '%s' has the name of the parameter in line %u (expected another name)", claim->name,
                            (unsigned)model->symbols[symbol].place.line);
    }
}

/* A parameter that may be 0 and is a factor of the divisor as written; NULL if there is none. */
static const ttc_symbol_entry *zero_factor(const ttc_model *model, ttc_id divisor)
{
    const ttc_graph *graph = model->graph;
    for (size_t i = 0; ttc_kind_of(graph, divisor) == TTC_PRODUCT && i < ttc_part_count(graph, divisor); i++) {
        const ttc_symbol_entry *found = zero_factor(model, ttc_part_at(graph, divisor, i).id);
        if (found != NULL) return found;
    }
    const bool is_symbol = ttc_kind_of(graph, divisor) == TTC_SYMBOL;
    const bool is_param = is_symbol && model->symbols[ttc_symbol_of(graph, divisor)].kind == TTC_PARAM;
    return is_param ? ttc_model_zero_divisor(model, divisor) : NULL;
}

/* Returns true if the equations divide by the parameter, so that it is not 0 on the domain. used: as of ttc_model_uses. */
static bool field_divides_by(const ttc_model *model, const unsigned char *used, const ttc_symbol_entry *param)
{
    bool divides = false;
    for (size_t i = 0; i < model->divisor_count && !divides; i++) {
        const ttc_divisor *d = model->divisors + i;
        const bool of_field = d->role == TTC_DIVIDES_FIELD || (d->role == TTC_DIVIDES_SYMBOL && used[d->owner]);
        divides = of_field && ttc_model_vanishes_with(model, d->divisor, param);
    }
    return divides;
}

/* Returns true if a domain record depends on the parameter and on no state: it may exclude 0, which the parser cannot decide. */
static bool domain_speaks_of(const ttc_model *model, ttc_id param)
{
    bool speaks = false;
    for (size_t i = 0; i < model->region_count && !speaks; i++) {
        const ttc_id region = model->regions[i].expression;
        speaks = ttc_model_depends(model, region, ttc_symbol_of(model->graph, param));
        for (size_t k = 0; k < model->state_count && speaks; k++) speaks = !ttc_model_depends(model, region, model->states[k]);
    }
    return speaks;
}

/* Report that a divisor is 0 where this parameter is (NULL: there is none), unless the equations divide by the parameter, or a
 * domain record may exclude 0. Returns true if it was reported. */
static bool tell_divisor(ttc_parser *parser, const unsigned char *used, const ttc_symbol_entry *param, ttc_severity severity,
                         const char *kind, const char *name, ttc_place place)
{
    if (param == NULL || field_divides_by(parser->model, used, param) || domain_speaks_of(parser->model, param->node))
        return false;
    ttc_report(parser->diagnostics, severity, place.line, place.column,
               "the %s '%s' divides by the parameter '%s', which may be 0, where no kernel could be prepared "
               "(expected 'param %s != 0', or '> 0')",
               kind, name, param->name, param->name);
    return true;
}

/* Report observed quantities and `valid` conditions that divide by a parameter which may be 0. All kernels share values prepared
 * from parameters, so that none could be prepared where the parameter is 0, although the equations are defined there. */
static void check_observed(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    unsigned char *used = ttc_model_uses(model);
    if (used == NULL) ttc_parse_no_memory(parser);
    for (size_t i = 0; used != NULL && i < model->divisor_count; i++) {
        const ttc_divisor *d = model->divisors + i;
        if (d->role == TTC_DIVIDES_VALID)
            tell_divisor(parser, used, zero_factor(model, d->divisor), TTC_ERROR, "condition", model->validities[d->owner].name,
                         model->validities[d->owner].place);
        for (size_t k = 0; d->role == TTC_DIVIDES_SYMBOL && !used[d->owner] && k < model->observed_count; k++) {
            const ttc_symbol_entry *observed = model->symbols + model->observed[k];
            unsigned char *own = ttc_model_uses_of(model, TTC_DIVIDES_SYMBOL, model->observed[k]);
            if (own == NULL) ttc_parse_no_memory(parser);
            else if (own[d->owner] || model->observed[k] == d->owner)
                tell_divisor(parser, used, zero_factor(model, d->divisor), TTC_ERROR, "observed quantity", observed->name,
                             observed->place);
            free(own);
        }
    }
    free(used);
}

/* Warn of integrals and densities that divide by a parameter which may be 0: proved or not, no kernel can be prepared there. */
static void warn_of_divisors(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    unsigned char *used = ttc_model_uses(model);
    if (used == NULL) ttc_parse_no_memory(parser);
    for (uint32_t k = 0; used != NULL && k < model->claim_count; k++) {
        const ttc_claim *claim = model->claims + k;
        bool told = false;
        for (size_t i = 0; i < model->divisor_count && !told; i++)
            told = ttc_model_prepares(model, k, model->divisors + i) &&
                   tell_divisor(parser, used, ttc_model_zero_divisor(model, model->divisors[i].divisor), TTC_WARNING,
                                ttc_claim_kind_name(claim->kind), claim->name, claim->place);
    }
    free(used);
}

static void check_matrices(ttc_parser *parser)
{
    const ttc_model *model = parser->model;
    size_t expected = model->state_count * model->state_count;
    for (size_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *claim = model->claims + i;
        if (claim->kind == TTC_CLAIM_MATRIX && claim->entry_count > 0 && claim->entry_count != expected)
            ttc_parse_error(parser, claim->place, "a matrix of %zu entries (expected %zu rows of %zu)", claim->entry_count,
                            model->state_count, model->state_count);
    }
}

void ttc_parse_resolve(ttc_parser *parser)
{
    for (size_t i = 0; i < parser->reference_count; i++) resolve_reference(parser, parser->references + i);
    check_equations(parser);
    check_matrices(parser);
    check_coordinates(parser);
    check_levels_hold(parser);
    check_integrals(parser);
    check_modulo_circles(parser);
    if (parser->out_of_memory || ttc_error_count(parser->diagnostics) > parser->errors_before) return;
    check_levels(parser);
    check_observed(parser);
    for (size_t i = 0; i < parser->model->elimination_count; i++) solve_elimination(parser, parser->model->eliminations + i);
    warn_of_divisors(parser);
    ttc_parse_warn(parser);
}
