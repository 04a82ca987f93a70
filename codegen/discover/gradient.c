#include "discover/gradient.h"

bool ttc_gradient_is_new(const ttc_flow *flow, const ttc_knowns *knowns, const ttc_ratio *value, ulong *parameters,
                         uint64_t *source)
{
    ttc_ring *ring = flow->ring;
    ttc_points points;
    ttc_span span;
    ttc_ratio slope;
    ttc_modular_ratio modular = { .numerator = { .count = 0 } };
    bool added = false;
    ttc_ratio *direction = flint_calloc(ring->variable_count, sizeof *direction);
    ulong *gradient = flint_calloc(flow->count + 1, sizeof *gradient);
    for (size_t v = 0; v < ring->variable_count; v++) ttc_ratio_init(ring, &direction[v]);
    ttc_ratio_init(ring, &slope);
    ttc_span_init(&span, flow->count, flow->mod);
    const bool good = ttc_points_draw(&points, 1, flow, parameters, source);
    for (size_t k = 0; good && k <= knowns->count; k++) {
        for (size_t i = 0; i < flow->count; i++) {
            gradient[i] = 0;
            if (flow->is_root[i]) continue;
            ttc_ratio_set_integer(ring, &direction[flow->variables[i]], 1);
            ttc_ratio_derive(ring, &slope, k < knowns->count ? &knowns->items[k].value : value, direction);
            ttc_ratio_set_integer(ring, &direction[flow->variables[i]], 0);
            ttc_modular_ratio_set(&modular, ring, &slope, flow->mod);
            if (!ttc_modular_ratio_value(&gradient[i], &modular, points.values, flow->mod)) gradient[i] = 0;
        }
        added = ttc_span_add(&span, gradient);
    }
    ttc_modular_ratio_clear(&modular);
    ttc_points_clear(&points);
    ttc_span_clear(&span);
    ttc_ratio_clear(ring, &slope);
    for (size_t v = 0; v < ring->variable_count; v++) ttc_ratio_clear(ring, &direction[v]);
    flint_free(gradient);
    flint_free(direction);
    return added;
}
