// The spherical top at (5.1) of Kilin & Ivanova (2023), written by hand, in the forms that peers integrate.
#ifndef BENCH_PEERS_FORMS_HPP
#define BENCH_PEERS_FORMS_HPP

#include <cmath>

static const double m = 1, R = 1, g = 1, I1 = 1.0 / 3, I3 = 1.0 / 3, a3 = 0.51, E = 2.15, G = -0.56;

// A number with its derivatives in two directions.
struct Dual {
    double v = 0, d[2] = {};
    Dual() = default;
    Dual(double value) : v(value) {}
};
static inline Dual chain(double v, double slope, const Dual &a)
{
    Dual r(v);
    for (int i = 0; i < 2; i++) r.d[i] = slope * a.d[i];
    return r;
}
static inline Dual combine(double v, double p, const Dual &a, double q, const Dual &b)
{
    Dual r(v);
    for (int i = 0; i < 2; i++) r.d[i] = p * a.d[i] + q * b.d[i];
    return r;
}
static inline Dual operator+(const Dual &a, const Dual &b) { return combine(a.v + b.v, 1, a, 1, b); }
static inline Dual operator-(const Dual &a, const Dual &b) { return combine(a.v - b.v, 1, a, -1, b); }
static inline Dual operator-(const Dual &a) { return chain(-a.v, -1, a); }
static inline Dual operator*(const Dual &a, const Dual &b) { return combine(a.v * b.v, b.v, a, a.v, b); }
static inline Dual operator*(double a, const Dual &b) { return chain(a * b.v, a, b); }
static inline Dual operator/(const Dual &a, const Dual &b)
{
    const double r = 1 / b.v;
    return combine(a.v * r, r, a, -a.v * r * r, b);
}
static inline Dual sqrt(const Dual &a) { return chain(std::sqrt(a.v), 0.5 / std::sqrt(a.v), a); }
static inline Dual sin(const Dual &a) { return chain(std::sin(a.v), std::cos(a.v), a); }
static inline Dual cos(const Dual &a) { return chain(std::cos(a.v), -std::sin(a.v), a); }
static inline Dual atan2(const Dual &y, const Dual &x)
{
    const double r2 = x.v * x.v + y.v * y.v;
    return combine(std::atan2(y.v, x.v), x.v / r2, y, -y.v / r2, x);
}
using std::atan2, std::cos, std::sin, std::sqrt;

template <class T> static T sine(const T &gamma3) { return sqrt((1.0 - gamma3) * (1.0 + gamma3)); }

struct Level { // gamma3, v_nu, omega_tau, v_tau, s; dt = s dtau
    static constexpr const char *name = "level";
    static constexpr int dim = 5;
    template <class T> static inline void field(const T *x, T *f)
    {
        const T b = a3 + R * x[0], e = R + a3 * x[0], s = x[4], s2 = s * s, w = x[2], u = x[3];
        const T K = I1 * R * R * s2 + I3 * b * b, Theta = m * K + I1 * I3, D = I1 + m * a3 * a3 * s2;
        const T r = 1.0 / (K * Theta * D), rK = r * Theta * D, rTheta = r * K * D, rD = r * K * Theta;
        const T wn = (R * G * s + I3 * b * u) * rK, w3 = (I1 * R * s * u - G * b) * rK, V = e * w + x[1];
        f[0] = s2 * w;
        f[1] = wn * u;
        f[2] = (m * a3 * s2 * (a3 * x[0] * w * w - g) - wn * (I1 * x[0] * wn + I3 * s * w3)) * rD;
        f[3] = -wn * x[1] + I3 * (I1 * wn * V - s * w3 * w * (R * (I1 - I3) * x[0] - a3 * I3)) * rTheta;
        f[4] = -x[0] * s * w;
    }
    static void start(double *x, const double *p)
    {
        const double s = sine(p[0]);
        x[0] = p[0], x[1] = p[1], x[2] = 0, x[3] = (a3 + R * p[0]) * p[2] + R * s * p[3], x[4] = s;
    }
    static double time(const double *, double) { return NAN; } // of a return, at `tau` of the stepper
    static void spin(const double *x, double &omega_n, double &omega3)
    {
        const double b = a3 + R * x[0], K = I1 * R * R * x[4] * x[4] + I3 * b * b;
        omega_n = (R * x[4] * G + I3 * b * x[3]) / K;
        omega3 = (I1 * R * x[4] * x[3] - b * G) / K;
    }
    // The section in (eta, gamma3) on the level E.
    template <class T> static void lift(T *x, const T *q)
    {
        const T s = sine(q[1]), b = a3 + R * q[1], K = I1 * R * R * s * s + I3 * b * b, Theta = m * K + I1 * I3;
        const T W = sqrt((2.0 * (E - m * g * a3 * q[1]) - G * G / K) / T(m));
        x[0] = q[1], x[1] = W * sin(q[0]), x[2] = 0.0, x[3] = W * sqrt(m * K / Theta) * cos(q[0]), x[4] = s;
    }
    template <class T> static void lower(T *q, const T *x)
    {
        const T b = a3 + R * x[0], K = I1 * R * R * x[4] * x[4] + I3 * b * b, Theta = m * K + I1 * I3;
        q[0] = atan2(x[1], x[3] / sqrt(m * K / Theta)), q[1] = x[0];
    }
};

