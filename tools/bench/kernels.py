"""Nanoseconds a call of the reduced field (3.2) and of field and Jacobian fused: jellett's kernels, scalar and batched, CasADi's
generated C, SymPy's common subexpressions, and C written by hand, all compiled by the same compiler with the same flags.

usage: kernels.py BUILD_DIR [REPEATS]; run from the top folder. Output: CSV. Throughput: independent points; chain: each call waits
for the one before. Times are medians of the repeats, with the least and the largest; a batched time is that of one lane."""
import os
import subprocess
import sys
import tempfile

import casadi
import sympy

NAMES = ["gamma3", "v_nu", "omega_tau", "omega_n", "omega3"]
PARAMS = ["m", "R", "g", "I1", "I3", "a3"]


def field(x, p, sqrt):
    gamma3, v, w, wn, w3 = x
    m, R, g, I1, I3, a3 = p
    s = sqrt(1 - gamma3 * gamma3)
    b, e = a3 + R * gamma3, R + a3 * gamma3
    Theta = I1 * I3 + I1 * m * R * R * s * s + I3 * m * b * b
    D, V = I1 + m * a3 * a3 * s * s, e * w + v
    return [s * w, wn * (b * wn + R * s * w3) / s,
            (m * a3 * s * s * (a3 * gamma3 * w * w - g) - wn * (I1 * gamma3 * wn + I3 * s * w3)) / (s * D),
            gamma3 * wn * w / s - m * I3 * b * wn * V / (s * Theta) + I3 * w3 * w * (I3 + m * R * e) / Theta,
            -m * R * I1 * wn * V / Theta + m * R * s * w3 * w * (R * gamma3 * (I1 - I3) - a3 * I3) / Theta]


def sympy_source():
    x, p = sympy.symbols("x:5"), sympy.symbols("p:6")
    f = sympy.Matrix(field(x, p, sympy.sqrt))
    text = ["#include <math.h>"]
    for name, outputs in (("rhs", list(f)), ("fused", list(f) + list(f.jacobian(x)))):
        shared, reduced = sympy.cse(outputs)
        text.append(f"void sympy_{name}(const double *restrict x, const double *restrict p, double *restrict out)\n{{")
        rename = {**{s: sympy.Symbol(f"x[{i}]") for i, s in enumerate(x)}, **{s: sympy.Symbol(f"p[{i}]") for i, s in enumerate(p)}}
        local = {s: sympy.Symbol(f"t{i}") for i, (s, _) in enumerate(shared)}
        def code(expression):
            return sympy.ccode(expression.xreplace({**local, **rename}), user_functions={"Pow": [
                (lambda base, power: power.is_Integer and 0 < int(power) < 5,
                 lambda base, power: "(" + "*".join([f"({base})"] * int(power)) + ")"),
                (lambda base, power: power.is_Integer and -5 < int(power) < 0,
                 lambda base, power: "(1/(" + "*".join([f"({base})"] * -int(power)) + "))"),
                (lambda base, power: power == sympy.Rational(1, 2), lambda base, power: f"sqrt({base})"),
                (lambda base, power: power == sympy.Rational(3, 2), lambda base, power: f"(({base})*sqrt({base}))"),
                (lambda base, power: power == -sympy.Rational(1, 2), lambda base, power: f"(1/sqrt({base}))"),
                (lambda base, power: power == -sympy.Rational(3, 2), lambda base, power: f"(1/(({base})*sqrt({base})))")]})
        text += [f"    const double t{i} = {code(e)};" for i, (_, e) in enumerate(shared)]
        text += [f"    out[{i}] = {code(e)};" for i, e in enumerate(reduced)] + ["}"]
    return "\n".join(text) + "\n"


def casadi_source(folder):
    x, p = casadi.SX.sym("x", 5), casadi.SX.sym("p", 6)
    f = casadi.vertcat(*field([x[i] for i in range(5)], [p[i] for i in range(6)], casadi.sqrt))
    here = os.getcwd()
    os.chdir(folder)
    generator = casadi.CodeGenerator("casadi_kernels.c")
    generator.add(casadi.Function("casadi_rhs", [x, p], [f]))
    generator.add(casadi.Function("casadi_fused", [x, p], [f, casadi.densify(casadi.jacobian(f, x))]))
    generator.generate()
    os.chdir(here)


