#include "cirque/io/json_input.h"

#include <string>

#include <gtest/gtest.h>

namespace cirque {
namespace {

/// `levels` arrays, one in another.
std::string Brackets(int levels) { return std::string(levels, '[') + std::string(levels, ']'); }

/// The same as CBOR: arrays of one element, the innermost empty.
std::string CborArrays(int levels) { return std::string(levels - 1, '\x81') + '\x80'; }

TEST(ParseJson, TakesWholeValuesOnly) {
  EXPECT_EQ(ParseJson(R"({"a": [1, 2.5, "\"]"]})"), nlohmann::json({{"a", {1, 2.5, "\"]"}}}));
  for (const std::string text : {"", "[1", "[1] 2", "{\"a\" 1}", "nan", "\"\xff\""}) {
    EXPECT_FALSE(ParseJson(text)) << text;
  }
}

TEST(ParseJson, RefusesWhatIsNestedDeeplyHoweverDeeply) {
  EXPECT_TRUE(ParseJson(Brackets(kMostJsonLevels)));
  EXPECT_FALSE(ParseJson(Brackets(kMostJsonLevels + 1)));
  EXPECT_FALSE(ParseJson(Brackets(100000)));
  EXPECT_FALSE(ParseJson(std::string(10000000, '[')));
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_FALSE(ParseJson(objects));
}

TEST(ParseJson, BracketsInTextsNestNothing) {
  const std::string text = "\"\\\"" + std::string(1000, '[') + "\\\\\"";
  EXPECT_EQ(ParseJson(text), "\"" + std::string(1000, '[') + "\\");
}

TEST(ParseCbor, TakesWholeValuesOnly) {
  const nlohmann::json value = {{"a", {1, 2.5, "b"}}};
  std::string bytes;
  nlohmann::json::to_cbor(value, bytes);
  EXPECT_EQ(ParseCbor(bytes), value);
  EXPECT_FALSE(ParseCbor(bytes + "\x01"));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(ParseCbor(bytes.substr(0, size))) << size;
  }
  // An array that promises 2^60 elements.
  EXPECT_FALSE(ParseCbor(std::string("\x9b\x10\0\0\0\0\0\0\0\1", 10)));
}

TEST(ParseCbor, RefusesWhatIsNestedDeeplyHoweverDeeply) {
  EXPECT_TRUE(ParseCbor(CborArrays(kMostJsonLevels)));
  EXPECT_FALSE(ParseCbor(CborArrays(kMostJsonLevels + 1)));
  EXPECT_FALSE(ParseCbor(CborArrays(10000000)));
  EXPECT_FALSE(ParseCbor(std::string(10000000, '\x9f')));  // of unknown length, never ended
}

}  // namespace
}  // namespace cirque
