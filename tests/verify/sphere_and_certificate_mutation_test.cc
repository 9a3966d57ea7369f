// Maps to the sphere and infeasibility certificates with one planted fault each, and the finding
// that it must be caught by; without the fault they are valid.
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/verify/infeasibility_check.h"
#include "cirque/verify/sphere_check.h"

#include "tests/verify/fixtures.h"
#include "tests/verify/mutations.h"

namespace cirque::verify {
namespace {

using Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A box to the sphere, the one with triangles, and with its quadrilaterals as they are.
Scene SphereScene(bool triangles) {
  Scene scene;
  for (int v = 0; v < 8; ++v) {
    scene.in.position.emplace_back(v % 2 ? 3 : -3, v / 2 % 2 ? 2 : -2, v / 4 ? 1 : -1);
  }
  for (const auto& [a, b, c, d] : std::vector<std::array<Index, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    const std::vector<Index> corners =
        triangles ? std::vector<Index>{a, b, c, a, c, d} : std::vector<Index>{a, b, c, d};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      scene.in.corner.push_back(corners[k]);
      if (triangles && k == 2) scene.in.first_corner.push_back(scene.in.first_corner.back() + 3);
    }
    scene.in.first_corner.push_back(static_cast<Index>(scene.in.corner.size()));
  }
  scene.out = scene.in;
  for (Vector3d& p : scene.out.position) p.normalize();
  return scene;
}

std::string SphereVerdict(const Scene& scene) {
  const StatusOr<SphereReport> report = VerifySphereMap(scene.in, scene.out, {});
  return report.ok() ? report->Verdict() : report.status().message();
}

const std::vector<Fault> kFaultsOfTriangleSpheres = {
    {"two points exchanged", "flipped",
     [](Scene* s) { std::swap(s->out.position[0], s->out.position[1]); }},
    {"two points in one", "zero-area", [](Scene* s) { s->out.position[0] = s->out.position[1]; }}};

const std::vector<Fault> kFaultsOfPolygonSpheres = {
    {"two points exchanged", "2 faces whose border crosses or touches itself (0, 2)",
     [](Scene* s) { std::swap(s->out.position[0], s->out.position[1]); }},
    {"a face folded", "whose border crosses or touches itself",
     [](Scene* s) { s->out.position[0] = s->out.position[3]; }}};

const std::vector<Fault> kFaultsOfSpheres = {
    {"a point moved across", "flipped", [](Scene* s) { s->out.position[0] *= -1; }},
    {"a point off the sphere", "1 vertex not on the unit sphere (3)",
     [](Scene* s) { s->out.position[3] *= 1 + 1e-9; }},
    {"a point that is not finite", "1 vertex not on the unit sphere (3)",
     [](Scene* s) { s->out.position[3].x() = kNaN; }},
    {"a mirror image", "mirrored as a whole",
     [](Scene* s) {
       for (Vector3d& p : s->out.position) p.z() *= -1;
     }},
    {"a mirror image with its faces reversed", "mirrored as a whole",
     [](Scene* s) {
       for (Vector3d& p : s->out.position) p.z() *= -1;
       ReverseFaces(&s->out);
     }},
    {"faces reversed", "run the other way round than in IN",
     [](Scene* s) { ReverseFaces(&s->out); }},
    {"all points in one half", "flipped",
     [](Scene* s) {
       for (Vector3d& p : s->out.position) p = (p + Vector3d(0, 0, 1.5)).normalized();
     }},
    {"a face missing", "of IN missing from OUT", [](Scene* s) { RemoveLastFace(&s->out); }},
    {"a face twice", "of OUT not in IN",
     [](Scene* s) {
       s->out.corner.insert(s->out.corner.end(), {0, 2, 3});
       s->out.first_corner.push_back(static_cast<Index>(s->out.corner.size()));
     }},
    {"a vertex more", "OUT must keep IN's vertices",
     [](Scene* s) { s->out.position.emplace_back(0, 0, 1); }}};

TEST(Mutations, Spheres) {
  for (const bool triangles : {true, false}) {
    const Scene scene = SphereScene(triangles);
    ExpectEachIsFound(scene, SphereVerdict, "valid (injective)", kFaultsOfSpheres);
    ExpectEachIsFound(scene, SphereVerdict, "valid (injective)",
                      triangles ? kFaultsOfTriangleSpheres : kFaultsOfPolygonSpheres);
  }
}

/// A vertex in every triangle of a tetrahedron: its three angles sum to 2 pi, each opposite an edge
/// of the tetrahedron, whose two leave at most pi - eps. 8 pi do not go into 6 (pi - eps).
Scene CertificateScene() {
  Scene scene;
  scene.in = MakeSoup({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {});
  const std::vector<Triangle> base = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  std::vector<Triangle> triangles;
  for (const Triangle& t : base) {
    const auto apex = static_cast<Index>(scene.in.position.size());
    scene.in.position.push_back(
        (scene.in.position[t[0]] + scene.in.position[t[1]] + scene.in.position[t[2]]) / 3);
    for (int k = 0; k < 3; ++k) triangles.push_back({t[k], t[(k + 1) % 3], apex});
  }
  scene.in = MakeSoup(scene.in.position, triangles);
  InfeasibilityCertificate& certificate = scene.certificate;
  certificate.epsilon_over_pi = 0.001;
  certificate.face_multiplier.assign(12, 0);
  certificate.constrained_vertex = {4, 5, 6, 7};
  certificate.lower_over_pi = certificate.upper_over_pi = {2, 2, 2, 2};
  certificate.vertex_multiplier = {1, 1, 1, 1};
  return scene;
}

std::string CertificateVerdict(const Scene& scene) {
  const StatusOr<InfeasibilityReport> report =
      CheckInfeasibility(scene.certificate, scene.in, DefaultTargets());
  return report.ok() ? report->Verdict() : report.status().message();
}

const std::vector<Fault> kFaultsOfCertificates = {
    {"a wrong sign", "the inequality fails",
     [](Scene* s) { s->certificate.vertex_multiplier[2] = -1; }},
    {"all signs wrong", "the inequality fails",
     [](Scene* s) {
       s->certificate.vertex_multiplier = {-1, -1, -1, -1};
     }},
    {"the wrong vertices", "the inequality fails",
     [](Scene* s) {
       s->certificate.constrained_vertex = {0, 1, 2, 3};
     }},
    {"a multiplier at a wrong face", "the inequality fails",
     [](Scene* s) { s->certificate.face_multiplier[0] = -3; }},
    {"multipliers too small", "the inequality fails",
     [](Scene* s) {
       s->certificate.vertex_multiplier = {1, 0, 0, 0};
     }},
    {"no multipliers", "the inequality fails",
     [](Scene* s) {
       s->certificate.vertex_multiplier = {0, 0, 0, 0};
     }},
    {"a target that nothing meets", "for targets that the certificate names itself (vertex 4: 100",
     [](Scene* s) {
       s->certificate.vertex_multiplier = {1, 0, 0, 0};
       s->certificate.lower_over_pi[0] = s->certificate.upper_over_pi[0] = 100;
     }},
    {"a sum of targets that nothing meets", "names itself (vertex 0: 100",
     [](Scene* s) {
       s->certificate.constrained_vertex[0] = 0;
       s->certificate.lower_over_pi[0] = s->certificate.upper_over_pi[0] = 100;
       s->certificate.vertex_multiplier = {1, 0, 0, 0};
     }},
    {"an empty interval", "the interval of vertex 7 is empty",
     [](Scene* s) { s->certificate.lower_over_pi[3] = 2.5; }},
    {"a margin that no triangle has", "is not in [0, 1/3)",
     [](Scene* s) { s->certificate.epsilon_over_pi = 0.34; }},
    {"a multiplier missing", "face_multiplier has 11 entries instead of 12",
     [](Scene* s) { s->certificate.face_multiplier.pop_back(); }},
    {"a multiplier that is not finite", "vertex_multiplier[1] is not finite",
     [](Scene* s) { s->certificate.vertex_multiplier[1] = HUGE_VAL; }},
    {"a vertex that does not exist", "constrained_vertex[3] = 99 does not exist",
     [](Scene* s) { s->certificate.constrained_vertex[3] = 99; }},
    {"a vertex twice", "does not increase",
     [](Scene* s) { s->certificate.constrained_vertex[3] = 6; }},
    {"a vertex removed that carries the proof", "at the removed vertex has a multiplier",
     [](Scene* s) {
       s->certificate.removed_vertex = 4;
       s->certificate.face_multiplier[0] = 1;
     }},
    {"the wrong mesh", "entries instead of", [](Scene* s) { s->in = Sheet(2); }}};

TEST(Mutations, Certificates) {
  ExpectEachIsFound(CertificateScene(), CertificateVerdict, "accepted (no coherent angles with",
                    kFaultsOfCertificates);
}

}  // namespace
}  // namespace cirque::verify
