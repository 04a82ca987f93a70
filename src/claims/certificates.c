/* Certificates that a family of equilibria excludes an invariant measure: points with field exactly zero, trace exactly nonzero. */
#include "claims/verify.h"

#include "core/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CERTIFICATES = 3, TRIES = 400, DIGITS = 40 };

/* Values to draw from. The legs x of Pythagorean triangles make sqrt(1 - x^2) rational; the others are small numbers. */
static const char *const legs[] = { "3/5", "4/5", "5/13", "12/13", "8/17", "15/17", "7/25", "24/25", "20/29", "21/29" };
static const char *const plain[] = { "1", "2", "1/2", "1/3", "2/3", "3/4", "3/2", "2/5", "5/3", "7/4" };

static const char *pick(jlt_random *random, const char *const *from, size_t count)
{
    return from[jlt_random_below(random, count)];
}

static void set(jlt_verify_run *run, uint32_t symbol, const char *fraction, bool negative)
{
    char text[32] = "-";

    if (negative) strncat(text, fraction, sizeof text - 2);
    (void)ttc_ball_set_fraction(run->oracle->ball, symbol, negative ? text : fraction);
}

/* A number drawn outside its state's open interval is replaced. With d its modulus, rounded to 1/256, the state becomes the point
 * at distance d from the finite end, or, in a bounded interval, the point at the fraction d of its length. */
static void move_inside(jlt_verify_run *run, unsigned state)
{
    const jlt_quantity *q = &run->descriptor->states[state];
    const uint32_t symbol = run->oracle->states[state];
    ttc_enclosure drawn;

    if (!ttc_ball_enclose(&drawn, run->oracle->ball, run->oracle->model->symbols[symbol].node)) return;
    if (drawn.value > q->low && drawn.value < q->high) return;
    const double part = round(fabs(drawn.value) * 256) / 256;
    const double moved = !isfinite(q->high)  ? q->low + part
                         : !isfinite(q->low) ? q->high - part
                                             : q->low + (q->high - q->low) * part;
    (void)ttc_ball_set(run->oracle->ball, symbol, moved);
}

static void draw_point(jlt_verify_run *run, const ttc_claim *claim, bool by_default)
{
    const jlt_descriptor *d = run->descriptor;
    const jlt_oracle *o = run->oracle;

    for (unsigned i = 0; i < d->param_count; i++) {
        const bool any = d->params[i].sign == JLT_ANY_SIGN || d->params[i].sign == JLT_NONZERO;
        set(run, o->params[i], pick(&run->random, plain, sizeof plain / sizeof *plain),
            any && jlt_random_below(&run->random, 2) == 0);
        if (by_default && o->defaults[i] != NULL) set(run, o->params[i], o->defaults[i], false);
    }
    for (unsigned i = 0; i < d->state_count; i++) {
        const bool limited = d->states[i].low > -1e300 && d->states[i].high < 1e300;
        const bool negative = d->states[i].low < 0.0 && jlt_random_below(&run->random, 2) == 0;
        if (limited) set(run, o->states[i], pick(&run->random, legs, sizeof legs / sizeof *legs), negative);
        else set(run, o->states[i], pick(&run->random, plain, sizeof plain / sizeof *plain), negative);
        move_inside(run, i);
    }
    for (size_t i = 0; i < claim->when.count; i++)
        ttc_ball_bind(o->ball, claim->when.items[i].symbol, claim->when.items[i].expression);
    for (size_t i = 0; i < claim->bindings.count; i++)
        ttc_ball_bind(o->ball, claim->bindings.items[i].symbol, claim->bindings.items[i].expression);
}

/* Whether the parameters, some of them set by conditions, have the signs that the table requires. */
static bool allowed(const jlt_verify_run *run)
{
    const jlt_descriptor *d = run->descriptor;

    for (unsigned i = 0; i < d->param_count; i++) {
        int sign = 0;
        if (!ttc_ball_exact_sign(&sign, run->oracle->ball, run->oracle->model->symbols[run->oracle->params[i]].node))
            return false;
        if ((d->params[i].sign == JLT_POSITIVE && sign <= 0) || (d->params[i].sign == JLT_NONNEGATIVE && sign < 0) ||
            (d->params[i].sign == JLT_NONZERO && sign == 0))
            return false;
    }
    return true;
}

