// What documents say about the tree is so.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/version.h"

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"
#include "tests/structure/public_headers.h"

namespace cirque {
namespace {

std::string ReadAll(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Documents, ThePictureOfTheFloorsIsDrawnFromTheIncludes) {
  const TemporaryFolder folder;
  const std::string drawn = folder.Path("architecture.svg");
  const std::string script = ProjectPath("framework/docs/draw_architecture.py");
  const auto run = RunShell("python3 '" + script + "' '" + drawn + "'");
  ASSERT_EQ(run.exit_status, 0) << run.output;
  const std::string picture = ReadAll(drawn);
  EXPECT_THAT(picture, testing::HasSubstr("solver includes linear: "));
  EXPECT_EQ(picture, ReadAll(ProjectPath("framework/docs/architecture.svg")))
      << "includes have changed: run framework/docs/draw_architecture.py";
}

TEST(Documents, TheCitationIsOfThisVersion) {
  EXPECT_THAT(ReadAll(ProjectPath("CITATION.cff")),
              testing::HasSubstr("\nversion: " + Version() + "\n"));
}

// Links to files of the tree, relative to the page that has them: "[text](path)".
std::vector<std::string> LinksOf(const std::string& text) {
  static const std::regex kLink(R"(\]\(([^)#:]+)\))");
  std::vector<std::string> links;
  for (std::sregex_iterator m(text.begin(), text.end(), kLink), end; m != end; ++m) {
    links.push_back((*m)[1]);
  }
  return links;
}

TEST(Documents, LinksLeadToFiles) {
  int count = 0;
  for (const std::string page :
       {"README.md", "CONTRIBUTING.md", "framework/docs/architecture.md",
        "framework/docs/mathematics.md", "framework/docs/errata.md", "framework/docs/programs.md",
        "framework/docs/concepts.md", "framework/docs/reference/core.md", "framework/docs/maps.md",
        "framework/docs/measures.md", "framework/docs/experiments.md",
        "framework/docs/building.md"}) {
    const std::filesystem::path folder = std::filesystem::path(ProjectPath(page)).parent_path();
    for (const std::string& link : LinksOf(ReadAll(ProjectPath(page)))) {
      EXPECT_TRUE(std::filesystem::exists(folder / link)) << page << ": " << link;
      ++count;
    }
  }
  EXPECT_GT(count, 10);
}

TEST(Documents, TheReferenceHasEveryPublicHeaderOnAPageOfTheSite) {
  const auto run = RunShell("'" + ProjectPath("framework/docs/reference.py") + "'");
  ASSERT_EQ(run.exit_status, 0) << run.output;
  const std::string index = ReadAll(ProjectPath("framework/docs/index.md"));
  for (const std::string& header : PublicHeaders()) {
    EXPECT_THAT(run.output, testing::HasSubstr("\n## " + header + "\n")) << header;
    const std::string folder = std::filesystem::path(header).parent_path().filename();
    EXPECT_THAT(index, testing::HasSubstr("\nreference/" + folder + "\n")) << header;
    const std::string page = ProjectPath("framework/docs/reference/" + folder + ".md");
    EXPECT_TRUE(std::filesystem::exists(page)) << page;
  }
  EXPECT_THAT(run.output, testing::HasSubstr("\n### MapSurface\n"));
  // The docstring in front of its declaration, and nothing that is not for users.
  EXPECT_THAT(run.output,
              testing::HasSubstr("V - E + F.\n\n```cpp\nIndex EulerCharacteristic(const "
                                 "Triangulation& triangulation);\n```"));
  EXPECT_THAT(run.output, testing::Not(testing::HasSubstr("private:")));
}

TEST(Documents, TheReadmeIsShort) { EXPECT_LE(ReadAll(ProjectPath("README.md")).size(), 6000u); }

int NumLines(const std::string& path) {
  const std::string text = ReadAll(ProjectPath(path));
  EXPECT_FALSE(text.empty()) << path;
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Documents, ExamplesTakeAsManyLinesAsContributorsAreTold) {
  static const std::regex kRow(R"(`(tests/\S+)\.\{h,cc\}` \| (\d+) \| (\d+) \|)");
  const std::string page = ReadAll(ProjectPath("CONTRIBUTING.md"));
  int rows = 0;
  for (std::sregex_iterator row(page.begin(), page.end(), kRow), end; row != end; ++row, ++rows) {
    const std::string pair = (*row)[1];
    // The pair, and the table with its line.
    EXPECT_EQ((*row)[2], "3") << pair;
    EXPECT_EQ(std::stoi((*row)[3]), NumLines(pair + ".h") + NumLines(pair + ".cc") + 1) << pair;
  }
  EXPECT_EQ(rows, 7);
}

TEST(Documents, ProgramsOfAnotherProjectAreShortAndSeeOneHeader) {
  for (const std::string program : {"map_arrays", "own_energy"}) {
    const std::string path = "tests/consumer/" + program + ".cc";
    EXPECT_LE(NumLines(path), 40) << path;
    EXPECT_THAT(LibraryIncludes(ReadAll(ProjectPath(path))),
                testing::ElementsAre("cirque/cirque.h"));
  }
}

}  // namespace
}  // namespace cirque
