#include "cirque/mesh/vertex_star.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace cirque {

using Vector = Eigen::Vector3d;

double VertexStar::Measure(const std::vector<Vector>& position, Index vertex) {
  double least = std::numeric_limits<double>::infinity();
  normal.clear();
  side_squared.clear();
  for (std::size_t k = 0; k < size(); ++k) {
    const Vector &p = position[ring[k]], &q = position[Next(k)];
    const Vector side = q - p, spoke = position[vertex] - p;
    normal.push_back(side.cross(spoke));
    side_squared.push_back(side.squaredNorm());
    const double longest =
        std::max({side_squared.back(), spoke.squaredNorm(), (q - position[vertex]).squaredNorm()});
    least = std::min(least, longest > 0 ? normal.back().norm() / longest : 0);
  }
  return least;
}

double VertexStar::BoundaryCosine(const std::vector<Vector>& position, Index vertex) const {
  const Vector in = position[vertex] - position[ring.back()];
  const Vector out = position[ring.front()] - position[vertex];
  const double product = in.norm() * out.norm();
  return product > 0 ? in.dot(out) / product : 0;
}

bool VertexStar::Score(const std::vector<Vector>& position, double least,
                       CollapseChoice* choice) const {
  const Index kept = ring[choice->at];
  const Vector& to = position[kept];
  choice->score = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < size(); ++k) {
    if (ring[k] == kept || Next(k) == kept) continue;  // vanishes
    const Vector &p = position[ring[k]], &q = position[Next(k)];
    const Vector spoke = to - p;
    const Vector turned = (q - p).cross(spoke);
    const double longest = std::max({side_squared[k], spoke.squaredNorm(), (q - to).squaredNorm()});
    // Normals are as long as twice the areas.
    const double length = turned.norm(), scale = normal[k].norm() * length;
    const double cosine = scale > 0 ? normal[k].dot(turned) / scale : 0;
    choice->cosine = std::min(choice->cosine, cosine);
    choice->score = std::min(choice->score, longest > 0 ? cosine * length / longest : 0);
    if (!(choice->score > least)) return false;
  }
  return true;
}

}  // namespace cirque
