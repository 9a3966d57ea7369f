// Meshes without coherent angles, through the program's files into the independent checker.
#include <filesystem>
#include <sstream>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/angles/infeasibility.h"
#include "cirque/angles/registry.h"
#include "cirque/core/atomic_file.h"
#include "cirque/domains/domain.h"
#include "cirque/io/io.h"
#include "cirque/pipeline/certificate.h"
#include "cirque/verify/infeasibility_check.h"

#include "experiments/circle_patterns/job.h"
#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"
#include "tests/common/temporary_folder.h"
#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class InfeasibleEndToEnd : public ::testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_.Path(name); }
  std::string ReadAll(const std::string& name) const { return folder_.Read(name); }

  verify::InfeasibilityReport Check(const PolygonSoup& soup, const std::string& certificate) const {
    const auto proof = verify::ReadInfeasibilityCertificate(Path(certificate));
    EXPECT_TRUE(proof.ok()) << proof.status().message();
    const auto report = verify::CheckInfeasibility(*proof, soup);
    EXPECT_TRUE(report.ok()) << report.status().message();
    return *report;
  }

  TemporaryFolder folder_;
};

PolygonSoup SoupOf(const Surface& surface) {
  PolygonSoup soup;
  soup.position = surface.position;
  soup.corner = surface.triangulation.vertex;
  for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
    soup.first_corner.push_back(3 * f + 3);
  }
  return soup;
}

TEST(InfeasibleMessage, NumbersAsTheFileAndTellsOfOtherRoads) {
  MapRequest request;
  request.options.triangulation = SolvedTriangulation::kInput;
  const auto map = MapSurface(Kleetope(Kleetope(GeneratedSurface("bumpy_terrain", 60))), request);
  ASSERT_EQ(map.status().code(), StatusCode::kInfeasible);
  EXPECT_THAT(map.status().message(), ::testing::HasSubstr("other roads tried"));
  EXPECT_THAT(map.status().message(), ::testing::Not(::testing::HasSubstr("0-based")));
}

TEST_F(InfeasibleEndToEnd, PolygonsAreNamedByTheTrianglesThatTheyWereCutInto) {
  const PolygonSoup quads = testing::Torus();
  ASSERT_TRUE(WriteMesh(Path("in.obj"), quads).ok());
  ASSERT_TRUE(WriteFileAtomically(Path("a.cones"), "1 1\n").ok());  // one cone, on a torus
  CirclePatternsJob job;
  job.input = Path("in.obj");
  job.output = Path("out.obj");
  job.cones = Path("a.cones");
  std::ostringstream report;
  EXPECT_EQ(RunOnMesh(job, {}, report).code(), StatusCode::kInfeasible);
  const auto checked = Check(quads, "out.certificate.json");
  EXPECT_TRUE(checked.accepted()) << checked.Verdict();
  EXPECT_TRUE(checked.names_triangles);
  EXPECT_EQ(checked.num_triangles, 18);
  EXPECT_EQ(checked.num_faces_left_out, 0);
  const auto proof = verify::ReadInfeasibilityCertificate(Path("out.certificate.json"));
  for (const Index face : proof->carrying_faces) EXPECT_LT(face, quads.num_polygons());
}

TEST_F(InfeasibleEndToEnd, AKleetopeByEveryMethod) {
  const PolygonSoup soup = SoupOf(Kleetope(GeneratedSurface("bumpy_terrain", 60)));
  ASSERT_TRUE(WriteMesh(Path("in.obj"), soup).ok());
  for (const std::string& method : AngleSolvers().Names()) {
    SCOPED_TRACE(method);
    CirclePatternsJob job;
    job.input = Path("in.obj");
    job.output = Path("out.obj");
    job.options.angle_solver = method;
    job.options.triangulation = SolvedTriangulation::kInput;
    std::ostringstream report;
    EXPECT_EQ(RunOnMesh(job, {}, report).code(), StatusCode::kInfeasible);
    EXPECT_FALSE(std::filesystem::exists(Path("out.obj")));
    const auto checked = Check(soup, "out.certificate.json");
    EXPECT_TRUE(checked.accepted()) << checked.Verdict();
    EXPECT_EQ(checked.epsilon_over_pi, 0);
  }
  const std::string csv = ReadAll("out.infeasible.csv");
  EXPECT_THAT(csv, StartsWith("kind,id,multiplier\n"));
  EXPECT_THAT(csv, HasSubstr("\nvertex,"));
  const auto mask = ReadMesh(Path("out.infeasible.ply"));
  ASSERT_TRUE(mask.ok()) << mask.status().message();
  EXPECT_EQ(mask->corner, soup.corner);
  EXPECT_EQ(mask->position, soup.position);
  const std::string ply = ReadAll("out.infeasible.ply");
  EXPECT_THAT(ply, HasSubstr("property uchar red"));
}

