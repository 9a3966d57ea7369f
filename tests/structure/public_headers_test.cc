// What is installed is what cirque/cirque.h reaches, few headers, each of them explained, and beside
// it the header for users of OpenMesh.
#include "tests/structure/public_headers.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/paths.h"

namespace cirque {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::size_t kMostHeaders = 59;

std::string TextOf(const std::string& header) {
  std::ifstream file(ProjectPath("framework/" + header));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(PublicHeaders, AreWhatTheHeaderOfAllReachesAndThatForOpenMesh) {
  const std::string for_openmesh = "cirque/openmesh.h";
  std::set<std::string> reached = {"cirque/cirque.h"};
  std::vector<std::string> open = {"cirque/cirque.h"};
  while (!open.empty()) {
    const std::string header = open.back();
    open.pop_back();
    for (const std::string& included : LibraryIncludes(TextOf(header))) {
      if (reached.insert(included).second) open.push_back(included);
    }
  }
  EXPECT_LE(reached.size(), kMostHeaders);
  for (const std::string& included : LibraryIncludes(TextOf(for_openmesh))) {
    EXPECT_TRUE(reached.contains(included)) << included;
  }
  reached.insert(for_openmesh);
  const std::vector<std::string> listed = PublicHeaders();
  EXPECT_THAT(listed, testing::UnorderedElementsAreArray(reached));
}

TEST(PublicHeaders, ExplainEveryDeclaration) {
  for (const std::string& header : PublicHeaders()) {
    EXPECT_THAT(UnexplainedDeclarations(TextOf(header)), IsEmpty()) << header;
  }
}

TEST(PublicHeaders, DeclarationsWithoutAWordAreSeen) {
  const std::string text =
      "#pragma once\n"
      "namespace cirque {\n"
      "class Announced;\n"
      "\n"
      "/// Explained.\n"
      "struct One {\n"
      "  int a;\n"
      "};\n"
      "\n"
      "// Not for users.\n"
      "template <class T>\n"
      "class Two {\n"
      "\n"
      "  void F() {}\n"
      "};\n"
      "\n"
      "/// Both.\n"
      "int Three(int x,\n"
      "          int y = {1});\n"
      "inline int Four() { return 4; }\n"
      "\n"
      "inline constexpr int kFive[] = {5,\n"
      "\n"
      "                                5};\n"
      "}  // namespace cirque\n";
  EXPECT_THAT(UnexplainedDeclarations(text),
              ElementsAre("11: template <class T>", "22: inline constexpr int kFive[] = {5,"));
}

}  // namespace
}  // namespace cirque
