// Every file of ../shared/cases, or of the folder that CIRQUE_CASES names: small inputs that once gave
// a wrong result, no result, or no end. Skipped where the folder is missing. What each stands for has a
// test of its own, that needs no files, beside the code that it is about.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/io/io.h"

#include "tests/common/paths.h"
#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

namespace fs = std::filesystem;

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr double kIsometric = 1 + 1e-9;

/// What circle_patterns is to make of a file. In arguments % is the folder.
struct MappedCase {
  std::string file, arguments;
  double most_mean = kAny;  ///< of the quasi-conformal distortion
  std::vector<std::string> says;
};

const std::vector<MappedCase>& MappedCases() {
  static const std::vector<MappedCase> kCases = {
      {"concavequad.obj", "", kIsometric, {}},
      {"L3.obj", "", kIsometric, {}},
      {"ngon1000.obj", "", kIsometric, {}},
      {"flat.obj", "", kIsometric, {}},
      {"rect4.obj", "-domain=rectangle -corners=1,5,25,21", kIsometric, {"conformal modulus 3,"}},
      {"cup32.obj", "", 2, {}},
      {"cup32.obj", "-ie %/cup.cut", kIsometric, {}},
      {"cup32.obj", "-ie %/cup.cut --seams=free", kIsometric, {}},
      {"ico_hole1.obj", "", 1.2, {}},
      {"mirror.ply", "", 2.44, {}},
      {"20mm-xyz-cube.stl", "", 1.12, {}},
      {"square8.obj", "", kIsometric, {}},
      {"square8.obj", "-domain=disk", 2, {}},
      {"mirror_reversed_out-in.obj", "", 1.05, {}},
      {"vt_rotated-in.obj", "", 1.05, {}},
      {"F4-mesh.obj", "", 1.05, {}},
      {"fan-506.obj", "", 1.5, {"made with cones"}},
      {"F9-face-order-base.obj", "", 2, {}},
      {"ear.obj", "", 1.1, {}},
      {"g60.obj", "", 1.01, {}},
      {"s1e160.obj", "", 1.05, {}},
      {"F1-coordinates-1e155.obj", "", 1.2, {}},
      {"F1b-needle-triangle.obj", "", kAny, {"0 flipped triangles"}},
      {"F1b-needle-triangle.obj", "--layout=least_squares", kAny, {"0 flipped triangles"}},
      {"materials.obj", "", 1.05, {}},
      {"cube.obj", "", kIsometric, {}},
      {"wall12.obj", "", kIsometric, {}},
      {"quad.obj", "-domain=rectangle", kIsometric, {"conformal modulus 1,"}},
      {"doublet.obj", "", 1.1, {}},
      {"doublet_uv.obj", "", 1.3, {}},
      {"doublesided.obj", "", kIsometric, {}},
      {"ico2.obj", "", 1.15, {}},
      {"ico2.obj", "-cut_paths 1-4", 1.3, {}},
      {"ico2.obj", "-iv %/cones6digits.txt", 1.4, {"3 rounded by up to", "miss Gauss-Bonnet by"}},
      {"ico_two.obj", "", 1.15, {"2 mapped, 0 without a map"}},
      {"unwelded.obj", "", kIsometric, {"72 mapped", "--repair=weld joins it"}},
      {"unwelded.obj", "--repair=weld", 1.05, {"167 vertices welded"}},
      {"cube_unwelded.obj", "", kIsometric, {"6 mapped"}},
      {"cube_unwelded.obj", "--repair=weld", kIsometric, {"16 vertices welded", "8 cones"}},
      {"bowtie.obj", "", 1.05, {"1 vertex split", "2 mapped"}},
      {"tjunc.obj", "", kIsometric, {"2 vertices split", "1 T-junction"}},
      {"dupface.obj", "", 1.05, {"1 face set aside"}},
      {"degen.stl", "", 1.05, {"1 face with a vertex twice set aside"}},
      {"zeroarea.obj", "", kIsometric, {"1 face of no area set aside"}},
      {"modelnet.off", "", 1.05, {}},
      {"trailing.off", "", 1.05, {"more follows than the header promises"}},
      {"edges2.off", "", 1.05, {"a face of fewer than 3 corners is ignored"}},
      {"upper_block.stl", "", kIsometric, {}},
      {"endsolid_sp.stl", "", 1.05, {}},
      {"bintrail.stl", "", 1.05, {"behind the announced triangles, 1 byte, is ignored"}},
      {"tristrips.ply", "", 1.05, {}},
      {"nofmtcomment.ply", "", 1.05, {"a line of the header"}},
      {"badvt.obj", "", 1.05, {"texture coordinate index 49"}},
      {"vt_empty.obj", "", 1.05, {"'vt' without numbers"}},
      {"zerovn.obj", "", 1.05, {"the corner has none"}},
      {"utf16.obj", "", 1.05, {"UTF-16"}},
      {"gz.obj.gz", "", 1.05, {}},
      {"tri.obj", "-domain=half_plane", kIsometric, {}},
      {"ico2_xatlas.obj", "", 1.15, {}},
      {"notconverged-1329-openscad_component.obj", "", kAny, {}},
      {"infeasible-31-b9_component.obj", "", 1.06, {}},
      {"unrepresentable-2670-SaraPezzini_component.obj", "", 1.3, {"made with cones"}}};
  return kCases;
}

