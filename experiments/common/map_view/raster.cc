#include "experiments/common/map_view/raster.h"

#include <algorithm>
#include <cmath>

#include "cirque/io/png.h"

namespace cirque {
namespace {

std::uint8_t Byte(float value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.f, 1.f)));
}

/// Each row as its differences from the pixel to the left (filter 1), which deflate well.
std::string FilteredRows(const RgbaImage& image) {
  std::string rows;
  const std::size_t length = 4 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* row = image.rgba.data() + y * length;
    rows.push_back(1);
    for (std::size_t i = 0; i < length; ++i) {
      rows.push_back(static_cast<char>(row[i] - (i < 4 ? 0 : row[i - 4])));
    }
  }
  return rows;
}

}  // namespace

std::string EncodePng(const RgbaImage& image) {
  return FormatPng(image.width, image.height, PngColour::kRgba, FilteredRows(image));
}

Raster::Raster(int width, int height)
    : width_(width),
      height_(height),
      columns_(width * kSamples),
      rows_(height * kSamples),
      sample_(static_cast<std::size_t>(columns_) * rows_, {0, 0, 0, 0}),
      depth_(sample_.size(), std::numeric_limits<float>::infinity()) {}

std::array<Raster::Range, 2> Raster::Box(const Eigen::Vector2d& low,
                                         const Eigen::Vector2d& high) const {
  const auto range = [](double from, double to, int count) {
    const double most = count;
    return Range{static_cast<int>(std::clamp(std::floor(from * kSamples), 0., most)),
                 static_cast<int>(std::clamp(std::ceil(to * kSamples + 1), 0., most))};
  };
  return {range(low.x(), high.x(), columns_), range(low.y(), high.y(), rows_)};
}

void Raster::Put(int x, int y, double depth, const Rgb& colour) {
  sample_[At(x, y)] = {Byte(colour[0]), Byte(colour[1]), Byte(colour[2]), 255};
  depth_[At(x, y)] = static_cast<float>(depth);
}

void Raster::Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width,
                  const Rgb& colour) {
  const Eigen::Vector2d a = from.head<2>(), along = to.head<2>() - a;
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(width / 2);
  const auto [columns, rows] = Box(a.cwiseMin(a + along) - margin, a.cwiseMax(a + along) + margin);
  const double length2 = along.squaredNorm();
  for (int y = rows[0]; y < rows[1]; ++y) {
    for (int x = columns[0]; x < columns[1]; ++x) {
      const Eigen::Vector2d p = Sample(x, y) - a;
      const double t = length2 > 0 ? std::clamp(p.dot(along) / length2, 0., 1.) : 0;
      if ((p - t * along).norm() > width / 2) continue;
      const double depth = (1 - t) * from.z() + t * to.z();
      if (IsFree(x, y, depth)) Put(x, y, depth, colour);
    }
  }
}

void Raster::Rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Rgb& colour) {
  const auto [columns, rows] = Box(low, high);
  for (int y = rows[0]; y < rows[1]; ++y) {
    for (int x = columns[0]; x < columns[1]; ++x) {
      const Eigen::Vector2d p = Sample(x, y);
      const bool inside = (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
      if (inside && IsFree(x, y, 0)) Put(x, y, 0, colour);
    }
  }
}

/// A pixel's colour is the mean of its opaque points, its opacity their share.
RgbaImage Raster::Finish() const {
  RgbaImage image = {width_, height_, {}};
  image.rgba.reserve(4 * static_cast<std::size_t>(width_) * height_);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      std::array<int, 3> sum = {0, 0, 0};
      int opaque = 0;
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const auto& at = sample_[At(x * kSamples + i % kSamples, y * kSamples + i / kSamples)];
        if (at[3] == 0) continue;
        ++opaque;
        for (int k = 0; k < 3; ++k) sum[k] += at[k];
      }
      const int divisor = std::max(opaque, 1);
      for (const int channel : sum) {
        image.rgba.push_back(static_cast<std::uint8_t>((channel + divisor / 2) / divisor));
      }
      image.rgba.push_back(static_cast<std::uint8_t>(255 * opaque / (kSamples * kSamples)));
    }
  }
  return image;
}

void Paste(const RgbaImage& image, int x, int y, RgbaImage* onto) {
  for (int row = std::max(0, -y); row < std::min(image.height, onto->height - y); ++row) {
    for (int column = std::max(0, -x); column < std::min(image.width, onto->width - x); ++column) {
      const std::size_t i = 4 * (static_cast<std::size_t>(row) * image.width + column);
      const std::size_t j = 4 * (static_cast<std::size_t>(row + y) * onto->width + column + x);
      const int opacity = image.rgba[i + 3];
      for (std::size_t k = 0; k < 3; ++k) {
        const int mixed = image.rgba[i + k] * opacity + onto->rgba[j + k] * (255 - opacity);
        onto->rgba[j + k] = static_cast<std::uint8_t>((mixed + 127) / 255);
      }
      onto->rgba[j + 3] = static_cast<std::uint8_t>(std::max<int>(opacity, onto->rgba[j + 3]));
    }
  }
}

}  // namespace cirque
