// Configs that are meant to do harm, or do by accident: all end in a message, soon.
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/run_experiment/config/config.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Lines: 1 question, 2 the mesh, 3 the method, 4 the rest.
std::string Config(const std::string& mesh, const std::string& method,
                   const std::string& rest = "") {
  return "question: why\nmeshes: [" + mesh + "]\nmethods: [" + method + "]\n" + rest;
}

constexpr char kMesh[] = "{generator: sphere}", kMethod[] = "{name: a}";

std::string MessageOf(const std::string& text) {
  const auto config = ParseConfig("/nowhere/a.yaml", text);
  return config.ok() ? "" : config.status().message();
}

/// Ten lists of ten aliases each: ten thousand million values in 300 bytes.
std::string AliasBomb() {
  std::string text = "question: [&a0 x";
  for (int i = 1; i <= 10; ++i) {
    text += fmt::format(", &a{} [", i);
    for (int k = 0; k < 10; ++k) text += fmt::format("{}*a{}", k == 0 ? "" : ", ", i - 1);
    text += "]";
  }
  return text + "]\n";
}

TEST(RunExperimentConfigLimits, DocumentsThatNeverEnd) {
  EXPECT_THAT(MessageOf("#\n,"),
              StartsWith("/nowhere/a.yaml:2:1: the file must hold one YAML document"));
  std::string many;
  for (int i = 0; i < 100000; ++i) many += "---\n";
  EXPECT_THAT(MessageOf(many),
              StartsWith("/nowhere/a.yaml:2:1: the file must hold one YAML document"));
}

TEST(RunExperimentConfigLimits, Nesting) {
  for (const char c : {'[', '{'}) {
    EXPECT_THAT(MessageOf("question: " + std::string(100000, c)),
                HasSubstr("lists and maps nested deeper than 20 levels"));
  }
  std::string dashes;
  for (int i = 0; i < 100000; ++i) dashes += "- ";
  EXPECT_THAT(MessageOf(dashes), HasSubstr("lists and maps nested deeper than 20 levels"));
}

TEST(RunExperimentConfigLimits, Aliases) {
  EXPECT_THAT(MessageOf("question: &a [*a]\n"),
              StartsWith("/nowhere/a.yaml:1:15: an alias inside of what it stands for"));
  EXPECT_THAT(MessageOf("question: x\nmeshes: &a [{file: *a}]\n"),
              StartsWith("/nowhere/a.yaml:2:20: an alias inside of what it stands for"));
  EXPECT_THAT(MessageOf(AliasBomb()), HasSubstr("more than 1000000 values; is an alias used too"));
  const auto honest = ParseConfig(
      "/nowhere/a.yaml", Config(kMesh, "&a {name: a, epsilon: &e 0.01}, {name: b, epsilon: *e}"));
  ASSERT_TRUE(honest.ok()) << honest.status().message();
  EXPECT_EQ(honest->runs.at(1).method.options.epsilon, 0.01);
}

TEST(RunExperimentConfigLimits, MapsWhereValuesBelong) {
  EXPECT_THAT(MessageOf(Config(kMesh, "{name: a, epsilon: {a: b}}")),
              StartsWith("/nowhere/a.yaml:3:30: 'epsilon' must be a number from 1e-12 to 1"));
  EXPECT_THAT(MessageOf(Config(kMesh, kMethod, "seeds: {a: b}\n")),
              StartsWith("/nowhere/a.yaml:4:8: 'seeds' must be a whole number"));
  EXPECT_THAT(MessageOf(Config(kMesh, kMethod, "seeds: [1, {a: b}]\n")),
              StartsWith("/nowhere/a.yaml:4:12: a value of 'seeds' must be a whole number"));
  EXPECT_THAT(MessageOf("question: why\nmeshes: {file: a}\nmethods: {name: a}\n"),
              StartsWith("/nowhere/a.yaml:2:9: 'meshes' must be a list of entries"));
}

TEST(RunExperimentConfigLimits, LinksThatLeadInACircle) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("self.obj", folder.Path("self.obj"));
  std::filesystem::create_directory_symlink(".", folder.Path("loop"));
  for (const std::string file : {"'*.obj'", "'loop/*.obj'", "'loop/loop/*/self.obj'", "self.obj"}) {
    const auto config = LoadConfig(folder.Write("a.yaml", Config("{file: " + file + "}", kMethod)));
    ASSERT_FALSE(config.ok());
    EXPECT_THAT(config.status().message(), HasSubstr("a.yaml:2:17: ")) << file;
  }
}

TEST(RunExperimentConfigLimits, ManyProblemsInOneLongLineMakeAShortMessage) {
  std::string mesh = "{generator: sphere";
  for (int i = 0; i < 2000; ++i) mesh += ", a: 1";
  const std::string message = MessageOf(Config(mesh + "}", kMethod));
  EXPECT_THAT(message, HasSubstr("a.yaml:2:30: unknown key of 'meshes' 'a'"));
  EXPECT_THAT(message, EndsWith("a.yaml: and 1950 more problems\n"));
  EXPECT_LT(message.size(), 50000u);
}

TEST(RunExperimentConfigLimits, Sizes) {
  EXPECT_THAT(
      MessageOf(std::string(2000000, '#')),
      StartsWith("/nowhere/a.yaml:1:1: the file has 2000000 bytes, a config at most 1048576"));
  std::string seeds, patterns;
  for (int i = 0; i < 100001; ++i) seeds += fmt::format("{}, ", i);
  for (int i = 0; i < 1001; ++i) patterns += fmt::format("'*{}', ", i);
  EXPECT_THAT(MessageOf(Config(kMesh, kMethod, "seeds: [" + seeds + "]\n")),
              StartsWith("/nowhere/a.yaml:2:10: with this entry 'meshes' makes 100001"));
  EXPECT_THAT(MessageOf(Config(kMesh, kMethod, "include: [" + patterns + "]\n")),
              StartsWith("/nowhere/a.yaml:4:10: 'include' lists more than 1000 patterns"));
  std::string methods = "&a {name: a, epsilon: [0.1, 0.2, 0.3], max_iterations: [1, 2, 3]}";
  for (int i = 0; i < 12000; ++i) methods += ", *a";
  EXPECT_THAT(MessageOf(Config(kMesh, methods)), HasSubstr("'methods' makes 100008 combinations"));
}

}  // namespace
}  // namespace cirque
