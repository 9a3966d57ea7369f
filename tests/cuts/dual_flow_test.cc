#include "cirque/cuts/dual_flow.h"

#include <cstdint>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

namespace cirque {
namespace {

TEST(DualFlow, PartsAPathAtItsWeakestJoint) {
  DualFlow flow(4);
  flow.Join(0, 1, 3), flow.Join(1, 2, 1), flow.Join(2, 3, 2);
  flow.SetSource(0), flow.SetSink(3);
  EXPECT_EQ(flow.MinimumCut(), (std::vector<bool>{true, true, false, false}));
}

TEST(DualFlow, IsCheapestOfAllCuts) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 40; ++trial) {
    const int n = 8;
    std::vector<std::tuple<int, int, std::int64_t>> joints;
    for (int k = 0; k < 16; ++k) {
      joints.emplace_back(random() % n, random() % n, random() % 100);
    }
    const auto cost = [&](const std::vector<bool>& side) {
      std::int64_t sum = 0;
      for (const auto& [a, b, capacity] : joints) sum += side[a] != side[b] ? capacity : 0;
      return sum;
    };
    DualFlow flow(n);
    for (const auto& [a, b, capacity] : joints) flow.Join(a, b, capacity);
    flow.SetSource(0), flow.SetSource(1), flow.SetSink(2);
    const std::vector<bool> cut = flow.MinimumCut();
    EXPECT_TRUE(cut[0] && cut[1] && !cut[2]);
    std::int64_t least = 1 << 20;
    for (int bits = 0; bits < 1 << n; ++bits) {
      std::vector<bool> side(n);
      for (int v = 0; v < n; ++v) side[v] = (bits >> v) & 1;
      if (side[0] && side[1] && !side[2]) least = std::min(least, cost(side));
    }
    EXPECT_EQ(cost(cut), least);
  }
}

}  // namespace
}  // namespace cirque
