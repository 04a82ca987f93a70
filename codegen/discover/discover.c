#include "discover/discover.h"

#include "discover/claim_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { REMARK_SIZE = 1024 };

ttc_discovery *ttc_discovery_create(const ttc_model *model, const ttc_bindings *conditions, const char *when, int degree,
                                    size_t memory,
                                    ttc_discovery_host host, const char **why)
{
    ttc_flow *flow = ttc_flow_create(model, conditions, why);
    if (flow == NULL) return NULL;
    ttc_discovery *d = flint_calloc(1, sizeof *d);
    *d = (ttc_discovery){ .flow = flow, .host = host, .source = 1, .when = when, .degree = degree, .memory = memory };
    d->parameters = flint_calloc(flow->ring->variable_count, sizeof *d->parameters);
    d->leading = flint_calloc(flow->ring->variable_count, sizeof *d->leading);
    ttc_sign_changes_find(&d->changes, flow);
    ttc_grading_find(&d->grading, flow);
    if (ttc_flow_draw_parameters(flow, d->parameters, -1, &d->source)
        && ttc_flow_draw_parameters(flow, d->leading, d->grading.parameter, &d->source))
        return d;
    *why = "no values of the parameters were found in a prime field";
    ttc_discovery_destroy(d);
    return NULL;
}

void ttc_discovery_destroy(ttc_discovery *d)
{
    if (d == NULL) return;
    ttc_knowns_clear(&d->densities, d->flow);
    ttc_knowns_clear(&d->factors, d->flow);
    ttc_knowns_clear(&d->integrals, d->flow);
    ttc_grading_clear(&d->grading);
    flint_free(d->leading);
    flint_free(d->parameters);
    ttc_flow_destroy(d->flow);
    flint_free(d);
}

/* The degree as a polynomial in the quantities; -1 if it is none. */
static int degree_of(const ttc_flow *flow, const ttc_ratio *value)
{
    const bool divides = ttc_flow_degree(flow, value->denominator) > 0;
    return divides ? -1 : ttc_flow_degree(flow, value->numerator);
}

bool ttc_discovery_value(ttc_discovery *d, ttc_ratio *out, ttc_id expression)
{
    ttc_ring *ring = d->flow->ring;
    ttc_evaluate(d->flow->valuation, out, expression);
    const bool has_value = ring->status == TTC_RING_OK;
    if (ring->status != TTC_RING_NO_MEMORY) ring->status = TTC_RING_OK;
    return has_value;
}

bool ttc_discovery_know(ttc_discovery *d, ttc_knowns *knowns, const char *name, ttc_id expression)
{
    int degree = -1;
    ttc_ratio value;
    ttc_ratio_init(d->flow->ring, &value);
    const bool has_value = ttc_discovery_value(d, &value, expression);
    if (has_value) {
        degree = degree_of(d->flow, &value);
        ttc_knowns_add(knowns, d->flow, name, &value, NULL, degree);
    }
    ttc_ratio_clear(d->flow->ring, &value);
    return has_value && (degree >= 0 || knowns == &d->densities);
}

bool ttc_discovery_fits(ttc_discovery *d, size_t *columns)
{
    const ttc_question question = { .degree = d->degree, .keeps_signs = true };
    const double bytes = ttc_search_bytes(d, &question, d->grading.weights != NULL, columns);
    if (bytes > (double)d->memory) d->too_large = bytes;
    return bytes <= (double)d->memory;
}

void ttc_discovery_introduce(ttc_discovery *d)
{
    ttc_text names = { 0 };
    for (size_t i = 0; i < d->flow->count; i++)
        ttc_text_format(&names, "%s%s", i > 0 ? ", " : "", d->flow->ring->names[d->flow->variables[i]]);
    ttc_discovery_remark(d, "%s%s, for parameters in general: P stands for polynomials in", d->flow->model->name, d->when);
    ttc_discovery_remark(d, "%s", ttc_text_string(&names));
    ttc_text_clear(&names);
}

static bool is_taken(const ttc_model *model, const char *name)
{
    uint32_t unused;
    return ttc_model_find_symbol(model, name, &unused) || ttc_model_find_claim(model, name, &unused);
}

char *ttc_discovery_name(ttc_discovery *d, const char *stem)
{
    const size_t size = strlen(stem) + 24;
    char *name = flint_malloc(size);
    do snprintf(name, size, "%s%zu", stem, ++d->named);
    while (is_taken(d->flow->model, name));
    return name;
}

bool ttc_discovery_try(ttc_discovery *d, const char *claim, bool *is_smooth)
{
    ttc_text text = { 0 };
    ttc_claim_text_wrap(&text, claim);
    ttc_text_add(&text, "\n");
    d->host.progress(d->host.context, "a find is proved");
    const bool proved = !text.failed && d->host.prove(d->host.context, ttc_text_string(&text), is_smooth);
    ttc_text_clear(&text);
    return proved;
}

static void pass_on(ttc_discovery *d, const char *claim, void (*take)(void *context, const char *text))
{
    ttc_text text = { 0 };
    ttc_claim_text_wrap(&text, claim);
    ttc_text_add(&text, "\n");
    take(d->host.context, ttc_text_string(&text));
    ttc_text_clear(&text);
}

void ttc_discovery_say(ttc_discovery *d, const char *claim) { pass_on(d, claim, d->host.say); }

bool ttc_discovery_publish(ttc_discovery *d, const char *claim)
{
    const bool proved = ttc_discovery_try(d, claim, NULL);
    d->unproved += !proved;
    pass_on(d, claim, proved ? d->host.say : d->host.complain);
    return proved;
}

void ttc_discovery_remark(ttc_discovery *d, const char *format, ...)
{
    char text[REMARK_SIZE];
    va_list arguments;
    va_start(arguments, format);
    const int length = snprintf(text, sizeof text, "# ");
    vsnprintf(text + length, sizeof text - (size_t)length - 1, format, arguments);
    va_end(arguments);
    strcat(text, "\n");
    d->host.remark(d->host.context, text);
}
