#pragma once

#include <string>

#include <Eigen/Core>

#include "cirque/core/option_table.h"
#include "cirque/core/status.h"
#include "cirque/mesh/surface.h"

namespace cirque {

/// How lengths of edges follow the curvature.
struct CurvatureSizing {
  double strength = 1;      ///< edges are as long as the radius of curvature to this power
  double ratio = 8;         ///< of the longest edges to the shortest that are asked for
  double smoothing = 0.03;  ///< over this length, as a part of the root of the area
};

/// The table of its fields.
const OptionTable<CurvatureSizing>& CurvatureSizingTable();

/// V: densities (RemeshOptions::density) by which edges are in proportion to (1 / k)^strength, k the
/// root of k1^2 + k2^2 of the principal curvatures: that of the tensor which edges and their dihedral angles
/// give around every vertex (D. Cohen-Steiner, J.-M. Morvan, "Restricted Delaunay triangulations
/// and normal cycle", SoCG 2003), smoothed by one step of heat flow. Lengths stay within a factor
/// of sqrt(ratio) of those where the curvature is its mean over the area. A flat surface has density 1. The same for a
/// scaled or moved surface.
Eigen::VectorXd DensityByCurvature(const Surface& surface, const CurvatureSizing& sizing);

/// The sizing of "curvature" or "curvature:strength=0.5,ratio=4". Error: another name or option.
StatusOr<CurvatureSizing> ParseCurvatureSizing(const std::string& text);

/// Whether that is meant, and not the name of a file.
bool NamesCurvatureSizing(const std::string& text);

}  // namespace cirque