static bool is_positive(const jlt_verify_run *run, ttc_id id)
{
    ttc_enclosure value;

    return ttc_ball_enclose(&value, run->oracle->ball, id) && value.value - fabs(value.rest) > value.radius;
}

static bool in_domain(const jlt_verify_run *run)
{
    const ttc_model *model = run->oracle->model;
    bool inside = true;

    for (size_t i = 0; inside && i < 2 * model->state_count; i++) {
        const ttc_id end = ttc_model_inside(model, model->states[i / 2], i % 2 != 0);
        inside = end == TTC_NONE || is_positive(run, end);
    }
    for (size_t i = 0; inside && i < model->region_count; i++) inside = is_positive(run, model->regions[i].expression);
    return inside;
}

/* Whether an expression is exactly zero: in rational arithmetic, or, with functions such as sin(0), by a ball without width. */
static bool is_zero(const jlt_verify_run *run, ttc_id id)
{
    JLT_FREED char *text = NULL;
    bool excludes_zero;
    int sign;

    if (ttc_ball_exact_sign(&sign, run->oracle->ball, id)) return sign == 0;
    text = ttc_ball_text(run->oracle->ball, id, DIGITS, &excludes_zero);
    return text != NULL && strcmp(text, "0") == 0;
}

static bool field_is_zero(const jlt_verify_run *run)
{
    bool zero = true;

    for (size_t i = 0; zero && i < run->oracle->model->state_count; i++) zero = is_zero(run, run->oracle->field[i]);
    return zero;
}

/* "NAME = value" of every parameter and state, joined with ", "; NULL if memory is out or a value is irrational. */
static char *describe(const jlt_verify_run *run)
{
    const jlt_oracle *o = run->oracle;
    const size_t params = run->descriptor->param_count, count = params + run->descriptor->state_count;
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    bool good = stream != NULL;

    for (size_t i = 0; good && i < count; i++) {
        const ttc_symbol_entry *entry = &o->model->symbols[i < params ? o->params[i] : o->states[i - params]];
        char *value = ttc_ball_exact_text(o->ball, entry->node);
        good = value != NULL;
        if (good) fprintf(stream, "%s%s = %s", i == 0 ? "" : ", ", entry->name, value);
        free(value);
    }
    if (stream != NULL && fclose(stream) != 0) good = false;
    if (good) return text;
    free(text);
    return NULL;
}

/* Whether a certificate with index >= first is at this point. */
static bool is_known(const jlt_verify_run *run, size_t first, const char *point)
{
    for (size_t i = first; i < run->certificate_count; i++)
        if (strcmp(run->certificates[i].point, point) == 0) return true;
    return false;
}

static void certify(jlt_verify_run *run, const jlt_equilibria *family)
{
    const ttc_claim *claim = jlt_verify_claim(run, family);
    const size_t first = run->certificate_count;

    for (int attempt = 0; claim != NULL && attempt < TRIES && run->certificate_count < first + CERTIFICATES; attempt++) {
        jlt_verify_certificate c = { .family = family };
        draw_point(run, claim, attempt >= TRIES / 2);
        if (!allowed(run) || !in_domain(run) || !field_is_zero(run)) continue;
        c.point = describe(run);
        c.enclosure = ttc_ball_text(run->oracle->ball, run->oracle->trace, DIGITS, &c.excludes_zero);
        /* The trace vanishes on a subset of the family; a point there certifies nothing. */
        if (c.point == NULL || !c.excludes_zero || is_known(run, first, c.point)) {
            free(c.point);
            free(c.enclosure);
            continue;
        }
        c.exact = true;
        c.trace = ttc_ball_exact_text(run->oracle->ball, run->oracle->trace);
        run->certificates[run->certificate_count++] = c;
        run->held++;
    }
    if (run->certificate_count == first)
        run->certificates[run->certificate_count++] = (jlt_verify_certificate){ .family = family };
}

jlt_status jlt_verify_certify(jlt_verify_run *run)
{
    const jlt_descriptor *d = run->descriptor;

    run->certificates = calloc(CERTIFICATES * d->equilibria_count + 1, sizeof *run->certificates);
    if (run->certificates == NULL) return JLT_ERR_NOMEM;
    for (unsigned i = 0; i < d->equilibria_count; i++)
        if (d->equilibria[i].obstructs) certify(run, &d->equilibria[i]);
    return JLT_OK;
}
