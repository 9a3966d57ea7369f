#pragma once

#include "cirque/linear/ranks.h"

namespace cirque {

/// What the ranks of a program know to do: one line a work in rank_works.cc, for ServeOtherRanks.
const RankWorks& AllRankWorks();

}  // namespace cirque
