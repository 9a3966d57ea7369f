#include "cirque/domains/extreme_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cirque {
namespace {

constexpr int kSafeExponent = 300;

template <class Derived>
auto TimesPowerOfTwo(const Eigen::MatrixBase<Derived>& values, int exponent) {
  return values.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); }).eval();
}

}  // namespace

int ExtremeExponent(const Surface& surface) {
  double largest = 0;
  for (const Eigen::Vector3d& x : surface.position) {
    largest = std::max(largest, x.cwiseAbs().maxCoeff());
  }
  if (!(largest > 0) || !std::isfinite(largest)) return 0;
  const int exponent = std::ilogb(largest);
  return std::abs(exponent) > kSafeExponent ? exponent : 0;
}

Surface Scaled(Surface surface, int exponent) {
  for (Eigen::Vector3d& x : surface.position) x = TimesPowerOfTwo(x, exponent);
  return surface;
}

void ScaleMap(int exponent, SurfaceMap* map) {
  for (Eigen::Vector2d& uv : map->uv.value) uv = TimesPowerOfTwo(uv, exponent);
  if (map->exact_map) {
    for (Eigen::Vector2d& uv : map->exact_map->uv) uv = TimesPowerOfTwo(uv, exponent);
  }
  FlatSurface& flat = map->flat;
  for (EdgeLengths* lengths :
       {&flat.intrinsic.lengths, &flat.intrinsic_lengths, &flat.on_input.lengths}) {
    lengths->value = TimesPowerOfTwo(lengths->value, exponent);
  }
  flat.log_radii.value.array() += exponent * std::log(2.0);
}

}  // namespace cirque
