// The programs as a user runs them, on files.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/energy/angle_constraints.h"
#include "cirque/generators/generators.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/con_file.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class ProgramsTest : public ::testing::Test {
 protected:
  /// Writes a mesh into the test's folder and returns its path.
  std::string Write(const std::string& name, const PolygonSoup& soup) const {
    const std::string path = folder_.Path(name);
    EXPECT_TRUE(WriteMesh(path, soup).ok());
    return path;
  }

  std::string WriteSurface(const std::string& name, const Surface& surface) const {
    PolygonSoup soup;
    soup.position = surface.position;
    soup.corner = surface.triangulation.vertex;
    for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
      soup.first_corner.push_back(3 * f + 3);
    }
    return Write(name, soup);
  }

  ProgramResult Flatten(const std::string& in, const std::string& out,
                        const std::string& flags = "") const {
    return RunProgram("circle_patterns -io " + in + " -oo " + out + " " + flags);
  }

  TemporaryFolder folder_;
};

TEST_F(ProgramsTest, FlagsByTheirOldNamesWorkAndSayOnceWhatTheyAreCalledNow) {
  const std::string in = Write("in.obj", *GenerateMesh("bumpy_terrain", {100, 1}));
  const ProgramResult mapped = Flatten(
      in, folder_.Path("out.obj"), "-angle_fit=entropy --angle_strategy dual --strategy=newton");
  EXPECT_EQ(mapped.exit_status, 0) << mapped.output;
  for (const char* note : {"note: --angle_fit is called --angle_objective now\n",
                           "note: --angle_strategy is called --angle_solver now\n",
                           "note: --strategy is called --radii_solver now\n"}) {
    const std::size_t first = mapped.output.find(note);
    ASSERT_NE(first, std::string::npos) << mapped.output;
    EXPECT_EQ(mapped.output.find(note, first + 1), std::string::npos);
  }
  const ProgramResult refused = Flatten(in, folder_.Path("out.obj"), "--strategy=newtn");
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_THAT(refused.output, HasSubstr("did you mean 'newton'?"));
}

TEST_F(ProgramsTest, AMapOfEveryReadableFormatIsVerified) {
  const PolygonSoup soup = *GenerateMesh("bumpy_terrain", {400, 1});
  for (const char* name : {"in.obj", "in.off", "in.ply"}) {
    const std::string in = Write(name, soup), out = folder_.Path("out.obj");
    const ProgramResult flattened = Flatten(in, out);
    EXPECT_EQ(flattened.exit_status, 0) << flattened.output;
    const ProgramResult verified = RunProgram("verify_map " + in + " " + out);
    EXPECT_EQ(verified.exit_status, 0) << verified.output;
    EXPECT_THAT(verified.output, EndsWith("verdict: valid (injective), 1 patch, 0 seam edges\n"));
  }
}

TEST_F(ProgramsTest, OutputKeepsTheOrderOfVerticesAndFaces) {
  PolygonSoup soup = *GenerateMesh("enneper_patch", {200, 2});
  soup.position.insert(soup.position.begin(), Eigen::Vector3d(9, 9, 9));  // isolated
  for (Index& v : soup.corner) ++v;
  const std::string in = Write("in.obj", soup), out = folder_.Path("out.obj");
  ASSERT_EQ(Flatten(in, out).exit_status, 0);
  const PolygonSoup written = *ReadMesh(out);
  EXPECT_EQ(written.position, soup.position);
  EXPECT_EQ(written.corner, soup.corner);
  EXPECT_EQ(written.texture.size(), soup.position.size() - 1);
}

TEST_F(ProgramsTest, ConesFixedAndRangedAreMet) {
  const std::string in = Write("in.obj", *GenerateMesh("bumpy_terrain", {300, 1}));
  const Surface surface = GeneratedSurface("bumpy_terrain", 300);
  const std::vector<bool> boundary = BoundaryVertices(surface.triangulation);
  const auto inner = std::find(boundary.begin(), boundary.end(), false) - boundary.begin();
  for (const std::string range : {"1.8", "1.7 1.9"}) {
    const std::string cones = folder_.Path("cones"), out = folder_.Path("out.obj");
    std::ofstream(cones) << inner + 1 << " " << range << "\n";
    const ProgramResult flattened = Flatten(in, out, "-iv " + cones);
    EXPECT_EQ(flattened.exit_status, 0) << flattened.output;
    EXPECT_THAT(flattened.output, HasSubstr("1 cone,"));
    const ProgramResult verified = RunProgram("verify_map " + in + " " + out);
    EXPECT_EQ(verified.exit_status, 0) << verified.output;
  }
}

