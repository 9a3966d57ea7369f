#include "cirque/verify/infeasibility_check.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A vertex put into every triangle of `base` and joined to its corners: the vertex of triangle f
/// is `first + f`, the pieces of f are 3 f + k, where piece 3 f + k has the base edge from corner
/// k.
struct Kleetope {
  PolygonSoup mesh;
  Index first;
  Index num_base_triangles;
};

Kleetope Stellate(const PolygonSoup& base) {
  std::vector<Eigen::Vector3d> position = base.position;
  std::vector<Triangle> triangles;
  const auto first = static_cast<Index>(position.size());
  for (Index f = 0; f < base.num_polygons(); ++f) {
    const Index* v = &base.corner[3 * f];
    position.push_back((position[v[0]] + position[v[1]] + position[v[2]]) / 3);
    const auto apex = static_cast<Index>(position.size()) - 1;
    for (int k = 0; k < 3; ++k) triangles.push_back({v[k], v[(k + 1) % 3], apex});
  }
  return {MakeSoup(std::move(position), triangles), first, base.num_polygons()};
}

/// Round every new vertex the three angles sum to 2 pi, and each of them is opposite a base edge,
/// where it and the one beyond sum to at most pi - eps. Summed up: 2 F_base <= (1 - eps) E_base,
/// which is false for closed base meshes (E = 3/2 F) and larger disks. So multiplier 1 at the new
/// vertices and 0 elsewhere are the certificate: left = 2 F_base, right = (1 - eps) E_base.
InfeasibilityCertificate CertificateOf(const Kleetope& k, double epsilon) {
  InfeasibilityCertificate certificate;
  certificate.epsilon_over_pi = epsilon;
  certificate.face_multiplier.assign(static_cast<std::size_t>(k.mesh.num_polygons()), 0.0);
  for (Index f = 0; f < k.num_base_triangles; ++f) {
    certificate.constrained_vertex.push_back(k.first + f);
    certificate.lower_over_pi.push_back(2);
    certificate.upper_over_pi.push_back(2);
    certificate.vertex_multiplier.push_back(1);
  }
  certificate.carrying_vertices = {k.first};
  return certificate;
}

