#pragma once

#include <vector>

#include "cirque/core/types.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/mesh/preflight.h"

/// From a soup that is no surface to one that is, for SurfacesOf.
namespace cirque {

/// A soup without what was set aside, its vertices split or welded, and what it has of the file.
struct RepairedSoup {
  PolygonSoup soup;            ///< without texture
  std::vector<Index> vertex;   ///< per vertex its number in the file
  std::vector<Index> polygon;  ///< likewise
  std::vector<Index> corner;   ///< likewise
};

/// What SurfacesOf says, of finite coordinates. `summary` gets what was done. O((F + V) log V).
RepairedSoup RepairSoup(const PolygonSoup& soup, const RepairOptions& options,
                        RepairSummary* summary);

}  // namespace cirque