TEST_F(ProgramsTest, MeasuresOfTheProgramAreThoseOfItsFiles) {
  const std::string in = Write("in.obj", *GenerateMesh("torus", {500, 1}));
  const std::string out = folder_.Path("out.obj"), own = folder_.Path("own.json");
  const std::string colours = folder_.Path("own.ply");
  const ProgramResult flattened = Flatten(in, out, "--measures=" + own + "," + colours);
  ASSERT_EQ(flattened.exit_status, 0) << flattened.output;
  EXPECT_THAT(flattened.output, HasSubstr("measures    " + own));
  EXPECT_EQ(ReadMesh(colours)->corner, ReadMesh(in)->corner);
  const std::string checked = folder_.Path("checked.json");
  const ProgramResult verified =
      RunProgram("verify_map " + in + " " + out + " --measures=" + checked);
  ASSERT_EQ(verified.exit_status, 0) << verified.output;
  EXPECT_THAT(verified.output, HasSubstr("symmetric_dirichlet"));
  const auto a = nlohmann::json::parse(std::ifstream(own))["measures"];
  const auto b = nlohmann::json::parse(std::ifstream(checked))["measures"];
  EXPECT_GT(a.size(), 25u);
  EXPECT_GT(a["cut_length"], 1);
  for (const auto& [name, value] : a.items()) {
    const double expected = value;
    EXPECT_NEAR(b[name].get<double>(), expected, 1e-9 * (1 + std::abs(expected))) << name;
  }
  EXPECT_EQ(Flatten(in, out, "--measures=a.txt").exit_status, 2);
}

TEST_F(ProgramsTest, FilledHolesAreNotInTheOutput) {
  const std::string in = Write("in.obj", *GenerateMesh("annulus", {400, 1}));
  const std::string out = folder_.Path("out.obj");
  const ProgramResult flattened = Flatten(in, out, "-fill_holes");
  EXPECT_EQ(flattened.exit_status, 0) << flattened.output;
  EXPECT_THAT(flattened.output, HasSubstr("1 holes filled"));
  EXPECT_EQ(ReadMesh(out)->corner, ReadMesh(in)->corner);
  EXPECT_EQ(RunProgram("verify_map " + in + " " + out).exit_status, 0);
}

TEST_F(ProgramsTest, TheFlatMetricIsWrittenAsCon) {
  const std::string in = Write("in.obj", *GenerateMesh("spherical_cap", {300, 1}));
  const std::string con = folder_.Path("out.con");
  ASSERT_EQ(Flatten(in, folder_.Path("out.obj"), "-oc " + con).exit_status, 0);
  const StatusOr<ConMesh> flat = ReadCon(con);
  ASSERT_TRUE(flat.ok()) << flat.status().message();
  const Triangulation& t = flat->triangulation;
  const CornerAngles angles = MeasureCornerAngles(t, flat->lengths);
  const AngleConstraints constraints(t, FreeBoundaryTargets(t));
  const Eigen::VectorXd sums = constraints.Apply(angles.value);
  for (int row = t.num_faces(); row < sums.size(); ++row) EXPECT_NEAR(sums[row], 2 * kPi, 1e-9);
}

TEST_F(ProgramsTest, RefinedMapsAndOpenedSurfacesAreVerified) {
  const std::string in = Write("in.obj", *GenerateMesh("double_torus", {800, 1}));
  const std::string out = folder_.Path("out.obj");
  const auto distortion = [&](const std::string& flags) {
    const ProgramResult mapped =
        Flatten(in, out, flags + " --certificate=" + folder_.Path("out.certificate.json"));
    EXPECT_EQ(mapped.exit_status, 0) << mapped.output;
    const ProgramResult verified = RunProgram("verify_map --json " + in + " " + out);
    EXPECT_EQ(verified.exit_status, 0) << verified.output;
    const auto certificate = nlohmann::json::parse(folder_.Read("out.certificate.json"));
    EXPECT_GT(certificate["values"]["visible_cut_length"].get<double>(), 0);
    return certificate["values"]["quasi_conformal_mean"].get<double>();
  };
  const double plain = distortion("--refine_map=none"),
               refined = distortion("--refine_map=mips:steps=3");
  EXPECT_LT(refined, plain);
  EXPECT_LT(distortion("--seams=free --refine_map=quasi_conformal"), refined);
  const ProgramResult half_plane = Flatten(in, out, "--domain=half_plane --cones=greedy");
  EXPECT_EQ(half_plane.exit_status, 2);
  EXPECT_THAT(half_plane.output, HasSubstr("takes no --cones"));
  for (const char* flag : {" --refine_map=mips", " --seams=free"}) {
    const ProgramResult layout = RunProgram("circle_patterns -ic x.con -no -oo " + out + flag);
    EXPECT_EQ(layout.exit_status, 2);
    EXPECT_THAT(layout.output, HasSubstr("leave out -refine_map"));
  }
}

