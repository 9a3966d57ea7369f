#pragma once

#include <functional>
#include <initializer_list>
#include <string>

#include <benchmark/benchmark.h>

namespace cirque {

/// Sizes in triangles that every suite of stages measures.
inline constexpr int kSmall = 2000, kLarge = 20000;

/// Registers "NAME/SIZE" for every size, in milliseconds of CPU time. Quiets Ceres, whose warnings
/// are in the summaries. True, for a constant to be initialised by.
bool RegisterBySize(const std::string& name, std::initializer_list<int> sizes,
                    const std::function<void(benchmark::State&, int size)>& run);

/// Counters of a run on that many faces: `faces`, and items a second.
void CountFaces(benchmark::State& state, int faces);

}  // namespace cirque
