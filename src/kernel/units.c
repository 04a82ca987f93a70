#include "kernel/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool jlt_units_is_table(const jlt_units *units) { return units->mass == 0 && units->length == 0 && units->time == 0; }

static int exponent_of(const jlt_units *units, const char *name, size_t length)
{
    if (length == 2 && strncmp(name, "kg", 2) == 0) return units->mass;
    if (length != 1) return 0;
    return *name == 'm' ? units->length : *name == 's' ? units->time : 0;
}

/* The exponent of the product that begins at *at and runs to the end of the text or to an unmatched ')', where it leaves *at. */
static int exponent_of_product(const jlt_units *units, const char **at)
{
    int sum = 0, sign = 1;

    while (**at != '\0' && **at != ')') {
        int factor = 0;
        if (strchr("*/ ", **at) != NULL) {
            sign = **at == '/' ? -1 : **at == '*' ? 1 : sign;
            ++*at;
            continue;
        }
        if (**at == '(') {
            ++*at;
            factor = exponent_of_product(units, at);
            if (**at == ')') ++*at;
        }
        else {
            const size_t length = strcspn(*at, "*/ ^()");
            factor = exponent_of(units, *at, length);
            *at += length;
        }
        if (**at == '^') {
            char *end;
            const long power = strtol(*at + 1, &end, 10);
            factor *= labs(power) <= 64 ? (int)power : 0;
            *at = end;
        }
        sum += sign * factor;
        sign = 1;
    }
    return sum;
}

int jlt_units_exponent(const jlt_units *units, const char *unit)
{
    const char *at = unit;
    int sum = exponent_of_product(units, &at);

    while (*at != '\0') { /* skip a ')' that matches no '(' */
        at++;
        sum += exponent_of_product(units, &at);
    }
    return sum;
}

bool jlt_units_has_time(const jlt_descriptor *d)
{
    const jlt_units second = { .time = 1 };
    bool has = false;

    for (unsigned i = 0; i < d->param_count; i++) has = has || jlt_units_exponent(&second, d->params[i].unit) != 0;
    for (unsigned i = 0; i < d->state_count; i++) has = has || jlt_units_exponent(&second, d->states[i].unit) != 0;
    return has;
}

void jlt_units_count(double *out, const double *in, const jlt_quantity *of, unsigned count, const jlt_units *units)
{
    for (unsigned i = 0; i < count; i++) out[i] = ldexp(in[i], -jlt_units_exponent(units, of[i].unit));
}

void jlt_units_restore(double *out, const double *in, const jlt_quantity *of, unsigned count, const jlt_units *units)
{
    for (unsigned i = 0; i < count; i++) out[i] = ldexp(in[i], jlt_units_exponent(units, of[i].unit));
}

/* The first parameter of this unit that is declared positive, and the largest state of this unit; each 0 if there is none. */
static double first_positive(const double *params, const jlt_quantity *of, unsigned count, const char *unit)
{
    for (unsigned i = 0; i < count; i++)
        if (of[i].sign == JLT_POSITIVE && strcmp(of[i].unit, unit) == 0 && params[i] > 0 && isfinite(params[i])) return params[i];
    return 0;
}

static double largest(const double *x, const jlt_quantity *of, unsigned count, const char *unit)
{
    double size = 0;

    for (unsigned k = 0; k < count; k++)
        if (strcmp(of[k].unit, unit) == 0 && isfinite(x[k])) size = fmax(size, fabs(x[k]));
    return size;
}

static int exponent_of_size(double param, double state)
{
    static const int spare = 6;

    if (param > 0 && !(state > 0 && ilogb(state) < ilogb(param) - spare)) return ilogb(param);
    return state > 0 ? ilogb(state) : 0;
}

void jlt_units_of_sizes(jlt_units *units, const double *params, const jlt_quantity *of, unsigned count, const double *x,
                        const jlt_quantity *states, unsigned n)
{
    units->mass = exponent_of_size(first_positive(params, of, count, "kg"), largest(x, states, n, "kg"));
    units->length = exponent_of_size(first_positive(params, of, count, "m"), largest(x, states, n, "m"));
}

double jlt_units_rate(const jlt_units *units, const double *x, const jlt_quantity *of, unsigned count, int derivatives)
{
    static const jlt_units seconds = { .time = 1 };
    const jlt_units timeless = { units->mass, units->length, 0 };
    double rate = 0;

    for (unsigned k = 0; k < count; k++) {
        const int power = jlt_units_exponent(&seconds, of[k].unit) - derivatives;
        const double size = ldexp(fabs(x[k]), -jlt_units_exponent(&timeless, of[k].unit));
        if (power < 0 && isfinite(size)) rate = fmax(rate, pow(size, -1. / power));
    }
    return rate;
}

void jlt_units_of_rate(jlt_units *units, double rate)
{
    if (rate > 0 && isfinite(rate * rate)) units->time = -(ilogb(rate * rate / 2) >> 1);
}
