#include "cirque/layout/seam_constraints.h"

namespace cirque {

std::complex<double> SeamConstraint::operator()(const Eigen::VectorXcd& z) const {
  // Differences first: translations of a side then cancel without rounding.
  return factor[0] * (z[vertex[0]] - z[vertex[1]]) + factor[2] * (z[vertex[2]] - z[vertex[3]]);
}

std::vector<SeamConstraint> SeamConstraints(const Triangulation& t, const Triangulation& open,
                                            const std::vector<Seam>& seams) {
  std::vector<SeamConstraint> constraints;
  for (const Seam& seam : seams) {
    const std::complex<double> rotation = std::polar(1.0, seam.rotation);
    for (const Index h : seam.halfedges) {
      const Index twin = t.twin[h];
      // The twin runs the other way: its tail lies across from h's tip.
      constraints.push_back({{open.Tail(twin), open.Tip(twin), open.Tip(h), open.Tail(h)},
                             {1.0, -1.0, -rotation, rotation},
                             Triangulation::Face(h),
                             Triangulation::Face(twin)});
    }
  }
  return constraints;
}

}  // namespace cirque
