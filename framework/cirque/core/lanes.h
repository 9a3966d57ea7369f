#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace cirque {

/// Four doubles that an instruction works on together where the processor has such, on others one after
/// another. Sums, products, quotients and comparisons (`a < b ? c : d` too) are those of doubles, lane
/// by lane: a function template of T, a double or Lanes, has the same results for both, everywhere.
using Lanes = double __attribute__((vector_size(32)));

constexpr int kLanes = 4;

namespace lanes {

using Words = std::uint64_t __attribute__((vector_size(32)));

constexpr std::uint64_t kSign = UINT64_C(1) << 63;

inline std::uint64_t ToBits(double x) { return std::bit_cast<std::uint64_t>(x); }
inline double FromBits(std::uint64_t bits) { return std::bit_cast<double>(bits); }

// Templates, of which only a loop over lanes makes functions.
template <class T>
[[gnu::always_inline]] inline Words ToBits(T x) {
  return std::bit_cast<Words>(x);
}
template <class W>
[[gnu::always_inline]] inline Lanes FromBits(W bits) {
  return std::bit_cast<Lanes>(bits);
}

template <class T = Lanes>
[[gnu::always_inline]] inline T Load(const double* from) {
  T x;
  std::memcpy(&x, from, sizeof(x));
  return x;
}

template <class T>
[[gnu::always_inline]] inline T Absolute(T x) {
  return FromBits(ToBits(x) & ~kSign);
}

/// The size of the first, the sign of the second.
template <class T>
[[gnu::always_inline]] inline T CopySign(T size, T sign) {
  return FromBits((ToBits(size) & ~kSign) | (ToBits(sign) & kSign));
}

/// The nearest whole number, for sizes up to 2^51.
template <class T>
[[gnu::always_inline]] inline T Round(T x) {
  constexpr double kShift = 0x1.8p52;
  return (x + kShift) - kShift;
}

/// 2^k, for whole numbers k from -1022 to 1023.
template <class T>
[[gnu::always_inline]] inline T PowerOfTwo(T k) {
  constexpr double kShift =
      0x1.8p52 + 1023;  // the sum's last bits are k's with the exponent's bias
  return FromBits(ToBits(k + kShift) << 52);
}

/// x = fraction 2^exponent with sqrt(1/2) <= fraction < sqrt(2), of a positive normal number.
template <class T>
struct BinaryScale {
  T fraction, exponent;
};

template <class T>
[[gnu::always_inline]] inline BinaryScale<T> Split(T x) {
  constexpr std::uint64_t kRootOfHalf = UINT64_C(0x3fe6a09e667f3bcd);
  constexpr std::uint64_t kExponent = UINT64_C(0xfff) << 52, kBias = UINT64_C(1024) << 52;
  // Counted from that root's bits, all numbers between two powers of 2 times it have one exponent.
  const auto exponent = (ToBits(x) - kRootOfHalf) & kExponent;
  // The double 1.5 2^52 + k has a whole number k in its last bits.
  const auto biased = ((exponent + kBias) >> 52) | ToBits(0x1.8p52);
  return {FromBits(ToBits(x) - exponent), FromBits(biased) - (0x1.8p52 + 1024)};
}

#ifdef __x86_64__
template <class Body>
[[gnu::target("avx2")]] inline void CallByAvx2(const Body& body) {
  body();
}
#endif

}  // namespace lanes

/// Calls body(), compiled for lanes as wide as the processor has. `body`, and what it calls, is always
/// inlined: [&]() __attribute__((always_inline)) { ... }. Sources of those that pass Lanes on are
/// compiled with -Wno-psabi.
template <class Body>
inline void OnWideLanes(const Body& body) {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return lanes::CallByAvx2(body);
#endif
  body();
}

}  // namespace cirque
