#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include <Eigen/Geometry>

#include "cirque/verify/sphere_check.h"

namespace cirque::verify {
namespace {

using Eigen::Vector3d;

/// The triangle with its first corner at 0 and its second on the positive real axis.
std::array<std::complex<double>, 2> InPlane(const Vector3d& a, const Vector3d& b,
                                            const Vector3d& c) {
  const Vector3d u = b - a, v = c - a;
  const double base = u.norm();
  return {std::complex<double>(base, 0), {u.dot(v) / base, u.cross(v).norm() / base}};
}

std::array<double, 3> Angles(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const auto angle = [](const Vector3d& apex, const Vector3d& p, const Vector3d& q) {
    return std::atan2((p - apex).cross(q - apex).norm(), (p - apex).dot(q - apex));
  };
  return {angle(a, b, c), angle(b, c, a), angle(c, a, b)};
}

/// What inversion about `apex` makes of the unit vector x, as seen from there.
Vector3d Inverted(const Vector3d& apex, const Vector3d& x) {
  const Vector3d from = x - apex;
  return from / from.squaredNorm();
}

double TriangleArea(const TriangleMesh& mesh, const std::vector<Vector3d>& position, Index h) {
  const Vector3d& a = position[mesh.vertex[h]];
  return 0.5 * (position[mesh.vertex[h + 1]] - a).cross(position[mesh.vertex[h + 2]] - a).norm();
}

double Norm(const std::vector<Vector3d>& sphere, const std::vector<double>& weight) {
  Vector3d sum = Vector3d::Zero();
  double total = 0;
  for (std::size_t v = 0; v < sphere.size(); ++v) {
    if (weight[v] > 0) sum += weight[v] * sphere[v];
    total += weight[v];
  }
  return sum.norm() / total;
}

/// Ratio of the singular values of the linear map between two triangles.
double QuasiConformal(const std::array<std::complex<double>, 2>& z,
                      const std::array<std::complex<double>, 2>& w) {
  const double p = std::abs(w[1] * std::conj(z[0]) - w[0] * std::conj(z[1]));
  const double q = std::abs(w[1] * z[0] - w[0] * z[1]);
  return (p + q) / std::abs(p - q);
}

}  // namespace

double CoveringDegree(const TriangleMesh& mesh, const std::vector<Vector3d>& sphere) {
  double sum = 0;
  for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); h += 3) {
    const Vector3d &a = sphere[mesh.vertex[h]], &b = sphere[mesh.vertex[h + 1]],
                   &c = sphere[mesh.vertex[h + 2]];
    // Half the solid angle (A. van Oosterom, J. Strackee, 1983).
    sum += std::atan2(a.dot((b - a).cross(c - a)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return sum / (2 * kPi);
}

double SphericalDelaunayMargin(const TriangleMesh& mesh, const std::vector<Index>& twin,
                               const std::vector<Vector3d>& sphere) {
  double margin = kPi;
  for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); ++h) {
    const Index g = twin[h];
    if (g < h) continue;
    // With the edge's tail at infinity both circles become lines through its tip.
    const Vector3d& apex = sphere[mesh.Tail(h)];
    const Vector3d tip = Inverted(apex, sphere[mesh.Tip(h)]);
    const Vector3d u = Inverted(apex, sphere[mesh.vertex[TriangleMesh::Prev(h)]]) - tip;
    const Vector3d w = Inverted(apex, sphere[mesh.vertex[TriangleMesh::Prev(g)]]) - tip;
    double angle = std::atan2(apex.dot(u.cross(w)), u.dot(w));
    if (angle < 0) angle += 2 * kPi;
    margin = std::min(margin, kPi - angle);
  }
  return margin;
}

double CentreUniform(const TriangleMesh& mesh, const std::vector<Vector3d>& sphere) {
  std::vector<double> weight(sphere.size(), 0);
  for (const Index v : mesh.vertex) weight[v] = 1;
  return Norm(sphere, weight);
}

double CentreByArea(const TriangleMesh& mesh, const std::vector<Vector3d>& position,
                    const std::vector<Vector3d>& sphere) {
  std::vector<double> weight(sphere.size(), 0);
  for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); ++h) {
    weight[mesh.vertex[h]] += TriangleArea(mesh, position, h - h % 3);
  }
  return Norm(sphere, weight);
}

SphereDistortion MeasureOnSphere(const TriangleMesh& mesh, const std::vector<Vector3d>& position,
                                 const std::vector<Vector3d>& sphere) {
  double area = 0, image_area = 0;
  for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); h += 3) {
    area += TriangleArea(mesh, position, h);
    image_area += TriangleArea(mesh, sphere, h);
  }
  SphereDistortion d;
  d.log_area_min = std::numeric_limits<double>::infinity();
  d.log_area_max = -d.log_area_min;
  for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); h += 3) {
    const Index* v = &mesh.vertex[h];
    const double share = TriangleArea(mesh, position, h) / area;
    const double ratio = TriangleArea(mesh, sphere, h) / image_area / share;
    const double qc = QuasiConformal(InPlane(position[v[0]], position[v[1]], position[v[2]]),
                                     InPlane(sphere[v[0]], sphere[v[1]], sphere[v[2]]));
    d.quasi_conformal_mean += share * qc;
    d.quasi_conformal_max = std::max(d.quasi_conformal_max, qc);
    d.log_area_min = std::min(d.log_area_min, std::log(ratio));
    d.log_area_max = std::max(d.log_area_max, std::log(ratio));
    d.log_area_l2 += share * std::log(ratio) * std::log(ratio);
    const auto from = Angles(position[v[0]], position[v[1]], position[v[2]]);
    const auto to = Angles(sphere[v[0]], sphere[v[1]], sphere[v[2]]);
    for (int k = 0; k < 3; ++k) {
      d.angle_max = std::max(d.angle_max, std::abs(to[k] - from[k]));
      d.angle_mean += std::abs(to[k] - from[k]) / static_cast<double>(mesh.vertex.size());
    }
  }
  d.log_area_l2 = std::sqrt(d.log_area_l2);
  return d;
}

}  // namespace cirque::verify