TEST_F(ProgramsTest, FromObjToConToTheSameMap) {
  const std::string in = Write("in.obj", *GenerateMesh("blob", {500, 1}));
  const std::string con = folder_.Path("flat.con"), direct = folder_.Path("direct.obj");
  // The metric is that of the circle pattern, the map would be refined.
  ASSERT_EQ(Flatten(in, direct, "-triangulation input -refine_map none -oc " + con).exit_status, 0);
  const std::string again = folder_.Path("again.obj");
  const ProgramResult laid_out = RunProgram("circle_patterns -ic " + con + " -no -oo " + again);
  ASSERT_EQ(laid_out.exit_status, 0) << laid_out.output;
  // The same triangles up to a motion of the one patch: distances to a far corner agree.
  const PolygonSoup a = *ReadMesh(direct), b = *ReadMesh(again);
  ASSERT_EQ(a.corner_texture.size(), b.corner_texture.size());
  const auto point = [](const PolygonSoup& soup, std::size_t corner) {
    return soup.texture[soup.corner_texture[corner]];
  };
  for (std::size_t corner = 1; corner < a.corner_texture.size(); ++corner) {
    const double wanted = (point(a, corner) - point(a, 0)).norm();
    EXPECT_NEAR((point(b, corner) - point(b, 0)).norm(), wanted, 1e-8 * (1 + wanted));
  }
}

TEST_F(ProgramsTest, AMetricIsSolvedAnew) {
  const std::string in = Write("in.obj", *GenerateMesh("spherical_cap", {300, 1}));
  const std::string flat = folder_.Path("flat.con"), anew = folder_.Path("anew.con");
  ASSERT_EQ(Flatten(in, folder_.Path("out.obj"), "-oc " + flat).exit_status, 0);
  // A flat Delaunay metric stays as it is, up to scale.
  const ProgramResult result =
      RunProgram("circle_patterns -epsilon 1e-9 -ic " + flat + " -oc " + anew);
  ASSERT_EQ(result.exit_status, 0) << result.output;
  const ConMesh before = *ReadCon(flat), after = *ReadCon(anew);
  ASSERT_EQ(after.triangulation.vertex, before.triangulation.vertex);
  const Eigen::VectorXd ratio = after.lengths.value.cwiseQuotient(before.lengths.value);
  EXPECT_LT(ratio.maxCoeff() / ratio.minCoeff() - 1, 1e-7);
}

TEST_F(ProgramsTest, OptionsMayStandInOneFile) {
  const std::string in = Write("in.obj", *GenerateMesh("bumpy_terrain", {200, 1}));
  const std::string out = folder_.Path("out.obj"), options = folder_.Path("options.txt");
  std::ofstream(options) << "-io " << in << "\n-oo " << out << "\n-triangulation input\n";
  EXPECT_EQ(RunProgram("circle_patterns " + options).exit_status, 0);
  EXPECT_EQ(RunProgram("verify_map " + in + " " + out).exit_status, 0);
  std::ofstream(options) << "-oi " << in << "\n";
  const ProgramResult refused = RunProgram("circle_patterns " + options);
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_THAT(refused.output, HasSubstr("did you mean"));
}

TEST_F(ProgramsTest, APlantedFlipIsAnInvalidMap) {
  const std::string in = Write("in.obj", *GenerateMesh("bumpy_terrain", {300, 1}));
  const std::string out = folder_.Path("out.obj");
  ASSERT_EQ(Flatten(in, out).exit_status, 0);
  PolygonSoup map = *ReadMesh(out);
  const Index* corner = &map.corner_texture[3 * 17];
  std::swap(map.texture[corner[0]], map.texture[corner[1]]);
  const std::string broken = Write("broken.obj", map);
  const ProgramResult verified = RunProgram("verify_map " + in + " " + broken);
  EXPECT_EQ(verified.exit_status, 1);
  EXPECT_THAT(verified.output, HasSubstr("INVALID"));
}

