// Files that are no single surface, through the program and its judge.
#include <fstream>
#include <sstream>
#include <string>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/domains/map_arrays.h"
#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ComponentsProgramTest : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& text) const {
    const std::string path = folder_.Path(name);
    std::ofstream(path) << text;
    return path;
  }

  std::string Write(const std::string& name, const PolygonSoup& soup) const {
    const std::string path = folder_.Path(name);
    EXPECT_TRUE(WriteMesh(path, soup).ok());
    return path;
  }

  ProgramResult Flatten(const std::string& in, const std::string& flags = "") const {
    return RunProgram("circle_patterns -io " + in + " -oo " + Out() + " -certificate " +
                      folder_.Path("out.json") + " " + flags);
  }

  std::string Out() const { return folder_.Path("out.obj"); }

  nlohmann::json Certificate() const {
    std::ifstream file(folder_.Path("out.json"));
    return nlohmann::json::parse(file);
  }

  void ExpectValid(const std::string& in) const {
    const ProgramResult verified = RunProgram("verify_map " + in + " " + Out());
    EXPECT_EQ(verified.exit_status, 0) << verified.output;
  }

  TemporaryFolder folder_;
};

constexpr char kTwoSquares[] =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 7 0 0\nv 7 2 0\nv 5 2 0\n"
    "f 1 2 3 4\nf 5 6 7 8\n";

TEST_F(ComponentsProgramTest, EveryComponentIsMappedAndTheAtlasKeepsTheirSizes) {
  const std::string in = Write("in.obj", kTwoSquares);
  const ProgramResult mapped = Flatten(in);
  EXPECT_EQ(mapped.exit_status, 0) << mapped.output;
  EXPECT_THAT(mapped.output, HasSubstr("components  2 mapped"));
  const PolygonSoup out = *ReadMesh(Out());
  ASSERT_EQ(out.num_polygons(), 2);
  ASSERT_EQ(out.corner.size(), 8u);  // the quadrilaterals of the file
  const auto side = [&](Index c) {
    return (out.texture[out.corner_texture[c + 1]] - out.texture[out.corner_texture[c]]).norm();
  };
  EXPECT_NEAR(side(0), 1, 1e-9);
  EXPECT_NEAR(side(4), 2, 1e-9);
  ExpectValid(in);
  const nlohmann::json certificate = Certificate();
  ASSERT_EQ(certificate["components"].size(), 2u);
  EXPECT_EQ(certificate["components"][1]["first_face"], 1);
  EXPECT_EQ(certificate["values"]["components"], 2);
  EXPECT_FALSE(certificate.contains("repair"));
}

TEST_F(ComponentsProgramTest, ACertificateOfOneComponentHasNoParts) {
  const std::string in = Write("in.obj", *GenerateMesh("bumpy_terrain", {100, 1}));
  EXPECT_EQ(Flatten(in).exit_status, 0);
  EXPECT_FALSE(Certificate().contains("components"));
  EXPECT_FALSE(Certificate()["values"].contains("components"));
}

TEST_F(ComponentsProgramTest, UvFramesScaleAndStayInTheSquare) {
  const std::string in = Write("in.obj", kTwoSquares);
  for (const auto& [flags, least, greatest] :
       {std::tuple("--uv=unit --uv_margin=0.1", 0.1, 0.9), {"--uv=scale=100", 0., 1000.}}) {
    EXPECT_EQ(Flatten(in, flags).exit_status, 0);
    double largest = 0;
    const PolygonSoup out = *ReadMesh(Out());
    for (const Eigen::Vector2d& p : out.texture) {
      EXPECT_GE(p.minCoeff(), least - 1e-9);
      EXPECT_LE(p.maxCoeff(), greatest + 1e-9);
      largest = std::max(largest, p.maxCoeff());
    }
    EXPECT_GT(largest, 0.3 * greatest);
    ExpectValid(in);
  }
  EXPECT_EQ(Flatten(in, "--uv=units").exit_status, 2);
}

TEST_F(ComponentsProgramTest, WhatIsSetAsideComesBackAndFlipsNothing) {
  // A square, a face of no area on its side, its first triangle again, a face of two vertices, and a
  // triangle that touches it in a vertex.
  const std::string in = Write("in.obj",
                               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0 0\nv 2 2 0\nv 2 1 0\n"
                               "f 1 2 3\nf 1 5 2\nf 1 3 4\nf 3 2 1\nf 3 3 6\nf 3 7 6\n");
  const ProgramResult mapped = Flatten(in);
  EXPECT_EQ(mapped.exit_status, 0) << mapped.output;
  EXPECT_THAT(mapped.output, HasSubstr("1 vertex split"));
  const PolygonSoup before = *ReadMesh(in), after = *ReadMesh(Out());
  EXPECT_EQ(after.first_corner, before.first_corner);
  EXPECT_EQ(after.corner, before.corner);
  ExpectValid(in);
  const nlohmann::json repair = Certificate()["repair"];
  EXPECT_EQ(repair["zero_area_faces"], nlohmann::json({1}));
  EXPECT_EQ(repair["duplicate_faces"], nlohmann::json({3}));
  EXPECT_EQ(repair["repeated_vertex_faces"], nlohmann::json({4}));
  EXPECT_EQ(repair["split_vertices"], nlohmann::json({2}));
  const ProgramResult refused = Flatten(in, "--repair=none");
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_THAT(refused.output, HasSubstr("--repair=safe"));
}

