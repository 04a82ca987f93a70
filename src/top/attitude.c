#include "top/attitude.h"

#include "kernel/descriptor.h"

#include <math.h>
#include <string.h>

static double defect(const double axes[3][3])
{
    double worst = 0;

    for (int i = 0; i < 3; i++) {
        for (int j = 0; j <= i; j++) {
            double dot = i == j ? -1 : 0;
            for (int k = 0; k < 3; k++) dot = fma(axes[i][k], axes[j][k], dot);
            worst = fmax(worst, fabs(dot));
        }
    }
    return worst;
}

/* The contact point is at r = -R gamma - a3 e3 from the centre of mass; e3 has the horizontal part (alpha3, beta3). */
static void complete(jlt_attitude *out, const jlt_top *top, double x, double y)
{
    out->centre[0] = x;
    out->centre[1] = y;
    for (int i = 0; i < 2; i++) out->contact[i] = out->centre[i] - top->a3 * out->axes[i][2];
    out->orthonormality = defect((const double (*)[3])out->axes);
}

static void from_angles(jlt_attitude *out, double gamma3, double s, double chi, double spin)
{
    const double tau[3] = { cos(spin), -sin(spin), 0 };
    const double n[3] = { sin(spin), cos(spin), 0 };

    for (int i = 0; i < 3; i++) {
        const double e3 = i == 2 ? 1 : 0;
        const double nu = s * e3 + gamma3 * n[i]; /* (tau, nu, gamma) is (tau, n, e3) turned about tau */
        out->axes[0][i] = cos(chi) * nu + sin(chi) * tau[i];
        out->axes[1][i] = sin(chi) * nu - cos(chi) * tau[i];
        out->axes[2][i] = gamma3 * e3 - s * n[i];
    }
}

static bool value_of(double *value, const jlt_descriptor *field, const double *y, const char *name)
{
    size_t index;

    if (!jlt_descriptor_state(field, name, &index)) return false;
    *value = y[index];
    return true;
}

static bool has_all(const jlt_descriptor *table, const char *const *names)
{
    size_t index;

    for (; *names != NULL; names++)
        if (!jlt_descriptor_state(table, *names, &index)) return false;
    return true;
}

static const char *const angles[] = { "gamma3", "chi", "spin", "x", "y", NULL };
static const char *const components[] = { "alpha1", "alpha2", "alpha3", "beta1", "beta2", "beta3",
                                          "gamma1", "gamma2", "gamma3", "x", "y", NULL };

bool jlt_attitude_is_told(const jlt_descriptor *table)
{
    return table != NULL && (has_all(table, angles) || has_all(table, components));
}

void jlt_attitude_of(jlt_attitude *out, const jlt_top *top, const jlt_descriptor *field, const double *y)
{
    double v[11] = { 0 }, s;

    if (has_all(field, components)) {
        for (int i = 0; i < 11; i++) value_of(&v[i], field, y, components[i]);
        memcpy(out->axes, v, sizeof out->axes);
        complete(out, top, v[9], v[10]);
        return;
    }
    for (int i = 0; i < 5; i++) value_of(&v[i], field, y, angles[i]);
    if (!value_of(&s, field, y, "s")) s = jlt_top_sine(v[0]); /* integrated, it keeps its digits near a pole */
    from_angles(out, v[0], s, v[1], v[2]);
    complete(out, top, v[3], v[4]);
}
