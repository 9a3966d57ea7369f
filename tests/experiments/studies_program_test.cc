// The program `studies` as a user runs it: its subcommands, their flags and refusals.
#include <iterator>
#include <regex>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(StudiesProgram, HelpNamesEveryStudyAndEachExplainsItself) {
  const ProgramResult all = RunProgram("studies --help");
  EXPECT_EQ(all.exit_status, 0);
  for (const char* name : {"strategies", "lorentz", "disk_accuracy", "random_surfaces", "any_cones",
                           "moved_texture", "slim", "reference_factorization", "lower_bound"}) {
    EXPECT_THAT(all.output, HasSubstr(name));
    const ProgramResult one = RunProgram(std::string("studies ") + name + " --help");
    EXPECT_EQ(one.exit_status, 0) << name;
    EXPECT_THAT(one.output, HasSubstr("--output")) << name;
  }
  const ProgramResult lorentz = RunProgram("studies lorentz --help");
  EXPECT_THAT(lorentz.output, HasSubstr("--points"));
  EXPECT_THAT(lorentz.output, Not(HasSubstr("--levels")));
}

TEST(StudiesProgram, RefusesWhatItDoesNotKnowWithWhatWasMeant) {
  for (const auto& [arguments, word] : std::vector<std::pair<std::string, std::string>>{
           {"", "which study?"},
           {"lorenz", "did you mean 'lorentz'"},
           {"lorentz --levels=2", "--levels is no flag of lorentz"},
           {"lorentz --pionts=9", "did you mean 'points'"},
           {"lorentz mesh.obj", "unexpected argument 'mesh.obj'"},
           {"disk_accuracy --levels=9", "1 to 8"},
           {"random_surfaces --count=0", "at least 1"},
           {"any_cones --surfaces=0", "at least 1"},
           {"moved_texture", "no mesh is given"},
           {"moved_texture --least_texels=1 a.obj", "from 2 to"},
           {"slim", "no mesh is given"},
           {"slim --most_steps=0 a.obj", "at least 1"},
           {"strategies", "no mesh given"},
           {"strategies none.obj", "none.obj"},
           {"reference_factorization", "no mesh given"},
           {"reference_factorization --repeats=0 a.obj", "from 1 on"},
           {"reference_factorization --subdivisions=-1 a.obj", "from 0 on"},
           {"reference_factorization --output=o.obj a.obj b.obj", "takes one mesh"},
           {"lower_bound a.obj", "one mesh and --output"}}) {
    const ProgramResult result = RunProgram("studies " + arguments);
    EXPECT_EQ(result.exit_status, 2) << arguments << "\n" << result.output;
    EXPECT_THAT(result.output, HasSubstr(word)) << arguments;
  }
}

// Maps that once were called ok and turned twice round a vertex (boundaries near their limits), and
// one whose solve was aborted.
TEST(StudiesProgram, SurfacesThatOnceHadFaultsHaveNone) {
  for (const int number : {203, 258, 1329, 3019, 3274, 5160, 8170, 8738}) {
    const ProgramResult result =
        RunProgram(fmt::format("studies random_surfaces --count=1 --first={}", number));
    EXPECT_EQ(result.exit_status, 0) << result.output;
    EXPECT_THAT(result.output, HasSubstr("Flags: -domain=")) << number;
  }
}

TEST(StudiesProgram, RandomSurfacesAreCountedByOutcomeAndTheSameEveryTime) {
  const ProgramResult once = RunProgram("studies random_surfaces --count=20 --first=7");
  EXPECT_EQ(once.exit_status, 0) << once.output;
  EXPECT_THAT(once.output, HasSubstr(": 20 surfaces"));
  EXPECT_THAT(once.output, HasSubstr("| domain |"));
  EXPECT_EQ(RunProgram("studies random_surfaces --count=20 --first=7").output, once.output);
}

// Every surface has a flat metric with these cones, laid out on the triangulation where it was solved.
TEST(StudiesProgram, AnyConesHaveAConformallyEquivalentFlatMetric) {
  const ProgramResult result = RunProgram("studies any_cones --surfaces=60");
  EXPECT_EQ(result.exit_status, 0) << result.output;
  for (const std::string way : {"equivalence, on its own triangulation", "equivalence, exact",
                                "circle pattern, ladder, exact"}) {
    const std::regex none_left("\\| " + way + R"( \| (\d+) \| (\d+) \| 0 \| - \|)");
    std::smatch found;
    ASSERT_TRUE(std::regex_search(result.output, found, none_left)) << way << result.output;
    EXPECT_EQ(found[1], found[2]);
    EXPECT_GT(std::stoi(found[1]), 40);
  }
}

TEST(StudiesProgram, AMovedTextureIsTheOneBakedThereButForReadingBetweenTexels) {
  const TemporaryFolder folder;
  ASSERT_TRUE(WriteMesh(folder.Path("cap.obj"), *GenerateMesh("spherical_cap", {300, 1})).ok());
  const ProgramResult result = RunProgram(
      "studies moved_texture --least_texels=64 --most_texels=128 " + folder.Path("cap.obj"));
  EXPECT_EQ(result.exit_status, 0) << result.output;
  const std::regex row(
      R"(equivalence \| (\d+) \| (\d+) \| ([0-9.e-]+) \| [0-9.e-]+ \| ([0-9.e-]+) \|)");
  std::vector<double> largest, mean;
  for (auto at = std::sregex_iterator(result.output.begin(), result.output.end(), row);
       at != std::sregex_iterator(); ++at) {
    largest.push_back(std::stod((*at)[3]));
    mean.push_back(std::stod((*at)[4]));
    EXPECT_GT(std::stoi((*at)[2]), 1000);
  }
  ASSERT_EQ(mean.size(), 2u) << result.output;
  EXPECT_GT(mean[0], 0);
  EXPECT_LT(mean[1], 0.5 * mean[0]);
  EXPECT_LT(largest[1], 0.2);
}

// Re-centred, Newton's method does not care how close to one another the points are.
TEST(StudiesProgram, LorentzConvergesAtEveryScaleWhereTheThesisLeavesTheBall) {
  const ProgramResult result = RunProgram("studies lorentz --points=50");
  EXPECT_EQ(result.exit_status, 0);
  const std::regex converged(R"(\| 1e[+-]\d\d \| \d+ \| [0-9.e-]+ \| converged \|)");
  const auto first = std::sregex_iterator(result.output.begin(), result.output.end(), converged);
  EXPECT_EQ(std::distance(first, std::sregex_iterator()), 13) << result.output;
  EXPECT_THAT(result.output, HasSubstr("left the ball"));
}

}  // namespace
}  // namespace cirque