TEST_F(ProgramsTest, AnInfeasibleMeshLeavesAProofThatVerifies) {
  const std::string in = WriteSurface("in.obj", Kleetope(GeneratedSurface("bumpy_terrain", 200)));
  const std::string out = folder_.Path("out.obj"), proof = folder_.Path("out.certificate.json");
  const ProgramResult flattened = Flatten(in, out, "-triangulation input");
  EXPECT_EQ(flattened.exit_status, 3) << flattened.output;
  EXPECT_THAT(flattened.output, HasSubstr("no coherent angles exist"));
  EXPECT_FALSE(std::filesystem::exists(out));
  const ProgramResult verified = RunProgram("verify_map --infeasible " + proof + " " + in);
  EXPECT_EQ(verified.exit_status, 0) << verified.output;
  // The same proof says nothing about another mesh.
  const std::string other =
      WriteSurface("other.obj", Kleetope(GeneratedSurface("bumpy_terrain", 200, 2)));
  EXPECT_NE(RunProgram("verify_map --infeasible " + proof + " " + other).exit_status, 0);
}

TEST_F(ProgramsTest, ACertificateHasItsNumbers) {
  const std::string in = Write("in.obj", *GenerateMesh("spherical_cap", {300, 1}));
  const std::string certificate = folder_.Path("certificate.json");
  ASSERT_EQ(Flatten(in, folder_.Path("out.obj"), "-certificate " + certificate).exit_status, 0);
  std::ifstream file(certificate);
  const auto json = nlohmann::json::parse(file);
  EXPECT_EQ(json["outcome"], "ok");
  EXPECT_LE(json["values"]["radii_gradient"], 1e-9);
  EXPECT_LE(json["values"]["radii_gap"], 1e-8);
  EXPECT_EQ(json["values"]["flipped_triangles"], 0);
  EXPECT_GT(json["values"]["quasi_conformal_mean"], 1);
}

TEST_F(ProgramsTest, BadInputIsExitStatusTwoAndLeavesNothing) {
  const std::string in = Write("in.obj", *GenerateMesh("sphere", {100, 1}));
  const std::string out = folder_.Path("out.obj");
  for (const auto& [command, word] : std::map<std::string, std::string>{
           {"circle_patterns -oi " + in, "did you mean"},
           {"circle_patterns -oo " + out, "no mesh is given"},
           {"circle_patterns -io " + in + " -oo " + out + " -triangulation inptu", "did you mean"},
           {"circle_patterns -io " + folder_.Path("none.obj") + " -oo " + out, "none.obj"},
           {"circle_patterns -io " + in + " -oo " + folder_.Path("x.png"),
            "one of obj, off, ply, glb"},
           {"circle_patterns -io " + in + " -oo " + out + " -epsilon many", "epsilon"},
           {"verify_map " + in, "1 file given"},
           {"verify_map " + in + " " + folder_.Path("none.obj"), "none.obj"},
           {"run_experiment " + folder_.Path("none.yaml"), "none.yaml"}}) {
    const ProgramResult result = RunProgram(command);
    EXPECT_EQ(result.exit_status, 2) << command << "\n" << result.output;
    EXPECT_THAT(result.output, HasSubstr(word)) << command;
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(ProgramsTest, SeamlessMapsTurnByRightAnglesAcrossEverySeam) {
  const std::string in = Write("double.obj", DoubleTorus({1500, 1})), out = folder_.Path("out.obj");
  const std::string verify = "verify_map " + in + " " + out + " --require_seam_rotations=4";
  ASSERT_EQ(RunProgram("circle_patterns " + in + " " + out).exit_status, 0);
  EXPECT_EQ(RunProgram(verify).exit_status, 1);
  const ProgramResult made = RunProgram("circle_patterns " + in + " " + out + " --holonomy=pi/2");
  ASSERT_EQ(made.exit_status, 0) << made.output;
  EXPECT_THAT(made.output, HasSubstr("rotations   4 along loops, to "));
  const ProgramResult verified = RunProgram(verify);
  EXPECT_EQ(verified.exit_status, 0) << verified.output;
}

TEST_F(ProgramsTest, HelpIsShownWithStatusZero) {
  for (const char* program : {"circle_patterns", "verify_map", "run_experiment"}) {
    const ProgramResult result = RunProgram(std::string(program) + " --help");
    EXPECT_EQ(result.exit_status, 0);
    EXPECT_THAT(result.output, HasSubstr(program));
  }
}

}  // namespace
}  // namespace cirque
