#include "dynamics/linear.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "core/guard.h"
#include "ext/eigen.h"

enum { N = JLT_LINEAR_DIM_MAX };

void jlt_linear_multiply(double *out, const double *a, const double *b, unsigned dim)
{
    double product[N * N];

    for (unsigned i = 0; i < dim; i++)
        for (unsigned j = 0; j < dim; j++) {
            double sum = 0;
            for (unsigned k = 0; k < dim; k++) sum += a[i * dim + k] * b[k * dim + j];
            product[i * dim + j] = sum;
        }
    memcpy(out, product, sizeof *out * dim * dim);
}

double jlt_linear_length(const double *v, size_t count)
{
    double sum = 0;

    for (size_t i = 0; i < count; i++) sum += v[i] * v[i];
    if (sum >= DBL_MIN && sum <= DBL_MAX) return sqrt(sum);
    sum = 0; /* squares over- or underflow */
    for (size_t i = 0; i < count; i++) sum = hypot(sum, v[i]);
    return sum;
}

/* a d - b c. Source: C.-P. Jeannerod, N. Louvet, J.-M. Muller, Math. Comp. 82 (2013). */
static double difference_of_products(double a, double d, double b, double c)
{
    const double w = b * c, error = fma(-b, c, w), difference = fma(a, d, -w);

    return difference + error;
}

double jlt_linear_determinant(const double *a, unsigned dim)
{
    double u[N * N], determinant = 1;

    if (dim == 2) return difference_of_products(a[0], a[3], a[1], a[2]);
    memcpy(u, a, sizeof *u * dim * dim);
    for (unsigned k = 0; k < dim; k++) {
        unsigned pivot = k;
        for (unsigned i = k + 1; i < dim; i++)
            if (fabs(u[i * dim + k]) > fabs(u[pivot * dim + k])) pivot = i;
        if (u[pivot * dim + k] == 0) return 0;
        for (unsigned j = k; pivot != k && j < dim; j++) {
            const double swap = u[k * dim + j];
            u[k * dim + j] = u[pivot * dim + j];
            u[pivot * dim + j] = swap;
        }
        determinant *= pivot == k ? u[k * dim + k] : -u[k * dim + k];
        for (unsigned i = k + 1; i < dim; i++) {
            const double factor = u[i * dim + k] / u[k * dim + k];
            for (unsigned j = k; j < dim; j++) u[i * dim + j] -= factor * u[k * dim + j];
        }
    }
    return determinant;
}

/* mu = (a + d)/2 +- sqrt((a - d)^2/4 + b c); the larger root comes without cancellation, the smaller from the product. Entries are
 * divided by a power of two above the largest, lest products over- or underflow. */
static jlt_status eigenvalues_of_two(double *re, double *im, const double *matrix)
{
    double a[4];
    int exponent;

    if (!jlt_guard_finite(matrix, 4)) return JLT_ERR_NONFINITE;
    frexp(fmax(fmax(fabs(matrix[0]), fabs(matrix[1])), fmax(fabs(matrix[2]), fabs(matrix[3]))), &exponent);
    for (int i = 0; i < 4; i++) a[i] = ldexp(matrix[i], -exponent);
    const double half = (a[0] + a[3]) / 2, gap = (a[0] - a[3]) / 2;
    const double discriminant = fma(gap, gap, a[1] * a[2]);
    im[0] = im[1] = 0;
    if (discriminant < 0) {
        re[0] = re[1] = half;
        im[0] = sqrt(-discriminant);
        im[1] = -im[0];
    } else {
        re[0] = half + (half < 0 ? -1 : 1) * sqrt(discriminant);
        re[1] = re[0] == 0 ? 0 : jlt_linear_determinant(a, 2) / re[0];
    }
    for (int i = 0; i < 2; i++) re[i] = ldexp(re[i], exponent), im[i] = ldexp(im[i], exponent);
    return jlt_guard_finite(re, 2) && jlt_guard_finite(im, 2) ? JLT_OK : JLT_ERR_NONFINITE;
}

/* Whether eigenvalue i comes before j: by modulus, or, if these are equal up to rounding, as on the unit circle, by real part, so
 * that the order does not change from one matrix to the next. */
static bool comes_first(const double *re, const double *im, unsigned i, unsigned j)
{
    const double a = hypot(re[i], im[i]), b = hypot(re[j], im[j]), same = 1e-7 * fmax(a, b);

    if (fabs(a - b) > same) return a > b;
    return fabs(re[i] - re[j]) > same ? re[i] > re[j] : im[i] > im[j];
}

jlt_status jlt_linear_eigenvalues(double *re, double *im, const double *a, unsigned dim)
{
    if (dim == 2) return eigenvalues_of_two(re, im, a);
    JLT_PASS(jlt_eigen_values(re, im, a, dim));
    for (unsigned i = 0; i < dim; i++)
        for (unsigned j = i; j > 0 && comes_first(re, im, j, j - 1); j--) {
            const double held_re = re[j], held_im = im[j];
            re[j] = re[j - 1], im[j] = im[j - 1];
            re[j - 1] = held_re, im[j - 1] = held_im;
        }
    return JLT_OK;
}

/* Both rows of a - value*I are orthogonal to v; the longer one determines its direction better. */
void jlt_linear_eigenvector(double v[2], const double a[4], double value)
{
    const double first = hypot(a[0] - value, a[1]), second = hypot(a[2], a[3] - value);

    if (first == 0 && second == 0) {
        v[0] = 1, v[1] = 0;
    } else if (first >= second) {
        v[0] = -a[1] / first, v[1] = (a[0] - value) / first;
    } else {
        v[0] = (value - a[3]) / second, v[1] = a[2] / second;
    }
}
