/* The orbit in one arithmetic, REAL; names end as NAME says. Included twice by oracle.c. */

typedef struct {
    REAL m, R, g, I1, I3, a3;
    REAL x[ORACLE_STATES][ORDER + 1]; /* Taylor coefficients in tau */
} NAME(series);

static REAL NAME(root)(REAL x)
{
    REAL y = (REAL)sqrtl((long double)x);
    for (int k = 0; k < 3 && y > 0; k++) y = (y + x / y) / 2;
    return y;
}

static REAL NAME(size)(REAL x)
{
    return x < 0 ? -x : x;
}

/* Coefficient k of a product, and of a quotient whose coefficients below k are in q. */
static REAL NAME(product)(const REAL *a, const REAL *b, int k)
{
    REAL sum = 0;
    for (int j = 0; j <= k; j++) sum += a[j] * b[k - j];
    return sum;
}

static REAL NAME(quotient)(const REAL *q, const REAL *a, const REAL *b, int k)
{
    REAL sum = a[k];
    for (int j = 0; j < k; j++) sum -= q[j] * b[k - j];
    return sum / b[0];
}

/* (3.2) times s, order by order. */
static void NAME(expand)(NAME(series) *t)
{
    const REAL m = t->m, R = t->R, g = t->g, I1 = t->I1, I3 = t->I3, a3 = t->a3;
    const REAL *c = t->x[ORACLE_GAMMA3], *v = t->x[ORACLE_V_NU], *wt = t->x[ORACLE_OMEGA_TAU], *wn = t->x[ORACLE_OMEGA_N],
               *w3 = t->x[ORACLE_OMEGA3], *s = t->x[ORACLE_S];
    REAL b[ORDER], e[ORDER], s2[ORDER], V[ORDER], Theta[ORDER], D[ORDER], bwn[ORDER], sw3[ORDER], vtau[ORDER], cwn[ORDER],
        cwt[ORDER], spin[ORDER], push[ORDER], top2[ORDER], f2[ORDER], roll[ORDER], lever[ORDER], spread[ORDER], top3[ORDER],
        f3[ORDER], wnV[ORDER], turn[ORDER], top4[ORDER], f4[ORDER];

    for (int k = 0; k < ORDER; k++) {
        const bool first = k == 0;
        b[k] = R * c[k] + (first ? a3 : 0);
        e[k] = a3 * c[k] + (first ? R : 0);
        s2[k] = NAME(product)(s, s, k);
        Theta[k] = I1 * m * R * R * s2[k] + I3 * m * NAME(product)(b, b, k) + (first ? I1 * I3 : 0);
        D[k] = m * a3 * a3 * s2[k] + (first ? I1 : 0);
        V[k] = NAME(product)(e, wt, k) + v[k];
        bwn[k] = NAME(product)(b, wn, k);
        sw3[k] = NAME(product)(s, w3, k);
        vtau[k] = bwn[k] + R * sw3[k];
        cwn[k] = NAME(product)(c, wn, k);
        cwt[k] = NAME(product)(c, wt, k);
        spin[k] = I1 * cwn[k] + I3 * sw3[k];
        push[k] = a3 * NAME(product)(cwt, wt, k) - (first ? g : 0);
        top2[k] = m * a3 * NAME(product)(s2, push, k) - NAME(product)(wn, spin, k);
        f2[k] = NAME(quotient)(f2, top2, D, k);
        roll[k] = NAME(product)(sw3, wt, k);
        lever[k] = m * R * e[k] + (first ? I3 : 0);
        spread[k] = R * (I1 - I3) * c[k] - (first ? a3 * I3 : 0);
        top3[k] = I3 * NAME(product)(roll, lever, k) - m * I3 * NAME(product)(bwn, V, k);
        f3[k] = NAME(quotient)(f3, top3, Theta, k);
        wnV[k] = NAME(product)(wn, V, k);
        turn[k] = m * R * (NAME(product)(roll, spread, k) - I1 * wnV[k]);
        top4[k] = NAME(product)(s, turn, k);
        f4[k] = NAME(quotient)(f4, top4, Theta, k);
        const REAL f[ORACLE_STATES] = { NAME(product)(s2, wt, k), NAME(product)(wn, vtau, k), f2[k],
                                        NAME(product)(cwn, wt, k) + f3[k], f4[k], -NAME(product)(cwt, s, k), s[k] };
        for (int i = 0; i < ORACLE_STATES; i++) t->x[i][k + 1] = f[i] / (k + 1);
    }
}

static REAL NAME(value)(const REAL *a, REAL h)
{
    REAL sum = a[ORDER];
    for (int k = ORDER - 1; k >= 0; k--) sum = sum * h + a[k];
    return sum;
}

