// The programs on maps to the sphere, as a user runs them.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class SphereProgramsTest : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const PolygonSoup& soup) const {
    const std::string path = folder_.Path(name);
    EXPECT_TRUE(WriteMesh(path, soup).ok());
    return path;
  }

  ProgramResult Map(const std::string& in, const std::string& out,
                    const std::string& flags = "") const {
    return RunProgram("circle_patterns -domain=sphere -io " + in + " -oo " + out + " " + flags);
  }

  TemporaryFolder folder_;
};

TEST_F(SphereProgramsTest, AMapIsVerifiedAndAPlantedFlipIsNot) {
  PolygonSoup soup = *GenerateMesh("blob", {600, 1});
  soup.position.insert(soup.position.begin(), Eigen::Vector3d(9, 9, 9));  // isolated
  for (Index& v : soup.corner) ++v;
  const std::string in = Write("in.obj", soup), out = folder_.Path("out.obj");
  const ProgramResult mapped = Map(in, out, "-pole=7 -normalization=uniform -principal_axes");
  ASSERT_EQ(mapped.exit_status, 0) << mapped.output;
  EXPECT_THAT(mapped.output, HasSubstr("pole        vertex 7 "));
  const std::string verify = "verify_map --domain=sphere " + in + " ";
  const ProgramResult verified = RunProgram(verify + out);
  EXPECT_EQ(verified.exit_status, 0) << verified.output;
  EXPECT_THAT(verified.output, EndsWith("verdict: valid (injective)\n"));
  PolygonSoup map = *ReadMesh(out);
  EXPECT_EQ(map.corner, soup.corner);
  std::swap(map.position[map.corner[0]], map.position[map.corner[1]]);
  const ProgramResult broken = RunProgram(verify + Write("broken.obj", map));
  EXPECT_EQ(broken.exit_status, 1);
  EXPECT_THAT(broken.output, HasSubstr("INVALID"));
}

TEST_F(SphereProgramsTest, PlyHoldsBothPositionsAndTheDistortion) {
  const PolygonSoup soup = *GenerateMesh("blob", {300, 2});
  const std::string in = Write("in.off", soup), out = folder_.Path("out.ply");
  ASSERT_EQ(Map(in, out).exit_status, 0);
  EXPECT_EQ(ReadMesh(out)->position, soup.position);  // extra properties are skipped
  std::ifstream file(out);
  std::string line;
  while (line != "end_header") ASSERT_TRUE(std::getline(file, line));
  for (const Eigen::Vector3d& point : soup.position) {
    Eigen::Vector3d x, s;
    file >> x[0] >> x[1] >> x[2] >> s[0] >> s[1] >> s[2];
    EXPECT_EQ(x, point);
    EXPECT_NEAR(s.norm(), 1, 1e-15);
  }
  for (Index f = 0; f < soup.num_polygons(); ++f) {
    int corners = 0, a = 0, b = 0, c = 0;
    double quasi_conformal = 0, angle = 0;
    file >> corners >> a >> b >> c >> quasi_conformal >> angle;
    EXPECT_EQ(corners, 3);
    EXPECT_GE(quasi_conformal, 1);
    EXPECT_GT(angle, 0);
  }
  EXPECT_TRUE(file.good());
}

/// The n-th line that begins so, from 0, replaced by another.
std::string WithLine(std::string text, const std::string& begin, int n, const std::string& other) {
  std::size_t at = text.find(begin);
  for (int i = 0; i < n; ++i) at = text.find("\n" + begin, at) + 1;
  return text.replace(at, text.find('\n', at) - at, other);
}