/// A command whose end and words are known. In it % is the folder, @ one to write into.
struct CommandCase {
  std::string command;
  int exit_status;
  std::vector<std::string> says;
};

const std::vector<CommandCase>& CommandCases() {
  static const std::vector<CommandCase> kCases = {
      {"circle_patterns %/msvc_ind_z.obj @/o.obj", 2, {"not finite: 25", "msvc_ind_z.obj:25"}},
      {"verify_map %/ico2.obj %/ico2_ind.obj",
       1,
       {"5 triangles with texture coordinates that are not finite"}},
      {"verify_map %/mirror_reversed_out-in.obj %/mirror_reversed_out-out.obj", 1, {"INVALID"}},
      {"verify_map --require_injective --require_rigid_seams %/vt_rotated-in.obj "
       "%/vt_rotated-out.obj",
       0,
       {"torn: 18 patches of 1 component"}},
      {"verify_map --max_patches=1 %/vt_rotated-in.obj %/vt_rotated-out.obj", 1, {"1 allowed"}},
      {"verify_map --infeasible %/F4-own-target.json %/F4-mesh.obj", 3, {"NOT PROVEN"}},
      {"verify_map %/ico2.obj %/ico2_xatlas.obj", 0, {"valid"}},
      {"verify_map %/doublet_uv.obj %/doublet_uv.obj", 0, {"valid (injective)"}},
      {"run_experiment --dry_run %/F2-yaml-endless-documents.yaml", 2, {"F2-yaml"}},
      {"run_experiment --dry_run %/F5-map-as-value.yaml", 2, {"F5-map-as-value.yaml:3"}},
      {"run_experiment --dry_run @/F6-symlink-loop.yaml", 2, {"F6-symlink-loop.yaml:2"}},
      {"circle_patterns %/F3-race-stacked-1098.obj @/o.obj --threads=2", 0, {"ladder"}},
      {"circle_patterns %/F3-race-stacked-1098.obj @/o.obj --exact=@/x.obj", 0, {"exact"}},
      {"verify_map --exact %/F3-race-stacked-1098.obj @/x.obj", 0, {"valid"}},
      {"circle_patterns @/opt1.txt", 0, {"opt.obj"}},
      {"circle_patterns @/opt2.txt", 0, {"opt.obj"}},
      {"circle_patterns @/materials.obj @/materials.obj", 2, {"--overwrite"}}};
  return kCases;
}

std::string Replaced(std::string text, char mark, const std::string& by) {
  for (std::size_t at = text.find(mark); at != std::string::npos;
       at = text.find(mark, at + by.size())) {
    text.replace(at, 1, by);
  }
  return text;
}

