// Meshes of a config by collection and condition.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "experiments/run_experiment/config/config.h"
#include "experiments/run_experiment/config/mesh_condition.h"
#include "experiments/run_experiment/config/mesh_sources.h"
#include "experiments/run_experiment/run/mesh_files.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// Whether it holds of a torus with a hole, of 1000 triangles.
bool Holds(const std::string& text) {
  const StatusOr<MeshCondition> condition = ParseMeshCondition(text);
  EXPECT_TRUE(condition.ok()) << text << ": " << condition.status().message();
  return condition.ok() && (*condition)({1000, 501, 1, 1, 1});
}

std::string Refusal(const std::string& text) { return ParseMeshCondition(text).status().message(); }

TEST(MeshCondition, ComparesFactsWithNumbersAndEachOther) {
  EXPECT_TRUE(Holds("triangles == 1000"));
  EXPECT_TRUE(Holds("1e3<=triangles"));
  EXPECT_FALSE(Holds("triangles > 1000"));
  EXPECT_TRUE(Holds("vertices < triangles"));
  EXPECT_TRUE(Holds("genus != 2"));
  EXPECT_FALSE(Holds("loops == 0"));
  EXPECT_TRUE(Holds("components >= 1"));
}

TEST(MeshCondition, OrBindsLeastAndNotMost) {
  EXPECT_TRUE(Holds("genus == 1 or genus == 2 and loops == 0"));
  EXPECT_FALSE(Holds("(genus == 1 or genus == 2) and loops == 0"));
  EXPECT_FALSE(Holds("not genus == 1 and loops == 1"));
  EXPECT_TRUE(Holds("not (genus == 1 and loops == 0)"));
  EXPECT_TRUE(Holds("not not genus == 1"));
}

TEST(MeshCondition, SaysWhereItIsWrong) {
  EXPECT_THAT(Refusal("triangels > 1"), HasSubstr("did you mean 'triangles'"));
  EXPECT_THAT(Refusal("triangles = 1"), HasSubstr("at '='"));
  EXPECT_THAT(Refusal("triangles >"), HasSubstr("at the end"));
  EXPECT_THAT(Refusal("(genus == 1"), HasSubstr("')'"));
  EXPECT_THAT(Refusal("genus == 1 loops == 2"), HasSubstr("at 'loops'"));
  EXPECT_THAT(Refusal("genus == 1e999"), HasSubstr("at '1e999'"));
  EXPECT_THAT(Refusal(""), HasSubstr("at the end"));
}

/// Files of three surfaces and of none, in two folders, two with one name.
class CorpusTest : public ::testing::Test {
 protected:
  CorpusTest() {
    Put("meshes/a/ball.obj", "sphere");
    Put("meshes/b/ball.off", "sphere");
    Put("meshes/b/ring.ply", "torus");
    Put("meshes/cap.obj", "hemisphere");
    folder_.Write("meshes/points.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
    folder_.Write("meshes/notes.md", "no mesh\n");
  }

  void Put(const std::string& path, const std::string& generator) {
    folder_.Write(path, "");
    const auto mesh = (*MeshGenerators().Find(generator))({200, 1});
    ASSERT_TRUE(WriteMesh(folder_.Path(path), mesh).ok());
  }

  StatusOr<ExperimentConfig> Load(const std::string& entry) {
    return LoadConfig(folder_.Write(
        "a.yaml", "question: which?\nmeshes:\n  - " + entry + "\nmethods:\n  - name: m\n"));
  }

  std::vector<std::string> Names(const std::string& entry) {
    const StatusOr<ExperimentConfig> config = Load(entry);
    EXPECT_TRUE(config.ok()) << config.status().message();
    std::vector<std::string> names;
    if (!config.ok()) return names;
    for (const PlannedRun& run : config->runs) names.push_back(run.mesh.name);
    return names;
  }

  TemporaryFolder folder_;
};

TEST_F(CorpusTest, IsAFolderAndItsFolders) {
  EXPECT_THAT(Names("{corpus: meshes}"), ElementsAre("a-ball", "b-ball", "ring", "cap", "points"));
}

TEST_F(CorpusTest, IsSelectedByTopologyAndSize) {
  EXPECT_THAT(Names("{corpus: meshes, where: genus == 1}"), ElementsAre("ring"));
  EXPECT_THAT(Names("{corpus: meshes, where: loops == 0 and genus == 0}"),
              ElementsAre("a-ball", "b-ball"));
  const StatusOr<ExperimentConfig> config = Load("{corpus: meshes, where: triangles > 0}");
  ASSERT_TRUE(config.ok());
  EXPECT_EQ(config->runs.size(), 4u);
  EXPECT_THAT(config->notes, ElementsAre(HasSubstr("4 of 5 meshes, those with triangles > 0; 1 "
                                                   "are no surfaces")));
}

TEST_F(CorpusTest, IsAListOrAPattern) {
  folder_.Write("list.txt", "# two\nmeshes/cap.obj\n\nmeshes/b/ring.ply\n");
  EXPECT_THAT(Names("{corpus: list.txt, name: two}"), ElementsAre("two-cap", "two-ring"));
  EXPECT_THAT(Names("{file: meshes/*/ball.*, where: genus == 0}"), ElementsAre("a-ball", "b-ball"));
  folder_.Write("list.txt", "meshes/cap.obj\nmeshes/cup.obj\n");
  EXPECT_THAT(Load("{corpus: list.txt}").status().message(), HasSubstr("list.txt:2: there is no"));
}

TEST_F(CorpusTest, IsAnArchiveThatIsReadOnce) {
  const auto run =
      RunShell("tar czf '" + folder_.Path("all.tar.gz") + "' -C '" + folder_.path() + "' meshes");
  ASSERT_EQ(run.exit_status, 0) << run.output;
  EXPECT_THAT(Names("{corpus: all.tar.gz, where: triangles > 0}"),
              UnorderedElementsAre("a-ball", "b-ball", "ring", "cap"));
  auto meshes = MeshesOfCorpus(folder_.path(), "all.tar.gz");
  ASSERT_TRUE(meshes.ok());
  const std::string cache = folder_.Path("cache");
  ASSERT_TRUE(ExtractMembers(*meshes, cache).ok());
  for (const MeshSpec& mesh : *meshes) {
    const StatusOr<LocatedMesh> located = LocateMesh(mesh, cache);
    ASSERT_TRUE(located.ok()) << located.status().message();
    EXPECT_THAT(located->path, HasSubstr("cache"));
  }
}

TEST_F(CorpusTest, RefusesWhatItCannotFind) {
  EXPECT_THAT(Load("{corpus: libcgal-dmo}").status().message(), HasSubstr("libcgal-demo"));
  EXPECT_THAT(Load("{corpus: meshes, where: gneus == 0}").status().message(),
              HasSubstr("did you mean 'genus'"));
  EXPECT_THAT(Load("{generator: torus, where: genus == 0}").status().message(), HasSubstr("where"));
  EXPECT_THAT(Load("{corpus: meshes, where: genus == 7}").status().message(),
              HasSubstr("nothing to run"));
  EXPECT_THAT(Load("{corpus: nowhere, optional: true}").status().message(),
              HasSubstr("nothing to run"));
}

}  // namespace
}  // namespace cirque
