#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/verify/judged_mesh.h"
#include "cirque/verify/mesh_match.h"
#include "cirque/verify/topology.h"

namespace cirque::verify {

struct SphereCheckOptions {
  double radius_tolerance = 1e-12;  ///< how far |x| of a vertex may be off 1
  double degree_tolerance = 1e-9;   ///< how far the signed areas' sum may be off 4 pi, relatively
};

/// How far the map is from a conformal one and from an area-preserving one, every triangle of IN
/// against the flat one of its points on the sphere; means and L2 are weighted by area on IN.
struct SphereDistortion {
  double quasi_conformal_mean = 0, quasi_conformal_max = 0;
  double log_area_min = 0, log_area_max = 0, log_area_l2 = 0;
  double angle_mean = 0, angle_max = 0;  ///< [rad]: over all corners, not weighted
};

/// What was found. Faces and vertices are IN's, numbered from 0.
struct SphereReport {
  std::vector<std::string> errors;  ///< why the map is invalid; empty for a valid one
  std::string noun = "triangle";    ///< what the faces are called: "face" where some are polygons
  Index num_faces = 0, num_vertices = 0;
  MeshMatch match;
  bool measured = false;          ///< whether it came to what follows
  double radius_deviation = 0;    ///< largest ||x| - 1|
  std::vector<Index> off_sphere;  ///< vertices beyond the tolerance, or not finite
  Orientations orientations;      ///< by the signs of det[a, b, c], exactly
  double degree = 0;              ///< signed area / 4 pi
  double delaunay_margin = 0;     ///< the smallest intersection angle of two circles of OUT [rad];
                                  ///< negative where IN's triangles are not Delaunay on the sphere
  double centre_uniform = 0;      ///< |centre of mass| of the vertices that have a triangle
  double centre_by_area = 0;      ///< the same weighted by a third of their triangles' area on IN
  SphereDistortion distortion;

  bool valid() const { return errors.empty(); }
  std::string Verdict() const;
};

/// Judges whether OUT's points are an injective map of the closed surface IN of genus 0 to the unit
/// sphere that keeps the orientation: the same faces in the same direction, points on the sphere,
/// every triangle positively oriented by IN's orientation (exactly) and every polygon filled by such
/// triangles, and all of them covering the sphere once. Vertices correspond by their numbers, since
/// OUT's positions are the map. A status is returned when IN is no orientable manifold or has
/// coordinates that are not finite.
StatusOr<SphereReport> VerifySphereMap(const PolygonSoup& in, const PolygonSoup& out,
                                       const SphereCheckOptions& options);

/// Sign of det[a, b, c], exact for all finite doubles.
int DeterminantSign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

std::string ToText(const SphereReport& report);
std::string ToJson(const SphereReport& report);

/// Signed areas of the spherical triangles over 4 pi.
double CoveringDegree(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& sphere);

/// The smallest intersection angle of the circumcircles of two neighbours on the sphere [rad].
double SphericalDelaunayMargin(const TriangleMesh& mesh, const std::vector<Index>& twin,
                               const std::vector<Eigen::Vector3d>& sphere);

/// Length of the centre of mass, uniform or weighted by a third of the triangles' area on IN.
double CentreUniform(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& sphere);
double CentreByArea(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& position,
                    const std::vector<Eigen::Vector3d>& sphere);

SphereDistortion MeasureOnSphere(const TriangleMesh& mesh,
                                 const std::vector<Eigen::Vector3d>& position,
                                 const std::vector<Eigen::Vector3d>& sphere);

}  // namespace cirque::verify
