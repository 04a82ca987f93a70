// The section map of `jellett bench` by GSL, Boost.odeint and SUNDIALS on a right-hand side written by hand in C.
//
//     section_peers REFERENCE.csv RETURNS REPEATS
//
// Forms: "level" (4 states and s, the form that jellett uses), "regular" (5 states and s) and "plain" (the equations as
// published). Every peer steps with its own error control; a change of sign of omega_tau is refined by Newton's method with
// single steps of the same method from the start of the step (SUNDIALS: on its own dense output). Output: the rows of
// `jellett bench`, without a header.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <boost/numeric/odeint.hpp>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace odeint = boost::numeric::odeint;

static const double m = 1, R = 1, g = 1, I1 = 1.0 / 3, I3 = 1.0 / 3, a3 = 0.51, G = -0.56;

struct Level { // gamma3, v_nu, omega_tau, v_tau, s; dt = s dtau
    static constexpr const char *name = "level";
    static constexpr int dim = 5;
    static inline void field(const double *x, double *f)
    {
        const double b = a3 + R * x[0], e = R + a3 * x[0], s = x[4], s2 = s * s, w = x[2], u = x[3];
        const double K = I1 * R * R * s2 + I3 * b * b, Theta = m * K + I1 * I3, D = I1 + m * a3 * a3 * s2;
        const double r = 1 / (K * Theta * D), rK = r * Theta * D, rTheta = r * K * D, rD = r * K * Theta;
        const double wn = (R * s * G + I3 * b * u) * rK, w3 = (I1 * R * s * u - b * G) * rK, V = e * w + x[1];
        f[0] = s2 * w;
        f[1] = wn * u;
        f[2] = (m * a3 * s2 * (a3 * x[0] * w * w - g) - wn * (I1 * x[0] * wn + I3 * s * w3)) * rD;
        f[3] = -wn * x[1] + I3 * (I1 * wn * V - s * w3 * w * (R * x[0] * (I1 - I3) - a3 * I3)) * rTheta;
        f[4] = -x[0] * s * w;
    }
    static void start(double *x, const double *p)
    {
        const double s = std::sqrt((1 - p[0]) * (1 + p[0]));
        x[0] = p[0], x[1] = p[1], x[2] = 0, x[3] = (a3 + R * p[0]) * p[2] + R * s * p[3], x[4] = s;
    }
    static double omega3(const double *x)
    {
        const double b = a3 + R * x[0];
        return (I1 * R * x[4] * x[3] - b * G) / (I1 * R * R * x[4] * x[4] + I3 * b * b);
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

struct Regular {
    static constexpr const char *name = "regular";
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
    static double omega3(const double *x) { return x[4]; }
};

struct Plain {
    static constexpr const char *name = "plain";
    static constexpr int dim = 5;
    static inline void field(const double *x, double *f) { reduced(x, std::sqrt((1 - x[0]) * (1 + x[0])), 1, f); }
    static void start(double *x, const double *p) { x[0] = p[0], x[1] = p[1], x[2] = 0, x[3] = p[2], x[4] = p[3]; }
    static double omega3(const double *x) { return x[4]; }
};

struct Grid {
    std::vector<std::array<double, 4>> start, expected;
    size_t checked = 0;
};

struct Outcome {
    double error = 0;
    size_t returns = 0, steps = 0, failed = 0;
};

static const size_t budget = 200000; // steps of one return

// Each stepper: start(x); step() makes one accepted step from before[] to x[] of length h (false: it cannot); to(theta, y) the
// state at a fraction of the last step.
template <class Form> struct Gsl {
    static constexpr const char *name = "gsl rk8pd";
    static int call(double, const double x[], double f[], void *)
    {
        Form::field(x, f);
        return GSL_SUCCESS;
    }
    gsl_odeiv2_system system{ call, nullptr, Form::dim, nullptr };
    gsl_odeiv2_step *stepper = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, Form::dim);
    gsl_odeiv2_control *control;
    gsl_odeiv2_evolve *evolve = gsl_odeiv2_evolve_alloc(Form::dim);
    double x[8], before[8], t = 0, h = 0, next = 0.05;
    explicit Gsl(double tolerance) : control(gsl_odeiv2_control_y_new(tolerance, tolerance)) {}
    ~Gsl()
    {
        gsl_odeiv2_evolve_free(evolve);
        gsl_odeiv2_control_free(control);
        gsl_odeiv2_step_free(stepper);
    }
    void start()
    {
        t = 0, next = 0.05;
        gsl_odeiv2_step_reset(stepper);
        gsl_odeiv2_evolve_reset(evolve);
    }
    bool step()
    {
        const double t0 = t;
        std::copy(x, x + Form::dim, before);
        if (gsl_odeiv2_evolve_apply(evolve, control, stepper, &system, &t, 1e9, &next, x) != GSL_SUCCESS) return false;
        h = t - t0;
        return std::isfinite(x[2]) && h > 1e-13;
    }
    void to(double theta, double *y)
    {
        double error[8];
        std::copy(before, before + Form::dim, y);
        gsl_odeiv2_step_reset(stepper);
        gsl_odeiv2_step_apply(stepper, 0, theta * h, y, error, nullptr, nullptr, &system);
    }
};

template <class Form> using State = std::array<double, Form::dim>;

template <class Form> static void call(const State<Form> &x, State<Form> &f, double) { Form::field(x.data(), f.data()); }

template <class Form, class Stepper> struct Boost {
    State<Form> now, last;
    double *x = now.data(), *before = last.data();
    double t = 0, h = 0, next = 0.05, tolerance;
    Stepper controlled;
    explicit Boost(double tolerance) : tolerance(tolerance), controlled(Stepper()) {}
    void start() { t = 0, next = 0.05; }
    template <class S> static bool attempt(S &s, State<Form> &x, double &t, double &h)
    {
        for (int i = 0; i < 100; i++)
            if (s.try_step(call<Form>, x, t, h) == odeint::success) return true;
        return false;
    }
};

template <class Form, class Error> struct Controlled : Boost<Form, int> {
    static const char *name;
    decltype(odeint::make_controlled(1.0, 1.0, Error())) stepper;
    Error single;
    explicit Controlled(double tolerance)
        : Boost<Form, int>(tolerance), stepper(odeint::make_controlled(tolerance, tolerance, Error()))
    {
    }
    bool step()
    {
        const double t0 = this->t;
        this->last = this->now;
        if (!this->attempt(stepper, this->now, this->t, this->next)) return false;
        this->h = this->t - t0;
        return std::isfinite(this->now[2]) && this->h > 1e-13;
    }
    void to(double theta, double *y)
    {
        State<Form> z = this->last, error;
        single.do_step(call<Form>, z, 0.0, theta * this->h, error);
        std::copy(z.begin(), z.end(), y);
    }
};

template <class Form> struct BulirschStoer : Boost<Form, int> {
    static constexpr const char *name = "odeint bulirsch_stoer";
    odeint::bulirsch_stoer<State<Form>> stepper;
    explicit BulirschStoer(double tolerance) : Boost<Form, int>(tolerance), stepper(tolerance, tolerance) {}
    void start()
    {
        this->t = 0, this->next = 0.05;
        stepper.reset();
    }
    bool step()
    {
        const double t0 = this->t;
        this->last = this->now;
        if (!this->attempt(stepper, this->now, this->t, this->next)) return false;
        this->h = this->t - t0;
        return std::isfinite(this->now[2]) && this->h > 1e-13;
    }
    void to(double theta, double *y)
    {
        odeint::bulirsch_stoer<State<Form>> other(this->tolerance, this->tolerance);
        State<Form> z = this->last;
        double t = 0, end = theta * this->h, step = end;
        while (t < end && this->attempt(other, z, t, step)) step = std::min(step, end - t);
        std::copy(z.begin(), z.end(), y);
    }
};

template <class Form> struct Cvode {
    static constexpr const char *name = "cvode adams";
    static int call(realtype, N_Vector x, N_Vector f, void *)
    {
        Form::field(N_VGetArrayPointer(x), N_VGetArrayPointer(f));
        return 0;
    }
    SUNContext context = nullptr;
    N_Vector now, dense;
    void *memory = nullptr;
    SUNNonlinearSolver solver = nullptr;
    double *x, before[8], t = 0, h = 0, tolerance;
    explicit Cvode(double tolerance) : tolerance(tolerance)
    {
        SUNContext_Create(nullptr, &context);
        now = N_VNew_Serial(Form::dim, context);
        dense = N_VNew_Serial(Form::dim, context);
        x = N_VGetArrayPointer(now);
    }
    void clear()
    {
        if (memory != nullptr) CVodeFree(&memory);
        if (solver != nullptr) SUNNonlinSolFree(solver);
    }
    ~Cvode()
    {
        clear();
        N_VDestroy(now);
        N_VDestroy(dense);
        SUNContext_Free(&context);
    }
    void start()
    {
        clear();
        t = 0;
        memory = CVodeCreate(CV_ADAMS, context);
        CVodeInit(memory, call, 0, now);
        CVodeSStolerances(memory, tolerance, tolerance);
        CVodeSetMaxNumSteps(memory, 100000000);
        solver = SUNNonlinSol_FixedPoint(now, 0, context);
        CVodeSetNonlinearSolver(memory, solver);
    }
    bool step()
    {
        const double t0 = t;
        std::copy(x, x + Form::dim, before);
        if (CVode(memory, 1e9, now, &t, CV_ONE_STEP) < 0) return false;
        h = t - t0;
        return std::isfinite(x[2]) && h > 1e-13;
    }
    void to(double theta, double *y)
    {
        CVodeGetDky(memory, t - (1 - theta) * h, 0, dense);
        std::copy(N_VGetArrayPointer(dense), N_VGetArrayPointer(dense) + Form::dim, y);
    }
};

template <class Form, class Peer> static void orbit(Peer &peer, const Grid &grid, size_t index, size_t returns, Outcome &out)
{
    Form::start(peer.x, grid.start[index].data());
    peer.start();
    for (size_t number = 1; number <= returns; number++) {
        size_t steps = 0;
        do {
            if (++steps > budget || !peer.step()) {
                out.failed++;
                if (number <= grid.checked) out.error = NAN;
                return;
            }
        } while (!(peer.before[2] < 0 && peer.x[2] >= 0));
        out.steps += steps;
        out.returns++;
        double y[8], f[8], theta = peer.before[2] / (peer.before[2] - peer.x[2]);
        for (int newton = 0; newton < 4; newton++) {
            peer.to(theta, y);
            Form::field(y, f);
            const double change = -y[2] / (f[2] * peer.h);
            theta += change;
            if (std::fabs(change) < 1e-9) break;
        }
        const double rest = y[2] / f[2];
        for (int i = 0; i < Form::dim; i++) y[i] -= rest * f[i];
        if (number > grid.checked) continue;
        const auto &expected = grid.expected[index * grid.checked + number - 1];
        for (double off : { y[0] - expected[0], y[1] - expected[1], Form::omega3(y) - expected[3] })
            if (!(std::fabs(off) <= out.error)) out.error = std::fabs(off);
    }
}

template <class Form, class Peer> static void curve(const Grid &grid, size_t returns, int repeats)
{
    for (int decade = -5; decade >= -14; decade--) {
        const double tolerance = std::pow(10, decade);
        std::vector<double> seconds;
        Outcome out;
        for (int k = 0; k <= repeats; k++) {
            out = Outcome();
            Peer peer(tolerance);
            const auto begin = std::chrono::steady_clock::now();
            for (size_t i = 0; i < grid.start.size(); i++) orbit<Form>(peer, grid, i, returns, out);
            if (k > 0) seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        }
        std::sort(seconds.begin(), seconds.end());
        const double n = (double)out.returns;
        std::printf("peer,%s,%s,1,%g,", Peer::name, Form::name, tolerance);
        if (std::isfinite(out.error)) std::printf("%.3e", out.error);
        std::printf(",%.0f,%.0f,%.0f,%.2f,%zu\n", n / seconds[seconds.size() / 2], n / seconds.back(), n / seconds.front(),
                    (double)out.steps / std::max(1.0, n), out.failed);
        std::fflush(stdout);
    }
}

template <class Form> using Rkf78 = Controlled<Form, odeint::runge_kutta_fehlberg78<State<Form>>>;
template <class Form> using Ck54 = Controlled<Form, odeint::runge_kutta_cash_karp54<State<Form>>>;
template <class Form, class Error> const char *Controlled<Form, Error>::name = "odeint cash_karp54";
template <> const char *Rkf78<Level>::name = "odeint fehlberg78";
template <> const char *Rkf78<Regular>::name = "odeint fehlberg78";
template <> const char *Rkf78<Plain>::name = "odeint fehlberg78";

template <class Form> static void all(const Grid &grid, size_t returns, int repeats)
{
    curve<Form, Gsl<Form>>(grid, returns, repeats);
    curve<Form, Rkf78<Form>>(grid, returns, repeats);
    curve<Form, Ck54<Form>>(grid, returns, repeats);
    curve<Form, BulirschStoer<Form>>(grid, returns, repeats);
    curve<Form, Cvode<Form>>(grid, returns, repeats);
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        std::fprintf(stderr, "usage: section_peers REFERENCE.csv RETURNS REPEATS\n");
        return 2;
    }
    gsl_set_error_handler_off();
    Grid grid;
    std::FILE *file = std::fopen(argv[1], "r");
    char line[1024];
    if (file == nullptr) {
        std::fprintf(stderr, "section_peers: cannot read %s\n", argv[1]);
        return 5;
    }
    while (std::fgets(line, sizeof line, file) != nullptr) {
        size_t orbit, number;
        double t;
        std::array<double, 4> p;
        if (std::sscanf(line, "%zu,%zu,%lf,%lf,%lf,%lf,%lf", &orbit, &number, &t, &p[0], &p[1], &p[2], &p[3]) != 7) continue;
        (number == 0 ? grid.start : grid.expected).push_back(p);
        grid.checked = std::max(grid.checked, number);
    }
    std::fclose(file);
    const size_t returns = std::strtoul(argv[2], nullptr, 10);
    const int repeats = std::atoi(argv[3]);
    all<Level>(grid, returns, repeats);
    all<Regular>(grid, returns, repeats);
    all<Plain>(grid, returns, repeats);
    return 0;
}
