#include "cirque/io/file_input.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/atomic_file.h"

#include "tests/mesh/meshes.h"

namespace cirque {
namespace {

TEST(ReadFileContent, HasEveryByte) {
  const std::string path = testing::TempPath("file_input_test.bytes");
  for (const std::size_t size : {0u, 1u, 65535u, 65536u, 65537u, 300000u}) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 31 % 257);
    ASSERT_TRUE(WriteFileAtomically(path, bytes).ok());
    const StatusOr<std::string> read = ReadFileContent(path);
    ASSERT_TRUE(read.ok()) << read.status().message();
    EXPECT_EQ(*read, bytes);
  }
  std::filesystem::remove(path);
  EXPECT_EQ(ReadFileContent(path).status().message(),
            path + ": cannot read: No such file or directory");
}

TEST(ReadBytes, TakesBothOrders) {
  const std::string bytes("\x01\x02\x03\x04\x05\x06\x07\x08", 8);
  EXPECT_EQ(ReadBytes<std::uint16_t>(bytes, ByteOrder::kLittle), 0x0201);
  EXPECT_EQ(ReadBytes<std::uint16_t>(bytes, ByteOrder::kBig), 0x0102);
  EXPECT_EQ(ReadBytes<std::uint32_t>(bytes, ByteOrder::kBig), 0x01020304u);
  EXPECT_EQ(ReadBytes<std::uint64_t>(bytes, ByteOrder::kLittle), 0x0807060504030201ULL);
  EXPECT_EQ(ReadBytes<double>(std::string("\x3f\xf8\0\0\0\0\0\0", 8), ByteOrder::kBig), 1.5);
  EXPECT_EQ(ReadBytes<float>(std::string("\0\0\xc0\xbf", 4), ByteOrder::kLittle), -1.5F);
}

TEST(TextScanner, WalksWordsAndLinesAndKnowsWhereItIs) {
  TextScanner scanner("f", "one two\n\n# nothing\n  three # four\r\nfive\rsix");
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.Word(), "one");
  EXPECT_FALSE(scanner.AtLineEnd());
  EXPECT_EQ(scanner.Word(), "two");
  EXPECT_TRUE(scanner.AtLineEnd());
  EXPECT_EQ(scanner.Word(), "");
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.line(), 4);
  EXPECT_EQ(scanner.Word(), "three");
  EXPECT_TRUE(scanner.AtLineEnd());
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.line(), 5);
  ASSERT_TRUE(scanner.NextLine());  // leaves "five"
  EXPECT_EQ(scanner.line(), 6);
  EXPECT_EQ(scanner.Word(), "six");
  EXPECT_FALSE(scanner.NextLine());
}

TEST(TextScanner, NumbersAreReadWholeOrNotAtAll) {
  TextScanner scanner("f", "1.5e3 +2 -7 12x nan 9223372036854775808 -0 1e400");
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.Number(), 1500);
  EXPECT_EQ(scanner.Integer(), 2);
  EXPECT_EQ(scanner.Count(), std::nullopt);  // at least 0
  EXPECT_EQ(scanner.Integer(), -7);
  EXPECT_EQ(scanner.Number(), std::nullopt);
  EXPECT_EQ(scanner.Word(), "12x");  // it stayed in front of it
  EXPECT_TRUE(std::isnan(*scanner.Number()));
  EXPECT_EQ(scanner.Integer(), std::nullopt);  // 2^63 fits no 64 bits
  EXPECT_EQ(scanner.Number(), 0x1p63);
  EXPECT_TRUE(std::signbit(*scanner.Number()));
  EXPECT_EQ(scanner.Number(), INFINITY);
  EXPECT_EQ(scanner.Number(), std::nullopt);
}

TEST(TextScanner, NumbersThatMicrosoftWroteAreNotFinite) {
  TextScanner scanner("f",
                      "1.#INF -1.#INF000 -1.#IND00 1.#QNAN +1.#R#2\nv 1.#IND 7 1.#0\n2.#INF\n1.#");
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.Number(), INFINITY);
  EXPECT_EQ(scanner.Number(), -INFINITY);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(scanner.Number().value_or(0)));
  EXPECT_TRUE(scanner.AtLineEnd());
  ASSERT_TRUE(scanner.NextLine());
  scanner.Word();
  EXPECT_EQ(scanner.Word(), "1.#IND");
  EXPECT_EQ(scanner.Number(), 7);
  EXPECT_EQ(scanner.Number(), 1);  // and a comment
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.Place(), "f:3");
  EXPECT_EQ(scanner.Number(), 2);
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.Number(), 1);
}

TEST(TextScanner, MessagesNameFileLineAndWord) {
  TextScanner scanner("dir/f", "\nword\n");
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.Expected("a number").message(), "dir/f:2: expected a number, got 'word'");
  EXPECT_EQ(scanner.Error("no").message(), "dir/f:2: no");
  scanner.Word();
  EXPECT_EQ(scanner.Expected("more").message(), "dir/f:2: expected more, got the end of the line");
}

TEST(TextScanner, ContinuedLinesAreOneWhereTheFormatHasThem) {
  const std::string text = "a \\\n b\\\r\nc\nd \\";
  TextScanner joins("f", text, TextScanner::Continuation::kBackslash);
  ASSERT_TRUE(joins.NextLine());
  EXPECT_EQ(joins.Word(), "a");
  EXPECT_EQ(joins.Word(), "b");
  EXPECT_EQ(joins.Word(), "c");
  EXPECT_TRUE(joins.AtLineEnd());
  TextScanner plain("f", text);
  ASSERT_TRUE(plain.NextLine());
  plain.Word();
  EXPECT_EQ(plain.Word(), "\\");
}

TEST(TextScanner, LeavesBinaryBytesAlone) {
  const std::string text("end_header\n\x01\x0a\x00\x23", 15);
  TextScanner scanner("f", text);
  ASSERT_TRUE(scanner.NextLine());
  EXPECT_EQ(scanner.BytesAfterLine(), text.substr(11));
}

TEST(Printable, ShortensAndHidesWhatCannotBeShown) {
  EXPECT_EQ(Quoted("word"), "'word'");
  EXPECT_EQ(Printable(std::string("a\x01\x80z", 4)), "a??z");
  EXPECT_LT(Printable(std::string(1000, 'x')).size(), 100u);
}

}  // namespace
}  // namespace cirque