TEST_F(SphereProgramsTest, AnExactMapIsVerifiedAndPlantedErrorsAreNot) {
  PolygonSoup soup = *GenerateMesh("blob", {400, 1});
  for (Eigen::Vector3d& x : soup.position) x.y() = 2 * x.y() + 0.5 * x.x();
  const std::string in = Write("in.obj", soup), exact = folder_.Path("exact.obj");
  const ProgramResult mapped = Map(in, folder_.Path("out.obj"), "--exact=" + exact);
  ASSERT_EQ(mapped.exit_status, 0) << mapped.output;
  EXPECT_THAT(mapped.output, HasSubstr("exact.obj ("));
  EXPECT_THAT(mapped.output, HasSubstr("faces for one of the input"));
  const std::string verify = "verify_map --domain=sphere --exact " + in + " ";
  const ProgramResult verified = RunProgram(verify + exact);
  EXPECT_EQ(verified.exit_status, 0) << verified.output;
  EXPECT_THAT(verified.output, HasSubstr("pieces of "));
  EXPECT_THAT(verified.output, EndsWith("verdict: valid (injective)\n"));
  std::ifstream file(exact);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_GT(ReadMesh(exact)->num_polygons(), soup.num_polygons() + 20);
  const std::string broken = folder_.Path("broken.obj");
  const auto last = static_cast<int>(ReadMesh(exact)->position.size()) - 1;  // a crossing
  for (const auto& [planted, status, word] :
       {std::tuple(WithLine(text, "v ", last, "v 0 0 1"), 1, "flipped triangle"),
        {WithLine(text, "v ", last, "v 0 0 1.001"), 1, "not on the unit sphere"},
        {WithLine(text, "vt ", last, "vt 0 0 0"), 1, "faces whose edges have points beside them"},
        {WithLine(text, "vt ", 0, "vt 0 0 0"), 1, "vertices that are not where IN has them"},
        {WithLine(text, "g face_", 1, "g face_1"), 1, "do not have their border"},
        {WithLine(text, "vt ", 3, "vt 0 0"), 2, "three numbers"},
        {WithLine(text, "g face_", 0, "g other"), 2, "face_N"}}) {
    std::ofstream(broken) << planted;
    const ProgramResult judged = RunProgram(verify + broken);
    EXPECT_EQ(judged.exit_status, status) << word << judged.output;
    EXPECT_THAT(judged.output, HasSubstr(word));
  }
}

TEST_F(SphereProgramsTest, AnExactPlyHoldsBothPositionsAndTheFacesOfTheInput) {
  PolygonSoup soup = *GenerateMesh("blob", {300, 2});
  for (Eigen::Vector3d& x : soup.position) x.y() *= 2.5;
  const std::string in = Write("in.obj", soup), exact = folder_.Path("exact.ply");
  ASSERT_EQ(Map(in, folder_.Path("out.obj"), "--exact=" + exact).exit_status, 0);
  const PolygonSoup refined = *ReadMesh(exact);
  ASSERT_GT(refined.position.size(), soup.position.size());
  for (std::size_t v = 0; v < soup.position.size(); ++v) {
    EXPECT_EQ(refined.position[v], soup.position[v]);
  }
  std::ifstream file(exact);
  std::string line;
  while (line != "end_header") ASSERT_TRUE(std::getline(file, line));
  for (std::size_t v = 0; v < refined.position.size(); ++v) {
    Eigen::Vector3d x, s;
    file >> x[0] >> x[1] >> x[2] >> s[0] >> s[1] >> s[2];
    EXPECT_NEAR(s.norm(), 1, 1e-15);
  }
  int face = 0, before = 0;
  for (Index f = 0; f < refined.num_polygons(); ++f) {
    int corners = 0, a = 0, b = 0, c = 0;
    before = face;
    file >> corners >> a >> b >> c >> face;
    EXPECT_TRUE(face == before || face == before + 1);
  }
  EXPECT_TRUE(file.good());
  EXPECT_EQ(face, soup.num_polygons() - 1);
}

