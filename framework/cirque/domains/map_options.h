#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cirque/cones/cone.h"
#include "cirque/core/enum_words.h"
#include "cirque/core/option_table.h"
#include "cirque/core/status.h"
#include "cirque/core/types.h"
#include "cirque/domains/domain.h"
#include "cirque/pipeline/options.h"

/// What the map of a mesh is asked for, of one component or of several.
namespace cirque {

/// Size and place of the images in the plane. kAsIs: true length, which is to say that an image has
/// the area of its surface; a single one as its domain has it. kUnit: within the unit square, the
/// margin left free at its border. kScale: as kAsIs, times `scale`.
enum class UvSize { kAsIs, kUnit, kScale };

/// Whether the images of several components keep the areas of their surfaces to each other, or each
/// is made as large as the others.
enum class PieceScale { kTrue, kEach };

template <>
inline constexpr auto kEnumWords<PieceScale> =
    std::to_array<EnumWord<PieceScale>>({{PieceScale::kTrue, "true"}, {PieceScale::kEach, "each"}});

/// Where the images go.
struct UvFrame {
  UvSize size = UvSize::kAsIs;
  double scale = 1;          ///< of kScale
  double margin = 1. / 256;  ///< between patches, and at the border of the unit square; of its side
  PieceScale pieces = PieceScale::kTrue;
};

/// "as_is", "unit" or "scale=S" into size and scale. Error (invalid input): anything else.
Status SetUvSize(const std::string& text, UvFrame* frame);

/// How a mesh is taken apart, and how the maps of its components are put together: options of the
/// programs, of MapSurface, of Python and of meshes of OpenMesh, under these names.
struct MeshOptions {
  std::string repair = "safe";  ///< as of ParseRepair
  bool fill_holes = false;      ///< all boundary loops but the longest closed for the solve
  std::string uv = "as_is";     ///< as of SetUvSize
  double uv_margin = UvFrame().margin;
  PieceScale scale_pieces = PieceScale::kTrue;
};

/// The table of its fields.
const OptionTable<MeshOptions>& MeshOptionTable();

/// The frame that they ask for. @pre they are as the table lets them be.
UvFrame FrameOf(const MeshOptions& options);

/// What a map of arrays is to be. `mesh`, `options` and `shape` are those of flags and YAML keys.
struct MapOptions {
  std::string domain = "plane";  ///< a name of Domains()
  MeshOptions mesh = {};
  ParameterizeOptions options = {};
  DomainOptions shape = {};  ///< its vertices are the arrays'
  /// The angle sums of single vertices [rad], the others as FreeBoundaryTargets; none: the cones
  /// that the options name.
  std::vector<Cone> cones = {};
  std::vector<double> angle_sums = {};  ///< V: of every vertex [rad], instead; empty: none
  /// Edges to open, as pairs of vertices; and shortest paths to open, by their ends.
  std::vector<std::pair<Index, Index>> cut = {}, cut_paths = {};
  bool exact = false;  ///< MeshMap::exact too

  /// Sets options by their names as texts: "domain", "exact" and those of MeshOptionTable,
  /// ParameterizeOptionTable and DomainOptionTable. Errors (invalid input): an unknown name, with
  /// the one that was meant; a value that may not be; an option that the domain does not read.
  Status Set(const OptionMap& texts);
};

/// Whether the options make sense by themselves and together. Error (invalid input): not.
Status CheckOptions(const MapOptions& options);

/// All that Set knows, in the order of the tables.
std::vector<OptionInfo> MapOptionInfos();

}  // namespace cirque