/// A kleetope of a disk, without and with an ear, which the solve for the disk leaves out.
PolygonSoup InfeasibleDisk(bool with_ear) {
  PolygonSoup soup = SoupOf(Kleetope(GeneratedSurface("bumpy_terrain", 60)));
  if (!with_ear) return soup;
  const Triangulation t = SurfaceOf(soup).triangulation;
  const Index h = BoundaryLoops(t).front().front(), tail = t.Tail(h), tip = t.Tip(h);
  const Eigen::Vector3d a = soup.position[tail], b = soup.position[tip];
  soup.position.push_back(0.5 * (a + b) + (b - a).cross(Eigen::Vector3d::UnitZ()));
  const auto ear = {tip, tail, static_cast<Index>(soup.position.size()) - 1};
  soup.corner.insert(soup.corner.end(), ear);
  soup.first_corner.push_back(static_cast<Index>(soup.corner.size()));
  return soup;
}

TEST_F(InfeasibleEndToEnd, ADiskForEveryShape) {
  for (const std::string domain : {"half_plane", "disk", "rectangle", "polygon"}) {
    SCOPED_TRACE(domain);
    const bool with_ear = domain != "half_plane";  // which it refuses
    const PolygonSoup soup = InfeasibleDisk(with_ear);
    ASSERT_TRUE(WriteMesh(Path("in.obj"), soup).ok());
    CirclePatternsJob job;
    job.input = Path("in.obj");
    job.output = Path(domain + ".obj");
    job.options.triangulation = SolvedTriangulation::kInput;
    job.domain.name = domain;
    std::ostringstream report;
    const Status status = RunOnMesh(job, {}, report);
    EXPECT_EQ(status.code(), StatusCode::kInfeasible) << status.message();
    EXPECT_FALSE(std::filesystem::exists(Path(domain + ".obj")));
    const auto checked = Check(soup, domain + ".certificate.json");
    EXPECT_TRUE(checked.accepted()) << checked.Verdict();
    EXPECT_TRUE(checked.straight_boundary);
    EXPECT_EQ(checked.num_beyond_chords, with_ear ? 1 : 0);
    EXPECT_GT(checked.margin, 0);
    EXPECT_LT(checked.link_upper_over_pi, 1);
    EXPECT_GT(checked.link_upper_over_pi, 0.99);
    EXPECT_THAT(ReadAll(domain + ".infeasible.csv"), HasSubstr("\nvertex,"));
    EXPECT_TRUE(ReadMesh(Path(domain + ".infeasible.ply")).ok());
  }
}

TEST_F(InfeasibleEndToEnd, AProofAboutADiskThatClaimsTooMuchIsRejected) {
  const PolygonSoup soup = InfeasibleDisk(true);
  ParameterizeOptions on_input;
  on_input.triangulation = SolvedTriangulation::kInput;
  const InfeasibilityCertificate good =
      MustFail(SurfaceOf(soup), RequestFor("disk", {}, on_input), StatusCode::kInfeasible)
          .infeasibility;
  const auto rejection = [&](const InfeasibilityCertificate& bad) {
    return verify::CheckInfeasibility(bad, soup)->Verdict();
  };
  EXPECT_THAT(rejection(good), StartsWith("accepted"));
  InfeasibilityCertificate bad = good;
  bad.face_multiplier.back() = 1;  // the ear's
  EXPECT_THAT(rejection(bad), HasSubstr("beyond an edge between two boundary vertices"));
  bad = good;
  for (double& upper : bad.upper_over_pi) upper = std::max(upper, 1.5);
  EXPECT_THAT(rejection(bad), HasSubstr("instead of pi"));
  bad = good;
  bad.removed_vertex = static_cast<Index>(soup.position.size()) - 2;  // the apex of a triangle
  EXPECT_THAT(rejection(bad), HasSubstr("is no boundary vertex"));
}

TEST_F(InfeasibleEndToEnd, AFullAngleAtAVertexOfTwoCorners) {
  const Surface fan = Fan(6, 0.5);
  ConeTargets targets = FreeBoundaryTargets(fan.triangulation);
  targets.lower[1] = targets.upper[1] = 2 * kPi;
  const AngleConstraints constraints(fan.triangulation, targets);
  const CornerAngles reference = AnglesOf(fan);
  std::vector<InfeasibilityCertificate> proofs(1);
  EXPECT_EQ(
      CheckTargets(MeasureSurface(fan.triangulation, MeasureEdgeLengths(fan)), targets, &proofs[0])
          .code(),
      StatusCode::kInfeasible);
  for (const std::string& method : AngleSolvers().Names()) {
    AngleFitResult result;
    const Status status =
        FitAngles({constraints, reference.value, 1e-3}, *AngleObjectives().Find("quadratic"),
                  **MakeAngleSolver(method), {}, &result);
    EXPECT_EQ(status.code(), StatusCode::kInfeasible) << method << ": " << status.message();
    proofs.push_back(result.infeasibility);
  }
  for (const InfeasibilityCertificate& proof : proofs) {
    Certificate certificate;
    certificate.outcome = "infeasible";
    certificate.infeasibility = proof;
    ASSERT_TRUE(WriteFileAtomically(Path("certificate.json"), certificate.ToJson()).ok());
    const auto checked = Check(SoupOf(fan), "certificate.json");
    EXPECT_TRUE(checked.accepted()) << checked.Verdict();
    EXPECT_EQ(checked.epsilon_over_pi, 0);
    EXPECT_THAT(checked.prescribed, ::testing::ElementsAre(1));
  }
}

}  // namespace
}  // namespace cirque