PolygonSoup Tetrahedron() {
  return MakeSoup({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                  {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

InfeasibilityReport Check(const InfeasibilityCertificate& certificate, const PolygonSoup& mesh) {
  const StatusOr<InfeasibilityReport> report = CheckInfeasibility(certificate, mesh);
  EXPECT_TRUE(report.ok()) << report.status().message();
  if (report.ok()) return *report;
  InfeasibilityReport none;
  none.errors = {"no report"};
  return none;
}

TEST(VerifyMapInfeasibility, AKleetopesCertificateIsAccepted) {
  const Kleetope closed = Stellate(Tetrahedron());
  const InfeasibilityReport report = Check(CertificateOf(closed, 0.001), closed.mesh);
  EXPECT_EQ(report.Verdict(), "accepted (no coherent angles with margin eps = 0.001 pi)");
  EXPECT_DOUBLE_EQ(report.left, 8);
  EXPECT_DOUBLE_EQ(report.right, 6 * (1 - 0.001));
  EXPECT_DOUBLE_EQ(report.margin, 8 - 6 * (1 - 0.001));
  EXPECT_EQ(report.num_flat, 4);
  const Kleetope disk = Stellate(Sheet(4));  // with boundary edges: 32 triangles, 56 edges
  EXPECT_DOUBLE_EQ(Check(CertificateOf(disk, 0.01), disk.mesh).right, 56 * 0.99);
  EXPECT_TRUE(Check(CertificateOf(disk, 0.01), disk.mesh).accepted());
}

TEST(VerifyMapInfeasibility, MultipliersOnFacesAndOfBothSignsAreAccountedFor) {
  // Adding c to the multiplier of a face adds c to the left side and c times the sum of its angles,
  // pi, to what the right side bounds: for the closed mesh with c everywhere and eps = 0, the base
  // edges have p = q = 1 + c and the spokes p = q = c.
  const Kleetope k = Stellate(Tetrahedron());
  InfeasibilityCertificate certificate = CertificateOf(k, 0);
  certificate.face_multiplier.assign(12, -0.25);
  const InfeasibilityReport negative = Check(certificate, k.mesh);
  EXPECT_DOUBLE_EQ(negative.left, 8 - 12 * 0.25);
  EXPECT_DOUBLE_EQ(negative.right, 6 * 0.75);
  EXPECT_TRUE(negative.accepted());
  certificate.face_multiplier.assign(12, 0.25);
  const InfeasibilityReport positive = Check(certificate, k.mesh);
  EXPECT_DOUBLE_EQ(positive.left, 8 + 12 * 0.25);
  EXPECT_DOUBLE_EQ(positive.right, 6 * 1.25 + 12 * 0.25);
}

TEST(VerifyMapInfeasibility, AChangedMultiplierIsRejected) {
  const Kleetope k = Stellate(Tetrahedron());
  InfeasibilityCertificate certificate = CertificateOf(k, 0.001);
  certificate.vertex_multiplier[2] = -1;
  const InfeasibilityReport report = Check(certificate, k.mesh);
  // Left 3 * 2 - 2; right: three edges of p = q = 1 and three of p = 1, q = -1.
  EXPECT_DOUBLE_EQ(report.left, 4);
  EXPECT_DOUBLE_EQ(report.right, 3 * 0.999 + 3 * 0.997);
  EXPECT_THAT(report.Verdict(), HasSubstr("REJECTED: the inequality fails"));
}

TEST(VerifyMapInfeasibility, EqualityProvesTheOpenProblemOnlyAndIsDecidedExactly) {
  const Kleetope k = Stellate(Sheet(2));  // 2 F_base = E_base = 16
  InfeasibilityCertificate certificate = CertificateOf(k, 0);
  const InfeasibilityReport equal = Check(certificate, k.mesh);
  EXPECT_EQ(equal.margin, 0);
  EXPECT_EQ(equal.Verdict(), "accepted (no coherent angles)");
  // Less by 2^-52 on the left only, since base triangle 3 has a neighbour at every edge; a sum of
  // doubles near 16 does not see it.
  certificate.vertex_multiplier[3] = 1 - std::ldexp(1, -53);
  const InfeasibilityReport less = Check(certificate, k.mesh);
  EXPECT_EQ(less.margin, -std::ldexp(1, -52));
  EXPECT_FALSE(less.accepted());
  // With all multipliers zero both sides are zero, which proves nothing.
  certificate.vertex_multiplier.assign(certificate.vertex_multiplier.size(), 0.0);
  EXPECT_FALSE(Check(certificate, k.mesh).accepted());
}

TEST(VerifyMapInfeasibility, AFeasibleMeshHasNoSuchCertificate) {
  // Equilateral angles are coherent on a hexagonal fan, so no multipliers may pass.
  const PolygonSoup fan = Fan(6, kPi / 3);
  InfeasibilityCertificate certificate;
  certificate.constrained_vertex = {0};
  certificate.lower_over_pi = certificate.upper_over_pi = {2};
  for (const double y : {-3.0, -1.0, -1e-9, 1e-300, 0.5, 2.0}) {
    for (const double face : {-2.0, -0.5, 0.0, 1.0}) {
      certificate.vertex_multiplier = {y};
      certificate.face_multiplier.assign(6, face);
      EXPECT_FALSE(Check(certificate, fan).accepted()) << y << " " << face;
    }
  }
}

TEST(VerifyMapInfeasibility, ConesAndPrescribedBoundaryVerticesAreNamed) {
  const Kleetope k = Stellate(Sheet(4));
  InfeasibilityCertificate certificate = CertificateOf(k, 0.001);
  certificate.lower_over_pi[0] = certificate.upper_over_pi[0] = 2.5;
  certificate.constrained_vertex.insert(certificate.constrained_vertex.begin(), 0);
  certificate.lower_over_pi.insert(certificate.lower_over_pi.begin(), 0.5);
  certificate.upper_over_pi.insert(certificate.upper_over_pi.begin(), 0.5);
  certificate.vertex_multiplier.insert(certificate.vertex_multiplier.begin(), 0.0);
  const InfeasibilityReport report = Check(certificate, k.mesh);
  EXPECT_TRUE(report.accepted());
  EXPECT_THAT(report.cones, ElementsAre(k.first));
  EXPECT_THAT(report.prescribed, ElementsAre(0));
  EXPECT_THAT(ToText(report), HasSubstr("other than 2 pi at 1 inner vertex (25)"));
}

TEST(VerifyMapInfeasibility, IllFormedCertificatesAreRejectedByName) {
  const Kleetope k = Stellate(Tetrahedron());
  const InfeasibilityCertificate good = CertificateOf(k, 0.001);
  const auto verdict = [&](const InfeasibilityCertificate& p) {
    return Check(p, k.mesh).Verdict();
  };
  InfeasibilityCertificate bad = good;
  bad.face_multiplier.pop_back();
  EXPECT_THAT(verdict(bad), HasSubstr("face_multiplier has 11 entries instead of 12"));
  bad = good;
  bad.vertex_multiplier[1] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(verdict(bad), HasSubstr("vertex_multiplier[1] is not finite"));
  bad = good;
  bad.constrained_vertex[1] = 99;
  EXPECT_THAT(verdict(bad), HasSubstr("constrained_vertex[1] = 99 does not exist"));
  bad = good;
  bad.constrained_vertex[1] = bad.constrained_vertex[0];
  EXPECT_THAT(verdict(bad), HasSubstr("does not increase"));
  bad = good;
  bad.lower_over_pi[3] = 2.5;
  EXPECT_THAT(verdict(bad), HasSubstr("the interval of vertex 7 is empty"));
  for (const double epsilon : {-1e-3, 0.34, std::numeric_limits<double>::quiet_NaN()}) {
    bad = good;
    bad.epsilon_over_pi = epsilon;
    EXPECT_THAT(verdict(bad), HasSubstr("is not in [0, 1/3)"));
  }
}

TEST(VerifyMapInfeasibility, CertificatesAreReadAndTheirFaultsNamed) {
  const auto json = [](const std::string& faces) {
    return R"({"outcome": "infeasible", "infeasibility": {"epsilon_over_pi": 0.001,
      "face_multiplier": )" +
           faces + R"(, "constrained_vertex": [4], "lower_over_pi": [2], "upper_over_pi": [2.5],
      "vertex_multiplier": [0.1], "carrying_faces": [], "carrying_vertices": [4]}})";
  };
  const StatusOr<InfeasibilityCertificate> certificate =
      ParseInfeasibilityCertificate(json("[1, -0.5, 2e-300]"));
  ASSERT_TRUE(certificate.ok()) << certificate.status().message();
  EXPECT_THAT(certificate->face_multiplier, ElementsAre(1, -0.5, 2e-300));
  EXPECT_THAT(certificate->constrained_vertex, ElementsAre(4));
  EXPECT_EQ(certificate->upper_over_pi[0], 2.5);
  const auto message = [](const std::string& text) {
    return ParseInfeasibilityCertificate(text).status().message();
  };
  EXPECT_EQ(message(json("[1, null]")), "infeasibility.face_multiplier[1]: null is no number");
  EXPECT_THAT(message(json("{}")), HasSubstr("face_multiplier: an array is needed"));
  EXPECT_THAT(message(R"({"outcome": "ok"})"), HasSubstr("outcome: \"ok\" instead of"));
  EXPECT_THAT(message(R"({"infeasibility": {}})"), HasSubstr("outcome: nothing instead of"));
  EXPECT_THAT(message(R"({"outcome": "infeasible"})"), HasSubstr("infeasibility: an object"));
  EXPECT_EQ(message("{ not json"), "not a JSON object");
  EXPECT_EQ(message(json(std::string(100000, '[') + std::string(100000, ']'))),
            "not a JSON object");
}