static REAL NAME(slope)(const REAL *a, REAL h)
{
    REAL sum = ORDER * a[ORDER];
    for (int k = ORDER - 1; k > 0; k--) sum = sum * h + k * a[k];
    return sum;
}

/* Where the polynomial a - level, or its derivative, changes sign between low and high. */
static REAL NAME(zero)(const REAL *a, REAL level, bool derivative, REAL low, REAL high)
{
    REAL (*const at)(const REAL *, REAL) = derivative ? NAME(slope) : NAME(value);
    const bool rises = at(a, high) > level;
    REAL x = (low + high) / 2;

    for (int k = 0; k < 100 && x != low && x != high; k++) {
        const REAL y = at(a, x) - level;
        if ((y > 0) == rises) high = x;
        else low = x;
        const REAL rate = derivative ? 0 : NAME(slope)(a, x), newton = rate != 0 && k > 4 ? x - y / rate : low;
        const bool lands = (newton - low) * (newton - high) < 0;
        if (lands && NAME(size)(newton - x) <= EPSILON * NAME(size)(x)) return newton;
        x = lands ? newton : (low + high) / 2;
    }
    return x;
}

static void NAME(rotate)(NAME(series) *t, REAL v_tau, REAL G)
{
    const REAL s = t->x[ORACLE_S][0], b = t->a3 + t->R * t->x[ORACLE_GAMMA3][0];
    const REAL K = t->I1 * t->R * t->R * s * s + t->I3 * b * b;
    if (!(K > 0)) return;
    t->x[ORACLE_OMEGA_N][0] = (t->R * s * G + t->I3 * b * v_tau) / K;
    t->x[ORACLE_OMEGA3][0] = (t->I1 * t->R * s * v_tau - b * G) / K;
}

static void NAME(levels)(const NAME(series) *t, REAL *E, REAL *G, REAL *v_tau)
{
    const REAL c = t->x[ORACLE_GAMMA3][0], v = t->x[ORACLE_V_NU][0], wt = t->x[ORACLE_OMEGA_TAU][0],
               wn = t->x[ORACLE_OMEGA_N][0], w3 = t->x[ORACLE_OMEGA3][0], s = t->x[ORACLE_S][0];
    const REAL b = t->a3 + t->R * c, D = t->I1 + t->m * t->a3 * t->a3 * s * s;
    *v_tau = b * wn + t->R * s * w3;
    *E = (t->m * v * v + D * wt * wt + t->I1 * wn * wn + t->I3 * w3 * w3 + t->m * *v_tau * *v_tau) / 2 + t->m * t->g * t->a3 * c;
    *G = t->I1 * t->R * s * wn - t->I3 * b * w3;
}

static void NAME(disturb)(NAME(series) *t, const oracle_question *q, oracle_noise noise, jlt_random *random)
{
    REAL E, G, v_tau, error[5];
    NAME(levels)(t, &E, &G, &v_tau);
    for (int i = 0; i < 5; i++) error[i] = q->tolerance * (2 * jlt_random_unit(random) - 1);
    const REAL U = q->speed, W = U / q->top.R;
    t->x[ORACLE_GAMMA3][0] += error[0];
    const REAL c = t->x[ORACLE_GAMMA3][0];
    if (q->plain) t->x[ORACLE_S][0] = NAME(root)((1 - c) * (1 + c) > 0 ? (1 - c) * (1 + c) : 0);
    else t->x[ORACLE_S][0] *= 1 + error[0];
    for (int i = ORACLE_V_NU; i <= ORACLE_OMEGA3; i++) {
        const REAL scale = i == ORACLE_V_NU ? U : W, size = NAME(size)(t->x[i][0]);
        const bool kept = (i == ORACLE_OMEGA_N && noise == ORACLE_OMEGA3_NOISE)
                          || (i == ORACLE_OMEGA3 && noise == ORACLE_OMEGA_N_NOISE);
        if (i < ORACLE_OMEGA_N || (noise != ORACLE_LEVEL_NOISE && !kept)) t->x[i][0] += error[i] * (size > scale ? size : scale);
    }
    const REAL size = NAME(size)(v_tau);
    if (noise == ORACLE_LEVEL_NOISE) NAME(rotate)(t, v_tau + error[3] * (size > U ? size : U), G);
    const REAL s = t->x[ORACLE_S][0], b = t->a3 + t->R * c;
    if (noise == ORACLE_OMEGA_N_NOISE) t->x[ORACLE_OMEGA3][0] = (t->I1 * t->R * s * t->x[ORACLE_OMEGA_N][0] - G) / (t->I3 * b);
    if (noise == ORACLE_OMEGA3_NOISE) t->x[ORACLE_OMEGA_N][0] = (G + t->I3 * b * t->x[ORACLE_OMEGA3][0]) / (t->I1 * t->R * s);
}

