// The peers as steppers: start() takes x as the start; step() makes one accepted step from before[] to x[] of length h (false:
// it cannot); to(theta, y) gives the state at a fraction of the last step.
#ifndef BENCH_PEERS_STEPPERS_HPP
#define BENCH_PEERS_STEPPERS_HPP

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <boost/numeric/odeint.hpp>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace odeint = boost::numeric::odeint;

static constexpr int room = 16; // states of the largest form

template <class Form> struct Gsl {
    static constexpr const char *name = "gsl,rk8pd";
    static int call(double, const double x[], double f[], void *)
    {
        Form::field(x, f);
        return GSL_SUCCESS;
    }
    gsl_odeiv2_system system{ call, nullptr, Form::dim, nullptr };
    gsl_odeiv2_step *stepper = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, Form::dim);
    gsl_odeiv2_control *control;
    gsl_odeiv2_evolve *evolve = gsl_odeiv2_evolve_alloc(Form::dim);
    double x[room], before[room], t = 0, h = 0, next = 0.05;
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
        double error[room];
        std::copy(before, before + Form::dim, y);
        gsl_odeiv2_step_reset(stepper);
        gsl_odeiv2_step_apply(stepper, 0, theta * h, y, error, nullptr, nullptr, &system);
    }
};

template <class Form> using State = std::array<double, Form::dim>;

template <class Form> static void call(const State<Form> &x, State<Form> &f, double) { Form::field(x.data(), f.data()); }

template <class Form> struct Boost {
    State<Form> now, last;
    double *x = now.data(), *before = last.data();
    double t = 0, h = 0, next = 0.05, tolerance;
    explicit Boost(double asked) : tolerance(asked) {}
    void start() { t = 0, next = 0.05; }
    template <class S> static bool attempt(S &s, State<Form> &x, double &t, double &h)
    {
        for (int i = 0; i < 100; i++)
            if (s.try_step(call<Form>, x, t, h) == odeint::success) return true;
        return false;
    }
    template <class S> bool advance(S &s)
    {
        const double t0 = t;
        last = now;
        if (!attempt(s, now, t, next)) return false;
        h = t - t0;
        return std::isfinite(now[2]) && h > 1e-13;
    }
};

struct Fehlberg78 {
    static constexpr const char *name = "odeint,rkf78";
    template <class State> using Of = odeint::runge_kutta_fehlberg78<State>;
};

struct DormandPrince5 {
    static constexpr const char *name = "odeint,dopri5";
    template <class State> using Of = odeint::runge_kutta_dopri5<State>;
};

template <class Form, class Method> struct Controlled : Boost<Form> {
    static constexpr const char *name = Method::name;
    using Single = typename Method::template Of<State<Form>>;
    using Stepper = decltype(odeint::make_controlled(1.0, 1.0, Single()));
    Stepper stepper;
    explicit Controlled(double tolerance) : Boost<Form>(tolerance), stepper(odeint::make_controlled(tolerance, tolerance, Single()))
    {
    }
    void start()
    {
        Boost<Form>::start();
        stepper = odeint::make_controlled(this->tolerance, this->tolerance, Single()); // forgets the slope of the last orbit
    }
    bool step() { return this->advance(stepper); }
    void to(double theta, double *y)
    {
        State<Form> z;
        Single single; // a new one: Dormand and Prince's would begin with the slope of its last step
        single.do_step(call<Form>, this->last, 0.0, z, theta * this->h);
        std::copy(z.begin(), z.end(), y);
    }
};

template <class Form> struct BulirschStoer : Boost<Form> {
    static constexpr const char *name = "odeint,bulirsch_stoer";
    odeint::bulirsch_stoer<State<Form>> stepper;
    explicit BulirschStoer(double tolerance) : Boost<Form>(tolerance), stepper(tolerance, tolerance) {}
    void start()
    {
        Boost<Form>::start();
        stepper.reset();
    }
    bool step() { return this->advance(stepper); }
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
    static constexpr const char *name = "sundials,cvode adams";
    static int call(realtype, N_Vector x, N_Vector f, void *)
    {
        Form::field(N_VGetArrayPointer(x), N_VGetArrayPointer(f));
        return 0;
    }
    SUNContext context = nullptr;
    N_Vector now, dense;
    void *memory = nullptr;
    SUNNonlinearSolver solver = nullptr;
    double *x, before[room], t = 0, h = 0, tolerance;
    explicit Cvode(double asked) : tolerance(asked)
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

#endif
