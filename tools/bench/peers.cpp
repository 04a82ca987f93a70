// The questions of `jellett bench` put to GSL, Boost.odeint and SUNDIALS, on a right-hand side written by hand.
//
//     peers section REFERENCE.csv RETURNS REPEATS FORM PEER [quick]
//     peers slope REFERENCE.csv REPEATS PEER [quick]
//
// FORM: level (4 states on a level of G and s, which jellett uses), five (5 states and s), five_plain (the equations as
// published); level_t and five_t carry physical time as well. PEER: gsl, odeint, cvode. Every peer steps with its own error
// control; a change of sign of omega_tau is refined by Newton's method with single steps of the same method from the start of
// the step (SUNDIALS: on its own dense output). Derivatives DP: by variational equations from dual numbers, and by central
// differences. Output: the rows of `jellett bench`, without a header.
#include "peers_forms.hpp"
#include "peers_steppers.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

static const size_t budget = 200000; // steps of one return

using Rows = std::vector<std::vector<double>>;

static Rows read(const char *path, size_t columns)
{
    Rows rows;
    char line[1024];
    std::FILE *file = std::fopen(path, "r");
    if (file == nullptr) {
        std::fprintf(stderr, "peers: cannot read %s\n", path);
        std::exit(5);
    }
    while (std::fgets(line, sizeof line, file) != nullptr) {
        std::vector<double> row;
        char *at = line, *end;
        for (double value = std::strtod(at, &end); end != at; value = std::strtod(at, &end)) {
            row.push_back(value);
            at = *end == ',' ? end + 1 : end;
        }
        if (row.size() == columns) rows.push_back(row);
    }
    std::fclose(file);
    return rows;
}

struct Question {
    Rows rows;           // of the reference
    size_t checked = 0;  // returns known of each orbit
    size_t returns = 0;
    int repeats = 1, stride = 1; // in decades of tolerance
};

static double now() // of this process alone
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// One pass that is not counted, then the repeats, unless it took longer than half a second: median, least, largest.
static std::array<double, 3> clock_of(int repeats, const std::function<void(bool)> &pass)
{
    std::vector<double> seconds;
    for (int k = 0; k <= repeats; k++) {
        const double begin = now();
        pass(k == 0);
        const double taken = now() - begin;
        if (k > 0 || taken > 0.5) seconds.push_back(taken);
        if (k == 0 && taken > 0.5) break;
    }
    std::sort(seconds.begin(), seconds.end());
    return { seconds[seconds.size() / 2], seconds.front(), seconds.back() };
}

static void note(double &worst, double value)
{
    if (!(std::fabs(value) <= worst)) worst = std::fabs(value);
}

static void print(const char *format, double value)
{
    std::putchar(',');
    if (std::isfinite(value)) std::printf(format, value);
}

// Steps to the next upward crossing and refines it. y: on the section; tau: the stepper's time there. False: there is none.
template <class Form, class Peer> static bool next_return(Peer &peer, double *y, double &tau, size_t &steps)
{
    double f[room], theta;
    size_t taken = 0;
    do {
        if (++taken > budget || !peer.step()) return false;
    } while (!(peer.before[2] < 0 && peer.x[2] >= 0));
    steps += taken;
    theta = peer.before[2] / (peer.before[2] - peer.x[2]);
    for (int newton = 0; newton < 4; newton++) {
        peer.to(theta, y);
        Form::field(y, f);
        const double change = -y[2] / (f[2] * peer.h);
        theta += change;
        if (std::fabs(change) < 1e-9) break;
    }
    const double rest = y[2] / f[2];
    for (int i = 0; i < Form::dim; i++) y[i] -= rest * f[i];
    tau = peer.t - (1 - theta) * peer.h;
    return true;
}

// ---- the section map

struct Outcome {
    double error = 0, time_error = 0, drift[2] = {};
    size_t returns = 0, steps = 0, failed = 0;
};

