#include "experiments/common/map_view/sha256.h"

#include <bit>
#include <cmath>
#include <string>

namespace cirque {
namespace {

using Word = std::uint32_t;

constexpr int kRounds = 64, kBlock = 64;  // bytes of a block

/// The first 32 bits of the fractional part of the root of a prime: of its cube root in every
/// round, of its square root for the first state.
Word FractionOf(long double root) {
  return static_cast<Word>((root - std::floor(root)) * 4294967296.0L);
}

bool IsPrime(int n) {
  for (int d = 2; d * d <= n; ++d) {
    if (n % d == 0) return false;
  }
  return true;
}

struct Constants {
  std::array<Word, kRounds> round;
  std::array<Word, 8> state;
};

const Constants& TheConstants() {
  static const Constants kConstants = [] {
    Constants constants;
    int prime = 1;
    for (int i = 0; i < kRounds; ++i) {
      do {
        ++prime;
      } while (!IsPrime(prime));
      constants.round[i] = FractionOf(std::cbrt(static_cast<long double>(prime)));
      if (i < 8) constants.state[i] = FractionOf(std::sqrt(static_cast<long double>(prime)));
    }
    return constants;
  }();
  return kConstants;
}

/// The bytes, a one bit, zeros, and the number of bits as 64 of them, in whole blocks.
std::string Padded(std::string_view bytes) {
  std::string padded(bytes);
  padded += '\x80';
  while (padded.size() % kBlock != kBlock - 8) padded += '\0';
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(bits >> shift & 0xff);
  return padded;
}

std::array<Word, kRounds> Schedule(std::string_view block) {
  std::array<Word, kRounds> w = {};
  for (int i = 0; i < kBlock; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<std::uint8_t>(block[i]);
  for (int i = 16; i < kRounds; ++i) {
    const Word a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) + w[i - 7] +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
  }
  return w;
}

void Compress(std::string_view block, std::array<Word, 8>* state) {
  const std::array<Word, kRounds> w = Schedule(block);
  auto [a, b, c, d, e, f, g, h] = *state;
  for (int i = 0; i < kRounds; ++i) {
    const Word choice = (e & f) ^ (~e & g), majority = (a & b) ^ (a & c) ^ (b & c);
    const Word first = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + choice +
                       TheConstants().round[i] + w[i];
    const Word second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + majority;
    h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
  }
  const Word next[] = {a, b, c, d, e, f, g, h};
  for (int i = 0; i < 8; ++i) (*state)[i] += next[i];
}

}  // namespace

std::array<std::uint8_t, 32> Sha256(std::string_view bytes) {
  const std::string padded = Padded(bytes);
  std::array<Word, 8> state = TheConstants().state;
  for (std::size_t at = 0; at < padded.size(); at += kBlock) {
    Compress(std::string_view(padded).substr(at, kBlock), &state);
  }
  std::array<std::uint8_t, 32> digest;
  for (int i = 0; i < 32; ++i) {
    digest[i] = static_cast<std::uint8_t>(state[i / 4] >> (24 - 8 * (i % 4)));
  }
  return digest;
}

}  // namespace cirque
