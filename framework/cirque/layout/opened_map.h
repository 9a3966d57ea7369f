#pragma once

#include <vector>

#include <Eigen/Core>

#include "cirque/core/metric.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/beltrami_system.h"
#include "cirque/layout/map_objective.h"
#include "cirque/layout/seams.h"
#include "cirque/layout/sliding.h"

namespace cirque {

/// A surface with the cut of its map and the seams that the cut became (MeasureSeams).
struct SeamedSurface {
  const IntrinsicSurface& surface;
  const Cut& cut;
  const std::vector<Seam>& seams;
  std::vector<bool> held = {};   ///< for every vertex of the surface, whether it stays; empty: none
  SlidingVertices sliding = {};  ///< of those that are not held; where there are seams they stay
  bool has_place = false;        ///< the image is not scaled, even if all of it may move
  bool injective = false;        ///< the image is, and stays so: the whole map has a fence
};

/// One for every edge of the seams, between vertices of `open`, the surface cut open.
std::vector<SeamConstraint> SeamConstraints(const Triangulation& triangulation,
                                            const Triangulation& open,
                                            const std::vector<Seam>& seams);

/// A map to the plane as its refinement sees it: one complex number for every vertex of the opened
/// surface.
class OpenedMap {
 public:
  /// A face weighs as much as its area, but no less than `least_area` of the mean, and all weigh 1.
  /// Faces without area, and those where |mu| is 1 in floating point, weigh nothing. Both ends of opened edges that are too short in the image for
  /// the two sides to stay congruent in floating point are held.
  OpenedMap(const SeamedSurface& of, const CornerUv& uv, double least_area);

  const Triangulation& open() const { return open_; }
  const std::vector<BeltramiFace>& faces() const { return faces_; }
  const std::vector<SeamConstraint>& seams() const { return seams_; }
  /// For every vertex of the opened surface.
  const std::vector<bool>& held() const { return held_; }
  bool HasRails() const { return !rails_.empty(); }          ///< vertices slide
  double FaceArea(Index face) const { return area_[face]; }  ///< all sum to 1

  Eigen::VectorXcd& z() { return z_; }

  /// An objective's value on every face, 0 on those without weight.
  std::vector<double> Energies(const MapObjective& objective) const;
  /// The weighted mean of them.
  double Mean(const std::vector<double>& energies) const;
  double Mean(const MapObjective& objective) const { return Mean(Energies(objective)); }

  /// The part in which the vertices move that `moves` says (V of the opened surface). `faces`,
  /// `seams`: those with such a vertex, increasing.
  MapPart PartOf(const std::vector<bool>& moves, const std::vector<Index>& faces,
                 const std::vector<Index>& seams);

  /// The part in which all move that are not held; of an image that is to stay injective with a fence,
  /// whose barrier has no weight.
  MapPart Whole();

  /// The positions as UVs, scaled about the origin to the area that the image had, unless vertices
  /// of the surface are held or slide, or the image has its place. Scaling rounds: where that would
  /// flip a face, part the sides of a short opened edge or make an image overlap that is to be
  /// injective, it is by the nearest power of two.
  void WriteTo(CornerUv* uv) const;

 private:
  void MeasureFaces(const IntrinsicSurface& surface, double least_area);
  void Hold(const SeamedSurface& of);
  void LayRails(const SeamedSurface& of);
  void NumberVertices(const std::vector<bool>& moves, const std::vector<Index>& faces,
                      MapPart* part);
  void AddFaces(const std::vector<Index>& faces, MapPart* part) const;
  void AddSeams(const std::vector<Index>& faces, const std::vector<Index>& seams,
                MapPart* part) const;
  void AddRails(const std::vector<Index>& faces, MapPart* part) const;
  Fence FenceOf(const std::vector<Index>& number) const;
  double ImageArea() const;
  bool KeepsOrientation(double scale) const;
  bool KeepsApart(double scale) const;
  double ScaleBack() const;

  Triangulation open_;
  std::vector<SeamConstraint> seams_;
  std::vector<BeltramiFace> faces_;
  std::vector<double> area_;
  std::vector<bool> held_;
  std::vector<Rail> rails_;     ///< increasing
  std::vector<Index> rail_of_;  ///< V of the opened surface: among rails_, or kNone
  Eigen::VectorXcd z_;
  double area_before_;
  bool short_seams_ = false, has_place_ = false, injective_ = false;
  std::vector<Index> number_;  ///< of a vertex in the part that is being made
};

}  // namespace cirque
