#include "cirque/domains/curve_fit.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cirque/domains/boundary_iteration.h"
#include "cirque/math/boundary_sweep.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kLeastAngle = 0.05 * kPi, kGreatestAngle = 1.75 * kPi;
constexpr double kShare = 0.8;  ///< of what a vertex's corners can reach

constexpr double kAtRest = 1e-7;  ///< of log lengths: what lies inside is refined afterwards

}  // namespace

CurveFit::CurveFit(const Surface& disk, const ClosedCurve& curve, const MapRequest& request,
                   const SolveControl& control)
    : disk_(disk),
      polygons_(curve),
      curve_(curve),
      request_(request),
      control_(control),
      loop_(BoundaryLoops(disk.triangulation).front()) {}

Status CurveFit::Run(SurfaceMap* map) {
  Status status = MapFreely(map);
  if (!status.ok()) return status;
  Begin(*map);
  const VectorXd start = Lengths(map->flat.on_input.lengths).array().log();
  const BoundaryRule rule = {[this](const VectorXd& shape) { return Targets(shape); },
                             [this](const VectorXd& shape, const EdgeLengths& flat) {
                               return polygons_.Missing(shape, Lengths(flat));
                             },
                             start, VectorXd::Ones(start.size()), kAtRest};
  BoundaryIteration iteration(disk_, rule, request_.options, control_);
  SurfaceMap failed;
  status = iteration.Run(&failed);
  summary_.rounds = 1 + iteration.rounds();
  if (status.code() == StatusCode::kCancelled) return status;
  if (status.ok()) *map = std::move(iteration.map());
  const VectorXd shape = status.ok() ? iteration.shape() : start;
  targets_ = status.ok() ? Targets(shape) : FreeBoundaryTargets(disk_.triangulation);
  summary_.length_mismatch =
      polygons_.Missing(shape, Lengths(map->flat.on_input.lengths)).cwiseAbs().maxCoeff();
  return PlaceOn(polygons_.Arcs(shape));
}

Status CurveFit::MapFreely(SurfaceMap* map) {
  ParameterizeOptions options = request_.options;
  options.refine_map = "none";
  return Parameterize(disk_, {options, FreeBoundaryTargets(disk_.triangulation), {}, {}}, control_,
                      map);
}

/// Turns the loop to where it begins, which nobody named: where the free boundary turns as the curve.
void CurveFit::Begin(const SurfaceMap& free) {
  const Triangulation& t = disk_.triangulation;
  const Index named = request_.shape.angle_zero;
  auto first = loop_.begin();
  if (named == kNone) {
    const std::vector<double> sum = VertexAngleSums(t, free.flat.on_input.angles);
    VectorXd angles(static_cast<Eigen::Index>(loop_.size()));
    for (std::size_t k = 0; k < loop_.size(); ++k) {
      angles[static_cast<Eigen::Index>(k)] = sum[t.Tail(loop_[k])];
    }
    first += NearestStart(curve_, Lengths(free.flat.on_input.lengths), angles);
  } else {
    first = std::find_if(loop_.begin(), loop_.end(), [&](Index h) { return t.Tail(h) == named; });
  }
  std::rotate(loop_.begin(), first, loop_.end());
  for (const Index h : loop_) on_curve_.vertex.push_back(t.Tail(h));
  summary_.start_vertex = disk_.soup_vertex[on_curve_.vertex[0]];
  Bound();
}

void CurveFit::Bound() {
  const std::vector<Index> corners = CornersPerVertex(disk_.triangulation);
  lower_ = VectorXd::Constant(static_cast<Eigen::Index>(loop_.size()), kLeastAngle);
  upper_ = lower_;
  for (std::size_t k = 0; k < on_curve_.vertex.size(); ++k) {
    upper_[static_cast<Eigen::Index>(k)] =
        std::min(kGreatestAngle, kShare * kPi * corners[on_curve_.vertex[k]]);
  }
}

VectorXd CurveFit::Lengths(const EdgeLengths& lengths) const {
  VectorXd of_loop(static_cast<Eigen::Index>(loop_.size()));
  for (std::size_t k = 0; k < loop_.size(); ++k) {
    of_loop[static_cast<Eigen::Index>(k)] = lengths.value[disk_.triangulation.edge[loop_[k]]];
  }
  return of_loop;
}

ConeTargets CurveFit::Targets(const VectorXd& shape) const {
  ConeTargets targets = FreeBoundaryTargets(disk_.triangulation);
  const VectorXd angles = polygons_.Angles(shape, lower_, upper_);
  for (std::size_t k = 0; k < on_curve_.vertex.size(); ++k) {
    const double angle = angles[static_cast<Eigen::Index>(k)];
    targets.lower[on_curve_.vertex[k]] = targets.upper[on_curve_.vertex[k]] = angle;
  }
  return targets;
}

Status CurveFit::PlaceOn(std::vector<double> arcs) {
  on_curve_.at_corner = polygons_.MeetCorners(&arcs);
  summary_.corners =
      static_cast<int>(std::count(on_curve_.at_corner.begin(), on_curve_.at_corner.end(), true));
  const std::vector<Vector2d> corner = polygons_.Corners(arcs);
  on_curve_.arcs = std::move(arcs);
  std::vector<DirectedSegment> sides;
  for (std::size_t k = 0; k < corner.size(); ++k) {
    sides.push_back({corner[k], corner[(k + 1) % corner.size()]});
    if (sides.back().tail == sides.back().tip) return TooFewVertices();
  }
  return FindOverlap(sides, Contacts::kEndsOnly) ? TooFewVertices() : Status();
}

Status CurveFit::TooFewVertices() const {
  return Status(StatusCode::kUnrepresentable,
                fmt::format("curve: joined by straight edges, the {} vertices of the boundary meet "
                            "one another where they lie on the curve, which is too fine for them "
                            "(subdivide the mesh, or take a smoother curve)",
                            loop_.size()));
}

}  // namespace cirque
