#pragma once

#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/cone_file.h"
#include "cirque/pipeline/cut_and_place.h"
#include "cirque/pipeline/parameterization.h"

namespace cirque {

/// Flattens for result's targets, by the pattern that the options name.
Status FlattenToTargets(const ParameterizeJob& job, Parameterization* result);

/// Cuts (along the given cut, and where that leaves no disks or cones inside, further) and lays out
/// result's flat surface, with free seams after flattening the surface opened
/// along the cut once more, and measures the map. Errors: kUnrepresentable for a layout with
/// flipped triangles; with free seams those of Flatten, but kNotConverged
/// for no coherent angles, of which there is no proof about the surface.
Status LayOutAndMeasure(const ParameterizeJob& job, Parameterization* result);

/// Whether the surface is opened along the cut that is given, or into the charts that are asked for,
/// with a free boundary, before anything is solved: the options keep no rigid seams, name no cones
/// and leave rotations free. (For jobs without targets.)
bool OpensFirst(const ParameterizeJob& job);

/// Does so, with a further cut where that leaves no disk. Whatever the surface needed as a whole,
/// opened it needs no cones. Errors: as LayOutAndMeasure.
Status OpenAndLayOut(const ParameterizeJob& job, Parameterization* result);

}  // namespace cirque
