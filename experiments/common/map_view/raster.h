#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace cirque {

/// Red, green, blue, each from 0 to 1.
using Rgb = Eigen::Vector3f;

/// A finished picture: red, green, blue and opacity of every pixel, row by row from the top.
struct RgbaImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// The picture as a PNG of 8 bits a channel (W3C's PNG specification, third edition).
std::string EncodePng(const RgbaImage& image);

/// A picture being painted, transparent at first. It is kept at kSamples x kSamples points a pixel,
/// whose mean a pixel is in the end, so that edges are smooth. Coordinates are those of the finished
/// picture: (0, 0) is the top left corner, x to the right, y down; what has a larger depth is hidden.
class Raster {
 public:
  Raster(int width, int height);

  /// `colour(b)` is asked for at every point of the triangle, b its barycentric coordinates. Either
  /// orientation; the third coordinate of a corner is its depth.
  template <class ColourAt>
  void Triangle(const std::array<Eigen::Vector3d, 3>& corner, const ColourAt& colour) {
    const Eigen::Vector2d a = corner[0].head<2>(), b = corner[1].head<2>(), c = corner[2].head<2>();
    const double area = Cross(b - a, c - a);
    if (area == 0 || !std::isfinite(area)) return;
    const auto [columns, rows] = Box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
    for (int y = rows[0]; y < rows[1]; ++y) {
      for (int x = columns[0]; x < columns[1]; ++x) {
        const Eigen::Vector2d p = Sample(x, y);
        const Eigen::Vector3d at(Cross(b - p, c - p) / area, Cross(c - p, a - p) / area,
                                 Cross(a - p, b - p) / area);
        if (at.minCoeff() < 0) continue;
        const double depth = at[0] * corner[0].z() + at[1] * corner[1].z() + at[2] * corner[2].z();
        if (IsFree(x, y, depth)) Put(x, y, depth, colour(at));
      }
    }
  }

  /// A line with round ends; a disk where they are the same.
  void Line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width,
            const Rgb& colour);

  void Rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Rgb& colour);

  RgbaImage Finish() const;

 private:
  static constexpr int kSamples = 3;

  static double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  }
  static Eigen::Vector2d Sample(int x, int y) {
    return Eigen::Vector2d(x + 0.5, y + 0.5) / kSamples;
  }
  using Range = std::array<int, 2>;
  /// The columns and rows of the points in a box, within the picture.
  std::array<Range, 2> Box(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

  bool IsFree(int x, int y, double depth) const {
    return static_cast<float>(depth) <= depth_[At(x, y)];
  }
  void Put(int x, int y, double depth, const Rgb& colour);
  std::size_t At(int x, int y) const { return static_cast<std::size_t>(y) * columns_ + x; }

  int width_, height_, columns_, rows_;
  std::vector<std::array<std::uint8_t, 4>> sample_;
  std::vector<float> depth_;
};

/// Copies an image's opaque pixels over another's, its top left corner at (x, y), and mixes where it
/// is not quite opaque. What reaches beyond is left out.
void Paste(const RgbaImage& image, int x, int y, RgbaImage* onto);

}  // namespace cirque