// gamma3, v_nu, omega_tau, omega_n, omega3: (3.2); `time` is dt/dtau.
static inline void reduced(const double *x, double s, double time, double *f)
{
    const double b = a3 + R * x[0], e = R + a3 * x[0], s2 = s * s, w = x[2], wn = x[3], w3 = x[4];
    const double Theta = I1 * I3 + I1 * m * R * R * s2 + I3 * m * b * b, D = I1 + m * a3 * a3 * s2, V = e * w + x[1];
    const double r = time / (s * Theta * D), over_s = time / s, over_Theta = r * s * D, over_sD = r * Theta;
    f[0] = s * w * time;
    f[1] = wn * (b * wn + R * s * w3) * over_s;
    f[2] = (m * a3 * s2 * (a3 * x[0] * w * w - g) - wn * (I1 * x[0] * wn + I3 * s * w3)) * over_sD;
    f[3] = x[0] * wn * w * over_s - m * I3 * b * wn * V * r * D + I3 * w3 * w * (I3 + m * R * e) * over_Theta;
    f[4] = m * R * (-I1 * wn * V + s * w3 * w * (R * x[0] * (I1 - I3) - a3 * I3)) * over_Theta;
}

struct Five {
    static constexpr const char *name = "five";
    static constexpr int dim = 6;
    static inline void field(const double *x, double *f)
    {
        reduced(x, x[5], x[5], f);
        f[5] = -x[0] * x[5] * x[2];
    }
    static void start(double *x, const double *p)
    {
        x[0] = p[0], x[1] = p[1], x[2] = 0, x[3] = p[2], x[4] = p[3], x[5] = std::sqrt((1 - p[0]) * (1 + p[0]));
    }
    static double time(const double *, double) { return NAN; }
    static void spin(const double *x, double &omega_n, double &omega3) { omega_n = x[3], omega3 = x[4]; }
};

struct Plain {
    static constexpr const char *name = "five_plain";
    static constexpr int dim = 5;
    static inline void field(const double *x, double *f) { reduced(x, std::sqrt((1 - x[0]) * (1 + x[0])), 1, f); }
    static void start(double *x, const double *p) { x[0] = p[0], x[1] = p[1], x[2] = 0, x[3] = p[2], x[4] = p[3]; }
    static double time(const double *, double tau) { return tau; }
    static void spin(const double *x, double &omega_n, double &omega3) { omega_n = x[3], omega3 = x[4]; }
};

// The same with physical time as one more state.
template <class Form> struct Timed : Form {
    static const char *name;
    static constexpr int dim = Form::dim + 1;
    static inline void field(const double *x, double *f)
    {
        Form::field(x, f);
        f[dim - 1] = x[dim - 2];
    }
    static void start(double *x, const double *p)
    {
        Form::start(x, p);
        x[dim - 1] = 0;
    }
    static double time(const double *x, double) { return x[dim - 1]; }
};
template <> const char *Timed<Level>::name = "level_t";
template <> const char *Timed<Five>::name = "five_t";

// Level with its derivatives in two directions: values, then tangents by states.
struct Tangent {
    static constexpr int dim = 3 * Level::dim;
    static inline void unpack(const double *x, Dual *z)
    {
        for (int i = 0; i < Level::dim; i++)
            z[i].v = x[i], z[i].d[0] = x[Level::dim + 2 * i], z[i].d[1] = x[Level::dim + 2 * i + 1];
    }
    static inline void pack(const Dual *z, double *x)
    {
        for (int i = 0; i < Level::dim; i++)
            x[i] = z[i].v, x[Level::dim + 2 * i] = z[i].d[0], x[Level::dim + 2 * i + 1] = z[i].d[1];
    }
    static inline void field(const double *x, double *f)
    {
        Dual z[Level::dim], rate[Level::dim];
        unpack(x, z);
        Level::field(z, rate);
        pack(rate, f);
    }
};

// Energy and Jellett's integral of gamma3, v_nu, omega_tau, omega_n, omega3.
static inline void integrals(const double *x, double *values)
{
    const double s = sine(x[0]), b = a3 + R * x[0], u = b * x[3] + R * s * x[4];
    values[0] = m * x[1] * x[1] / 2 + (I1 + m * a3 * a3 * s * s) * x[2] * x[2] / 2 + I1 * x[3] * x[3] / 2 + I3 * x[4] * x[4] / 2
              + m * u * u / 2 + m * g * a3 * x[0];
    values[1] = I1 * R * s * x[3] - I3 * b * x[4];
}

#endif
