// A circle pattern's energy with a term of one's own in one Ceres problem: log radii that shall also
// be near each other.
#include <iostream>

#include <ceres/ceres.h>

#include "cirque/cirque.h"

struct Near {  // 1/2 (w (x - y))^2
  template <class T>
  bool operator()(const T* x, const T* y, T* residual) const {
    residual[0] = T(weight) * (x[0] - y[0]);
    return true;
  }
  double weight;
};

int main() {
  const auto surface = cirque::SurfaceFromTriangles(
      {{2, 0, 0}, {2, 1, 0}, {-1, 2, 0}, {-2, 0, 0}, {0, 0, 0}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}});
  const cirque::Triangulation& t = surface->triangulation;
  const auto angles = cirque::MeasureCornerAngles(t, cirque::MeasureEdgeLengths(*surface));
  const cirque::CirclePatternEnergy pattern(t, {angles.value});
  for (const double weight : {0.0, 1.0, 10.0}) {
    std::vector<double> rho(t.num_faces(), 0.0);
    ceres::Problem problem;
    pattern.AddResidualBlocks(rho.data(), &problem);
    for (int f = 0; f + 1 < t.num_faces(); ++f) {
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Near, 1, 1, 1>(new Near{weight}),
                               nullptr, &rho[f], &rho[f + 1]);
    }
    ceres::Solver::Summary summary;
    ceres::Solve({}, &problem, &summary);
    std::cout << "weight " << weight << ": log radii";
    for (const double x : rho) std::cout << " " << x;
    std::cout << (summary.IsSolutionUsable() ? "\n" : " not solved\n");
  }
}
