#include "cirque/math/exact_integer.h"

#include <algorithm>

#include <glog/logging.h>

namespace cirque {

ExactInteger::ExactInteger(std::int64_t mantissa, int shift) : sign_(mantissa < 0 ? -1 : 1) {
  if (mantissa == 0) return;
  CHECK_GE(shift, 0);
  std::uint64_t magnitude = static_cast<std::uint64_t>(mantissa);
  if (mantissa < 0) magnitude = ~magnitude + 1;
  for (int i = 0; i < shift / 32; ++i) Push(0);
  const int bits = shift % 32;
  Push(static_cast<std::uint32_t>(magnitude << bits));
  magnitude >>= 32 - bits;
  Push(static_cast<std::uint32_t>(magnitude));
  Push(static_cast<std::uint32_t>(magnitude >> 32));
  Trim();
}

ExactInteger& ExactInteger::operator=(const ExactInteger& other) {
  size_ = other.size_;
  sign_ = other.sign_;
  std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
  return *this;
}

ExactInteger ExactInteger::operator-() const {
  ExactInteger negative = *this;
  negative.sign_ = -sign_;
  return negative;
}

ExactInteger operator+(const ExactInteger& a, const ExactInteger& b) {
  if (a.sign_ == b.sign_) return ExactInteger::AddMagnitudes(a, b);
  return ExactInteger::CompareMagnitude(a, b) >= 0 ? ExactInteger::SubtractMagnitudes(a, b)
                                                   : ExactInteger::SubtractMagnitudes(b, a);
}

ExactInteger operator*(const ExactInteger& a, const ExactInteger& b) {
  ExactInteger product;
  if (a.size_ == 0 || b.size_ == 0) return product;
  for (int k = 0; k < a.size_ + b.size_; ++k) product.Push(0);
  for (int i = 0; i < a.size_; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < b.size_; ++j) {
      carry += std::uint64_t{a.limbs_[i]} * b.limbs_[j] + product.limbs_[i + j];
      product.limbs_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    product.limbs_[i + b.size_] = static_cast<std::uint32_t>(carry);
  }
  product.sign_ = a.sign_ * b.sign_;
  product.Trim();
  return product;
}

int ExactInteger::CompareMagnitude(const ExactInteger& a, const ExactInteger& b) {
  if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
  for (int i = a.size_ - 1; i >= 0; --i) {
    if (a.limbs_[i] != b.limbs_[i]) return a.limbs_[i] < b.limbs_[i] ? -1 : 1;
  }
  return 0;
}

ExactInteger ExactInteger::AddMagnitudes(const ExactInteger& a, const ExactInteger& b) {
  if (a.size_ < b.size_) return AddMagnitudes(b, a);
  ExactInteger sum;
  sum.sign_ = a.sign_;
  std::uint64_t carry = 0;
  for (int i = 0; i < a.size_; ++i) {
    carry += std::uint64_t{a.limbs_[i]} + (i < b.size_ ? b.limbs_[i] : 0u);
    sum.Push(static_cast<std::uint32_t>(carry));
    carry >>= 32;
  }
  if (carry != 0) sum.Push(static_cast<std::uint32_t>(carry));
  return sum;
}

ExactInteger ExactInteger::SubtractMagnitudes(const ExactInteger& a, const ExactInteger& b) {
  ExactInteger difference;
  difference.sign_ = a.sign_;
  std::uint64_t borrow = 0;
  for (int i = 0; i < a.size_; ++i) {
    const std::uint64_t limb =
        std::uint64_t{a.limbs_[i]} - (i < b.size_ ? b.limbs_[i] : 0u) - borrow;
    difference.Push(static_cast<std::uint32_t>(limb));
    borrow = limb >> 63;
  }
  difference.Trim();
  return difference;
}

void ExactInteger::Push(std::uint32_t limb) {
  CHECK_LT(size_, kCapacity);
  limbs_[size_++] = limb;
}

void ExactInteger::Trim() {
  while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
}

}  // namespace cirque
