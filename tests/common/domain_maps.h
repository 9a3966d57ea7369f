#pragma once

#include <complex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/domains/corner_places.h"
#include "cirque/domains/domain.h"

namespace cirque {

/// The generator of a surface of the domain's own topology.
inline std::string GeneratorFor(const std::string& domain) {
  if (domain == "annulus" || domain == "strip") return "annulus";
  if (domain == "torus") return "torus";
  if (domain == "round_holes") return "catenoid";
  return domain == "sphere" ? "blob" : "hemisphere";
}

inline MapRequest RequestFor(const std::string& domain, const DomainOptions& shape = {},
                             const ParameterizeOptions& options = {}) {
  MapRequest request;
  request.domain = domain;
  request.shape = shape;
  request.options = options;
  return request;
}

/// Where a map without seams has the vertices.
inline std::vector<std::complex<double>> PlacesOf(const Surface& surface, const SurfaceMap& map) {
  return PlacesOfVertices(surface.triangulation, map.uv);
}

/// The map that there must be.
inline SurfaceMap MustMap(const Surface& surface, const MapRequest& request) {
  const StatusOr<SurfaceMap> map = MapSurface(surface, request);
  EXPECT_TRUE(map.ok()) << map.status().message();
  return map.ok() ? *map : SurfaceMap();
}

/// The certificate of a map that must be refused with this code.
inline Certificate MustFail(const Surface& surface, const MapRequest& request, StatusCode wanted) {
  Certificate failed;
  const StatusOr<SurfaceMap> map = MapSurface(surface, request, {}, &failed);
  EXPECT_EQ(map.status().code(), wanted) << map.status().message();
  EXPECT_EQ(failed.outcome, ToString(wanted));
  EXPECT_EQ(failed.message, map.status().message());
  return failed;
}

}  // namespace cirque