TEST_F(SphereProgramsTest, LatitudeAndLongitudeAreTexture) {
  const PolygonSoup soup = *GenerateMesh("blob", {500, 1});
  const std::string in = Write("in.obj", soup), texture = folder_.Path("texture.obj");
  const ProgramResult mapped = Map(in, folder_.Path("out.obj"), "-latlong=" + texture);
  ASSERT_EQ(mapped.exit_status, 0) << mapped.output;
  const PolygonSoup textured = *ReadMesh(texture);
  EXPECT_EQ(textured.position, soup.position);
  ASSERT_EQ(textured.corner_texture.size(), soup.corner.size());
  for (const Eigen::Vector2d& uv : textured.texture) {
    EXPECT_TRUE(uv.y() >= 0 && uv.y() <= 1);
    EXPECT_TRUE(uv.x() >= 0 && uv.x() < 2);
  }
}

TEST_F(SphereProgramsTest, TheCertificateHasItsNumbers) {
  const std::string in = Write("in.obj", *GenerateMesh("blob", {400, 1}));
  const std::string certificate = folder_.Path("certificate.json");
  ASSERT_EQ(Map(in, folder_.Path("out.obj"), "-certificate " + certificate).exit_status, 0);
  std::ifstream file(certificate);
  const auto json = nlohmann::json::parse(file);
  EXPECT_EQ(json["outcome"], "ok");
  EXPECT_EQ(json["overlap"], "injective");
  const auto& values = json["values"];
  EXPECT_EQ(values["flipped_triangles"], 0);
  EXPECT_LE(values["centre_of_mass"], 1e-12);
  EXPECT_GE(values["delaunay_margin"], 1e-3 - 1e-9);
  EXPECT_NEAR(values["degree"], 1, 1e-12);
  EXPECT_GT(values["angle_distortion_max"], values["angle_distortion_mean"]);
  EXPECT_GT(values["quasi_conformal_mean"], 1);
  EXPECT_GE(values["pole_vertex"], 0);
}

TEST_F(SphereProgramsTest, BadOptionsAreExitStatusTwoAndLeaveNothing) {
  const std::string in = Write("in.obj", *GenerateMesh("sphere", {100, 1}));
  const std::string torus = Write("torus.obj", *GenerateMesh("torus", {400, 1}));
  const std::string out = folder_.Path("out.obj"), both = " -io " + in + " -oo " + out;
  for (const auto& [command, word] : std::map<std::string, std::string>{
           {"circle_patterns -domain=spere" + both, "did you mean 'sphere'"},
           {"circle_patterns -pole=3" + both, "takes no --pole"},
           {"circle_patterns -domain=sphere -pole=0x" + both, "pole"},
           {"circle_patterns -domain=sphere -pole=1000" + both, "no face has vertex 1000"},
           {"circle_patterns -domain=sphere -pole=-1" + both, "vertices 1 to"},
           {"circle_patterns -domain=sphere -normalization=unifrom" + both, "did you mean"},
           {"circle_patterns -domain=sphere -triangulation=inptu" + both, "did you mean"},
           {"circle_patterns -domain=sphere -layout=direction" + both, "did you mean"},
           {"circle_patterns -domain=sphere -iv cones" + both, "takes no --iv"},
           {"circle_patterns -domain=sphere -latlong=x.ply" + both, ".obj"},
           {"circle_patterns -domain=sphere -io " + in + " -oo " + folder_.Path("x.png"),
            "ply, glb"},
           {"circle_patterns -domain=sphere -io " + torus + " -oo " + out, "genus 1"},
           {"verify_map --domain=spere " + in + " " + in, "did you mean 'sphere'"},
           {"verify_map --domain=sphere --radius_tolerance=-1 " + in + " " + in, "tolerance"},
           {"verify_map --domain=sphere " + torus + " " + torus, "V - E + F = 0"},
           {"studies lorentz -points=1", "at least 4"}}) {
    const ProgramResult result = RunProgram(command);
    EXPECT_EQ(result.exit_status, 2) << command << "\n" << result.output;
    EXPECT_THAT(result.output, HasSubstr(word)) << command;
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace cirque
