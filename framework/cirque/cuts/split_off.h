#pragma once

#include <vector>

#include "cirque/core/triangulation.h"

namespace cirque {

/// The cut with further edges opened, so that no patch has both some of the faces and others: those of
/// a patch are parted from the rest of it, and where they are all of it, from each other. Patches need
/// be no disks then (CompleteCut). O(F).
/// @pre one flag an edge; faces of the triangulation, in any order.
Cut SplitOff(const Triangulation& triangulation, const Cut& given, const std::vector<Index>& faces);

}  // namespace cirque
