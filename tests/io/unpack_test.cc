#include "cirque/io/unpack.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/atomic_file.h"
#include "cirque/io/io.h"

#include "tests/common/temporary_folder.h"
#include "tests/io/gzip.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using testing::Gzipped;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

StatusOr<std::string> Unpack(const std::string& content, std::vector<std::string>* warnings) {
  return Unpacked("m", content, warnings);
}

TEST(Unpacked, LeavesWhatIsNotPackedAsItIs) {
  std::vector<std::string> warnings;
  for (const std::string& content :
       {std::string(), kObj, std::string("\x1f", 1), std::string(9, '\0')}) {
    EXPECT_EQ(*Unpack(content, &warnings), content);
  }
  EXPECT_THAT(warnings, IsEmpty());
}

TEST(Unpacked, UnpacksGzipMemberByMember) {
  std::vector<std::string> warnings;
  std::string large;
  for (int i = 0; i < 100000; ++i) large += std::to_string(i * 7919LL % 100003) + "\n";
  EXPECT_EQ(*Unpack(Gzipped(large), &warnings), large);
  EXPECT_EQ(*Unpack(Gzipped("") + Gzipped("a") + Gzipped("b"), &warnings), "ab");
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(*Unpack(Gzipped("a") + "tail", &warnings), "a");
  EXPECT_THAT(warnings, ElementsAre("m: what is behind the packed content, 4 bytes, is ignored"));
}

TEST(Unpacked, RefusesWhatIsCutOrDamaged) {
  std::vector<std::string> warnings;
  const std::string whole = Gzipped(kObj);
  for (std::size_t size = 2; size < whole.size(); ++size) {
    EXPECT_EQ(Unpack(whole.substr(0, size), &warnings).status().message(),
              "m: the packed file (gzip) ends early; is it cut off?");
  }
  std::string damaged = whole;
  damaged[damaged.size() - 8] ^= 1;  // the check sum
  EXPECT_EQ(Unpack(damaged + "x", &warnings).status().message(),
            "m: the packed file (gzip) is damaged");
}

TEST(Unpacked, ASmallFileCannotFillTheMemory) {
  std::vector<std::string> warnings;
  const std::string zeros(std::size_t{1} << 25, '\0');  // shrinks to a thousandth
  const std::string packed = Gzipped(zeros);
  ASSERT_LT(kMostSwelling * packed.size(), zeros.size());
  EXPECT_EQ(Unpack(packed, &warnings).status().message(),
            "m: swells to more than 200 times its size; unpack it yourself if it is to be trusted");
}

TEST(Unpacked, TurnsUtf16IntoUtf8) {
  const std::string utf8 = "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80";  // 1 to 4 bytes a letter
  const std::string little = std::string(
      "\xFF\xFE"
      "a\0\xE9\0\xAC\x20\x3D\xD8\x00\xDE",
      12);
  std::string big = little;
  for (std::size_t i = 0; i < big.size(); i += 2) std::swap(big[i], big[i + 1]);
  std::vector<std::string> warnings;
  EXPECT_EQ(*Unpack(little, &warnings), utf8);
  EXPECT_EQ(*Unpack(big, &warnings), utf8);
  EXPECT_EQ(*Unpack(Gzipped(big), &warnings), utf8);
  EXPECT_EQ(warnings.size(), 3u);
  // Halves of a pair alone, and half a letter at the end.
  EXPECT_EQ(*Unpack(std::string("\xFF\xFE\x3D\xD8"
                                "a\0\x00\xDE"
                                "b",
                                9),
                    &warnings),
            "\xEF\xBF\xBD"
            "a\xEF\xBF\xBD");
}

TEST(Unpacked, EveryFormatIsReadPacked) {
  const TemporaryFolder folder;
  const PolygonSoup soup = *ParseMesh("m.obj", kObj);
  for (const std::string& extension : WritableExtensions()) {
    std::string text;
    const TextPieces pieces = *FormatMesh("m." + extension, soup);
    for (const std::string& piece : pieces) text += piece;
    for (const std::string& name : {"m." + extension + ".gz", "m." + extension, std::string("m")}) {
      ASSERT_TRUE(WriteFileAtomically(folder.Path(name), Gzipped(text)).ok());
      const StatusOr<PolygonSoup> read = ReadMesh(folder.Path(name));
      ASSERT_TRUE(read.ok()) << name << read.status().message();
      EXPECT_EQ(read->position, soup.position);
      EXPECT_EQ(read->corner, soup.corner);
      EXPECT_THAT(read->warnings, IsEmpty());
    }
  }
}

}  // namespace
}  // namespace cirque