template <class Form> static void check(Outcome &out, const double *expected, const double *start, const double *y, double tau)
{
    double x[5] = { y[0], y[1], y[2] }, now[2], then[2];
    const double first[5] = { start[3], start[4], 0, start[5], start[6] };
    Form::spin(y, x[3], x[4]);
    integrals(x, now);
    integrals(first, then);
    for (int i = 0; i < 2; i++) note(out.drift[i], now[i] - then[i]);
    if (expected == nullptr) return;
    note(out.time_error, Form::time(y, tau) - expected[2]);
    note(out.error, x[0] - expected[3]);
    note(out.error, x[1] - expected[4]);
    note(out.error, x[4] - expected[6]);
}

template <class Form, class Peer> static void orbit(Peer &peer, const Question &q, size_t index, bool first, Outcome &out)
{
    const std::vector<double> *row = &q.rows[index * (q.checked + 1)];
    Form::start(peer.x, row->data() + 3);
    peer.start();
    for (size_t number = 1; number <= q.returns; number++) {
        double y[room], tau;
        if (!next_return<Form>(peer, y, tau, out.steps)) {
            out.failed++;
            if (number <= q.checked) out.error = out.time_error = NAN;
            return;
        }
        out.returns++;
        if (first) check<Form>(out, number <= q.checked ? row[number].data() : nullptr, row->data(), y, tau);
    }
}

template <class Form, class Peer> static void section_curve(const Question &q)
{
    for (int decade = q.stride > 1 ? 5 : 4; decade <= 15; decade += q.stride) {
        const double tolerance = std::strtod(("1e-" + std::to_string(decade)).c_str(), nullptr);
        Outcome out;
        const auto seconds = clock_of(q.repeats, [&](bool first) {
            Outcome pass;
            Peer peer(tolerance);
            for (size_t i = 0; i < q.rows.size() / (q.checked + 1); i++) orbit<Form>(peer, q, i, first, pass);
            if (first) out = pass;
        });
        const double n = std::max(1.0, (double)out.returns);
        std::printf("%s,%s,1,%g", Peer::name, Form::name, tolerance);
        for (double value : { out.error, out.time_error, out.drift[0], out.drift[1] }) print("%.3e", value);
        for (double value : seconds) std::printf(",%.4g", 1e6 * value / n);
        std::printf(",%.2f,%zu\n", (double)out.steps / n, out.failed);
        std::fflush(stdout);
    }
}

// ---- its derivative

// DP by columns of y's tangents along the flow, less what the return time adds.
template <class Peer> static bool variational(Peer &peer, const double *q, double, double *slope)
{
    Dual z[Level::dim], f[Level::dim], image[2], at[2] = { q[0], q[1] };
    double y[room], tau;
    size_t steps = 0;
    at[0].d[0] = at[1].d[1] = 1;
    Level::lift(z, at);
    Tangent::pack(z, peer.x);
    peer.start();
    if (!next_return<Tangent>(peer, y, tau, steps)) return false;
    Tangent::unpack(y, z);
    Level::field(z, f);
    const double along[2] = { z[2].d[0] / f[2].v, z[2].d[1] / f[2].v };
    for (int i = 0; i < Level::dim; i++)
        for (int j = 0; j < 2; j++) z[i].d[j] -= f[i].v * along[j];
    Level::lower(image, z);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) slope[2 * i + j] = image[i].d[j];
    return true;
}

template <class Peer> static bool central(Peer &peer, const double *q, double h, double *slope)
{
    for (int j = 0; j < 2; j++) {
        double image[2][2], at[2] = { q[0], q[1] }, moved[2];
        for (int side = 0; side < 2; side++) {
            double y[room], tau;
            size_t steps = 0;
            at[j] = moved[side] = q[j] + (side == 0 ? h : -h);
            Level::lift(peer.x, at);
            peer.start();
            if (!next_return<Level>(peer, y, tau, steps)) return false;
            Level::lower(image[side], y);
        }
        for (int i = 0; i < 2; i++) slope[2 * i + j] = (image[0][i] - image[1][i]) / (moved[0] - moved[1]);
    }
    return true;
}