TEST(NamedTriangles, ACertificateIsAboutTheTrianglesThatItNames) {
  // A quad mesh: pairs of pieces across the base edges, 6 quads around 4 vertices of three each.
  const Kleetope k = Stellate(Tetrahedron());
  const PolygonSoup& pieces = k.mesh;
  PolygonSoup quads = MakeSoup(pieces.position, {});
  InfeasibilityCertificate certificate = CertificateOf(k, 0);
  for (Index f = 0; f < 12; ++f) {
    for (Index g = f + 1; g < 12; ++g) {
      const Index *a = &pieces.corner[3 * f], *b = &pieces.corner[3 * g];
      if (a[0] != b[1] || a[1] != b[0]) continue;
      // Across the base edge a[0] a[1], which is the quad's diagonal.
      const auto q = quads.num_polygons();
      for (const Index v : {a[2], a[0], b[2], a[1]}) quads.corner.push_back(v);
      quads.first_corner.push_back(static_cast<Index>(quads.corner.size()));
      certificate.triangle_face.insert(certificate.triangle_face.end(), {q, q});
      for (const Index corner : {1, 3, 0, 3, 1, 2}) certificate.triangle_corner.push_back(corner);
    }
  }
  ASSERT_EQ(quads.num_polygons(), 6);
  const StatusOr<InfeasibilityReport> report = CheckInfeasibility(certificate, quads);
  ASSERT_TRUE(report.ok()) << report.status().message();
  EXPECT_TRUE(report->accepted()) << report->Verdict();
  EXPECT_TRUE(report->proves_asked);
  EXPECT_TRUE(report->names_triangles);
  // Along the other diagonals the vertices in the middle have six triangles, and all is well.
  InfeasibilityCertificate other = certificate;
  for (std::size_t i = 0; i < other.triangle_corner.size(); i += 6) {
    const Index corners[] = {0, 1, 2, 2, 3, 0};
    std::copy(std::begin(corners), std::end(corners),
              other.triangle_corner.begin() + static_cast<std::ptrdiff_t>(i));
  }
  EXPECT_THAT(CheckInfeasibility(other, quads)->Verdict(), HasSubstr("the inequality fails"));
  // Triangles that do not fill their face, that are none, or too few.
  InfeasibilityCertificate twice = certificate;
  twice.triangle_corner[3] = 1;
  twice.triangle_corner[4] = 3;
  EXPECT_THAT(CheckInfeasibility(twice, quads)->Verdict(), HasSubstr("of face 0 do not fill it"));
  twice.triangle_corner[3] = 9;
  EXPECT_THAT(CheckInfeasibility(twice, quads)->Verdict(), HasSubstr("of face 0 do not fill it"));
  InfeasibilityCertificate foreign = certificate;
  foreign.triangle_face[0] = 6;
  EXPECT_THAT(CheckInfeasibility(foreign, quads)->Verdict(), HasSubstr("triangle_face[0] = 6"));
  foreign.triangle_corner.pop_back();
  EXPECT_THAT(CheckInfeasibility(foreign, quads)->Verdict(), HasSubstr("35 entries instead of 36"));
}

}  // namespace
}  // namespace cirque::verify
