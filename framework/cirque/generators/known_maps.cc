#include "cirque/generators/known_maps.h"

#include <cmath>
#include <complex>

#include "cirque/core/types.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d Stereographic(const Vector3d& p) {
  const Vector3d q = p.normalized();
  return q.head<2>() / (1 + q.z());
}

Vector3d InverseStereographic(const Vector2d& w) {
  const double s = w.squaredNorm();
  return Vector3d(2 * w.x(), 2 * w.y(), 1 - s) / (1 + s);
}

Vector3d Enneper(const Vector2d& w) {
  const double u = w.x(), v = w.y();
  return {u - u * u * u / 3 + u * v * v, v - v * v * v / 3 + u * u * v, u * u - v * v};
}

/// Gauss-Newton for the nearest point of the surface. The parameterization being conformal, the
/// normal matrix is (1 + u^2 + v^2)^2 times the identity.
Vector2d InverseEnneper(const Vector3d& p) {
  constexpr int kMaxSteps = 100;
  Vector2d w = p.head<2>();
  for (int i = 0; i < kMaxSteps; ++i) {
    const double u = w.x(), v = w.y(), stretch = 1 + u * u + v * v;
    const Vector3d du(1 - u * u + v * v, 2 * u * v, 2 * u);
    const Vector3d dv(2 * u * v, 1 - v * v + u * u, -2 * v);
    const Vector3d residual = p - Enneper(w);
    const Vector2d step = Vector2d(du.dot(residual), dv.dot(residual)) / (stretch * stretch);
    w += step;
    if (step.norm() < 1e-15) break;
  }
  return w;
}

Vector2d CappedTubeToPlane(const Vector3d& p) {
  return p.z() >= 0 ? Stereographic(p) : Vector2d(p.head<2>().normalized() * std::exp(-p.z()));
}

Vector3d PlaneToCappedTube(const Vector2d& w) {
  const double radius = w.norm();
  if (radius <= 1) return InverseStereographic(w);
  return {w.x() / radius, w.y() / radius, -std::log(radius)};
}

Vector3d PlaneToCatenoid(const Vector2d& w) {
  const double radius = w.norm(), z = -std::log(radius);
  const Vector2d xy = w * (std::cosh(z) / radius);
  return {xy.x(), xy.y(), z};
}

constexpr double kEccentricPole = 0.44929605382547434;  ///< c of EccentricAnnulusMap

Vector2d EccentricToConcentric(const Vector3d& p) {
  const std::complex<double> z(p.x(), p.y()), w = (z - kEccentricPole) / (1.0 - kEccentricPole * z);
  return {w.real(), w.imag()};
}

Vector3d ConcentricToEccentric(const Vector2d& p) {
  const std::complex<double> w(p.x(), p.y()), z = (w + kEccentricPole) / (1.0 + kEccentricPole * w);
  return {z.real(), z.imag(), 0};
}

/// ds/dq integrates to
///   s = 2 k atan(m tan(q/2)),   k = r / sqrt(R^2 - r^2),   m = sqrt((R - r) / (R + r)).
constexpr double kBig = kTorusMajorRadius, kSmall = kTorusMinorRadius;
double TorusScale() { return kSmall / std::sqrt(kBig * kBig - kSmall * kSmall); }
double TorusSkew() { return std::sqrt((kBig - kSmall) / (kBig + kSmall)); }

Vector2d TorusToPlane(const Vector3d& p) {
  const double q = std::atan2(p.z(), p.head<2>().norm() - kBig);
  const double s = std::atan2(TorusSkew() * std::sin(q / 2), std::cos(q / 2));
  return {std::atan2(p.y(), p.x()), 2 * TorusScale() * s};
}

Vector3d PlaneToTorus(const Vector2d& w) {
  const double s = w.y() / (2 * TorusScale());
  const double q = 2 * std::atan2(std::sin(s), TorusSkew() * std::cos(s));
  const double radius = kBig + kSmall * std::cos(q);
  return {radius * std::cos(w.x()), radius * std::sin(w.x()), kSmall * std::sin(q)};
}

}  // namespace

ConformalMap IdentityMap() {
  return {[](const Vector3d& p) -> Vector2d { return p.head<2>(); },
          [](const Vector2d& w) { return Vector3d(w.x(), w.y(), 0); }};
}

ConformalMap StereographicMap() { return {Stereographic, InverseStereographic}; }

ConformalMap EnneperMap() { return {InverseEnneper, Enneper}; }

ConformalMap CappedTubeMap() { return {CappedTubeToPlane, PlaneToCappedTube}; }

ConformalMap CatenoidMap() {
  return {[](const Vector3d& p) -> Vector2d { return p.head<2>().normalized() * std::exp(-p.z()); },
          PlaneToCatenoid};
}

ConformalMap EccentricAnnulusMap() { return {EccentricToConcentric, ConcentricToEccentric}; }

ConformalMap TorusMap() { return {TorusToPlane, PlaneToTorus}; }

Vector2d TorusPeriods() { return {2 * kPi, 2 * kPi * TorusScale()}; }

const Registry<ConformalMap>& KnownConformalMaps() {
  static const Registry<ConformalMap> table("known conformal map",
                                            {{"flat_delaunay_patch", IdentityMap()},
                                             {"hexagonal_fan", IdentityMap()},
                                             {"spherical_cap", StereographicMap()},
                                             {"hemisphere", StereographicMap()},
                                             {"enneper_patch", EnneperMap()},
                                             {"capped_tube", CappedTubeMap()},
                                             {"long_capped_tube", CappedTubeMap()},
                                             {"annulus", IdentityMap()},
                                             {"eccentric_annulus", EccentricAnnulusMap()},
                                             {"plate_with_holes", IdentityMap()},
                                             {"catenoid", CatenoidMap()},
                                             {"sphere", StereographicMap()},
                                             {"torus", TorusMap()}});
  return table;
}

}  // namespace cirque