class SharedCases : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* named = std::getenv("CIRQUE_CASES");
    cases_ = named ? named : ProjectPath("../shared/cases");
    if (!fs::is_directory(cases_)) GTEST_SKIP() << cases_ << " is not there";
  }

  void ExpectMapped(const MappedCase& of) const {
    SCOPED_TRACE(of.file + " " + of.arguments);
    const std::string in = cases_ + "/" + of.file, out = folder_.Path("out.obj");
    const std::string certificate = folder_.Path("out.json");
    const ProgramResult run =
        RunProgram("circle_patterns " + in + " " + out + " --certificate=" + certificate + " " +
                   Replaced(of.arguments, '%', cases_));
    ASSERT_EQ(run.exit_status, 0) << run.output;
    for (const std::string& words : of.says) EXPECT_THAT(run.output, HasSubstr(words));
    EXPECT_EQ(run.output.find("nan"), std::string::npos) << run.output;
    const auto values = nlohmann::json::parse(folder_.Read("out.json"))["values"];
    if (of.most_mean < kAny) {
      EXPECT_LE(values["quasi_conformal_mean"], of.most_mean);
    }
    const ProgramResult judged = RunProgram("verify_map " + in + " " + out);
    EXPECT_EQ(judged.exit_status, 0) << judged.output;
  }

  /// Shares of the table, so that no test takes long.
  void ExpectMappedFrom(double begin, double end) const {
    const auto& all = MappedCases();
    const auto size = static_cast<double>(all.size());
    for (auto i = static_cast<std::size_t>(begin * size); i < static_cast<std::size_t>(end * size);
         ++i) {
      ExpectMapped(all[i]);
    }
  }

  TemporaryFolder folder_;
  std::string cases_;
};

TEST_F(SharedCases, TheFirstThirdIsMapped) { ExpectMappedFrom(0, 1. / 3); }
TEST_F(SharedCases, TheSecondThirdIsMapped) { ExpectMappedFrom(1. / 3, 2. / 3); }
TEST_F(SharedCases, TheLastThirdIsMapped) { ExpectMappedFrom(2. / 3, 1); }

TEST_F(SharedCases, CommandsEndAsTheyShould) {
  for (const char* name :
       {"opt1.txt", "opt2.txt", "ear.obj", "materials.obj", "F6-symlink-loop.yaml"}) {
    fs::copy_file(cases_ + "/" + name, folder_.Path(name));
  }
  fs::create_directory_symlink("loop", folder_.Path("loop"));
  for (const CommandCase& of : CommandCases()) {
    const std::string command = Replaced(Replaced(of.command, '%', cases_), '@', folder_.path());
    const ProgramResult run =
        RunShell("cd " + folder_.path() + " && " + ProgramFolder() + "/" + command);
    EXPECT_EQ(run.exit_status, of.exit_status) << command << "\n" << run.output;
    for (const std::string& words : of.says) EXPECT_THAT(run.output, HasSubstr(words)) << command;
  }
  EXPECT_TRUE(fs::exists(folder_.Path("opt.obj")));
}

TEST_F(SharedCases, FacesRenumberedGiveTheSameMap) {
  std::vector<PolygonSoup> maps;
  for (const char* name : {"base", "renumbered"}) {
    const std::string out = folder_.Path(std::string(name) + ".obj");
    ASSERT_EQ(RunProgram("circle_patterns " + cases_ + "/F9-face-order-" + name + ".obj " + out)
                  .exit_status,
              0);
    maps.push_back(*ReadMesh(out));
  }
  const auto sides = [](const PolygonSoup& map) {
    std::vector<double> lengths;
    for (std::size_t c = 0; c < map.corner.size(); ++c) {
      const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
      lengths.push_back(
          (map.texture[map.corner_texture[c]] - map.texture[map.corner_texture[next]]).norm());
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
  };
  const std::vector<double> before = sides(maps[0]), after = sides(maps[1]);
  ASSERT_EQ(before.size(), after.size());
  EXPECT_GT(before.front(), 0);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(after[i], before[i], 1e-6 * before.back());
  }
}

TEST_F(SharedCases, NoFileIsForgotten) {
  std::string known = "README.md F9-face-order-renumbered.obj ear.obj";
  for (const MappedCase& of : MappedCases()) known += " " + of.file + " " + of.arguments;
  for (const CommandCase& of : CommandCases()) known += " " + of.command;
  for (const auto& entry : fs::directory_iterator(cases_)) {
    EXPECT_THAT(known, HasSubstr(entry.path().filename().string()));
  }
}

}  // namespace
}  // namespace cirque
