#pragma once

#include <array>
#include <cstdint>

namespace cirque {

/// A signed integer of fixed capacity on the stack: magnitude in limbs of 32 bits, least first.
///
/// The capacity holds every polynomial of degree 4 in differences of finite doubles, brought to
/// their common denominator 2^k: 4 (1024 + 1074 + 1) bits and a few of carry. Exceeding it is a
/// broken caller. Serves the exact branch of the geometric predicates only: plain schoolbook
/// arithmetic, fast because ordinary coordinates fill two or three limbs.
class ExactInteger {
 public:
  ExactInteger() = default;
  ExactInteger(const ExactInteger& other) { *this = other; }
  ExactInteger& operator=(const ExactInteger& other);
  /// mantissa * 2^shift, shift >= 0.
  ExactInteger(std::int64_t mantissa, int shift);

  int Sign() const { return size_ == 0 ? 0 : sign_; }
  ExactInteger operator-() const;

  friend ExactInteger operator+(const ExactInteger& a, const ExactInteger& b);
  friend ExactInteger operator-(const ExactInteger& a, const ExactInteger& b) { return a + (-b); }
  friend ExactInteger operator*(const ExactInteger& a, const ExactInteger& b);

 private:
  static constexpr int kCapacity = 4 * (1024 + 1074 + 1) / 32 + 4;

  static int CompareMagnitude(const ExactInteger& a, const ExactInteger& b);
  static ExactInteger AddMagnitudes(const ExactInteger& a, const ExactInteger& b);
  /// |a| - |b|; |a| >= |b|.
  static ExactInteger SubtractMagnitudes(const ExactInteger& a, const ExactInteger& b);
  void Push(std::uint32_t limb);
  void Trim();

  int size_ = 0;
  int sign_ = 1;
  std::array<std::uint32_t, kCapacity> limbs_;  ///< only the first size_ are ever read
};

}  // namespace cirque