HAND = r"""
#include <math.h>
void hand_rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double m = p[0], R = p[1], g = p[2], I1 = p[3], I3 = p[4], a3 = p[5];
    const double s2 = (1 - x[0])*(1 + x[0]), s = sqrt(s2), b = a3 + R*x[0], e = R + a3*x[0];
    const double Theta = I1*I3 + m*(I1*R*R*s2 + I3*b*b), D = I1 + m*a3*a3*s2, V = e*x[2] + x[1];
    const double r = 1/(s*Theta*D), over_Theta = r*s*D, over_sTheta = r*D, over_s = over_sTheta*Theta, over_sD = r*Theta;
    const double mR = m*R, nV = x[3]*V, product = x[4]*x[2];
    out[0] = s*x[2];
    out[1] = x[3]*(b*x[3] + R*s*x[4])*over_s;
    out[2] = (m*a3*s2*(a3*x[0]*x[2]*x[2] - g) - x[3]*(I1*x[0]*x[3] + I3*s*x[4]))*over_sD;
    out[3] = x[0]*x[3]*x[2]*over_s - m*I3*b*nV*over_sTheta + I3*product*(I3 + mR*e)*over_Theta;
    out[4] = mR*(s*product*(R*x[0]*(I1 - I3) - a3*I3) - I1*nV)*over_Theta;
}
void hand_fused(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double m = p[0], R = p[1], g = p[2], I1 = p[3], I3 = p[4], a3 = p[5];
    const double c = x[0], v = x[1], w = x[2], n = x[3], w3 = x[4];
    const double s2 = (1 - c)*(1 + c), s = sqrt(s2), b = a3 + R*c, e = R + a3*c;
    const double Theta = I1*I3 + m*(I1*R*R*s2 + I3*b*b), D = I1 + m*a3*a3*s2, V = e*w + v;
    const double r = 1/(s*Theta*D), over_Theta = r*s*D, over_sTheta = r*D, over_s = over_sTheta*Theta, over_D = r*Theta*s;
    const double over_s2 = over_s*over_s, over_s3 = over_s2*over_s, mR = m*R, ma = m*a3, product = w3*w, n2 = n*n, nw = n*w;
    const double Theta_c = 2*mR*(I3*b - I1*R*c)*over_Theta, D_c = -2*ma*a3*c, weight = a3*c*w*w - g, K = R*c*(I1 - I3) - a3*I3;
    const double side = m*I3*b*over_sTheta, lever = I3*(I3 + mR*e)*over_Theta, push = mR*over_Theta;
    const double f2 = (ma*s*weight - n*(I1*c*n*over_s + I3*w3))*over_D, B = side*n*V, C = lever*product;
    const double f4 = push*(s*product*K - I1*n*V);
    double *J = out + 5;
    out[0] = s*w;
    out[1] = n*(b*n*over_s + R*w3);
    out[2] = f2;
    out[3] = c*nw*over_s - B + C;
    out[4] = f4;
    J[0] = -c*w*over_s, J[1] = 0, J[2] = s, J[3] = 0, J[4] = 0;
    J[5] = n2*over_s*(R + b*c*over_s2), J[6] = 0, J[7] = 0, J[8] = 2*b*n*over_s + R*w3, J[9] = R*n;
    J[10] = (ma*(a3*s*w*w - c*over_s*weight) - I1*n2*over_s3 - f2*D_c)*over_D;
    J[11] = 0, J[12] = 2*ma*a3*s*c*w*over_D, J[13] = -(2*I1*c*n*over_s + I3*w3)*over_D, J[14] = -I3*n*over_D;
    J[15] = nw*over_s3 - m*I3*n*over_sTheta*(R*V + b*a3*w) - B*c*over_s2 + I3*mR*a3*product*over_Theta + (B - C)*Theta_c;
    J[16] = -side*n, J[17] = c*n*over_s - side*n*e + lever*w3, J[18] = c*w*over_s - side*V, J[19] = lever*w;
    J[20] = push*(s*R*(I1 - I3)*product - c*over_s*product*K - I1*a3*nw) - f4*Theta_c;
    J[21] = -push*I1*n, J[22] = push*(s*w3*K - I1*n*e), J[23] = -push*I1*V, J[24] = push*s*w*K;
}
"""

