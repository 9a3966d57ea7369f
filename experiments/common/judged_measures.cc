#include "experiments/common/judged_measures.h"

#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Geometry>

namespace cirque::verify {
namespace {

/// The surface in the library's numbering, where halfedge 3 f + k lies opposite corner k and not
/// behind it.
Triangulation ToTriangulation(const Surface& surface) {
  std::vector<Index> twin(surface.twin.size(), kNone);
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    const Index across = surface.twin[TriangleMesh::Next(h)];
    if (across != kNone) twin[h] = TriangleMesh::Prev(across);
  }
  return NumberEdges(surface.mesh.num_vertices, surface.mesh.vertex, std::move(twin));
}

CornerAngles AnglesInSpace(const Triangulation& t, const std::vector<Eigen::Vector3d>& position) {
  CornerAngles angles;
  angles.value.resize(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Eigen::Vector3d& apex = position[t.vertex[h]];
    const Eigen::Vector3d a = position[t.Tail(h)] - apex, b = position[t.Tip(h)] - apex;
    angles.value[h] = std::atan2(a.cross(b).stableNorm(), a.dot(b));
  }
  return angles;
}

/// The registered measures, of which that of overlaps need not look for any.
Registry<DistortionMeasure> MeasuresWithoutOverlap() {
  Registry<DistortionMeasure> measures("distortion measure", {});
  for (const std::string& name : DistortionMeasures().Names()) {
    DistortionMeasure measure = *DistortionMeasures().Find(name);
    if (name == "overlap") {
      measure.measure = [](const MappedFaces& faces) {
        const double none = faces.num_faces() == 0 ? kUnknown : 0;
        return Measurement{{}, {none, none}};
      };
    }
    measures = measures.With(name, std::move(measure));
  }
  return measures;
}

}  // namespace

MapMeasures MeasureComplex(const UvComplex& complex, const std::vector<Eigen::Vector3d>& of_file,
                           bool injective) {
  const Triangulation t = ToTriangulation(complex.surface);
  std::vector<Eigen::Vector3d> position;
  for (Index v = 0; v < t.num_vertices; ++v) position.push_back(of_file[complex.mesh().Origin(v)]);
  EdgeLengths lengths;
  lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    lengths.value[e] = (position[t.Tip(h)] - position[t.Tail(h)]).stableNorm();
  }
  const CornerAngles angles = AnglesInSpace(t, position);
  return MeasureMap(t, lengths, {complex.uv}, &angles,
                    injective ? MeasuresWithoutOverlap() : DistortionMeasures());
}

Index WorstTriangle(const MapMeasures& measures) {
  const Eigen::VectorXd& ratio = measures.FaceValuesOf("quasi_conformal").value;
  Index worst = kNone;
  for (Index f = 0; f < ratio.size(); ++f) {
    if (!std::isnan(ratio[f]) && (worst == kNone || ratio[f] > ratio[worst])) worst = f;
  }
  return worst;
}

QualityFigures ToQualityFigures(const MapMeasures& measures) {
  QualityFigures quality;
  quality.lines = FormatFigures(measures);
  for (const MapMeasures::Figure& figure : measures.figures) {
    quality.values.emplace_back(figure.name, figure.value);
  }
  quality.worst_triangle = WorstTriangle(measures);
  return quality;
}

}  // namespace cirque::verify
