#include "cirque/core/text.h"

#include <gtest/gtest.h>

namespace cirque {
namespace {

TEST(Text, NearestWordFindsMisspellingsAndNothingElse) {
  const std::vector<std::string> known = {"newton", "newton_cg", "ceres_line_search"};
  EXPECT_EQ(NearestWord("newtn", known), "newton");
  EXPECT_EQ(NearestWord("ceres_linesearch", known), "ceres_line_search");
  EXPECT_EQ(NearestWord("conse", {"con", "cones"}), "cones");  // two neighbours exchanged
  EXPECT_EQ(NearestWord("interior", known), "");
  EXPECT_EQ(NearestWord("x", {}), "");
  EXPECT_EQ(NearestWord(std::string(100000000, 'n'), known), "");
}

TEST(Text, UnknownNameNamesKindHintAndKnown) {
  EXPECT_EQ(UnknownName("strategy", "newtn", {"newton", "cg"}),
            "unknown strategy 'newtn'; did you mean 'newton'? Known: newton, cg");
  EXPECT_EQ(UnknownName("strategy", "zzz", {"newton"}), "unknown strategy 'zzz'. Known: newton");
}

TEST(Text, IdListIsCut) {
  EXPECT_EQ(IdList({3, 7}), "3, 7");
  EXPECT_EQ(IdList({1, 2, 3, 4}, 2), "1, 2 and 2 more");
}

TEST(Text, TheNearestOfSeveralWinsAndShortWordsForgiveTwoLetters) {
  const std::vector<std::string> known = {"area", "angle", "angles"};
  EXPECT_EQ(NearestWord("angel", known), "angle");
  EXPECT_EQ(NearestWord("angless", known), "angles");
  EXPECT_EQ(NearestWord("ar", known), "area");
  EXPECT_EQ(NearestWord("zzzz", known), "");
  for (const std::string& word : known) EXPECT_EQ(NearestWord(word, known), word);
}

TEST(Text, JoinTakesAnySeparator) {
  EXPECT_EQ(Join({}), "");
  EXPECT_EQ(Join({"a"}), "a");
  EXPECT_EQ(Join({"a", "b", "c"}, " | "), "a | b | c");
  EXPECT_EQ(IdList({}), "");
  EXPECT_EQ(IdList({4, 5, 6}, 3), "4, 5, 6");
}

TEST(Text, LinesAreWrappedAndGoOnAtTheIndent) {
  EXPECT_EQ(Wrapped("a ", "bc de fg", 4, 9), "a   bc de\n    fg\n");
  EXPECT_EQ(Wrapped("a ", "bc de fg", 4, 8), "a   bc\n    de\n    fg\n");
  EXPECT_EQ(Wrapped("abcdef ", "gh", 4, 9), "abcdef\n    gh\n");
  EXPECT_EQ(Wrapped("", "longer_than_the_line x", 2, 9), "  longer_than_the_line\n  x\n");
  EXPECT_EQ(Wrapped("a", "  b \n c ", 2), "a b c\n");
}

}  // namespace
}  // namespace cirque