TEST_F(ComponentsProgramTest, MapsAsTheLibraryMapsTheSameArrays) {
  const std::string in = Write("in.obj", UncleanMesh());
  const PolygonSoup mesh = *ReadMesh(in);
  for (const std::string uv : {"as_is", "unit"}) {
    const ProgramResult mapped = Flatten(in, "--scale_pieces=each --uv=" + uv);
    ASSERT_EQ(mapped.exit_status, 0) << mapped.output;
    MapOptions options;
    ASSERT_TRUE(options.Set({{"scale_pieces", "each"}, {"uv", uv}}).ok());
    const auto by_library = MapSurface(ArraysOf(mesh), options);
    ASSERT_TRUE(by_library.ok()) << by_library.status().message();
    const PolygonSoup by_program = *ReadMesh(Out());
    EXPECT_EQ(by_program.corner, by_library->mesh.corner);
    EXPECT_EQ(by_program.texture, by_library->mesh.texture);
    EXPECT_EQ(by_program.corner_texture, by_library->mesh.corner_texture);
    ExpectValid(in);
  }
}

TEST_F(ComponentsProgramTest, UnweldedMeshesAreToldOfWeldingWhichMakesThemOne) {
  const std::string in = Write("in.obj",
                               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 1\nv 2 1 1\nv 1 "
                               "1 0\nf 1 2 3 4\nf 5 6 7 8\n");
  const ProgramResult apart = Flatten(in);
  EXPECT_THAT(apart.output, HasSubstr("--repair=weld"));
  EXPECT_EQ(Certificate()["values"]["components"], 2);
  const ProgramResult welded = Flatten(in, "--repair=weld");
  EXPECT_EQ(welded.exit_status, 0) << welded.output;
  EXPECT_THAT(welded.output, Not(HasSubstr("--repair=weld")));
  EXPECT_FALSE(Certificate().contains("components"));
  EXPECT_EQ(ReadMesh(Out())->corner, ReadMesh(in)->corner);  // the file's own vertices
  ExpectValid(in);
}

TEST_F(ComponentsProgramTest, AComponentThatFailsIsNamedAndTheOthersComeOut) {
  const PolygonSoup terrain = *GenerateMesh("bumpy_terrain", {100, 1});
  const std::string in =
      Write("in.obj", Together({terrain, *GenerateMesh("sphere", {200, 1}), terrain}));
  const ProgramResult mapped = Flatten(in, "--domain=disk");
  EXPECT_EQ(mapped.exit_status, 2);
  EXPECT_THAT(mapped.output, HasSubstr("2 mapped, 1 without a map"));
  EXPECT_THAT(mapped.output, HasSubstr("1 of 3 components without a map"));
  EXPECT_EQ(Certificate()["outcome"], "invalid_input");
  EXPECT_EQ(Certificate()["values"]["components_failed"], 1);
  EXPECT_TRUE(ReadMesh(Out()).ok());
}

TEST_F(ComponentsProgramTest, NamesOfTheFileFindTheirComponent) {
  const std::string in = Write("in.obj", Together({*GenerateMesh("bumpy_terrain", {100, 1}),
                                                   *GenerateMesh("sphere", {200, 1})}));
  const Index last = static_cast<Index>(ReadMesh(in)->position.size());
  // Four cones of pi on the sphere; the terrain is mapped as if there were no file.
  std::ostringstream cones;
  for (const Index v : {last, last - 5, last - 9, last - 20}) cones << v << " 1\n";
  const ProgramResult mapped = Flatten(in, "-iv " + Write("cones.txt", cones.str()));
  EXPECT_EQ(mapped.exit_status, 0) << mapped.output;
  const nlohmann::json parts = Certificate()["components"];
  EXPECT_EQ(parts[1]["values"]["cones"], 4);
  EXPECT_EQ(parts[0]["values"].value("cones", 0), 0);
  ExpectValid(in);
}

TEST_F(ComponentsProgramTest, WhatSeveralComponentsDoNotAllowIsSaidWithTheirSizes) {
  const PolygonSoup sphere = *GenerateMesh("sphere", {200, 1});
  const std::string in = Write("in.obj", Together({sphere, sphere}));
  const ProgramResult to_sphere = Flatten(in, "--domain=sphere");
  EXPECT_EQ(to_sphere.exit_status, 2);
  const std::string size = std::to_string(sphere.num_polygons());
  EXPECT_THAT(to_sphere.output, HasSubstr("the mesh has 2 (" + size + " faces from face 1 on, " +
                                          size + " faces from"));
  const ProgramResult metric = Flatten(in, "-oc " + folder_.Path("out.con"));
  EXPECT_EQ(metric.exit_status, 2);
  EXPECT_THAT(metric.output, HasSubstr("-oc holds the metric of one component"));
}

}  // namespace
}  // namespace cirque
