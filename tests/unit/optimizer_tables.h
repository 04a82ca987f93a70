/* Tables with right-hand sides for every pass of the optimizer: polynomials, ratios, roots. */
#ifndef TEST_OPTIMIZER_TABLES_H
#define TEST_OPTIMIZER_TABLES_H

static const char polynomials[] =
    "model polynomials\nparam a > 0\nparam b\nstate x\nstate y\nstate z\n"
    "eq x =\n    + a*x*y*z\n    + b*x*y\n    + 2*x*z^2\n    - 3/7*y^3*z\n"
    "eq y =\n    + a*x*y*z^2\n    + b*x*y*z\n    - x*z^3\n    + x^2*y^2\n"
    "eq z =\n    + (x + y)*(a*z + b*x)\n    - (x + y)^2*z\n    + 5*x*y*z\n";
static const char ratios[] =
    "model ratios\nparam a > 0\nparam b > 0\nstate x\nstate y\nstate z\n"
    "eq x = y/(x^2 + a) + z/(y^2 + b)\neq y = x/(x^2 + a) - z/((x^2 + a)*(y^2 + b))\neq z = x*y/(z^2 + a*b)\n";
static const char roots[] =
    "model roots\nparam a > 0\nstate x\nstate y\nstate z\nroot r = sqrt(x^2 + y^2)\n"
    "eq x = -a*x/r^3 + y/r\neq y = -a*y/r^3 - x/r\neq z = z*r + r^2*x\n";
static const char *const tables[] = { polynomials, ratios, roots };
enum { TABLES = sizeof tables / sizeof *tables };

#endif
