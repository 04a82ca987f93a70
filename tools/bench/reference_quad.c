/* Reference section returns in quadruple precision.
 *
 *     cc -O2 -o reference_quad tools/bench/reference_quad.c -lquadmath -lm
 *     ./reference_quad ETA_LOW ETA_HIGH GAMMA_LOW GAMMA_HIGH COUNT RETURNS    RETURNS 0: derivatives of the map
 *     ./reference_quad ETA_LOW ETA_HIGH GAMMA_LOW GAMMA_HIGH COUNT -RETURNS   exponents over so many returns
 *     ./reference_quad                                                        an orbit of the balanced sphere
 *
 * Starts: a COUNT x COUNT grid of the section omega_tau = 0; returns: upward crossings, refined by Newton steps of the
 * method of reference_quad.h. Derivatives in (eta, gamma3) by central differences of sixth order with step 1e-5, good to
 * 1e-22. Exponents: the logarithm of the 2-norm of the derivative of so many returns, per time; step 1e-7, good to 1e-20
 * where growth is below 1000. Output: CSV on stdout, 33 digits. */
#include "reference_quad.h"

static void print(int first, int second, const quad *values, int count)
{
    char text[48];
    printf(second >= 0 ? "%d,%d" : "%d", first, second);
    for (int i = 0; i < count; i++) {
        quadmath_snprintf(text, sizeof text, "%.32Qe", values[i]);
        printf(",%s", text);
    }
    putchar('\n');
}

static void print_state(int orbit, int number, const quad *x)
{
    print(orbit, number, (const quad[]){ x[6], x[0], x[1], x[3], x[4] }, 5);
}

static void returns_of(int orbit, quad eta, quad gamma, int returns)
{
    quad x[STATES], y[STATES], z[STATES], h = 0.05Q;
    start(eta, gamma, x);
    print_state(orbit, 0, x);
    for (int number = 1; number <= returns && x[5] > 1e-14Q;) { /* below, the orbit ends at a pole */
        quad taken = step(x, &h, y);
        if (crossing(x, y, taken, z)) print_state(orbit, number++, z);
        for (int i = 0; i < STATES; i++) x[i] = y[i];
    }
}

/* Start, image, time, and the derivative by rows. */
static void derivative(quad eta, quad gamma, int number, quad h, quad *row)
{
    static const quad weight[] = { 0.75Q, -0.15Q, 1 / 60.0Q };
    quad up[3], down[3];
    row[0] = eta, row[1] = gamma;
    for (int i = 5; i < 9; i++) row[i] = 0;
    image(eta, gamma, number, row + 2);
    for (int column = 0; column < 2; column++)
        for (int k = 1; k <= 3; k++) {
            image(eta + (column == 0 ? k * h : 0), gamma + (column == 1 ? k * h : 0), number, up);
            image(eta - (column == 0 ? k * h : 0), gamma - (column == 1 ? k * h : 0), number, down);
            for (int i = 0; i < 2; i++) row[5 + 2 * i + column] += weight[k - 1] * (up[i] - down[i]) / h;
        }
}

static void slopes_of(int orbit, quad eta, quad gamma)
{
    quad row[9];
    derivative(eta, gamma, 1, 1e-5Q, row);
    print(orbit, -1, row, 9);
}

/* The larger singular value of [a b; c d] from those of its symmetric and its antisymmetric part. */
static void exponent_of(int orbit, quad eta, quad gamma, int returns)
{
    quad row[9];
    derivative(eta, gamma, returns, 1e-7Q, row);
    quad a = row[5], b = row[6], c = row[7], d = row[8];
    quad norm = (hypotq(a + d, c - b) + hypotq(a - d, c + b)) / 2;
    print(orbit, -1, (const quad[]){ eta, gamma, logq(norm) / row[4], row[4] }, 4);
}

/* The balanced sphere m = R = g = 1, I1 = 2/5, I3 = 1/4 at t = 0, 1, 5, 20. */
static void balanced_flow(void)
{
    static const int times[] = { 0, 1, 5, 20 };
    quad x[STATES] = { 0.3Q, 0.5Q, 0.2Q, 0.3Q, 0.9Q }, y[STATES], z[STATES], h = 0.05Q, taken = 0;
    I1 = 0.4Q, I3 = 0.25Q, a3 = 0;
    x[5] = sqrtq((1 - x[0]) * (1 + x[0]));
    for (int i = 0; i < STATES; i++) y[i] = x[i];
    puts("t,gamma3,v_nu,omega_tau,omega_n,omega3");
    for (int k = 0; k < 4; k++) {
        while (y[6] < times[k]) {
            for (int i = 0; i < STATES; i++) x[i] = y[i];
            taken = step(x, &h, y);
        }
        quad part = taken * (times[k] - x[6]) / fmaxq(y[6] - x[6], 1e-300Q);
        extrapolate(x, part, z);
        for (int newton = 0; newton < 8; newton++) {
            part += (times[k] - z[6]) / z[5];
            extrapolate(x, part, z);
        }
        print(times[k], -1, z, 5);
    }
}

int main(int argc, char **argv)
{
    if (argc == 1) {
        balanced_flow();
        return 0;
    }
    if (argc != 7) return 2;
    I1 = I3 = (quad)1 / 3;
    a3 = (quad)51 / 100;
    E = (quad)215 / 100;
    G = -(quad)56 / 100;
    quad low = strtoflt128(argv[1], NULL), high = strtoflt128(argv[2], NULL);
    quad gamma_low = strtoflt128(argv[3], NULL), gamma_high = strtoflt128(argv[4], NULL);
    int count = atoi(argv[5]), returns = atoi(argv[6]);
    puts(returns > 0   ? "orbit,return,t,gamma3,v_nu,omega_n,omega3"
         : returns < 0 ? "orbit,eta,gamma3,exponent,t"
                       : "orbit,eta,gamma3,image_eta,image_gamma3,t,eta_eta,eta_gamma3,gamma3_eta,gamma3_gamma3");
    for (int orbit = 0; orbit < count * count; orbit++) {
        quad eta = low + (high - low) * (orbit / count) / (count - 1);
        quad gamma = gamma_low + (gamma_high - gamma_low) * (orbit % count) / (count - 1);
        if (returns > 0) returns_of(orbit, eta, gamma, returns);
        else if (returns < 0) exponent_of(orbit, eta, gamma, -returns);
        else slopes_of(orbit, eta, gamma);
        fflush(stdout);
    }
    return 0;
}
