#include "cirque/domains/sphere_pole.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cirque/cones/cone_problem.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/farthest_vertices.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/metrics/mapped_faces.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kShortList = 64;
/// Vertices at the pole's own place are taken to be this share of the farthest distance away.
constexpr double kNearest = 1e-9;

/// Distances of all vertices from one of them, the farthest being 1.
std::vector<double> RelativeDistances(const Surface& surface, Index pole) {
  std::vector<double> distance;
  double farthest = 0;
  for (const Vector3d& x : surface.position) {
    distance.push_back((x - surface.position[pole]).stableNorm());
    farthest = std::max(farthest, distance.back());
  }
  for (double& r : distance) r = std::max(r / farthest, kNearest);
  return distance;
}

/// Per vertex the area of its star times the star's smallest angle; 0 where the star is no disk.
std::vector<double> StarQualities(const IntrinsicTriangulation& intrinsic) {
  const Triangulation& t = intrinsic.triangulation;
  const CornerAngles angles = MeasureCornerAngles(t, intrinsic.lengths);
  std::vector<double> area(t.num_vertices, 0), smallest(t.num_vertices, kPi);
  std::vector<Index> corner(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index v = t.vertex[h], first = h - h % 3;
    corner[v] = h;
    area[v] += intrinsic.lengths.value[t.edge[Triangulation::Next(h)]] *
               intrinsic.lengths.value[t.edge[Triangulation::Prev(h)]] * std::sin(angles.value[h]);
    smallest[v] = std::min(smallest[v], angles.value.segment<3>(first).minCoeff());
  }
  std::vector<double> quality(t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) {
    quality[v] = HasDiskStar(t, corner[v]) ? area[v] * smallest[v] : 0;
  }
  return quality;
}

double InversionCost(const Surface& surface, const IntrinsicTriangulation& intrinsic, Index pole) {
  const Triangulation& t = intrinsic.triangulation;
  const std::vector<double> distance = RelativeDistances(surface, pole);
  double cost = 0;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index a = t.Tail(t.edge_halfedge[e]), b = t.Tip(t.edge_halfedge[e]);
    if (a == pole || b == pole) continue;
    const double length = intrinsic.lengths.value[e];
    cost += length * length / (distance[a] * distance[b]);
  }
  return cost;
}

}  // namespace

std::vector<Index> PoleCandidates(const Surface& surface, const IntrinsicTriangulation& intrinsic,
                                  Index count) {
  const std::vector<double> quality = StarQualities(intrinsic);
  std::vector<Index> candidates;
  for (Index v = 0; v < static_cast<Index>(quality.size()); ++v) {
    if (quality[v] > 0) candidates.push_back(v);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](Index a, Index b) { return quality[a] > quality[b]; });
  if (candidates.size() > kShortList) candidates.resize(kShortList);
  if (candidates.empty()) return candidates;
  std::vector<double> cost(quality.size());
  for (const Index v : candidates) cost[v] = InversionCost(surface, intrinsic, v);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](Index a, Index b) { return cost[a] < cost[b]; });
  return FarthestVertices(intrinsic.triangulation, intrinsic.lengths, candidates,
                          std::min(count, static_cast<Index>(candidates.size())));
}

double PredictedLogRange(const IntrinsicTriangulation& intrinsic, Index pole) {
  const ConeProblem problem(intrinsic.triangulation, intrinsic.lengths);
  Eigen::VectorXd curvature = -problem.curvature();
  curvature[pole] += 4 * kPi;
  Eigen::VectorXd u = problem.Solve(curvature);
  u[pole] = u[pole == 0 ? 1 : 0];
  return u.maxCoeff() - u.minCoeff();
}

EdgeLengths InvertedLengths(const Surface& surface, const Triangulation& closed,
                            const EdgeLengths& lengths, const PuncturedSurface& punctured) {
  const std::vector<double> distance = RelativeDistances(surface, punctured.pole);
  const Triangulation& t = punctured.triangulation;
  EdgeLengths inverted = LengthsOf(punctured, closed, lengths);
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    inverted.value[e] /=
        distance[punctured.vertex[t.Tail(h)]] * distance[punctured.vertex[t.Tip(h)]];
  }
  return inverted;
}

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
  const IntrinsicSurface on_sphere = MeasureSurface(t, image);
  const CornerUv planar = FacesInPlane(on_sphere);
  const MappedFaces faces = MeasureFaces(t, source, planar);
  const Eigen::VectorXd differences =
      AngleDifferences(MeasureSurface(t, source).angles, on_sphere.angles);
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
  // Without flips: the degree of a sphere's layout is 1. Some there may be beside an exact map.
  const bool flips = certificate.layout && certificate.layout->flipped_triangles > 0;
  certificate.overlap = flips ? "unknown" : "injective";
}

}  // namespace cirque
