#include "cirque/pipeline/whole_translations.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cirque/cuts/cut_graph.h"
#include "cirque/lattice/flat_domain.h"
#include "cirque/lattice/lattice_map.h"
#include "cirque/layout/seams.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Job = ParameterizeJob;

LatticeKind KindOf(const ParameterizeOptions& options) {
  return options.holonomy == HolonomyRule::kHalves ? LatticeKind::kSquares
                                                   : LatticeKind::kTriangles;
}

double DistanceToLattice(LatticeKind kind, const Eigen::Vector2d& point) {
  return (NearestInLattice(kind, point) - point).norm();
}

/// How far cones are from points of the lattice, and seams' translations from lattice vectors, at most, in
/// cells.
double LatticeGap(const Triangulation& t, LatticeKind kind, const std::vector<Index>& cones,
                  const Parameterization& result) {
  std::vector<bool> is_cone(t.num_vertices, false);
  for (const Index v : cones) is_cone[v] = true;
  double gap = 0;
  for (Index c = 0; c < t.num_halfedges(); ++c) {
    if (is_cone[t.vertex[c]]) gap = std::max(gap, DistanceToLattice(kind, result.uv.value[c]));
  }
  const auto& angles = result.flat.on_input.angles;
  for (const Seam& seam : MeasureSeams(t, result.cut, cones, angles, result.uv).seams) {
    gap = std::max(gap, DistanceToLattice(kind, seam.translation));
  }
  return gap;
}

}  // namespace

void MoveOntoLattice(const Job& job, Parameterization* result) {
  const Triangulation& t = job.surface.triangulation;
  Certificate& certificate = result->certificate;
  IntegerSummary& summary = Fill(&certificate.integers);
  summary.integer_cells = job.options.integer_cells;
  // Where rotations were missed there is no lattice, and the certificate says so already.
  if (!Inaccuracy(certificate).empty()) return;
  job.control.BeginStage("lattice");
  const LatticeKind kind = KindOf(job.options);
  const FlatDomain flat = DomainOf(t, result->uv);
  const double area_of_cell = kind == LatticeKind::kSquares ? 1 : std::sqrt(3.) / 4;
  const double cell = std::sqrt(flat.area() / (summary.integer_cells * area_of_cell));
  StatusOr<LatticeMap> map = MakeLatticeMap(flat, kind, cell, &result->cut);
  if (!map.ok()) {
    summary.integer_obstacle = map.status().message();
    return;
  }
  result->uv = std::move(map->uv);
  summary.integer_shift = map->largest_shift;
  const std::vector<Index> cones = ConeVertices(job.surface.boundary, result->targets);
  const bool exact = SnapRotations(t, result->cut, cones, result->flat.on_input.angles,
                                   OrderOf(kind), &result->uv);
  DescribeCut(job, result);
  Fill(&certificate.layout).rotation_order = exact ? OrderOf(kind) : 0;
  summary.integer_gap = LatticeGap(t, kind, cones, *result);
}

}  // namespace cirque
