#pragma once

#include <atomic>
#include <vector>

#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// A map of a surface opened along a cut, without flipped faces.
struct OpenedImage {
  const Triangulation& triangulation;
  const Cut& cut;
  const CornerUv& uv;
  const std::vector<bool>* closed = nullptr;  ///< E: edges that should stay closed; null: none
};

/// The cut with further edges opened so that every patch of the image covers no point twice, in few
/// patches ("charts"), exactly. Two sheets of the image that lie upon each other (a component of the
/// pairs of faces whose interiors meet) are parted by the cut between them that is shortest in the
/// image: a minimum cut of the dual graph, along the edges of a shortest path from boundary to
/// boundary. So on until no sheets are left in one patch; and once more with cuts about halfway between
/// sheets, which part others on the way; at last neighbours that fit are made one again. The fewer
/// charts are the result, of as many the shorter cut. Closed edges are opened only where nothing else
/// parts two sheets. Error: cancelled.
StatusOr<Cut> CutIntoCharts(const OpenedImage& image, const std::atomic<bool>* cancelled = nullptr);

}  // namespace cirque
