/* Reference orbits near the poles in quadruple precision, at the parameters of (5.1) rounded to double.
 *
 *     cc -O2 -o reference_passages tools/bench/reference_passages.c -lquadmath -lm
 *     ./reference_passages passages > passages_51.csv
 *     ./reference_passages approach > approach_51.csv
 *
 * passages: one return that passes the pole gamma3 = pole at the distance s = 10^-k, where omega_tau = 0. That point is taken
 * on the levels at eta and followed backwards to the crossing before it, which is rounded to double: the start; the
 * end is the crossing of the same direction after the passage. condition is the sum over the start's states (gamma3, v_nu,
 * omega_tau, omega_n, omega3, s, each by itself) of |d end/d x_j| max(|x_j|, 1e-3), the largest over the end's states and t, by
 * differences of 1e-21.
 *
 * approach: an orbit that ends at the pole gamma3 = +1, where s = 10^-k; the last row has s < 1e-25. */
#include <string.h>

#include "reference_quad.h"

static const quad tolerance = 1e-30Q;

/* On to the next crossing of omega_tau = 0 in a direction of t (rising: +1), with h of either sign; *least: smallest s met. */
static void next_crossing(quad *x, quad h, int direction, quad *least)
{
    quad y[STATES], f[STATES], part;
    int seen = 0; /* a start on the section has to leave it first */

    if (h < 0) direction = -direction;
    for (;;) {
        quad error = extrapolate(x, h, y);
        if (error > tolerance) {
            h *= 0.7Q;
            continue;
        }
        if (seen && x[2] * direction < 0 && y[2] * direction >= 0) break;
        seen = 1;
        memcpy(x, y, sizeof y);
        if (x[5] < *least) *least = x[5];
        if (error < 1e-32Q) h *= 1.15Q;
    }
    part = h * x[2] / (x[2] - y[2]);
    for (int newton = 0; newton < 9; newton++) {
        extrapolate(x, part, y);
        field(y, f);
        if (newton < 8) part -= y[2] / f[2];
    }
    memcpy(x, y, sizeof y);
}

static void print_row(const quad *x, int count)
{
    char text[48];
    for (int i = 0; i < count; i++) {
        quadmath_snprintf(text, sizeof text, "%.32Qe", x[i]);
        printf(",%s", text);
    }
    putchar('\n');
}

static quad condition(const quad *from, const quad *to, int direction)
{
    quad worst = 0, sum[STATES] = { 0 };
    for (int j = 0; j < 6; j++) {
        quad x[STATES], least = 1, size = fabsq(from[j]) > 1e-3Q ? fabsq(from[j]) : 1e-3Q;
        memcpy(x, from, sizeof x);
        x[j] += 1e-21Q;
        next_crossing(x, 0.05Q, direction, &least);
        for (int i = 0; i < STATES; i++) sum[i] += fabsq(x[i] - to[i]) / 1e-21Q * size;
    }
    for (int i = 0; i < STATES; i++)
        if (sum[i] > worst) worst = sum[i];
    return worst;
}

static void passages(void)
{
    static const struct {
        int pole;
        quad eta;
    } families[] = { { 1, 0.7Q }, { 1, -0.7Q }, { -1, -2.4Q }, { -1, 2.4Q } };
    puts("pole,eta,k,closest,condition,gamma3,v_nu,omega_n,omega3,t_end,gamma3_end,v_nu_end,omega_n_end,omega3_end");
    for (int family = 0; family < 4; family++)
        for (int k = 1; k <= 8; k++) {
            const int pole = families[family].pole;
            quad x[STATES], from[STATES], s = powq(10, -k), least = 1;
            /* At the pole +1 the passage crosses downwards, at -1 upwards: start and end cross the other way. */
            start(families[family].eta, pole * sqrtq((1 - s) * (1 + s)), x);
            x[5] = s;
            next_crossing(x, -0.05Q, pole, &least);
            for (int i = 0; i < 5; i++) from[i] = (double)x[i];
            from[2] = 0;
            from[5] = sqrtq((1 - from[0]) * (1 + from[0]));
            from[6] = 0;
            memcpy(x, from, sizeof x);
            least = 1;
            next_crossing(x, 0.05Q, -pole, &least);
            least = x[5];
            memcpy(x, from, sizeof x);
            quad unused = 1;
            next_crossing(x, 0.05Q, pole, &unused);
            printf("%d,%g,%d,%.6e,%.3e", pole, (double)families[family].eta, k, (double)least, (double)condition(from, x, pole));
            const quad row[] = { from[0], from[1], from[3], from[4], x[6], x[0], x[1], x[3], x[4] };
            print_row(row, 9);
            fflush(stdout);
        }
}

static void approach(void)
{
    quad x[STATES], y[STATES], f[STATES], h = 0.05Q;
    int k = 0;

    puts("k,t,gamma3,v_nu,omega_tau,omega_n,omega3,s");
    start(-1, 0.2Q, x);
    for (int i = 0; i < 5; i++) x[i] = (double)x[i];
    x[2] = 0;
    x[5] = sqrtq((1 - x[0]) * (1 + x[0]));
    quad row[] = { x[6], x[0], x[1], x[2], x[3], x[4], x[5] };
    printf("0");
    print_row(row, 7);
    while (x[5] > 1e-25Q) {
        quad error = extrapolate(x, h, y), level = powq(10, -(k + 1));
        if (error > tolerance) {
            h *= 0.7Q;
            continue;
        }
        if (k < 12 && x[5] > level && y[5] <= level && x[0] > 0 && x[2] > 0) {
            quad z[STATES], part = h * (x[5] - level) / (x[5] - y[5]);
            for (int newton = 0; newton < 8; newton++) {
                extrapolate(x, part, z);
                field(z, f);
                part -= (z[5] - level) / f[5];
            }
            extrapolate(x, part, z);
            const quad near[] = { z[6], z[0], z[1], z[2], z[3], z[4], z[5] };
            printf("%d", ++k);
            print_row(near, 7);
            continue; /* the same step may hold the next level */
        }
        memcpy(x, y, sizeof y);
        if (error < 1e-32Q) h *= 1.15Q;
    }
    const quad end[] = { x[6], x[0], x[1], x[2], x[3], x[4], x[5] };
    printf("99");
    print_row(end, 7);
}

int main(int argc, char **argv)
{
    I1 = I3 = (quad)(1.0 / 3);
    a3 = (quad)0.51;
    E = (quad)2.15;
    G = -(quad)0.56;
    if (argc == 2 && strcmp(argv[1], "passages") == 0) passages();
    else if (argc == 2 && strcmp(argv[1], "approach") == 0) approach();
    else return 2;
    return 0;
}
