#pragma once

#include <vector>

#include "cirque/domains/domain.h"
#include "cirque/domains/half_plane_chart.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/half_plane.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// Whether a centre of mass goes to 0 instead of a vertex.
bool PutsMassAtCentre(const DomainOptions& options);

/// Puts the vertices of a topological disk into the unit disk (MapToDisk), from a chart in the
/// half-plane.
class DiskPlacement {
 public:
  DiskPlacement(const Surface& surface, const IntrinsicSurface& intrinsic,
                const DomainOptions& domain, const SolveControl& control);

  /// By the Moebius map that the options ask for; returns the flipped faces.
  std::vector<Index> Place(const HalfPlaneChart& chart);

  /// From the chart's boundary lengths alone, with the boundary spread out by a share in (0, 1] and
  /// everything inside embedded convexly; a vertex is the centre then, whatever the options ask
  /// for.
  std::vector<Index> Spread(const HalfPlaneChart& chart, double share);

  /// Where a refinement of the map has moved the vertices, as corners of a triangulation of them.
  void TakePositions(const Triangulation& triangulation, const CornerUv& uv);

  /// Those of another placement of the same disk, with what is at 0 and at angle zero.
  void TakePlaces(const DiskPlacement& other);

  const std::vector<Complex>& position() const { return position_; }
  Index centre() const { return centre_; }  ///< kNone: a centre of mass is at 0
  Index angle_zero() const { return angle_zero_; }
  CornerUv Uv() const { return UvOf(t_); }
  CornerUv UvOf(const Triangulation& triangulation) const;  ///< of the same vertices
  double BoundaryCentreOfMass() const;
  double AreaCentreOfMass() const;

 private:
  bool InCore(Index v) const;
  ExtendedComplex InChart(Index v) const;
  Complex AmidTheSurface() const;
  void PlaceOverhangingBoundary(Complex start);
  Complex ChooseCentre(Complex start);
  WeightedPoints PointsOf(const std::string& normalization) const;
  Index NearestToCentre(Complex c) const;
  std::vector<double> AnglesFromLengths() const;
  bool Embed(const std::vector<bool>& fixed);
  bool RecentreAndEmbed();
  std::vector<Index> Finish();
  std::vector<Index> AllFaces() const;

  const Triangulation& t_;
  const std::vector<Index>& numbers_;  ///< in the file; kNone: no vertex of it
  const DomainOptions& domain_;
  const SolveControl& control_;
  const std::vector<bool>& on_boundary_;
  const Eigen::VectorXd weights_;      ///< of edges, for convex embeddings
  std::vector<double> area_, length_;  ///< shares per vertex: of area, of the boundary's length
  HalfPlaneChart chart_;
  std::vector<Complex> position_;  ///< per vertex
  Index centre_ = kNone, angle_zero_ = kNone;
};

}  // namespace cirque
