// Rings of includes, bases that know their derived classes and long functions are seen where they
// were planted, and only there.
#include "tests/structure/include_graph.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/code_text.h"
#include "tests/structure/rules.h"

namespace cirque {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(StructureGraph, ARingThroughSourcesIsSeen) {
  IncludeGraph graph;
  graph.Add("framework/cirque/core/a.h", "#pragma once\n");
  graph.Add("framework/cirque/core/a.cc",
            "#include \"cirque/core/a.h\"\n#include \"cirque/core/b.h\"\n");
  graph.Add("framework/cirque/core/b.h", "#include \"cirque/core/c.h\"\n");
  EXPECT_THAT(graph.Cycles(), IsEmpty());
  graph.Add("framework/cirque/core/c.cc", "#include \"cirque/core/a.h\"\n");
  EXPECT_THAT(graph.Cycles(), ElementsAre("framework/cirque/core/a, framework/cirque/core/b, "
                                          "framework/cirque/core/c: include each other in a ring"));
}

TEST(StructureGraph, APairThatOthersShareIsNoRing) {
  IncludeGraph graph;
  graph.Add("bench/a.cc", "#include \"bench/b.h\"\n#include \"bench/c.h\"\n");
  graph.Add("bench/b.cc", "#include \"bench/b.h\"\n#include \"bench/c.h\"\n");
  graph.Add("bench/c.h", "#include <vector>\n");
  EXPECT_THAT(graph.Cycles(), IsEmpty());
  EXPECT_THAT(graph.Includes("bench/b"), ElementsAre("bench/c"));
}

TEST(StructureGraph, ABaseThatIncludesItsDerivedIsSeen) {
  IncludeGraph graph;
  graph.Add("tests/base.h", "class Base {\n};\n");
  graph.Add("tests/one.h", "class One final : public cirque::Base {};\n");
  graph.Add("tests/two.h", "struct Two : Other<Base>, private Base {};\n");
  graph.Add("tests/registry.cc", "#include \"tests/one.h\"\n#include \"tests/base.h\"\n");
  EXPECT_THAT(graph.BasesThatIncludeDerived(), IsEmpty());
  graph.Add("tests/base.cc", "#include \"tests/one.h\"\n#include \"tests/two.h\"\n");
  EXPECT_THAT(
      graph.BasesThatIncludeDerived(),
      ElementsAre("tests/base: includes tests/one, whose class One derives from its class Base",
                  "tests/base: includes tests/two, whose class Two derives from its class Base"));
}

TEST(StructureGraph, CommentsLiteralsAndDirectivesAreNoCode) {
  EXPECT_EQ(CodeOf("a{ // }\nb"), "a{     \nb");
  EXPECT_EQ(CodeOf("f(\"}\\\"\", '{', 1'000)"), "f(     ,    , 1'000)");
  EXPECT_EQ(CodeOf("x = R\"re(}\")re\" + y"), "x =             + y");
  EXPECT_EQ(CodeOf("#define A { \\\n  {\nB /* {\n */ C"), "             \n   \nB     \n    C");
}

TEST(StructureGraph, TypesAreSeenWithTheirNamespaces) {
  EXPECT_THAT(
      VisibleTypesOf("namespace a {\nstruct B {\n  struct Inner {};\n};\nclass Declared;\n"
                     "template <typename T>\nclass C final : public B {};\n"
                     "namespace {\nstruct Hidden {};\n}\n"
                     "enum class D : int { kOne };\nB F() { struct Local {}; return {}; }\n}\n"
                     "namespace a::b {\nstruct E {};\n}\n"),
      testing::ElementsAre("a::B", "a::C", "a::D", "a::b::E"));
}

TEST(StructureGraph, FunctionsAreMeasuredFromSignatureToBrace) {
  const std::string text =
      "namespace a {\n"
      "class B : public C {\n"
      "  B() = default;\n"
      "  int D(std::vector<int> x = {}) const;\n"
      "};\n"
      "const int kTable[] = {\n 1,\n 2};\n"
      "int Long(int x,\n"
      "         int y) {\n"
      "  for (;;) {\n"
      "    [] { return 1; }();\n"
      "  }\n"
      "}\n"
      "}  // namespace a\n";
  const std::vector<FunctionSpan> functions = FunctionsOf(text);
  ASSERT_EQ(functions.size(), 1u);
  EXPECT_EQ(functions[0].first_line, 9);
  EXPECT_EQ(functions[0].num_lines, 6);
}

TEST(StructureGraph, LongFunctionsOfProductionCodeAreFaults) {
  std::string text = "void F() {\n";
  for (int i = 0; i < 98; ++i) text += "  G();\n";
  EXPECT_THAT(Violations("bench/a.cc", text + "}\n"), IsEmpty());
  EXPECT_THAT(Violations("bench/a.cc", "\n" + text + "  G();\n}\n"),
              ElementsAre("bench/a.cc:2: a function of 101 lines, more than 100"));
  EXPECT_THAT(Violations("tests/a.cc", text + "  G();\n}\n"), IsEmpty());
}

}  // namespace
}  // namespace cirque
