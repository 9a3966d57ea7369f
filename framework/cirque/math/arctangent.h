#pragma once

#include <algorithm>
#include <cmath>

#include "cirque/core/types.h"
#include "cirque/math/pi.h"

namespace cirque {

/// (arctan(t) / t - 1) / t^2 as a polynomial of z = t^2 in [0, tan(pi/8)^2]: interpolated at Chebyshev's
/// points to 40 digits and rounded to doubles, with which arctan is off by at most 0.03 ulp (measured
/// at 2001 points, and against 50 digits in the tests).
inline double ArctangentTail(double z) {
  constexpr double c[] = {-0x1.5555555555555p-2, 0x1.9999999999953p-3,  -0x1.249249248d7eep-3,
                          0x1.c71c71c304b64p-4,  -0x1.745d165df3ee7p-4, 0x1.3b1392d9e64b0p-4,
                          -0x1.110e880a643d8p-4, 0x1.e19a13b800ab6p-5,  -0x1.ac7a937cce153p-5,
                          0x1.74ddd3c6187b4p-5,  -0x1.1b33b8784aa69p-5, 0x1.0ad368c98424cp-6};
  const double z2 = z * z, z4 = z2 * z2;
  const double low = (c[0] + c[1] * z) + (c[2] + c[3] * z) * z2;
  const double middle = (c[4] + c[5] * z) + (c[6] + c[7] * z) * z2;
  const double high = (c[8] + c[9] * z) + (c[10] + c[11] * z) * z2;
  return low + (middle + high * z4) * z4;
}

/// std::atan2 in a fraction of its time, to 2 ulp, relatively exact towards 0: sums and products, and one
/// quotient, whose results are the same on every processor. Without branches but for numbers of
/// extreme size, which are left to std::atan2.
inline double Arctangent(double y, double x) {
  constexpr double kTangentOfPi8 = 0x1.a827999fcef32p-2;
  const double height = std::abs(y), width = std::abs(x);
  const double long_side = std::max(height, width), short_side = std::min(height, width);
  const bool ordinary = long_side > 0x1p-900 && height < 0x1p900 && width < 0x1p900;
  if (!ordinary) return std::atan2(y, x);
  const bool near =
      short_side > kTangentOfPi8 * long_side;  // arctan(t) = pi/4 - arctan((1-t)/(1+t))
  const double t =
      near ? (short_side - long_side) / (short_side + long_side) : short_side / long_side;
  const double z = t * t, tail = t * z * ArctangentTail(z);
  double angle = near ? 0.25 * kPi + (t + (tail + 0.25 * kPiLow)) : t + tail;
  if (height > width) angle = 0.5 * kPi - (angle - 0.5 * kPiLow);
  if (x < 0) angle = kPi - (angle - kPiLow);
  return std::copysign(angle, y);
}

}  // namespace cirque
