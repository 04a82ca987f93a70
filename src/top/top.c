#include "top/top.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "kernel/way.h"

enum { LIFTED = JLT_TOP_STATES + 1 }; /* the states and s */

static const char lifting[] = "regular";

const double jlt_top_samples[JLT_TOP_SAMPLES][JLT_TOP_STATES] = {
    { -0.8, 0.93, -0.71, 0.83, -0.59 }, { -0.28, -0.67, 0.89, 0.73, 0.97 }, { 0.6, 0.79, 0.61, -0.87, 0.53 }
};

typedef struct {
    const char *name;
    double *value;
} named_value;

enum { NAMES = 6, NEEDED = 3 };

static void name_all(named_value out[NAMES], jlt_top *top)
{
    const named_value all[NAMES] = { { "m", &top->m }, { "R", &top->R }, { "I1", &top->I1 }, { "I3", &top->I3 }, { "g", &top->g },
                                     { "a3", &top->a3 } };

    memcpy(out, all, sizeof all);
}

jlt_status jlt_top_read(jlt_top *out, const jlt_descriptor *descriptor, const double *params)
{
    jlt_top top = { 0 };
    named_value wanted[NAMES];
    size_t index;

    name_all(wanted, &top);
    for (size_t w = 0; w < NAMES; w++) {
        if (jlt_descriptor_param(descriptor, wanted[w].name, &index)) *wanted[w].value = params[index];
        else if (w < NEEDED) return JLT_ERR_ARG;
    }
    *out = top;
    return JLT_OK;
}

void jlt_top_write(double *params, const jlt_descriptor *descriptor, const jlt_top *top)
{
    jlt_top copy = *top;
    named_value given[NAMES];
    size_t index;

    name_all(given, &copy);
    for (unsigned i = 0; i < descriptor->param_count; i++) params[i] = NAN;
    for (size_t w = 0; w < NAMES; w++)
        if (jlt_descriptor_param(descriptor, given[w].name, &index)) params[index] = *given[w].value;
}

/* Whether a model has the top's states, in this order, and its parameters. */
static bool is_known(const jlt_descriptor *model)
{
    static const char *const states[JLT_TOP_STATES] = { "gamma3", "v_nu", "omega_tau", "omega_n", "omega3" };
    jlt_top top;
    named_value wanted[NAMES];
    size_t index;

    if (model->state_count != JLT_TOP_STATES) return false;
    for (unsigned i = 0; i < JLT_TOP_STATES; i++)
        if (strcmp(model->states[i].name, states[i]) != 0) return false;
    name_all(wanted, &top);
    for (size_t w = 0; w < NAMES; w++)
        if (!jlt_descriptor_param(model, wanted[w].name, &index)) return false;
    return true;
}

double jlt_top_sine(double gamma3)
{
    return sqrt(fmax(0, (1 - gamma3) * (1 + gamma3))); /* a gamma3 from integration may exceed 1 by rounding */
}

/* The field of a variant in the time in which s is a state; NULL if it is missing, or of other states or sizes. */
static const jlt_descriptor *find_field(const char *variant)
{
    const jlt_descriptor *field = jlt_descriptor_find(JLT_DEFAULT_MODEL, variant, lifting, NULL);

    if (field == NULL || !is_known(field->family[0]) || field->state_count != LIFTED
        || field->param_count > JLT_WAY_VALUES_MAX || field->prepared_count > JLT_WAY_VALUES_MAX
        || field->integral_count > JLT_WAY_VALUES_MAX)
        return NULL;
    return field;
}

static void add_sine(double *lifted, const double *x)
{
    memcpy(lifted, x, JLT_TOP_STATES * sizeof *x);
    lifted[JLT_TOP_STATES] = jlt_top_sine(x[JLT_TOP_GAMMA3]);
}

double jlt_top_integral(const jlt_top *top, const char *variant, const char *name, const double *x)
{
    const jlt_descriptor *field = find_field(variant);
    double lifted[LIFTED], params[JLT_WAY_VALUES_MAX], block[JLT_WAY_VALUES_MAX], values[JLT_WAY_VALUES_MAX];
    unsigned i = 0;

    while (field != NULL && i < field->integral_count && strcmp(field->integrals[i].name, name) != 0) i++;
    if (field == NULL || i == field->integral_count) return NAN;
    add_sine(lifted, x);
    jlt_top_write(params, field, top);
    field->prepare(params, block);
    field->integral_values.call(lifted, block, values);
    return values[i];
}

