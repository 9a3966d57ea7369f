#include "cirque/math/exact_integer.h"

#include <random>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

namespace cirque {
namespace {

using cpp_int = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

/// Two integers that must be equal, built side by side.
struct Pair {
  ExactInteger ours;
  cpp_int theirs;
};

Pair Make(std::int64_t mantissa, int shift) {
  return {ExactInteger(mantissa, shift), cpp_int(mantissa) << shift};
}

/// Equality by the sign of the difference with the boost value, rebuilt from its own bits.
void ExpectEqual(const Pair& p) {
  EXPECT_EQ(p.ours.Sign(), p.theirs.sign());
  ExactInteger rebuilt;
  const cpp_int magnitude = abs(p.theirs);
  for (unsigned bit = 0; p.theirs != 0 && bit <= msb(magnitude); ++bit) {
    if (bit_test(magnitude, bit)) rebuilt = rebuilt + ExactInteger(p.theirs.sign(), bit);
  }
  EXPECT_EQ((p.ours - rebuilt).Sign(), 0);
}

TEST(ExactInteger, AgreesWithBoostOnSumsAndProducts) {
  std::mt19937_64 random(1);
  const auto draw = [&] {
    const std::int64_t mantissa = static_cast<std::int64_t>(random()) >> (random() % 64);
    return Make(mantissa, static_cast<int>(random() % 200));
  };
  for (int i = 0; i < 200; ++i) {
    const Pair a = draw(), b = draw(), c = draw();
    ExpectEqual({a.ours + b.ours, a.theirs + b.theirs});
    ExpectEqual({a.ours - b.ours, a.theirs - b.theirs});
    ExpectEqual({a.ours * b.ours - c.ours * a.ours, a.theirs * b.theirs - c.theirs * a.theirs});
  }
}

TEST(ExactInteger, CarriesAndBorrowsRunThroughAllLimbs) {
  const ExactInteger one(1, 0), power(1, 4000);
  const ExactInteger ones = power - one;
  EXPECT_EQ((ones + one - power).Sign(), 0);
  EXPECT_EQ((ones * ones - (power * power - power - power + one)).Sign(), 0);
  EXPECT_EQ((ones - power).Sign(), -1);
}

TEST(ExactInteger, ExtremeMantissasAndZero) {
  ExpectEqual(Make(INT64_MIN, 31));
  ExpectEqual(Make(INT64_MAX, 1));
  ExpectEqual(Make(0, 1000));
  EXPECT_EQ((ExactInteger(0, 0) * ExactInteger(-7, 3)).Sign(), 0);
  EXPECT_EQ((-ExactInteger()).Sign(), 0);
}

}  // namespace
}  // namespace cirque
