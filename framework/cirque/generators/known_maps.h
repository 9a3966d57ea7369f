#pragma once

#include <functional>

#include <Eigen/Core>

#include "cirque/core/registry.h"

namespace cirque {

/// A smooth conformal, orientation preserving map between a surface and the plane, unique up to
/// what keeps angles. Its two directions are inverse to each other on the surface; `to_plane` also
/// takes points near the surface, as if moved onto it. Broken arguments (a pole, infinity) give
/// values that are not finite.
struct ConformalMap {
  std::function<Eigen::Vector2d(const Eigen::Vector3d&)> to_plane;
  std::function<Eigen::Vector3d(const Eigen::Vector2d&)> to_surface;
};

/// The plane z = 0: the identity.
ConformalMap IdentityMap();

/// The unit sphere from its south pole: (x, y) / (1 + z), the northern hemisphere onto the unit
/// disk.
ConformalMap StereographicMap();

/// Enneper's minimal surface onto its parameters, |(u, v)| <= 1,
///   (u - u^3/3 + u v^2, v - v^3/3 + u^2 v, u^2 - v^2) -> (u, v);
/// the metric is (1 + u^2 + v^2)^2 (du^2 + dv^2).
ConformalMap EnneperMap();

/// The northern unit hemisphere with the unit cylinder below its equator: stereographic on the
/// cap; on the cylinder, z < 0,
///   (cos p, sin p, z) -> e^-z (cos p, sin p).
ConformalMap CappedTubeMap();

/// The catenoid:
///   (cosh z cos p, cosh z sin p, z) -> e^-z (cos p, sin p).
ConformalMap CatenoidMap();

/// The plane ring between the unit circle and that of radius 0.3 about (0.4, 0), onto the concentric
/// one: z -> (z - c) / (1 - c z) with c such that the inner circle's ends go to +-q.
ConformalMap EccentricAnnulusMap();
inline constexpr double kEccentricRadius = 0.3, kEccentricShift = 0.4;
/// q = e^-arcosh((1 + r^2 - d^2) / (2 r)) for r = 0.3, d = 0.4: the concentric ring's inner radius.
inline constexpr double kEccentricConformalRadius = 0.36572807176729882;

/// The torus, R = 1, r = 0.4:
///   ((R + r cos q) cos p, (R + r cos q) sin p, r sin q) -> (p, s),   ds = r dq / (R + r cos q),
/// both counted modulo their periods from -half to half: a rectangle of 2 pi times
/// 2 pi r / sqrt(R^2 - r^2), of ratio sqrt((R/r)^2 - 1).
ConformalMap TorusMap();
inline constexpr double kTorusMajorRadius = 1, kTorusMinorRadius = 0.4;
/// The periods (2 pi, 2 pi r / sqrt(R^2 - r^2)) of TorusMap.
Eigen::Vector2d TorusPeriods();

/// Maps by the names of the generators that they belong to, one line an entry in known_maps.cc.
/// With free boundary a circle pattern approximates *some* conformal map; to compare with these,
/// fix the boundary or divide out what is free.
const Registry<ConformalMap>& KnownConformalMaps();

}  // namespace cirque
