// What circle_patterns makes of users' files: read in every dress, written back as they were.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/con_file.h"
#include "cirque/io/io.h"

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/io/gzip.h"

namespace cirque {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A bulging 4 x 4 grid of quadrilaterals with all that an OBJ file can have, lines ended by `end`.
std::string Grid(const std::string& end) {
  std::string text = "# by hand" + end + "mtllib a.mtl" + end + end + "o part" + end;
  for (int v = 0; v < 25; ++v) {
    const int x = v % 5, y = v / 5;
    text += "v " + std::to_string(x) + ".0 " + std::to_string(y) + " 0." +
            std::to_string(x * (4 - x) * y * (4 - y)) + "  1 0 0" + end + "vn 0 0 1" + end;
    text += "vt 0." + std::to_string(v) + " 0" + end;
  }
  for (int q = 0; q < 20; ++q) {
    if (q % 5 == 4) continue;
    if (q == 0) text += "g left" + end + "usemtl red" + end + "s 1" + end;
    if (q == 10) text += "g right" + end + "usemtl blue" + end + "# the rest" + end;
    const auto corner = [](int v) { return std::to_string(v) + "/" + std::to_string(v); };
    text += "f " + corner(q + 1) + " " + corner(q + 2) + "/1 " + std::to_string(q + 7) + "//" +
            std::to_string(q + 7) + " " + std::to_string(q + 6 - 26) + end;
  }
  return text + "l 1 2 3" + end + "p 4" + end + "# end" + end;
}

/// The lines that are no vt, with what follows the slashes of faces cut off.
std::vector<std::string> Kept(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0, end; at < text.size(); at = end) {
    end = text.find('\n', at) + 1;
    std::string line = text.substr(at, end - at);
    if (line.starts_with("vt ")) continue;
    if (line.starts_with("f ")) {
      std::string vertices;
      bool in_vertex = true;
      for (const char c : line) {
        in_vertex = c == ' ' || c == '\r' || c == '\n' || (in_vertex && c != '/');
        if (in_vertex) vertices += c;
      }
      line = vertices;
    }
    lines.push_back(line);
  }
  return lines;
}

