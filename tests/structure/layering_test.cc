// The tree obeys the structure that docs/architecture.md describes, and the checker sees what
// breaks it.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/paths.h"
#include "tests/structure/code_text.h"
#include "tests/structure/include_graph.h"
#include "tests/structure/rules.h"

namespace cirque {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string ReadAll(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Structure, EveryFileObeysTheRules) {
  const std::vector<std::string> files = SourceFiles(ProjectPath("."));
  ASSERT_THAT(files, testing::Contains("framework/cirque/core/status.h"));
  for (const std::string& file : files) {
    EXPECT_THAT(Violations(file, ReadAll(ProjectPath(file))), IsEmpty());
  }
}

// The files of C++ with their includes.
IncludeGraph GraphOfTheProject() {
  IncludeGraph graph;
  for (const std::string& file : SourceFiles(ProjectPath("."))) {
    if (file.ends_with(".h") || file.ends_with(".cc")) graph.Add(file, ReadAll(ProjectPath(file)));
  }
  return graph;
}

TEST(Structure, NoFileIncludesOneThatIncludesItBack) {
  const IncludeGraph graph = GraphOfTheProject();
  EXPECT_FALSE(graph.Includes("framework/cirque/energy/energy").empty());
  EXPECT_THAT(graph.Cycles(), IsEmpty());
}

TEST(Structure, NoBaseClassIncludesItsDerivedOnes) {
  EXPECT_THAT(GraphOfTheProject().BasesThatIncludeDerived(), IsEmpty());
}

// Two of one name in one program are one to the linker, whatever they are: only luck decides which.
TEST(Structure, NoTypeIsDefinedTwice) {
  std::map<std::string, std::set<std::string>> files_of;
  for (const std::string& file : SourceFiles(ProjectPath("."))) {
    if (!file.ends_with(".h") && !file.ends_with(".cc")) continue;
    for (const std::string& type : VisibleTypesOf(ReadAll(ProjectPath(file)))) {
      files_of[type].insert(file);
    }
  }
  EXPECT_GT(files_of.size(), 500u);
  for (const auto& [type, files] : files_of) EXPECT_THAT(files, testing::SizeIs(1)) << type;
}

TEST(Structure, TopLevelIsTheDesigns) {
  const std::set<std::string> allowed = {
      "CMakeLists.txt", "framework",    "experiments",     "configs",           "bench",
      "tests",          "results",      "README.md",       "CMakePresets.json", "LICENSE",
      "CHANGELOG.md",   "CITATION.cff", "CONTRIBUTING.md", "pyproject.toml"};
  for (const auto& entry : std::filesystem::directory_iterator(ProjectPath("."))) {
    const std::string name = entry.path().filename();
    const bool is_free = name.starts_with(".") || name.starts_with("build");
    EXPECT_TRUE(is_free || allowed.contains(name)) << name << " is not of the top level";
  }
}

TEST(StructureRules, IncludesPointDown) {
  EXPECT_THAT(Violations("framework/cirque/mesh/a.cc", "#include \"cirque/core/status.h\"\n"),
              IsEmpty());
  EXPECT_THAT(
      Violations("framework/cirque/mesh/a.cc", "\n#include \"cirque/solver/newton.h\"\n"),
      ElementsAre("framework/cirque/mesh/a.cc:2: mesh includes solver, which lies above it"));
  EXPECT_THAT(Violations("framework/cirque/cuts/a.cc", "#  include <cirque/layout/b.h>\n"),
              ElementsAre("framework/cirque/cuts/a.cc:1: cuts includes its sibling layout"));
  EXPECT_THAT(Violations("framework/cirque/energy/a.cc", "#include \"cirque/mesh/surface.h\"\n"),
              ElementsAre("framework/cirque/energy/a.cc:1: energy includes mesh"));
  EXPECT_THAT(Violations("framework/cirque/solver/a.cc", "#include \"cirque/mesh/surface.h\"\n"),
              ElementsAre("framework/cirque/solver/a.cc:1: solver includes mesh"));
  EXPECT_EQ(Violations("framework/cirque/core/a.cc", "#include \"cirque/extra/b.h\"\n").size(), 1u);
  EXPECT_EQ(Violations("framework/cirque/extra/a.cc", "#include \"cirque/core/b.h\"\n").size(), 1u);
}

TEST(StructureRules, NumericsSeeNoSurfaceAndTheJudgeOnlyFiles) {
  for (const std::string folder : {"energy", "solver", "audit"}) {
    for (const std::string target : {"mesh", "generators"}) {
      EXPECT_THAT(
          Violations("framework/cirque/" + folder + "/a.cc",
                     "#include \"cirque/" + target + "/b.h\"\n"),
          ElementsAre("framework/cirque/" + folder + "/a.cc:1: " + folder + " includes " + target));
    }
  }
  EXPECT_THAT(Violations("framework/cirque/verify/a.cc", "#include \"cirque/io/io.h\"\n"),
              IsEmpty());
  EXPECT_THAT(Violations("framework/cirque/verify/a.cc", "#include \"cirque/layout/seams.h\"\n"),
              ElementsAre("framework/cirque/verify/a.cc:1: verify includes layout"));
  EXPECT_THAT(Violations("framework/cirque/domains/a.cc", "#include \"cirque/verify/b.h\"\n"),
              ElementsAre("framework/cirque/domains/a.cc:1: domains includes its sibling verify"));
}

TEST(StructureRules, TheHeaderOfAllIsForUsers) {
  const std::string include = "#include \"cirque/cirque.h\"\n";
  EXPECT_THAT(Violations("experiments/one/a.cc", include), IsEmpty());
  EXPECT_EQ(Violations("framework/cirque/domains/a.cc", include).size(), 1u);
  EXPECT_THAT(Violations("framework/cirque/cirque.h",
                         "#pragma once\n#include \"cirque/domains/domain.h\"\n"),
              IsEmpty());
}

TEST(StructureRules, NobodyIncludesALeaf) {
  EXPECT_EQ(Violations("framework/cirque/core/a.cc", "#include \"tests/common/paths.h\"\n").size(),
            1u);
  EXPECT_EQ(Violations("bench/a.cc", "#include \"experiments/common/b.h\"\n").size(), 1u);
  EXPECT_EQ(Violations("experiments/one/a.cc", "#include \"experiments/two/b.h\"\n").size(), 1u);
  EXPECT_THAT(Violations("experiments/one/a.cc", "#include \"experiments/common/b.h\"\n"),
              IsEmpty());
  EXPECT_THAT(Violations("tests/one/a.cc", "#include \"experiments/two/b.h\"\n"), IsEmpty());
}

TEST(StructureRules, TheFrameworkDoesNotPrint) {
  for (const std::string line : {"#include <iostream>\n", "  std::cout << 1;\n", "printf(\"\");\n",
                                 "std::fprintf(stderr, \"\");\n", "fmt::print(\"{}\", 1);\n"}) {
    EXPECT_EQ(Violations("framework/cirque/core/a.cc", line).size(), 1u) << line;
    EXPECT_THAT(Violations("experiments/one/a.cc", line), IsEmpty()) << line;
  }
  EXPECT_THAT(Violations("framework/cirque/core/a.cc", "// as printf(\"%g\") does\n"), IsEmpty());
  EXPECT_THAT(Violations("framework/cirque/core/a.cc", "std::snprintf(buffer, 9, \"\");\n"),
              IsEmpty());
}

TEST(StructureRules, DeferredWorkLengthAndGuardsAreSeen) {
  for (const std::string word : {"TO"
                                 "DO",
                                 "FIX"
                                 "ME"}) {
    EXPECT_EQ(Violations("tests/a.cc", "// " + word + ": later\n").size(), 1u);
  }
  std::string lines;
  for (int i = 0; i < 500; ++i) lines += "\n";
  EXPECT_THAT(Violations("tests/a.cc", lines), IsEmpty());
  EXPECT_THAT(Violations("tests/a.cc", lines + "\n"),
              ElementsAre("tests/a.cc:501: longer than 500 lines"));
  EXPECT_EQ(Violations("tests/a.h", "int F();\n").size(), 1u);
  EXPECT_THAT(Violations("tests/a.h", "#pragma once\n"), IsEmpty());
}

}  // namespace
}  // namespace cirque
