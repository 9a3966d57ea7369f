#include "cirque/core/option_table.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cirque {

enum class Shade { kLight, kDark };

template <>
inline constexpr auto kEnumWords<Shade> = std::to_array<EnumWord<Shade>>({{Shade::kLight, "light"},
                                                                          {Shade::kDark, "dark"}});

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Base {
  int steps = 7;
};

/// An option of each kind.
struct Paint : Base {
  bool wet = false;
  double thickness = 0.1;
  std::string colour = "red";
  std::string maker;
  Shade shade = Shade::kLight;
  std::vector<int> coats = {1, 2};
};

Status EvenLength(const std::string& text) {
  return text.size() % 2 == 0 ? Status() : Status::InvalidInput("'" + text + "' is of odd length");
}

const OptionTable<Paint>& Table() {
  static const OptionTable<Paint> kTable(
      "paint",
      Joined<Paint>(
          {Option<Paint>("steps", &Paint::steps, "most steps").Between(1, 9)},
          {{"wet", &Paint::wet, "not dry"},
           Option<Paint>("thickness", &Paint::thickness, "of a coat")
               .Between(0, 1)
               .Unit("mm")
               .About("Coat")
               .Formerly("width"),
           Option<Paint>("colour", &Paint::colour, "what one sees").OneOf({"red", "green"}),
           Option<Paint>("maker", &Paint::maker, "who").Checked(EvenLength),
           {"shade", &Paint::shade, "how bright"},
           Option<Paint>("coats", &Paint::coats, "by number").Between(0, 9)}));
  return kTable;
}

std::string Refusal(const std::string& name, const std::string& text) {
  Paint paint;
  const Status status = Table().Set({{name, text}}, &paint);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_EQ(Table().Values(paint), Table().Values({})) << "a refusal changes nothing";
  return status.message();
}

TEST(OptionTable, EveryKindIsSet) {
  Paint paint;
  const Status status = Table().Set({{"steps", "9"},
                                     {"wet", "true"},
                                     {"thickness", "2.5e-1"},
                                     {"colour", "green"},
                                     {"maker", "abcd"},
                                     {"shade", "dark"},
                                     {"coats", "3,0,9"}},
                                    &paint);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(paint.steps, 9);
  EXPECT_TRUE(paint.wet);
  EXPECT_EQ(paint.thickness, 0.25);
  EXPECT_EQ(paint.colour, "green");
  EXPECT_EQ(paint.maker, "abcd");
  EXPECT_EQ(paint.shade, Shade::kDark);
  EXPECT_THAT(paint.coats, ElementsAre(3, 0, 9));
}

TEST(OptionTable, ARefusalNamesOptionValueAndBound) {
  EXPECT_EQ(Refusal("steps", "10"), "paint: steps = '10' is not an integer in [1, 9]");
  EXPECT_EQ(Refusal("steps", "0"), "paint: steps = '0' is not an integer in [1, 9]");
  EXPECT_EQ(Refusal("steps", "2.0"), "paint: steps = '2.0' is not an integer in [1, 9]");
  EXPECT_EQ(Refusal("steps", "5 "), "paint: steps = '5 ' is not an integer in [1, 9]");
  EXPECT_EQ(Refusal("steps", "99999999999"),
            "paint: steps = '99999999999' is not an integer in [1, 9]");
  EXPECT_EQ(Refusal("thickness", "1.5"), "paint: thickness = '1.5' is not a number in [0, 1] mm");
  EXPECT_EQ(Refusal("thickness", "nan"), "paint: thickness = 'nan' is not a number in [0, 1] mm");
  EXPECT_EQ(Refusal("thickness", ""), "paint: thickness = '' is not a number in [0, 1] mm");
  EXPECT_EQ(Refusal("wet", "yes"), "paint: wet = 'yes' is not true or false");
  EXPECT_EQ(Refusal("colour", "blue"), "paint: colour = 'blue' is not one of red, green");
  EXPECT_EQ(Refusal("shade", "drak"),
            "paint: shade = 'drak' is not one of light, dark; did you mean 'dark'?");
  EXPECT_EQ(Refusal("maker", "abc"), "paint: maker: 'abc' is of odd length");
  EXPECT_EQ(Refusal("coats", "1,10"),
            "paint: coats = '1,10' is not a list with commas, each an integer in [0, 9]");
  EXPECT_EQ(Refusal("coats", "1,,2"),
            "paint: coats = '1,,2' is not a list with commas, each an integer in [0, 9]");
  EXPECT_THAT(Refusal("colur", "red"), HasSubstr("unknown paint option 'colur'; did you mean "
                                                 "'colour'? Known: steps, wet, thickness"));
}

