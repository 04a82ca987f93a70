/* Where the separatrices of the saddle of the section map at (5.1) cross on a symmetric orbit, in quadruple precision.
 *
 *     cc -O2 -o reference_separatrix tools/bench/reference_separatrix.c -lquadmath -lm
 *
 * The unstable manifold is followed from x + d v: x the saddle, v its eigenvector, d = 9e-10, of which the manifold bends away
 * by d^2; errors of steps grow as d does, to 1e-21. The orbit is symmetric where P(q) is the mirror image of q, at which eta has
 * the other sign; the distance d is found by the secant method. The stable manifold has at q the mirrored tangent of P(q).
 * Tangents are differences of sixth order in log d. Output: eta, gamma3, and the angle between both manifolds in these
 * coordinates; with an argument K, by returns 2K fewer and a larger d, to see how far both agree.
 */
#include "reference_quad.h"

static quad saddle, direction[2];

/* The saddle lies on eta = 0, as does its image. */
static void find_saddle(quad h)
{
    quad up[3], down[3], slope[2][2], trace, determinant;
    saddle = -0.61358438970663813576600081039Q;
    for (int newton = 0; newton < 3; newton++) {
        quad here[3];
        for (int j = 0; j < 2; j++) {
            slope[0][j] = slope[1][j] = 0;
            for (int k = 1; k <= 3; k++) {
                static const quad weight[] = { 0.75Q, -0.15Q, 1 / 60.0Q };
                image(j == 0 ? k * h : 0, saddle + (j == 1 ? k * h : 0), 1, up);
                image(j == 0 ? -k * h : 0, saddle - (j == 1 ? k * h : 0), 1, down);
                for (int i = 0; i < 2; i++) slope[i][j] += weight[k - 1] * (up[i] - down[i]) / h;
            }
        }
        image(0, saddle, 1, here);
        saddle -= (here[1] - saddle) / (slope[1][1] - 1);
    }
    trace = slope[0][0] + slope[1][1];
    determinant = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
    quad multiplier = (trace - sqrtq(trace * trace - 4 * determinant)) / 2, x = slope[0][1], y = multiplier - slope[0][0];
    direction[0] = x / hypotq(x, y), direction[1] = y / hypotq(x, y);
}

/* q and P(q), by the logarithm of d. */
static void points(quad log_distance, int turns, quad *q, quad *p)
{
    quad d = expq(log_distance), x[STATES], y[STATES], z[STATES], h = 0.05Q;
    start(d * direction[0], saddle + d * direction[1], x);
    for (int made = 0; made <= turns;) {
        if (crossing(x, y, step(x, &h, y), z) && ++made == turns) lower(z, q);
        for (int i = 0; i < STATES; i++) x[i] = y[i];
    }
    lower(z, p);
}

int main(int argc, char **argv)
{
    static const quad weight[] = { 0.75Q, -0.15Q, 1 / 60.0Q };
    const quad rate = logq(1.24275395055601804989106Q), h = 1e-5Q;
    I1 = I3 = (quad)1 / 3, a3 = (quad)51 / 100, E = (quad)215 / 100, G = -(quad)56 / 100;
    int turns = 98 - (argc > 1 ? 2 * atoi(argv[1]) : 0);
    quad at = logq(1.168e-8Q) - (turns - 86) * rate, before = at - 0.01Q;
    quad q[3], p[3], up[2][3], down[2][3], tangent[2][2] = { { 0 } };
    find_saddle(1e-5Q);
    points(before, turns, q, p);
    for (quad last = q[0] + p[0], now; fabsq(last) > 1e-18Q; last = now) {
        points(at, turns, q, p);
        now = q[0] + p[0];
        quad next = now == last ? at : at - now * (at - before) / (now - last);
        before = at, at = next;
    }
    points(at, turns, q, p);
    for (int k = 1; k <= 3; k++) {
        points(at + k * h, turns, up[0], up[1]);
        points(at - k * h, turns, down[0], down[1]);
        for (int i = 0; i < 2; i++)
            for (int j = 0; j < 2; j++) tangent[i][j] += weight[k - 1] * (up[i][j] - down[i][j]) / h;
    }
    const quad *v = tangent[0], *w = tangent[1];
    char text[3][48];
    const quad out[3] = { q[0], q[1], atanq(fabsq((v[0] * w[1] + v[1] * w[0]) / (v[1] * w[1] - v[0] * w[0]))) };
    for (int i = 0; i < 3; i++) quadmath_snprintf(text[i], sizeof text[i], "%.32Qe", out[i]);
    printf("eta,gamma3,angle\n%s,%s,%s\n", text[0], text[1], text[2]);
    return 0;
}