bool jlt_top_rates(const jlt_top *top, const char *variant, double *rates, const double *x)
{
    const jlt_descriptor *field = find_field(variant);
    double lifted[LIFTED], params[JLT_WAY_VALUES_MAX], block[JLT_WAY_VALUES_MAX], slow[LIFTED];

    if (field == NULL) return false;
    add_sine(lifted, x);
    jlt_top_write(params, field, top);
    field->prepare(params, block);
    field->rhs.call(lifted, block, slow);
    for (unsigned i = 0; i < JLT_TOP_STATES; i++) rates[i] = slow[i] / lifted[JLT_TOP_STATES]; /* dt = s dtau */
    return true;
}

bool jlt_top_agrees(double value, double wanted, double size)
{
    return fabs(value - wanted) <= 64 * DBL_EPSILON * size;
}

const jlt_way *jlt_top_way(const char *model)
{
    const jlt_descriptor *field = find_field(NULL);

    for (unsigned i = 0; field != NULL && i < field->way_count; i++) {
        const jlt_way *way = &field->ways[i];
        if (strcmp(way->model, model) == 0 && strcmp(way->time, lifting) == 0 && way->state_count == way->coordinate_count + 1
            && way->state_count <= JLT_WAY_VALUES_MAX && way->param_count <= JLT_WAY_VALUES_MAX)
            return way;
    }
    return NULL;
}

bool jlt_top_claims(const jlt_claim **broken, const char *kind, const char *name)
{
    const jlt_descriptor *field = find_field(NULL);

    *broken = field == NULL ? NULL : jlt_descriptor_claim(field, kind, name);
    if (*broken == NULL || (*broken)->verdict != JLT_PROVED) return false;
    *broken = NULL;
    return true;
}

bool jlt_top_serves(const jlt_claim **broken, const char *model, const char *const *names)
{
    const jlt_descriptor *field = find_field(NULL);
    const jlt_way *way = jlt_top_way(model);

    *broken = NULL;
    if (way == NULL || jlt_way_target(way, NULL) == NULL) return false;
    if (!jlt_way_holds(broken, field, way, jlt_way_target(way, NULL))) return false;
    for (; *names != NULL; names++)
        if (!jlt_top_claims(broken, "integral", *names)) return false;
    *broken = NULL;
    return true;
}

void jlt_top_look(const jlt_way *way, double *y, double *other, const jlt_top *top, const double *x)
{
    double lifted[LIFTED], params[JLT_WAY_VALUES_MAX], pairs[2 * JLT_WAY_VALUES_MAX];

    add_sine(lifted, x);
    jlt_top_write(params, find_field(NULL), top);
    way->coordinates(lifted, params, pairs);
    for (unsigned i = 0; i < way->coordinate_count; i++)
        y[i] = way->is_angle[i] ? atan2(pairs[2 * i], pairs[2 * i + 1]) : pairs[2 * i];
    jlt_way_params(way, other, lifted, params);
}

void jlt_top_return(const jlt_way *way, double *x, const double *y, const double *other)
{
    double lifted[LIFTED];

    way->back(y, other, lifted);
    memcpy(x, lifted, JLT_TOP_STATES * sizeof *x);
}

double jlt_top_v_tau(const jlt_top *top, const double *x)
{
    static const char level[] = "spherical_top_level";
    const jlt_way *way = jlt_top_way(level);
    const jlt_descriptor *table = jlt_descriptor_find(level, NULL, NULL, NULL);
    double y[JLT_WAY_VALUES_MAX], other[JLT_WAY_VALUES_MAX];
    size_t index;

    if (way == NULL || table == NULL || !jlt_descriptor_state(table, "v_tau", &index) || index >= way->coordinate_count) return NAN;
    jlt_top_look(way, y, other, top, x);
    return y[index];
}

double jlt_top_energy(const jlt_top *top, const double *x)
{
    return jlt_top_integral(top, NULL, "E", x);
}

double jlt_top_jellett(const jlt_top *top, const double *x)
{
    return jlt_top_integral(top, NULL, "G", x);
}