HARNESS = r"""
#define _GNU_SOURCE
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
typedef void (*kernel)(const double *restrict, const double *restrict, double *restrict);
void hand_rhs(const double *restrict, const double *restrict, double *restrict);
void hand_fused(const double *restrict, const double *restrict, double *restrict);
void sympy_rhs(const double *restrict, const double *restrict, double *restrict);
void sympy_fused(const double *restrict, const double *restrict, double *restrict);
int casadi_rhs(const double **, double **, long long *, double *, int);
int casadi_fused(const double **, double **, long long *, double *, int);
static void call_casadi_rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double *in[] = { x, p };
    double *result[] = { out }, w[4096];
    casadi_rhs(in, result, 0, w, 0);
}
static void call_casadi_fused(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double *in[] = { x, p };
    double *result[] = { out, out + 5 }, w[4096];
    casadi_fused(in, result, 0, w, 0);
}
enum { POINTS = 64 };
static double points[POINTS][5], soa[5*POINTS] __attribute__((aligned(64))), lanes_out[30*POINTS] __attribute__((aligned(64)));
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9*(double)t.tv_nsec;
}
static int ascending(const void *a, const void *b) { double x = *(const double *)a - *(const double *)b; return (x > 0) - (x < 0); }
static void report(const char *name, const char *what, const char *mode, double *times, int repeats)
{
    qsort(times, (size_t)repeats, sizeof *times, ascending);
    printf("%s,%s,%s,%.2f,%.2f,%.2f\n", name, what, mode, times[repeats/2], times[0], times[repeats - 1]);
}
static void measure(const char *name, const char *what, kernel k, const double *p, int repeats)
{
    double times[101], out[40], x[5];
    const int calls = 2000;
    for (int chain = 0; chain < 2; chain++) {
        for (int r = 0; r < repeats; r++) {
            volatile double sink = 0;
            memcpy(x, points[0], sizeof x);
            double begin = now();
            for (int i = 0; i < calls; i++)
                for (int j = 0; j < POINTS; j++) {
                    if (chain) {
                        k(x, p, out);
                        for (int c = 0; c < 5; c++) x[c] = points[j][c] + 1e-300*out[c]; /* waits for the call before */
                    } else {
                        k(points[j], p, out);
                    }
                    __asm__ volatile("" : : "r"(out) : "memory");
                }
            times[r] = (now() - begin)/((double)calls*POINTS)*1e9;
            sink = out[0];
            (void)sink;
        }
        report(name, what, chain ? "chain" : "throughput", times, repeats);
    }
}
/* The same prepared values p in all lanes. */
static void measure_lanes(const char *name, const char *what, jlt_kernel_lanes k, const jlt_kernel_batch *kernels, const double *p, int repeats)
{
    static double spread[512*8] __attribute__((aligned(64)));
    const unsigned lanes = kernels->lanes;
    static double x[5*POINTS] __attribute__((aligned(64)));
    double times[101];
    const int calls = 2000;
    for (unsigned i = 0; i < kernels->prepared*lanes; i++) spread[i] = p[i/lanes];
    for (int chain = 0; chain < 2; chain++) {
        for (int r = 0; r < repeats; r++) {
            memcpy(x, soa, sizeof x);
            double begin = now();
            for (int i = 0; i < calls; i++)
                for (unsigned j = 0; j < POINTS; j += lanes) {
                    k(chain ? x : soa + j, spread, lanes_out, POINTS);
                    for (int c = 0; chain && c < 5; c++)
                        for (unsigned l = 0; l < lanes; l++) x[c*POINTS + l] = soa[c*POINTS + j + l] + 1e-300*lanes_out[c*POINTS + l];
                    __asm__ volatile("" : : "r"(lanes_out) : "memory");
                }
            times[r] = (now() - begin)/((double)calls*POINTS)*1e9;
        }
        report(name, what, chain ? "chain" : "throughput", times, repeats);
    }
}
int main(int argc, char **argv)
{
    const int repeats = argc > 1 ? atoi(argv[1]) : 11;
    const double params[] = { 1.3, 0.7, 9.81, 0.29, 0.21, -0.12 };
    static const char *const names[] = { "m", "R", "g", "I1", "I3", "a3" };
    const jlt_descriptor *d = jlt_descriptor_find("spherical_top", "", "", "");
    static double block[512], out1[40], out2[40];
    double ordered[16];
    for (unsigned i = 0; i < d->param_count; i++)
        for (unsigned j = 0; j < 6; j++)
            if (strcmp(d->params[i].name, names[j]) == 0) ordered[i] = params[j];
    d->prepare(ordered, block);
    for (int j = 0; j < POINTS; j++) {
        points[j][0] = -0.9 + 1.8*j/POINTS;
        for (int c = 1; c < 5; c++) points[j][c] = sin(j*1.7 + c);
        for (int c = 0; c < 5; c++) soa[c*POINTS + j] = points[j][c];
    }
    for (int j = 0; j < POINTS; j++) { /* all must compute the same */
        d->rhs_jacobian.call(points[j], block, out1);
        kernel all[] = { sympy_fused, call_casadi_fused, hand_fused, sympy_rhs, call_casadi_rhs, hand_rhs };
        for (int k = 0; k < 6; k++) {
            all[k](points[j], params, out2);
            /* CasADi's matrices are by columns */
            for (int i = 0; i < (k < 3 ? 30 : 5); i++) {
                int at = k == 1 && i >= 5 ? 5 + (i - 5)%5*5 + (i - 5)/5 : i;
                if (!(fabs(out1[i] - out2[at]) <= 1e-10*(1 + fabs(out1[i])))) { printf("kernel %d differs in output %d: %.17g, %.17g\n", k, i, out1[i], out2[at]); return 1; }
            }
        }
    }
    puts("code,kernel,mode,ns_median,ns_least,ns_largest");
    measure("jellett", "rhs", d->rhs.call, block, repeats);
    measure("casadi", "rhs", call_casadi_rhs, params, repeats);
    measure("sympy_cse", "rhs", sympy_rhs, params, repeats);
    measure("by_hand", "rhs", hand_rhs, params, repeats);
    measure("jellett", "rhs_jacobian", d->rhs_jacobian.call, block, repeats);
    measure("casadi", "rhs_jacobian", call_casadi_fused, params, repeats);
    measure("sympy_cse", "rhs_jacobian", sympy_fused, params, repeats);
    measure("by_hand", "rhs_jacobian", hand_fused, params, repeats);
    for (int isa = 0; isa < JLT_ISA_COUNT; isa++) {
        const jlt_kernel_batch *b = d->batches[isa];
        char name[64];
        if (!jlt_batch_isa_runs(b)) continue;
        snprintf(name, sizeof name, "jellett_%s", b->isa);
        measure_lanes(name, "rhs", b->rhs, b, block, repeats);
        measure_lanes(name, "rhs_jacobian", b->rhs_jacobian, b, block, repeats);
    }
    return 0;
}
"""

