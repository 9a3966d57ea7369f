// Small maps and certificates that a verifier was once fooled by, or refused though they are right.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/io/mesh_formats.h"
#include "cirque/verify/infeasibility_check.h"

#include "tests/verify/fixtures.h"

namespace cirque::verify {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

PolygonSoup Obj(const std::string& text) { return *ParseObj("in.obj", text); }

double UvArea(const MapReport& report) {
  double twice = 0;
  const std::vector<Point>& uv = report.complex->uv;
  for (std::size_t h = 0; h < uv.size(); h += 3) {
    const Point a = uv[h + 1] - uv[h], b = uv[h + 2] - uv[h];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

const char kConcaveQuad[] = "v 0 0 0\nv 1 0 0\nv 0.25 0.25 0\nv 0 1 0\nf 2 3 4 1\n";
const char kL[] = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 3 4 5 6 1 2\n";

TEST(KnownCases, ConcavePolygonsAreNoFans) {
  for (const auto& [text, area] : {std::pair(kConcaveQuad, 0.25), {kL, 3.0}}) {
    const PolygonSoup in = Obj(text);
    const MapReport report = Judge(in, WithVertexUv(in, Flattened(in)));
    EXPECT_EQ(report.Verdict(), "valid (injective), 1 patch, 0 seam edges");
    EXPECT_DOUBLE_EQ(UvArea(report), area);
    // The fan at the first corner folds over, in the plane and in space.
    PolygonSoup fan = in;
    fan.corner = FanTriangulate(in)->vertex;
    fan.first_corner.clear();
    for (std::size_t c = 0; c <= fan.corner.size(); c += 3) {
      fan.first_corner.push_back(static_cast<Index>(c));
    }
    const std::string verdict = Judge(in, WithVertexUv(fan, Flattened(in))).Verdict();
    EXPECT_THAT(verdict, HasSubstr("1 polygon cut by OUT into triangles that lie partly outside"));
    EXPECT_THAT(verdict, HasSubstr("1 flipped face (0)"));
  }
}

// What a fan makes of the concave quadrilateral: every triangle counterclockwise, three times the
// area.
TEST(KnownCases, AFanThatIsLaidOutFlatIsNoMapOfTheConcavePolygon) {
  const PolygonSoup out = Obj(
      "v 0 0 0\nv 1 0 0\nv 0.25 0.25 0\nv 0 1 0\nvt 0.948683298 0.316227766\nvt 0 0\n"
      "vt 0.474341649 -0.632455532\nvt 1.264911064 -0.632455532\nf 2/2 3/3 4/4\nf 2/2 4/4 1/1\n");
  const MapReport report = Judge(Obj(kConcaveQuad), out);
  EXPECT_NEAR(UvArea(report), 0.75, 1e-8);
  EXPECT_EQ(report.Verdict(),
            "INVALID: 1 polygon cut by OUT into triangles that lie partly outside of it (0)");
}

// A flap at a right angle to the rest of its polygon faces away from their common normal, and does
// not where both are seen from above.
TEST(KnownCases, APolygonFarFromFlatMayBeCutAsItIsSeenAlongAnAxis) {
  const std::string points = "v 0 0 0\nv 0.8 0 -0.6\nv 0.8 1 -0.6\nv 0 1 0\nv -0.059 0.5 -0.08\n";
  const PolygonSoup in = Obj(points + "f 1 2 3 4 5\n");
  const PolygonSoup out = Obj(points + "f 1 2 3\nf 1 3 4\nf 1 4 5\n");
  EXPECT_EQ(Judge(in, WithVertexUv(out, Flattened(in))).Verdict(),
            "valid (injective), 1 patch, 0 seam edges");
  const PolygonSoup outside = Obj(points + "f 1 2 3\nf 1 3 5\nf 5 3 4\nf 1 4 5\nf 1 5 4\n");
  EXPECT_THAT(Judge(in, WithVertexUv(outside, Flattened(in))).Verdict(), HasSubstr("INVALID"));
}

const char kDoublet[] =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.4 0.6 0.3\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "vt 0.4 0.6\n";

TEST(KnownCases, TwoQuadrilateralsThatShareTwoEdgesAreASurface) {
  const PolygonSoup in = Obj(std::string(kDoublet) + "f 1/1 2/2 3/3 5/5\nf 1/1 5/5 3/3 4/4\n");
  const MapReport report = Judge(in, in);
  EXPECT_EQ(report.Verdict(), "valid (injective), 1 patch, 0 seam edges");
  EXPECT_EQ(report.angles->num_plain, 1);  // the vertex of two corners
  EXPECT_DOUBLE_EQ(UvArea(report), 1);
  // Cut along the other diagonals, and along those that coincide.
  const PolygonSoup cut =
      Obj(std::string(kDoublet) + "f 1/1 2/2 5/5\nf 2/2 3/3 5/5\nf 1/1 5/5 4/4\nf 5/5 3/3 4/4\n");
  EXPECT_EQ(Judge(in, cut).Verdict(), report.Verdict());
  const PolygonSoup fans =
      Obj(std::string(kDoublet) + "f 1/1 2/2 3/3\nf 1/1 3/3 5/5\nf 1/1 5/5 3/3\nf 1/1 3/3 4/4\n");
  EXPECT_THAT(Judge(in, fans).Verdict(), HasSubstr("1 flipped face (1)"));
}

// A quadrilateral with two triangles on its back: a closed surface, opened at three edges.
TEST(KnownCases, APolygonWithABackOfTrianglesIsAClosedSurface) {
  const PolygonSoup in = Obj("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 3 2\nf 1 4 3\n");
  const PolygonSoup out = Obj(
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\nvt 1.2 -1.6\nvt -.6 .8\n"
      "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 1/1 3/5 2/2\nf 1/1 4/4 3/6\n");
  const MapReport report = Judge(in, out);
  EXPECT_TRUE(report.valid()) << report.Verdict();
  EXPECT_EQ(report.complex->num_seam_edges, 3);
  EXPECT_EQ(report.complex->num_patches, 1);
  EXPECT_EQ(report.match.faces.pieces.size(), 1u);
}

TEST(KnownCases, TrianglesTornApartAreCountedAndSaid) {
  PolygonSoup out = WithVertexUv(Sheet(3), Flattened(Sheet(3)));
  for (auto corner = out.corner_texture.begin(); corner != out.corner_texture.end(); corner += 3) {
    std::rotate(corner, corner + 1, corner + 3);
  }
  VerifyOptions options;
  options.require_injective = options.seams.rigid = true;
  const MapReport report = Judge(Sheet(3), out, options);
  EXPECT_EQ(report.Verdict(), "valid (injective), torn: 18 patches of 1 component, 21 seam edges");
  const Json json = Json::parse(ToJson(report));
  EXPECT_EQ(json["torn"], true);
  EXPECT_EQ(json["patches"], 18);
  EXPECT_EQ(json["components"], 1);
  EXPECT_EQ(json["seam_edges"], 21);
  options.seams.max_patches = 1;
  EXPECT_EQ(Judge(Sheet(3), out, options).Verdict(), "INVALID: 18 patches, 1 allowed");
}

TEST(KnownCases, ACertificateThatNamesTargetsNobodyAskedForProvesNothing) {
  const auto certificate = *ParseInfeasibilityCertificate(
      R"({"outcome": "infeasible", "infeasibility": {"epsilon_over_pi": 0, "face_multiplier":
      [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], "constrained_vertex": [5],
      "lower_over_pi": [100], "upper_over_pi": [100], "vertex_multiplier": [1],
      "carrying_faces": [], "carrying_vertices": []}})");
  const InfeasibilityReport report = *CheckInfeasibility(certificate, Sheet(3));
  EXPECT_TRUE(report.accepted());
  EXPECT_FALSE(report.proves_asked);
  EXPECT_THAT(report.own_targets, ElementsAre(5));
  EXPECT_THAT(ToText(report),
              StartsWith("targets           the certificate's own (vertex 5: 100 pi), not the "
                         "default's\n"));
  EXPECT_THAT(report.Verdict(), StartsWith("NOT PROVEN of the targets asked about"));
  EXPECT_EQ(Json::parse(ToJson(report))["accepted"], false);
  // Of someone who asks for these it is the answer.
  AngleTargets asked = DefaultTargets();
  asked.at.resize(16);
  asked.at[5] = AngleInterval{100, 100};
  EXPECT_EQ(CheckInfeasibility(certificate, Sheet(3), asked)->Verdict(),
            "accepted (no coherent angles)");
  asked.at[5] = AngleInterval{1, 3};
  EXPECT_FALSE(CheckInfeasibility(certificate, Sheet(3), asked)->proves_asked);
}

// Where wider targets are refuted, narrower ones are.
TEST(KnownCases, ACertificateOfWiderTargetsProvesTheDefault) {
  InfeasibilityCertificate certificate;
  certificate.epsilon_over_pi = 0.01;
  certificate.face_multiplier.assign(12, 0);
  certificate.constrained_vertex = {4, 5, 6, 7};
  certificate.lower_over_pi = {2, 2, 1.9, 2};
  certificate.upper_over_pi = {2, 2, 2.1, 3};
  certificate.vertex_multiplier = {1, 1, 1, 1};
  std::vector<Eigen::Vector3d> position(8, {0, 0, 0});
  std::vector<Triangle> triangles;
  const std::vector<Triangle> base = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  for (Index f = 0; f < 4; ++f) {
    for (int k = 0; k < 3; ++k) triangles.push_back({base[f][k], base[f][(k + 1) % 3], 4 + f});
  }
  const InfeasibilityReport report =
      *CheckInfeasibility(certificate, MakeSoup(position, triangles));
  EXPECT_TRUE(report.own_targets.empty());
  EXPECT_TRUE(report.proves_asked);
}

TEST(KnownCases, TextureCoordinatesThatAreNotFiniteAreNoFlips) {
  PolygonSoup out = WithVertexUv(Sheet(4), Flattened(Sheet(4)));
  out.texture[6] = {std::nan(""), std::nan("")};
  const MapReport report = Judge(Sheet(4), out);
  EXPECT_THAT(report.Verdict(),
              StartsWith("INVALID: 6 triangles with texture coordinates that are not finite ("));
  EXPECT_FALSE(report.orientations.has_value());
}

TEST(KnownCases, APlyWithTextureCoordinatesIsAMap) {
  const std::string points = "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n4 0 1 2 3\n";
  for (const std::string names : {"s t", "u v", "texture_u texture_v"}) {
    const std::string u = names.substr(0, names.find(' ')), v = names.substr(names.find(' ') + 1);
    const PolygonSoup map = *ParsePly(
        "m.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty float " +
            u + "\nproperty float " + v +
            "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" + points);
    EXPECT_EQ(Judge(map, map).Verdict(), "valid (injective), 1 patch, 0 seam edges") << names;
  }
}

}  // namespace
}  // namespace cirque::verify
