#include "cirque/pipeline/infeasibility_files.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Six triangles around vertex 0 or the last, a multiplier at two of them and at one vertex.
InfeasibilityCertificate SomeProof() {
  InfeasibilityCertificate proof;
  proof.face_multiplier = {1, 0, 0, -0.5, 0, 1e-9};
  proof.constrained_vertex = {2, 5};
  proof.vertex_multiplier = {0, -4};
  return proof;
}

/// The lines after the header of a text PLY that describe faces.
std::vector<std::string> FaceLines(const std::string& ply) {
  std::istringstream text(ply);
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("3 ")) lines.push_back(line);
  }
  return lines;
}

TEST(InfeasibilityCsv, ListsWhatCarriesTheProofInOrder) {
  EXPECT_EQ(InfeasibilityCsv(SomeProof()),
            "kind,id,multiplier\nface,0,1\nface,3,-0.5\nvertex,5,-4\n");
  EXPECT_EQ(InfeasibilityCsv({}), "kind,id,multiplier\n");
}

TEST(InfeasibilityCsv, OnlyRatiosMatter) {
  InfeasibilityCertificate scaled = SomeProof();
  for (double& y : scaled.face_multiplier) y *= 1024;
  for (double& y : scaled.vertex_multiplier) y *= 1024;
  const std::string csv = InfeasibilityCsv(scaled);
  EXPECT_THAT(csv, HasSubstr("face,0,1024\nface,3,-512\nvertex,5,-4096\n"));
  EXPECT_THAT(csv, Not(HasSubstr("face,5")));
  const Surface fan = Fan(6, 0.3);
  EXPECT_EQ(InfeasibilityPly(fan, scaled), InfeasibilityPly(fan, SomeProof()));
}

TEST(InfeasibilityPly, ColoursFacesByTheirStrongestMultiplier) {
  const Surface fan = Fan(6, 0.3);
  InfeasibilityCertificate proof = SomeProof();
  proof.vertex_multiplier = {0, 0};
  const std::string ply = InfeasibilityPly(fan, proof);
  EXPECT_THAT(ply, StartsWith("ply\n"));
  const std::vector<std::string> faces = FaceLines(ply);
  ASSERT_EQ(faces.size(), 6u);
  EXPECT_THAT(faces[0], HasSubstr(" 255 0 0"));  // the strongest, positive: red
  EXPECT_THAT(faces[1], HasSubstr(" 200 200 200"));
  EXPECT_THAT(faces[3], Not(HasSubstr(" 200 200 200")));  // negative: blue
  EXPECT_THAT(faces[5], HasSubstr(" 200 200 200"));       // too weak to carry anything
}

TEST(InfeasibilityPly, AVertexColoursTheFacesAroundIt) {
  const Surface fan = Fan(6, 0.3);
  const Triangulation& t = fan.triangulation;
  InfeasibilityCertificate proof;
  proof.face_multiplier.assign(6, 0);
  proof.constrained_vertex = {fan.soup_vertex[t.vertex[0]]};
  proof.vertex_multiplier = {-2};
  const std::vector<std::string> faces = FaceLines(InfeasibilityPly(fan, proof));
  for (Index f = 0; f < t.num_faces(); ++f) {
    bool touches = false;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) touches = touches || t.vertex[h] == t.vertex[0];
    EXPECT_THAT(faces[f], HasSubstr(touches ? " 0 0 255" : " 200 200 200")) << f;
  }
}

}  // namespace
}  // namespace cirque
