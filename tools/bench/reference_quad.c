/* Reference section returns in quadruple precision.
 *
 *     cc -O2 -o reference_quad tools/bench/reference_quad.c -lquadmath -lm
 *     ./reference_quad ETA_LOW ETA_HIGH GAMMA_LOW GAMMA_HIGH COUNT RETURNS
 *
 * Starts: a COUNT x COUNT grid of the section omega_tau = 0; returns: upward crossings, refined by Newton steps of the
 * method of reference_quad.h. Output: CSV on stdout, 33 digits. */
#include "reference_quad.h"

static void print(int orbit, int number, const quad *x)
{
    char text[48];
    printf("%d,%d", orbit, number);
    static const int order[] = { 6, 0, 1, 3, 4 };
    for (int i = 0; i < 5; i++) {
        quadmath_snprintf(text, sizeof text, "%.32Qe", x[order[i]]);
        printf(",%s", text);
    }
    putchar('\n');
}

int main(int argc, char **argv)
{
    if (argc != 7) return 2;
    I1 = I3 = (quad)1 / 3;
    a3 = (quad)51 / 100;
    E = (quad)215 / 100;
    G = -(quad)56 / 100;
    quad low = strtoflt128(argv[1], NULL), high = strtoflt128(argv[2], NULL);
    quad gamma_low = strtoflt128(argv[3], NULL), gamma_high = strtoflt128(argv[4], NULL);
    int count = atoi(argv[5]), returns = atoi(argv[6]);
    puts("orbit,return,t,gamma3,v_nu,omega_n,omega3");
    for (int orbit = 0; orbit < count * count; orbit++) {
        quad x[STATES], y[STATES], f[STATES], h = 0.05Q;
        start(low + (high - low) * (orbit / count) / (count - 1),
              gamma_low + (gamma_high - gamma_low) * (orbit % count) / (count - 1), x);
        print(orbit, 0, x);
        for (int number = 1; number <= returns;) {
            quad error = extrapolate(x, h, y);
            if (error > 1e-30Q) {
                h *= 0.7Q;
                continue;
            }
            if (x[2] < 0 && y[2] >= 0) {
                quad part = h * x[2] / (x[2] - y[2]);
                quad z[STATES];
                for (int newton = 0; newton < 8; newton++) {
                    extrapolate(x, part, z);
                    field(z, f);
                    part -= z[2] / f[2];
                }
                extrapolate(x, part, z);
                print(orbit, number++, z);
            }
            for (int i = 0; i < STATES; i++) x[i] = y[i];
            if (error < 1e-32Q) h *= 1.15Q;
            if (x[5] < 1e-14Q) break; /* this orbit ends at a pole */
        }
        fflush(stdout);
    }
    return 0;
}