class FilesThroughTheProgram : public ::testing::Test {
 protected:
  ProgramResult Run(const std::string& arguments) const {
    return RunProgram("circle_patterns " + arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(FilesThroughTheProgram, OnlyTextureLinesAndFaceIndicesOfAnObjDiffer) {
  for (const std::string end : {"\n", "\r\n"}) {
    const std::string text = Grid(end);
    const std::string in = folder_.Write("in.obj", text), out = folder_.Path("out.obj");
    ASSERT_EQ(Run("-io " + in + " -oo " + out).exit_status, 0);
    const std::string written = folder_.Read("out.obj");
    EXPECT_EQ(Kept(written), Kept(text));
    const PolygonSoup before = *ReadMesh(in), after = *ReadMesh(out);
    EXPECT_EQ(after.position, before.position);
    EXPECT_EQ(after.first_corner, before.first_corner);
    EXPECT_EQ(after.corner, before.corner);
    EXPECT_EQ(after.texture.size(), 25u);
    EXPECT_NE(after.texture, before.texture);
    EXPECT_EQ(RunProgram("verify_map " + in + " " + out).exit_status, 0);
  }
}

TEST_F(FilesThroughTheProgram, AnInputIsNoOutputUnlessThatIsAskedFor) {
  const std::string text = Grid("\n");
  const std::string in = folder_.Write("in.obj", text), link = folder_.Path("link.obj");
  const std::string hard = folder_.Path("hard.obj");
  std::filesystem::create_symlink(in, link);
  std::filesystem::create_hard_link(in, hard);
  for (const std::string& arguments :
       {"-io " + in + " -oo " + in, "-io " + in + " -oo " + link, "-io " + link + " -oo " + hard,
        "-io " + in + " -oo " + folder_.path() + "/../" +
            std::filesystem::path(folder_.path()).filename().string() + "/in.obj",
        "-io " + in + " -oo " + folder_.Path("o.obj") + " -oc " + in}) {
    const ProgramResult refused = Run(arguments);
    EXPECT_EQ(refused.exit_status, 2) << arguments;
    EXPECT_THAT(refused.output, HasSubstr("--overwrite")) << arguments;
    EXPECT_EQ(folder_.Read("in.obj"), text);
  }
  ASSERT_EQ(Run("-io " + in + " -oo " + link + " --overwrite").exit_status, 0);
  EXPECT_NE(folder_.Read("in.obj"), text);
  EXPECT_EQ(Kept(folder_.Read("in.obj")), Kept(text));
}

TEST_F(FilesThroughTheProgram, MapsAreWrittenInEveryFormatThatHoldsThem) {
  const std::string in = folder_.Write("in.obj", Grid("\n"));
  for (const std::string& extension : MapExtensions()) {
    const std::string out = folder_.Path("out." + extension);
    const ProgramResult run = Run("-io " + in + " -oo " + out);
    ASSERT_EQ(run.exit_status, 0) << run.output;
    if (extension == "glb") continue;
    EXPECT_EQ(ReadMesh(out)->texture.size(), 25u) << extension;
    EXPECT_EQ(RunProgram("verify_map " + in + " " + out).exit_status, 0) << extension;
  }
  EXPECT_THAT(Run("-io " + in + " -oo " + folder_.Path("out.stl")).output,
              HasSubstr("a map is written as one of obj, off, ply, glb"));
}

TEST_F(FilesThroughTheProgram, PackedFilesAndStandardInputAreRead) {
  const std::string text = Grid("\n");
  const std::string packed = folder_.Write("in.obj.gz", testing::Gzipped(text));
  const std::string out = folder_.Path("out.obj");
  const std::string program = ProgramFolder() + "/circle_patterns -oo " + out;
  for (const std::string& command : {program + " -io " + packed, program + " -io - < " + packed,
                                     "gzip -dc " + packed + " | " + program + " -io /dev/stdin"}) {
    const ProgramResult run = RunShell("(" + command + ")");
    ASSERT_EQ(run.exit_status, 0) << run.output;
    EXPECT_EQ(Kept(folder_.Read("out.obj")), Kept(text));
    std::filesystem::remove(out);
  }
}

TEST_F(FilesThroughTheProgram, WhatIsPassedOverIsSaid) {
  const std::string in = folder_.Write("in.obj", "f 1 2\n" + Grid("\n"));
  const std::string out = folder_.Path("out.obj");
  EXPECT_THAT(Run("-io " + in + " -oo " + out).output,
              HasSubstr("warning     " + in + ":1: a face of fewer than 3 corners is ignored"));
  EXPECT_THAT(RunProgram("verify_map " + in + " " + out).output,
              AllOf(HasSubstr("warning: " + in + ":1:"), HasSubstr("warning: " + out + ":26:")));
}

TEST_F(FilesThroughTheProgram, AFileOfOptionsMayHaveCommentsAndQuotes) {
  const std::string in = folder_.Write("a mesh.obj", Grid("\n"));
  const std::string con = folder_.Path("out.con");
  const std::string options = folder_.Write(
      "all.txt", "-io \"" + in + "\"  # the input\n# -no\n-oo '" + folder_.Path("an out.obj") +
                     "'\n-oc " + con + " --con=thesis\n");
  const ProgramResult run = Run(options);
  ASSERT_EQ(run.exit_status, 0) << run.output;
  EXPECT_TRUE(std::filesystem::exists(folder_.Path("an out.obj")));
  EXPECT_THAT(folder_.Read("out.con"), Not(HasSubstr("f ")));
  EXPECT_EQ(ReadCon(con)->triangulation.num_vertices, 25);
}

TEST_F(FilesThroughTheProgram, SurfacesOfNeuroimagingBecomeObjByTheScript) {
  if (RunShell("/usr/bin/python3 -c 'import nibabel'").exit_status != 0) {
    GTEST_SKIP() << "python3-nibabel is not installed";
  }
  const auto array = [](const std::string& intent, const std::string& type, int rows,
                        const std::string& data) {
    return "<DataArray Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" + type +
           "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"2\" Dim0=\"" +
           std::to_string(rows) +
           "\" Dim1=\"3\" Encoding=\"ASCII\" Endian=\"LittleEndian\" ExternalFileName=\"\" "
           "ExternalFileOffset=\"\"><MetaData/><Data>" +
           data + "</Data></DataArray>";
  };
  const std::string surface =
      folder_.Write("a.surf.gii",
                    "<?xml version=\"1.0\" encoding=\"UTF-8\"?><GIFTI Version=\"1.0\" "
                    "NumberOfDataArrays=\"2\"><MetaData/><LabelTable/>" +
                        array("POINTSET", "FLOAT32", 4, "0 0 0 1 0 0 1 1 0.5 0 1 0") +
                        array("TRIANGLE", "INT32", 2, "0 1 2 0 2 3") + "</GIFTI>");
  const std::string obj = folder_.Path("a.obj");
  const ProgramResult run =
      RunShell(ProjectPath("experiments/scripts/surface_to_obj") + " " + surface + " " + obj);
  ASSERT_EQ(run.exit_status, 0) << run.output;
  const PolygonSoup soup = *ReadMesh(obj);
  EXPECT_EQ(soup.corner, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(soup.position[2], Eigen::Vector3d(1, 1, 0.5));
}

}  // namespace
}  // namespace cirque