/* The length of a step: what the last two coefficients leave below `part` of scale. */
static REAL NAME(length)(const NAME(series) *t, const REAL *scale)
{
    long double h = INFINITY;
    for (int k = ORDER - 1; k <= ORDER; k++)
        for (int i = 0; i <= ORACLE_S; i++) { /* s has an error relative to itself: else it stays at the limit of stability */
            const long double part = (long double)(NAME(size)(t->x[i][k]) / (i == ORACLE_S ? t->x[i][0] : scale[i]));
            if (part > 0) h = fminl(h, powl(PART / part, 1.0L / k));
        }
    return isfinite(h) ? h : (REAL)(1 / (1e-3L + scale[ORACLE_OMEGA3]));
}

/* Where a chart divides by b or s, its steps are parts of them, and so are those between errors; at b = R/1000 it has ended. */
static REAL NAME(chart)(const NAME(series) *t, oracle_noise noise, REAL h)
{
    const REAL b = NAME(size)(t->a3 + t->R * t->x[ORACLE_GAMMA3][0]), end = t->R / 1000, rest = b > end ? b : end;
    const REAL b_moves = 4 * h * t->R * NAME(size)(t->x[ORACLE_GAMMA3][1]), s_moves = 4 * h * NAME(size)(t->x[ORACLE_S][1]);
    if (noise == ORACLE_OMEGA_N_NOISE && b_moves > rest) return h * rest / b_moves;
    if (noise == ORACLE_OMEGA3_NOISE && s_moves > t->x[ORACLE_S][0]) return h * t->x[ORACLE_S][0] / s_moves;
    return h;
}

static void NAME(put)(oracle_orbit *out, const NAME(series) *t, REAL h, int number)
{
    for (int i = 0; i < ORACLE_STATES; i++) out->rows[number][i] = (long double)NAME(value)(t->x[i], h);
}

/* At a crossing: the fastest change, of t too, for that of omega_tau. */
static long double NAME(lean)(const NAME(series) *t, REAL h, const REAL *scale)
{
    const REAL turn = NAME(size)(NAME(slope)(t->x[ORACLE_OMEGA_TAU], h)) / scale[ORACLE_OMEGA_TAU];
    REAL fastest = 0;
    for (int i = 0; i < ORACLE_STATES; i++) {
        const REAL size = NAME(size)(NAME(value)(t->x[i], h)), unit = i == ORACLE_T && size > scale[i] ? size : scale[i];
        const REAL change = NAME(size)(NAME(slope)(t->x[i], h)) / unit;
        if (i != ORACLE_S && change > fastest) fastest = change;
    }
    return (long double)(fastest / turn);
}

/* Crossings within a step, between extrema of omega_tau, which are looked for between nine points. */
static bool NAME(cross)(oracle_orbit *out, const NAME(series) *t, const oracle_question *q, REAL h, const REAL *scale)
{
    enum { PARTS = 8 };
    const REAL *w = t->x[ORACLE_OMEGA_TAU];
    REAL points[2 * PARTS + 2];
    int count = 0;

    for (int k = 0; k <= PARTS; k++) {
        const REAL here = h * k / PARTS, next = h * (k + 1) / PARTS;
        points[count++] = here;
        if (k < PARTS && NAME(slope)(w, here) * NAME(slope)(w, next) < 0) {
            const REAL at = NAME(zero)(w, 0, true, here, next);
            points[count++] = at;
        }
    }
    for (int k = 1; k < count; k++) {
        const REAL before = NAME(value)(w, points[k - 1]), after = NAME(value)(w, points[k]);
        const long double depth = (long double)(NAME(size)(before) / scale[ORACLE_OMEGA_TAU]);
        if (depth > out->depth[out->count + 1]) out->depth[out->count + 1] = depth;
        const int sign = q->time_direction * ((before < 0 && after >= 0) - (before > 0 && after <= 0));
        if (sign == 0 || (q->crossings != 0 && sign != q->crossings)) continue;
        const REAL at = NAME(zero)(w, 0, false, points[k - 1], points[k]);
        NAME(put)(out, t, at, ++out->count);
        out->lean[out->count] = NAME(lean)(t, at, scale);
        if (out->count == q->count) return true;
    }
    return false;
}

static bool NAME(pass)(oracle_orbit *out, const NAME(series) *t, const oracle_question *q, REAL h)
{
    const REAL *clock = t->x[ORACLE_T], end = NAME(value)(clock, h);
    while (out->count < q->count && q->time_direction * (end - (REAL)q->times[out->count]) >= 0) {
        const REAL wanted = q->times[out->count];
        NAME(put)(out, t, NAME(zero)(clock, wanted, false, 0, h), ++out->count);
    }
    return out->count == q->count;
}

