// Pictures read back as they were written, those of other programs by every filter, and what is no
// picture refused.
#include "cirque/io/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/file_input.h"
#include "cirque/io/png.h"

#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using testing::HasSubstr;

Image Pattern(int channels, int most) {
  Image image{5, 3, channels, most, {}};
  for (int i = 0; i < 15 * channels; ++i) {
    image.sample.push_back(static_cast<std::uint16_t>((i * 7919) % (most + 1)));
  }
  return image;
}

TEST(Image, WhatIsWrittenIsReadBack) {
  const TemporaryFolder folder;
  for (const int most : {255, 65535}) {
    for (int channels = 1; channels <= 4; ++channels) {
      for (const char* name : {"a.png", "a.pgm", "a.ppm"}) {
        const Image image = Pattern(channels, most);
        const Status written = WriteImage(folder.Path(name), image);
        const bool holds =
            std::string(name) == "a.png" || channels == (std::string(name) == "a.pgm" ? 1 : 3);
        ASSERT_EQ(written.ok(), holds) << name << channels;
        if (!holds) continue;
        const auto read = ReadImage(folder.Path(name));
        ASSERT_TRUE(read.ok()) << read.status().message();
        EXPECT_EQ(read->width, 5);
        EXPECT_EQ(read->height, 3);
        EXPECT_EQ(read->channels, channels);
        EXPECT_EQ(read->most, most);
        EXPECT_EQ(read->sample, image.sample) << name << channels;
      }
    }
  }
}

TEST(Image, EveryFilterOfPngIsUndone) {
  // Five rows of grey, all 10 20 30, each by its filter: none, left, above, their mean, Paeth's.
  const std::string rows = {0, 10, 20, 30, 1, 10, 10, 10, 2, 0, 0, 0, 3, 5, 5, 5, 4, 0, 0, 0};
  const auto read = ParseImage("a", FormatPng(3, 5, PngColour::kGrey, rows));
  ASSERT_TRUE(read.ok()) << read.status().message();
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i < 3; ++i) EXPECT_EQ(read->sample[3 * row + i], 10 * (i + 1)) << row;
  }
}

TEST(Image, NetpbmHeadersHaveCommentsAndGreatestSamples) {
  const auto read = ParseImage("a", "P5 # made by hand\n2\t1 # size\n9\n\x03\x09");
  ASSERT_TRUE(read.ok()) << read.status().message();
  EXPECT_EQ(read->most, 9);
  EXPECT_EQ(read->sample, (std::vector<std::uint16_t>{3, 9}));
}

TEST(Image, WhatIsNoPictureIsRefused) {
  const std::string png = FormatPng(3, 1, PngColour::kGrey, std::string("\0abc", 4));
  for (const auto& [content, why] : std::vector<std::pair<std::string, std::string>>{
           {"v 0 0 0\n", "PNG, PGM (P5) or PPM (P6)"},
           {"P5 2", "a header of"},
           {"P5 2 2 70000 ", "greatest sample"},
           {"P5 0 2 255 ", "at least 1 x 1"},
           {"P6 100000 100000 255 ", "samples"},
           {"P5 2 2 255 abc", "ends early"},
           {png.substr(0, png.size() - 20), "ends early"},
           {FormatPng(4, 1, PngColour::kGrey, std::string("\0abc", 4)), "damaged"}}) {
    const auto read = ParseImage("p.png", content);
    ASSERT_FALSE(read.ok()) << why;
    EXPECT_EQ(read.status().code(), StatusCode::kInvalidInput);
    EXPECT_THAT(read.status().message(), HasSubstr(why));
    EXPECT_THAT(read.status().message(), HasSubstr("p.png: "));
  }
  std::string palette = png;
  palette[25] = 3;
  EXPECT_THAT(ParseImage("p", palette).status().message(), HasSubstr("palette"));
  EXPECT_THAT(WriteImage("a.gif", Pattern(1, 255)).message(), HasSubstr(".png"));
}

}  // namespace
}  // namespace cirque
