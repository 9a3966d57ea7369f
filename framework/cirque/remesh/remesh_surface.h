#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/enum_words.h"
#include "cirque/core/option_table.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"
#include "cirque/layout/exact_map.h"
#include "cirque/mesh/surface.h"
#include "cirque/pipeline/parameterization.h"

namespace cirque {

/// Where edges shall be of one length: on the surface, or in the flat metric, where triangles then are
/// even and on the surface as large as the metric's scale makes them.
enum class EvenOn { kSurface, kMap };

template <>
inline constexpr auto kEnumWords<EvenOn> =
    std::to_array<EnumWord<EvenOn>>({{EvenOn::kSurface, "surface"}, {EvenOn::kMap, "map"}});

/// Which lattice of the flat metric the mesh shall be: none, its vertices are where they are even.
enum class MeshLattice { kFree, kSquares, kTriangles };

template <>
inline constexpr auto kEnumWords<MeshLattice> =
    std::to_array<EnumWord<MeshLattice>>({{MeshLattice::kFree, "none"},
                                          {MeshLattice::kSquares, "squares"},
                                          {MeshLattice::kTriangles, "triangles"}});

/// What a new mesh of a surface shall be like.
struct RemeshOptions {
  double edge = 0;   ///< length of edges on the surface, > 0; 0: by `vertices`
  int vertices = 0;  ///< about so many; 0: by `edge`
  EvenOn even_on = EvenOn::kSurface;
  /// Squares need rotations by multiples of pi/2 (HolonomyRule::kHalves), triangles by pi/3; edges are
  /// then even in the metric, and irregular vertices are its cones alone.
  MeshLattice lattice = MeshLattice::kFree;
  double corners = 40;  ///< [degrees]: a boundary that turns by more keeps its vertex
  int rounds = 8;
  /// V of the surface, > 0: of how many times as many vertices per area; empty: 1.
  Eigen::VectorXd density = {};
};

/// The table of its fields but `density`.
const OptionTable<RemeshOptions>& RemeshOptionTable();

/// A new mesh of a surface: its vertices are points of it.
struct RemeshedSurface {
  Triangulation triangulation;  ///< no face has a vertex twice, no two vertices have two edges
  /// Of a lattice of squares: the vertices of each, counter-clockwise; triangles are their halves.
  std::vector<std::array<Index, 4>> squares;
  std::vector<SurfacePoint> point;  ///< V: where on the old surface
  std::vector<Eigen::Vector3d> position;
  std::vector<Index> cones;  ///< its vertices that are cones of the flat metric
  double edge = 0;           ///< mean length of its edges, where density is 1
};

/// The most vertices that may be asked for, by `vertices` or by way of `edge`.
inline constexpr double kMostNewVertices = 2e7;

/// Meshes a surface anew, by even triangles of a flat cone metric conformal to it: angles there are
/// those on the surface as far as the map is conformal, and seams are nowhere, as nothing is laid
/// out (MakeEvenTriangles). Vertices are found on the old surface by its exact map. Topology, cones
/// and boundary loops stay. A lattice is made in the metric changed by MakeLatticeMap (closed surfaces).
/// Errors: kInvalidInput, options that ask for nothing or for too much; kNotConverged, a map that is
/// not of one flat metric of the whole surface (free seams), or as MakeEvenTriangles,
/// MakeLatticeMap and MakeLatticeMesh.
/// @pre `map` was made with ParameterizeOptions::exact of `surface`.
StatusOr<RemeshedSurface> RemeshSurface(const Surface& surface, const Parameterization& map,
                                        const RemeshOptions& options,
                                        const SolveControl& control = {});

}  // namespace cirque