/* The fastest change in a unit of time that the scales make, relative to scale. */
static REAL NAME(pace)(const NAME(series) *t, const REAL *scale)
{
    REAL fastest = 0;
    for (int i = 0; i <= ORACLE_S; i++) {
        const REAL change = NAME(size)(t->x[i][1]) / (t->x[ORACLE_S][0] * scale[i] * scale[ORACLE_OMEGA3]);
        if (change > fastest) fastest = change;
    }
    return fastest;
}

/* At a pole: both rates across the equilibria there are negative, and nothing is left of s and omega_n. */
static bool NAME(ends)(oracle_orbit *out, const NAME(series) *t, const oracle_question *q, const REAL *scale)
{
    const REAL s = t->x[ORACLE_S][0], w = t->x[ORACLE_OMEGA_TAU][0], v = t->x[ORACLE_V_NU][0], left = q->tolerance * 1e-4;
    const int sigma = t->x[ORACLE_GAMMA3][0] > 0 ? 1 : -1;
    const REAL b = t->a3 + t->R * t->x[ORACLE_GAMMA3][0];
    const REAL fall = q->time_direction * sigma * w, other = q->time_direction * (t->m * b * v - t->I1 * sigma * w);
    const bool rests = NAME(size)(t->x[ORACLE_OMEGA_N][0]) < left * scale[ORACLE_OMEGA_N];

    if (s < left && rests && fall > 0 && (other > 0 || t->x[ORACLE_OMEGA_N][0] == 0)) {
        NAME(put)(out, t, 0, out->count + 1);
        out->rows[out->count + 1][ORACLE_T] += (long double)(s / (sigma * w));
        out->end = sigma > 0 ? ORACLE_POLE_PLUS : ORACLE_POLE_MINUS;
        return true;
    }
    if (NAME(pace)(t, scale) > still) return false;
    NAME(put)(out, t, 0, out->count + 1);
    out->end = ORACLE_REST;
    return true;
}

static void NAME(begin)(NAME(series) *t, const oracle_question *q)
{
    const REAL c = q->gamma3;
    *t = (NAME(series)){ .m = q->top.m, .R = q->top.R, .g = q->top.g, .I1 = q->top.I1, .I3 = q->top.I3, .a3 = q->top.a3 };
    const REAL start[] = { c, q->v_nu, q->omega_tau, q->omega_n, q->omega3, NAME(root)((1 - c) * (1 + c)) };
    for (int i = 0; i <= ORACLE_S; i++) t->x[i][0] = start[i];
    if (q->level) NAME(rotate)(t, q->v_tau, q->G);
}

static void NAME(follow)(oracle_orbit *out, const oracle_question *q, oracle_noise noise, jlt_random *random)
{
    static NAME(series) t;
    const REAL W = (REAL)q->speed / q->top.R, scale[ORACLE_STATES] = { 1, q->speed, W, W, W, 1, 1 / W };
    REAL E, G, E0, G0, v_tau;

    *out = (oracle_orbit){ .end = ORACLE_BUDGET, .least_s = 1, .least_pace = INFINITY };
    NAME(begin)(&t, q);
    NAME(levels)(&t, &E0, &G0, &v_tau);
    while (out->steps++ < STEPS_MAX) {
        NAME(expand)(&t);
        if (NAME(ends)(out, &t, q, scale)) break;
        const int before = out->count;
        const REAL pace = NAME(pace)(&t, scale);
        out->least_pace = fminl(out->least_pace, (long double)pace);
        const REAL h = q->time_direction * NAME(chart)(&t, noise, NAME(length)(&t, scale));
        const bool done = q->times != NULL ? NAME(pass)(out, &t, q, h) : NAME(cross)(out, &t, q, h, scale);
        for (int k = before + 1; k <= out->count; k++) out->pace[k] = (long double)pace;
        if (done) {
            out->end = ORACLE_ALIVE;
            break;
        }
        for (int i = 0; i < ORACLE_STATES; i++) t.x[i][0] = NAME(value)(t.x[i], h);
        out->least_s = fminl(out->least_s, (long double)t.x[ORACLE_S][0]);
        /* Near its end at a pole or at rest errors die out. */
        if (noise != ORACLE_EXACT && t.x[ORACLE_S][0] > q->tolerance && pace > q->tolerance) NAME(disturb)(&t, q, noise, random);
    }
    NAME(levels)(&t, &E, &G, &v_tau);
    const REAL c = t.x[ORACLE_GAMMA3][0], s = t.x[ORACLE_S][0], U = q->speed;
    out->drift = fmaxl((long double)(NAME(size)(E - E0) / (t.m * U * U)),
                       fmaxl((long double)(NAME(size)(G - G0) / (NAME(size)(G0) + t.m * t.R * t.R * U)),
                             (long double)NAME(size)(c * c + s * s - 1)));
}
