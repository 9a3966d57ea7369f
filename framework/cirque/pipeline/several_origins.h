#pragma once

#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/input_chart.h"
#include "cirque/layout/planar_layout.h"

namespace cirque {

/// What a layout is of.
struct FlatTriangles {
  const Triangulation& triangulation;
  const InputChart& flat;           ///< none flipped
  const std::vector<Index>& cones;  ///< to be opened
};

/// Lays out a flat surface whose triangles doubles do not hold about one origin, by directions: the cut
/// is opened further and each patch has a frame of its own, about its smallest triangle (LayOutPatches),
/// in which all its triangles are positively oriented and its edges as long as they shall be to 1e-9.
/// What is not so in a patch is split off, again and again; a triangle by itself lies with its longest
/// side on the x axis and the nearer end of that in the origin, which any triangle with angles above 0
/// can. Patches so lie upon each other.
///
/// `alone`: faces that are to lie by themselves. `layout`: of the cut as it comes. Error
/// (kUnrepresentable): a triangle whose sides doubles do not hold.
Status LayOutAboutSeveralOrigins(const FlatTriangles& of, const std::vector<Index>& alone, Cut* cut,
                                 PlanarLayout* layout);

}  // namespace cirque