FLAGS = ["-O3", "-march=native", "-ffp-contract=off", "-fno-math-errno", "-std=gnu11"]


def main():
    build = sys.argv[1]
    repeats = sys.argv[2] if len(sys.argv) > 2 else "11"
    compiler = os.environ.get("CC", "cc")
    with tempfile.TemporaryDirectory() as folder:
        casadi_source(folder)
        for name, text in (("sympy_kernels.c", sympy_source()), ("hand_kernels.c", HAND), ("harness.c", HARNESS)):
            with open(os.path.join(folder, name), "w") as file:
                file.write(text)
        # The field under test is compiled here too, with the flags of the others; the rest of the library as it was built.
        sources = [os.path.join(folder, n) for n in ("casadi_kernels.c", "sympy_kernels.c", "hand_kernels.c", "harness.c")]
        sources.append("generated/spherical_top/general.c")
        program = os.path.join(folder, "kernels")
        link = subprocess.run(["pkg-config", "--libs", "gsl", "arpack", "jansson", "libconfig"], capture_output=True, text=True).stdout.split()
        subprocess.run([compiler, *FLAGS, "-DJLT_VERSION=\"bench\"", "-DJLT_HAVE_X86", "-Isrc", "-Igenerated", *sources,
                        os.path.join(build, "libjellett.a"), "-lflint-arb", "-lflint", "-lmpfr", "-lgmp", *link, "-lgomp", "-lm",
                        "-Wl,--allow-multiple-definition", "-o", program], check=True)
        print("# " + compiler + " " + " ".join(FLAGS), flush=True)
        sys.exit(subprocess.run([program, repeats]).returncode)


main()
