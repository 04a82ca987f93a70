/* Reference section returns in quadruple precision.
 *
 *     cc -O2 -o reference_quad tools/bench/reference_quad.c -lquadmath -lm
 *     ./reference_quad ETA_LOW ETA_HIGH GAMMA_LOW GAMMA_HIGH COUNT RETURNS    RETURNS 0: derivatives of the map
 *     ./reference_quad                                                        an orbit of the balanced sphere
 *
 * Starts: a COUNT x COUNT grid of the section omega_tau = 0; returns: upward crossings, refined by Newton steps of the
 * method of reference_quad.h. Derivatives in (eta, gamma3) by central differences of sixth order with step 1e-5, good to
 * 1e-22. Output: CSV on stdout, 33 digits. */
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

/* One step, of the length that gives 1e-30; y gets its end. Returns its length, and proposes the next in *h. */
static quad step(const quad *x, quad *h, quad *y)
{
    quad error;
    while ((error = extrapolate(x, *h, y)) > 1e-30Q) *h *= 0.7Q;
    quad taken = *h;
    if (error < 1e-32Q) *h *= 1.15Q;
    return taken;
}

/* The upward crossing within a step of length h from x to y; false when there is none. */
static int crossing(const quad *x, const quad *y, quad h, quad *z)
{
    quad f[STATES], part = h * x[2] / (x[2] - y[2]);
    if (!(x[2] < 0 && y[2] >= 0)) return 0;
    for (int newton = 0; newton < 8; newton++) {
        extrapolate(x, part, z);
        field(z, f);
        part -= z[2] / f[2];
    }
    extrapolate(x, part, z);
    return 1;
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

/* (eta, gamma3) and the time of the first return. */
static void image(quad eta, quad gamma, quad *out)
{
    quad x[STATES], y[STATES], z[STATES], h = 0.05Q;
    start(eta, gamma, x);
    while (!crossing(x, y, step(x, &h, y), z))
        for (int i = 0; i < STATES; i++) x[i] = y[i];
    quad b = a3 + R * z[0], s = z[5], Theta = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b, C = Theta - I1 * I3;
    out[0] = atan2q(m * I1 * R * s * z[1], sqrtq(Theta * C) * (z[4] + m * G * b / C));
    out[1] = z[0];
    out[2] = z[6];
}

/* Start, image, time, and the derivative by rows. */
static void slopes_of(int orbit, quad eta, quad gamma)
{
    static const quad weight[] = { 0.75Q, -0.15Q, 1 / 60.0Q };
    const quad h = 1e-5Q;
    quad row[9] = { eta, gamma }, up[3], down[3];
    image(eta, gamma, row + 2);
    for (int column = 0; column < 2; column++)
        for (int k = 1; k <= 3; k++) {
            image(eta + (column == 0 ? k * h : 0), gamma + (column == 1 ? k * h : 0), up);
            image(eta - (column == 0 ? k * h : 0), gamma - (column == 1 ? k * h : 0), down);
            for (int i = 0; i < 2; i++) row[5 + 2 * i + column] += weight[k - 1] * (up[i] - down[i]) / h;
        }
    print(orbit, -1, row, 9);
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
    puts(returns > 0 ? "orbit,return,t,gamma3,v_nu,omega_n,omega3"
                     : "orbit,eta,gamma3,image_eta,image_gamma3,t,eta_eta,eta_gamma3,gamma3_eta,gamma3_gamma3");
    for (int orbit = 0; orbit < count * count; orbit++) {
        quad eta = low + (high - low) * (orbit / count) / (count - 1);
        quad gamma = gamma_low + (gamma_high - gamma_low) * (orbit % count) / (count - 1);
        if (returns > 0) returns_of(orbit, eta, gamma, returns);
        else slopes_of(orbit, eta, gamma);
        fflush(stdout);
    }
    return 0;
}
