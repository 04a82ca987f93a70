#include "top/attitude.h"

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
static void complete(jlt_attitude *out, const jlt_top *top, const double centre[2])
{
    for (int i = 0; i < 2; i++) {
        out->centre[i] = centre[i];
        out->contact[i] = centre[i] - top->a3 * out->axes[i][2];
    }
    out->orthonormality = defect((const double (*)[3])out->axes);
}

void jlt_attitude_from_angles(jlt_attitude *out, const jlt_top *top, double gamma3, double s, double chi, double spin,
                              const double centre[2])
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
    complete(out, top, centre);
}

void jlt_attitude_from_axes(jlt_attitude *out, const jlt_top *top, const double axes[3][3], const double centre[2])
{
    memcpy(out->axes, axes, sizeof out->axes);
    complete(out, top, centre);
}
