#include "tests/io/glb_file.h"

#include <zlib.h>

#include <cmath>

namespace cirque {
namespace {

std::uint32_t Number(const std::string& bytes, std::size_t at,
                     ByteOrder order = ByteOrder::kLittle) {
  return ReadBytes<std::uint32_t>(std::string_view(bytes).substr(at), order);
}

}  // namespace

GlbFile::GlbFile(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(Number(bytes, 4), 2u);
  EXPECT_EQ(Number(bytes, 8), bytes.size());
  const std::uint32_t length = Number(bytes, 12);
  EXPECT_EQ(length % 4, 0u);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  json = nlohmann::json::parse(bytes.substr(20, length));
  EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
  buffer_ = bytes.substr(28 + length);
  EXPECT_EQ(Number(bytes, 20 + length), buffer_.size());
  EXPECT_EQ(json["buffers"][0]["byteLength"], buffer_.size());
  for (const auto& view : json["bufferViews"]) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
              buffer_.size());
  }
}

std::string GlbFile::View(int view) const {
  const auto& v = json["bufferViews"][view];
  return buffer_.substr(v["byteOffset"], v["byteLength"]);
}

SquarePicture::SquarePicture(const std::string& png) {
  EXPECT_EQ(png.substr(0, 16), std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
  const auto big = [&](std::size_t at) { return Number(png, at, ByteOrder::kBig); };
  side = static_cast<int>(big(16));
  EXPECT_EQ(big(20), big(16));
  EXPECT_EQ(png[24], 8);
  channels = png[25] == 2 ? 3 : 1;
  const std::uint32_t packed = big(33);
  EXPECT_EQ(png.substr(37, 4), "IDAT");
  EXPECT_EQ(big(41 + packed), crc32(0, reinterpret_cast<const Bytef*>(&png[37]), packed + 4));
  rows.assign(static_cast<std::size_t>(side) * (channels * side + 1), '\0');
  uLongf size = rows.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                       reinterpret_cast<const Bytef*>(&png[41]), packed),
            Z_OK);
  EXPECT_EQ(size, rows.size());
}

int SquarePicture::At(int x, int y, int channel) const {
  const std::size_t row = static_cast<std::size_t>(y) * (channels * side + 1);
  EXPECT_EQ(rows[row], 0);
  return static_cast<unsigned char>(rows[row + 1 + channels * x + channel]);
}

double SquarePicture::Sample(const Eigen::Vector2d& place, int channel) const {
  const Eigen::Vector2d pixel = side * place - Eigen::Vector2d(0.5, 0.5);
  const Eigen::Vector2d low = pixel.array().floor(), part = pixel - low;
  const auto at = [&](int i, int j) {
    const auto wrapped = [&](double k) {
      return static_cast<int>(k - side * std::floor(k / side));
    };
    return At(wrapped(low.x() + i), wrapped(low.y() + j), channel);
  };
  return (1 - part.y()) * ((1 - part.x()) * at(0, 0) + part.x() * at(1, 0)) +
         part.y() * ((1 - part.x()) * at(0, 1) + part.x() * at(1, 1));
}

}  // namespace cirque
