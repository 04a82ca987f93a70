/* Periodic orbits of Roessler's and Lorenz' systems proved by CAPD, as jellett proves them: legs from crossing to crossing, all
 * unknown at once, one zero in the boxes by the interval Newton operator.
 *
 * usage: capd_peer SYSTEM RADIUS ORDER TOLERANCE     the points, two coordinates a leg, come from standard input
 *
 * Output: one row, the period's middle and radius, or a message and status 1 where nothing is proved. */
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <vector>

#include "capd/capdlib.h"
#define CAPD_DEFAULT_DIMENSION 3
#define CAPD_USER_NAMESPACE capd3
#include "capd/fdcapdlib.h"

using capd::IMatrix;
using capd::interval;
using capd::IVector;

namespace {

struct problem {
    const char *formulas;
    int state;            /* of the section */
    double value;
    int numerator, denominator; /* of beta */
    capd::poincare::CrossingDirection direction;
};

const problem roessler = { "par:q;var:x,y,z;fun:-y-z,x+q*y,q+x*z-57*z/10;", 0, 0, 1, 5, capd::poincare::MinusPlus };
const problem lorenz = { "par:q;var:x,y,z;fun:10*(y-x),x*(28-z)-y,x*y-q*z;", 2, 27, 8, 3, capd::poincare::MinusPlus };

capd3::IVector lifted(const problem &of, const interval &first, const interval &second)
{
    if (of.state == 0) return { interval(of.value), first, second };
    return { first, second, interval(of.value) };
}

} // namespace

int main(int count, char **words)
{
    if (count != 5) return 2;
    const problem &of = std::strcmp(words[1], "lorenz") == 0 ? lorenz : roessler;
    const interval around = std::atof(words[2]) * interval(-1, 1);
    std::vector<double> points;
    for (double value; std::cin >> value;) points.push_back(value);
    const int size = static_cast<int>(points.size()), offset = of.state == 0 ? 1 : 0;

    capd3::IMap field(of.formulas);
    field.setParameter("q", interval(of.numerator) / interval(of.denominator));
    capd3::IOdeSolver solver(field, std::atoi(words[3]));
    solver.setAbsoluteTolerance(std::atof(words[4]));
    solver.setRelativeTolerance(std::atof(words[4]));
    capd3::ICoordinateSection section(3, of.state, of.value);
    capd3::IPoincareMap map(solver, section, of.direction);
    try {
        IVector middle(size), box(size), residual(size);
        IMatrix derivative(size, size);
        for (int i = 0; i < size; i++) middle[i] = points[i], box[i] = middle[i] + around;
        for (int i = 0; i < size; i += 2) {
            const int next = (i + 2) % size;
            capd3::C0HORect2Set point(lifted(of, middle[i], middle[i + 1]));
            const capd3::IVector image = map(point);
            capd3::C1Rect2Set set(lifted(of, box[i], box[i + 1]));
            capd3::IMatrix monodromy(3, 3);
            const capd3::IVector end = map(set, monodromy);
            const capd3::IMatrix partial = map.computeDP(end, monodromy);
            for (int row = 0; row < 2; row++) {
                residual[next + row] = middle[next + row] - image[offset + row];
                derivative[next + row][next + row] += 1;
                for (int column = 0; column < 2; column++)
                    derivative[next + row][i + column] -= partial[offset + row][offset + column];
            }
        }
        const IVector newton = middle - capd::matrixAlgorithms::gauss(derivative, residual);
        if (!capd::vectalg::subsetInterior(newton, box)) {
            std::cerr << "capd_peer: not proved\n";
            return 1;
        }
        interval period = 0, time;
        for (int i = 0; i < size; i += 2) {
            capd3::C0HORect2Set set(lifted(of, newton[i], newton[i + 1]));
            map(set, time);
            period += time;
        }
        std::cout.precision(17);
        std::cout << (period.leftBound() + period.rightBound()) / 2 << "," << (period.rightBound() - period.leftBound()) / 2
                  << "\n";
    } catch (const std::exception &error) {
        std::cerr << "capd_peer: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
