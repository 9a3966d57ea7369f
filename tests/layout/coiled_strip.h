#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"

#include "tests/common/surfaces.h"

namespace cirque {

/// A strip with the flat metric that it has where it goes round 1.3 times in the plane, which lies upon
/// itself, and its image where it goes round 0.9 times: what that strives for overlaps.
struct CoiledStrip {
  Surface strip = FlatStrip(80, 4);
  Cut none{std::vector<bool>(strip.triangulation.num_edges(), false)};
  CornerUv start = Coiled(0.9);
  EdgeLengths lengths = LengthsIn(Coiled(1.3));

  CornerUv Coiled(double turns) const {
    CornerUv uv;
    for (const Index v : strip.triangulation.vertex) {
      const Eigen::Vector3d& x = strip.position[v];
      const double angle = 2 * kPi * turns * (1 - x.x() / 80), radius = 1 + 0.15 * x.y();
      uv.value.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return uv;
  }

  EdgeLengths LengthsIn(const CornerUv& uv) const {
    const Triangulation& t = strip.triangulation;
    EdgeLengths result{Eigen::VectorXd(t.num_edges())};
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const Index tail = Triangulation::Next(h), tip = Triangulation::Prev(h);
      result.value[t.edge[h]] = (uv.value[tip] - uv.value[tail]).norm();
    }
    return result;
  }
};

}  // namespace cirque