template <class Peer>
static void slope_curve(const Question &q, const char *way, bool (*of)(Peer &, const double *, double, double *))
{
    for (int decade = q.stride > 1 ? 5 : 4; decade <= 15; decade += q.stride) {
        const double tolerance = std::strtod(("1e-" + std::to_string(decade)).c_str(), nullptr), h = 0.3 * std::cbrt(tolerance);
        double error = 0;
        size_t failed = 0;
        Peer peer(tolerance);
        const auto seconds = clock_of(q.repeats, [&](bool first) {
            for (const auto &row : q.rows) {
                double slope[4], size = 0, off = 0;
                const bool made = of(peer, row.data() + 1, h, slope);
                if (!first) continue;
                failed += !made;
                for (int k = 0; k < 4; k++) {
                    size = std::max(size, std::fabs(row[6 + k]));
                    note(off, made ? slope[k] - row[6 + k] : NAN);
                }
                note(error, off / size);
            }
        });
        std::printf("%s,%s,1,%g", Peer::name, way, tolerance);
        print("%.3e", error);
        for (double value : seconds) std::printf(",%.4g", 1e6 * value / (double)q.rows.size());
        std::printf(",%zu\n", failed);
        std::fflush(stdout);
    }
}

// ---- what is asked

template <template <class> class Peer> static void slope(const Question &q)
{
    slope_curve<Peer<Tangent>>(q, "variational", variational);
    slope_curve<Peer<Level>>(q, "central", central);
}

template <class Form> using Rkf78 = Controlled<Form, Fehlberg78>;
template <class Form> using Dopri5 = Controlled<Form, DormandPrince5>;

template <class Form> static void section(const Question &q, const std::string &peer)
{
    if (peer == "gsl") section_curve<Form, Gsl<Form>>(q);
    if (peer == "odeint") {
        section_curve<Form, Rkf78<Form>>(q);
        section_curve<Form, Dopri5<Form>>(q);
        section_curve<Form, BulirschStoer<Form>>(q);
    }
    if (peer == "cvode") section_curve<Form, Cvode<Form>>(q);
}

static int usage()
{
    std::fputs("usage: peers section REFERENCE.csv RETURNS REPEATS FORM PEER [quick]\n"
               "       peers slope REFERENCE.csv REPEATS PEER [quick]\n", stderr);
    return 2;
}

static void ask_section(Question &q, const std::string &form, const std::string &peer)
{
    for (const auto &row : q.rows) q.checked = std::max(q.checked, (size_t)row[1]);
    if (form == "level") section<Level>(q, peer);
    if (form == "five") section<Five>(q, peer);
    if (form == "five_plain") section<Plain>(q, peer);
    if (form == "level_t") section<Timed<Level>>(q, peer);
    if (form == "five_t") section<Timed<Five>>(q, peer);
}

static void ask_slope(const Question &q, const std::string &peer)
{
    if (peer == "gsl") slope<Gsl>(q);
    if (peer == "odeint") {
        slope<Rkf78>(q);
        slope<Dopri5>(q);
        slope<BulirschStoer>(q);
    }
    if (peer == "cvode") slope<Cvode>(q);
}

int main(int argc, char **argv)
{
    const std::vector<std::string> words(argv + 1, argv + argc);
    const bool quick = !words.empty() && words.back() == "quick";
    const size_t count = words.size() - quick;
    Question q;
    q.stride = quick ? 3 : 1;
    gsl_set_error_handler_off();
    if (count == 6 && words[0] == "section") {
        q.rows = read(argv[2], 7);
        q.returns = std::strtoul(argv[3], nullptr, 10);
        q.repeats = std::atoi(argv[4]);
        ask_section(q, words[4], words[5]);
        return 0;
    }
    if (count == 4 && words[0] == "slope") {
        q.rows = read(argv[2], 10);
        q.repeats = std::atoi(argv[3]);
        ask_slope(q, words[3]);
        return 0;
    }
    return usage();
}
