#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/io/file_input.h"

namespace cirque {

/// A binary glTF as its readers see it, every length in it checked.
class GlbFile {
 public:
  explicit GlbFile(const std::string& bytes);

  std::string View(int view) const;

  /// The numbers of an accessor, `row` of them of a `shape`.
  template <class T>
  std::vector<T> Accessor(int number, const std::string& shape, std::size_t row) const {
    const auto& accessor = json["accessors"][number];
    EXPECT_EQ(accessor["type"], shape);
    const std::string bytes = View(accessor["bufferView"]);
    EXPECT_EQ(bytes.size(), accessor["count"].get<std::size_t>() * row * sizeof(T));
    std::vector<T> numbers;
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(T)) {
      numbers.push_back(ReadBytes<T>(std::string_view(bytes).substr(at), ByteOrder::kLittle));
    }
    return numbers;
  }

  nlohmann::json json;

 private:
  std::string buffer_;
};

/// A picture of 8 bits a channel, square, without filters.
struct SquarePicture {
  explicit SquarePicture(const std::string& png);

  int At(int x, int y, int channel = 0) const;

  /// As glTF samples a texture that repeats, between the four nearest pixels; v counts downwards.
  double Sample(const Eigen::Vector2d& place, int channel = 0) const;

  int side = 0, channels = 0;
  std::string rows;
};

}  // namespace cirque
