#include "cirque/domains/sphere_measures.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/metrics/measure_map.h"
#include "cirque/pipeline/map_measures.h"

namespace cirque {

double SphericalDelaunayMargin(const IntrinsicSurface& punctured, const Eigen::VectorXd& angle) {
  const Triangulation& t = punctured.triangulation;
  double margin = kPi;
  std::vector<double> sum(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    sum[t.vertex[h]] += angle[h];
    margin = std::min(margin, kPi - angle[h] - (t.twin[h] == kNone ? 0 : angle[t.twin[h]]));
  }
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (punctured.boundary[v]) margin = std::min(margin, kPi - sum[v]);
  }
  return margin;
}

void NumberAsInFile(const Surface& surface, const PuncturedSurface& punctured,
                    InfeasibilityCertificate* proof) {
  std::vector<double> of_face(surface.triangulation.num_faces(), 0);
  for (std::size_t f = 0; f < punctured.face.size(); ++f) {
    of_face[punctured.face[f]] = proof->face_multiplier[f];
  }
  proof->face_multiplier = std::move(of_face);
  for (Index& f : proof->carrying_faces) f = punctured.face[f];
  for (auto* vertices : {&proof->constrained_vertex, &proof->carrying_vertices}) {
    for (Index& v : *vertices) v = surface.soup_vertex[punctured.vertex[v]];
  }
  proof->removed_vertex = surface.soup_vertex[punctured.pole];
}

void MeasureSphereMap(const Surface& surface, const EdgeLengths& source, SurfaceMap* map) {
  const Triangulation& t = surface.triangulation;
  const EdgeLengths image = ChordLengths(t, map->position);
  const CornerUv planar = FacesInPlane(t, image);
  const MappedFaces faces = MeasureFaces(t, source, planar);
  const Eigen::VectorXd differences = AngleDifferences(t, source, image);
  map->quasi_conformal.setZero(t.num_faces());
  for (Index i = 0; i < faces.num_faces(); ++i) {
    map->quasi_conformal[faces.face[i]] = faces.sigma_max[i] / faces.sigma_min[i];
  }
  map->angle_distortion.resize(t.num_faces());
  for (Index f = 0; f < t.num_faces(); ++f) {
    map->angle_distortion[f] = differences.segment<3>(3 * f).maxCoeff();
  }
  Certificate& certificate = map->certificate;
  certificate.distortion = DistortionOf(t, source, planar);
  certificate.sphere->angle_distortion_mean = differences.mean();
  certificate.sphere->angle_distortion_max = differences.maxCoeff();
  certificate.sphere->degree = SphericalDegree(t, map->position);
  certificate.overlap = "injective";  // no flips, and the degree of a sphere's layout is 1
}

}  // namespace cirque