TEST(OptionTable, BoundsAreIncludedAndDefaultsAlwaysAllowed) {
  Paint paint;
  for (const char* bound : {"0", "1"}) {
    EXPECT_TRUE(Table().Set({{"thickness", bound}}, &paint).ok()) << bound;
  }
  EXPECT_TRUE(Table().Set({{"maker", ""}}, &paint).ok());
}

TEST(OptionTable, AWholeStructIsValidatedWithFieldValueAndBound) {
  EXPECT_TRUE(Table().Validate({}).ok());
  Paint paint;
  paint.thickness = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Table().Validate(paint).message(),
            "paint: thickness = 'nan' is not a number in [0, 1] mm");
  paint = {};
  paint.steps = -3;
  EXPECT_EQ(Table().Validate(paint).message(), "paint: steps = '-3' is not an integer in [1, 9]");
  paint = {};
  paint.colour = "gren";
  EXPECT_EQ(Table().Validate(paint).message(),
            "paint: colour = 'gren' is not one of red, green; did you mean 'green'?");
  paint = {};
  paint.maker = "abc";
  EXPECT_EQ(Table().Validate(paint).message(), "paint: maker: 'abc' is of odd length");
  paint = {};
  paint.coats = {4, 17};
  EXPECT_THAT(Table().Validate(paint).message(), HasSubstr("coats = '4,17'"));
}

TEST(OptionTable, PrintedValuesGiveBackTheStruct) {
  Paint paint;
  paint.steps = 3;
  paint.wet = true;
  paint.thickness = 0.1 + 0.2;
  paint.maker = "ab=c,d";
  paint.shade = Shade::kDark;
  paint.coats = {};
  const OptionMap values = Table().Values(paint);
  EXPECT_EQ(values.at("thickness"), "0.30000000000000004");
  EXPECT_EQ(values.at("shade"), "dark");
  Paint back;
  ASSERT_TRUE(Table().Set(values, &back).ok());
  EXPECT_EQ(back.steps, paint.steps);
  EXPECT_EQ(back.wet, paint.wet);
  EXPECT_EQ(back.thickness, paint.thickness);
  EXPECT_EQ(back.maker, paint.maker);
  EXPECT_EQ(back.shade, paint.shade);
  EXPECT_EQ(back.coats, paint.coats);
}

TEST(OptionTable, DescribesWhatItKnows) {
  const OptionInfo thickness = Table().Find("thickness")->info();
  EXPECT_EQ(thickness.kind, OptionKind::kNumber);
  EXPECT_EQ(thickness.default_text, "0.1");
  EXPECT_EQ(thickness.unit, "mm");
  EXPECT_EQ(thickness.group, "Coat");
  EXPECT_TRUE(IsNumeric(thickness.kind));
  EXPECT_THAT(Table().Find("shade")->info().words, ElementsAre("light", "dark"));
  EXPECT_EQ(Table().Find("coats")->info().default_text, "1,2");
  EXPECT_EQ(Table().Find("steps")->info().default_text, "7");
  EXPECT_EQ(Table().Find("stairs"), nullptr);
}

TEST(OptionTable, FormerNamesWorkAndSayWhatTheyAreCalledNow) {
  Paint paint;
  ASSERT_TRUE(Table().Set({{"width", "0.5"}}, &paint).ok());
  EXPECT_EQ(paint.thickness, 0.5);
  OptionMap options = {{"width", "0.7"}, {"steps", "2"}};
  EXPECT_THAT(UseNewNames(Table().Infos(), &options),
              ElementsAre("'width' is called 'thickness' now"));
  EXPECT_EQ(options, (OptionMap{{"thickness", "0.7"}, {"steps", "2"}}));
  EXPECT_TRUE(UseNewNames(Table().Infos(), &options).empty());
}

TEST(EnumWords, ValuesAndWordsAreEachOthers) {
  EXPECT_THAT(WordsOf<Shade>(), ElementsAre("light", "dark"));
  for (const Shade shade : {Shade::kLight, Shade::kDark}) {
    EXPECT_EQ(FromWord<Shade>(ToWord(shade)), shade);
  }
  EXPECT_FALSE(FromWord<Shade>("Light").has_value());
  EXPECT_EQ(ToWord(static_cast<Shade>(5)), "");
}

TEST(Expectation, IsWhatAValueMustBe) {
  OptionInfo option;
  option.kind = OptionKind::kInteger;
  EXPECT_EQ(Expectation(option), "an integer");
  option.kind = OptionKind::kNumber;
  option.bounds.lower = 0;
  EXPECT_EQ(Expectation(option), "a number in [0, inf]");
  option.kind = OptionKind::kText;
  EXPECT_EQ(Expectation(option), "a text");
}

}  // namespace
}  // namespace cirque
