#include "cirque/verify/sphere_check.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/verify/infeasibility_check.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"

namespace cirque::verify {
namespace {

using ::testing::HasSubstr;

PolygonSoup SoupOf(const cirque::Surface& surface) {
  PolygonSoup soup;
  soup.position = surface.position;
  soup.corner = surface.triangulation.vertex;
  for (Index f = 1; f <= surface.triangulation.num_faces(); ++f) soup.first_corner.push_back(3 * f);
  return soup;
}

std::string Verdict(const PolygonSoup& in, const PolygonSoup& out) {
  const StatusOr<SphereReport> report = VerifySphereMap(in, out, {});
  EXPECT_TRUE(report.ok()) << report.status().message();
  return report->Verdict();
}

class VerifySphereTest : public ::testing::Test {
 protected:
  const PolygonSoup sphere_ = *GenerateMesh("sphere", {400, 1});
};

TEST_F(VerifySphereTest, ASphereIsItsOwnConformalMap) {
  const SphereReport report = *VerifySphereMap(sphere_, sphere_, {});
  EXPECT_TRUE(report.valid()) << report.Verdict();
  EXPECT_NEAR(report.degree, 1, 1e-13);
  EXPECT_NEAR(report.distortion.quasi_conformal_max, 1, 1e-9);
  EXPECT_NEAR(report.distortion.log_area_l2, 0, 1e-12);
  EXPECT_EQ(report.distortion.angle_max, 0);
  EXPECT_GE(report.delaunay_margin, -1e-12);  // the generator's triangulation is Delaunay
}

TEST_F(VerifySphereTest, MarginsOfRegularPolyhedraAreKnown) {
  // Circles about the faces meet at the angle of the dihedral supplement in hyperbolic space.
  for (const auto& [faces, margin] : {std::pair(4, 2 * kPi / 3), {8, kPi / 2}, {20, 2 * kPi / 5}}) {
    const PolygonSoup soup = SoupOf(RegularPolyhedron(faces));
    EXPECT_NEAR(VerifySphereMap(soup, soup, {})->delaunay_margin, margin, 1e-12) << faces;
  }
}

TEST_F(VerifySphereTest, PlantedErrorsAreNamed) {
  PolygonSoup out = sphere_;
  std::swap(out.position[out.corner[30]], out.position[out.corner[31]]);
  EXPECT_THAT(Verdict(sphere_, out), HasSubstr("flipped"));
  out = sphere_;
  out.position[3] *= 1 + 1e-9;
  EXPECT_THAT(Verdict(sphere_, out), HasSubstr("1 vertex not on the unit sphere (3)"));
  out.position[3][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(Verdict(sphere_, out), HasSubstr("not on the unit sphere"));
  out = sphere_;
  for (auto& x : out.position) x.z() = -x.z();
  EXPECT_THAT(Verdict(sphere_, out), HasSubstr("flipped"));
  out = sphere_;
  for (auto& x : out.position) x.setZero();
  EXPECT_THAT(Verdict(sphere_, out), HasSubstr("not on the unit sphere"));
  for (auto& x : out.position) x = {0, 0, 1};
  EXPECT_THAT(Verdict(sphere_, out), HasSubstr("zero-area triangles"));
}

TEST_F(VerifySphereTest, AMirroredMapIsNotHiddenByTurnedFaces) {
  PolygonSoup out = sphere_;
  for (auto& x : out.position) x.z() = -x.z();
  for (Index f = 0; f < out.num_polygons(); ++f)
    std::swap(out.corner[3 * f], out.corner[3 * f + 1]);
  EXPECT_THAT(Verdict(sphere_, out), HasSubstr("run the other way round"));
}

TEST_F(VerifySphereTest, OtherTrianglesAreNoMap) {
  PolygonSoup out = sphere_;
  out.corner.resize(out.corner.size() - 3);
  out.first_corner.pop_back();
  EXPECT_THAT(Verdict(sphere_, out), HasSubstr("1 triangle of IN missing"));
  out = sphere_;
  out.position.pop_back();
  EXPECT_FALSE(VerifySphereMap(sphere_, out, {}).ok());  // a corner without a vertex
}

TEST_F(VerifySphereTest, InputsThatAreNoSphereAreRefused) {
  for (const char* generator : {"torus", "spherical_cap"}) {
    const PolygonSoup soup = *GenerateMesh(generator, {400, 1});
    EXPECT_EQ(VerifySphereMap(soup, soup, {}).status().code(), StatusCode::kInvalidInput);
  }
}

TEST_F(VerifySphereTest, DeterminantsAreExact) {
  const Eigen::Vector3d a(1, 1e-17, 0), b(1, 0, 1e-17), c(1, -1e-17, -1e-17);
  EXPECT_EQ(DeterminantSign(a, b, c), 1);
  EXPECT_EQ(DeterminantSign(b, a, c), -1);
  EXPECT_EQ(DeterminantSign(a, b, a + b), 0);
  const Eigen::Vector3d tiny(0x1p-600, 0, 0);
  EXPECT_EQ(DeterminantSign(tiny, {0, 0x1p-600, 0}, {0, 0, 0x1p-600}), 1);
}

TEST_F(VerifySphereTest, AProofWithoutAVertexIsCheckedAgainstTheRest) {
  const cirque::Surface kleetope = Kleetope(GeneratedSurface("sphere", 60));
  ParameterizeOptions on_input;
  on_input.triangulation = SolvedTriangulation::kInput;
  const Certificate certificate =
      MustFail(kleetope, RequestFor("sphere", {.pole = 2}, on_input), StatusCode::kInfeasible);
  const PolygonSoup soup = SoupOf(kleetope);
  const InfeasibilityCertificate good = *ParseInfeasibilityCertificate(certificate.ToJson());
  EXPECT_EQ(good.removed_vertex, 2);
  const InfeasibilityReport report = *CheckInfeasibility(good, soup);
  EXPECT_TRUE(report.accepted()) << report.Verdict();
  EXPECT_GT(report.margin, 0);
  EXPECT_LT(report.link_upper_over_pi, 1);
  const auto rejection = [&](InfeasibilityCertificate bad) {
    return CheckInfeasibility(bad, soup)->Verdict();
  };
  InfeasibilityCertificate bad = good;
  bad.removed_vertex = 3;
  EXPECT_THAT(rejection(bad), HasSubstr("REJECTED"));
  bad.removed_vertex = 1000;
  EXPECT_THAT(rejection(bad), HasSubstr("does not exist"));
  bad = good;
  for (double& y : bad.face_multiplier) y = -y;
  EXPECT_THAT(rejection(bad), HasSubstr("REJECTED"));
  bad = good;
  for (double& lower : bad.lower_over_pi) lower = std::max(lower, 0.5);
  EXPECT_THAT(rejection(bad), HasSubstr("is held to at least"));
}

}  // namespace
}  // namespace cirque::verify
