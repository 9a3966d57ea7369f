// Every seed of every target and every input that was once a finding, without a fuzzer.
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/io/file_input.h"

#include "tests/common/paths.h"
#include "tests/fuzz/fuzz_target.h"

namespace cirque::testing {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> FoundInputs(const std::string& target) {
  std::vector<std::string> paths;
  std::error_code none;
  for (const auto& entry :
       fs::directory_iterator(ProjectPath("tests/fuzz/corpus/" + target), none)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(FuzzCorpus, SeedsAndFoundInputsKeepEveryPromise) {
  for (const FuzzTarget& target : FuzzTargets()) {
    SCOPED_TRACE(target.name);
    EXPECT_FALSE(target.seeds.empty()) << "fuzzing starts from valid inputs: give it some";
    target.run("");
    for (const std::string& seed : target.seeds) target.run(seed);
    for (const std::string& path : FoundInputs(target.name)) {
      SCOPED_TRACE(path);
      const StatusOr<std::string> input = ReadFileContent(path);
      ASSERT_TRUE(input.ok()) << input.status().message();
      target.run(*input);
    }
  }
}

/// Whether some file of the project has a path that begins so.
bool SomeFileBegins(const std::string& beginning) {
  const fs::path start = ProjectPath(beginning);
  const auto files = fs::directory_iterator(start.parent_path());
  return std::any_of(begin(files), end(files), [&](const fs::directory_entry& file) {
    return file.path().string().starts_with(start.string());
  });
}

TEST(FuzzCorpus, EveryTargetNamesTheSourcesItIsFor) {
  for (const FuzzTarget& target : FuzzTargets()) {
    EXPECT_FALSE(target.sources.empty()) << target.name;
    for (const std::string& beginning : target.sources) {
      EXPECT_TRUE(SomeFileBegins(beginning)) << target.name << ": " << beginning;
    }
  }
}

TEST(FuzzCorpus, EveryFolderBelongsToATarget) {
  std::set<std::string> names;
  for (const FuzzTarget& target : FuzzTargets()) {
    EXPECT_TRUE(names.insert(target.name).second) << target.name << " is there twice";
  }
  int folders = 0;
  for (const auto& entry : fs::directory_iterator(ProjectPath("tests/fuzz/corpus"))) {
    EXPECT_TRUE(names.contains(entry.path().filename())) << entry.path();
    ++folders;
  }
  EXPECT_GT(folders, 0);
}

}  // namespace
}  // namespace cirque::testing
