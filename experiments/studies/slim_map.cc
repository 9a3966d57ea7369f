#include "experiments/studies/slim_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include "cirque/linear/registry.h"
#include "cirque/linear/sparse_cholesky.h"

namespace cirque {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kToTheFlip = 0.8;  ///< of the way to where a face collapses
constexpr double kArmijo = 1e-4, kProximal = 1e-10;
constexpr int kMostHalvings = 40, kMostIdle = 5;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A face in its own plane: J = sum_k uv_k gradient_k'.
struct FlatFace {
  std::array<Index, 3> vertex;
  Eigen::Matrix<double, 3, 2> gradient;
  double area;  ///< of a surface of area 1
};

std::vector<FlatFace> FlatFaces(const Surface& surface) {
  std::vector<FlatFace> faces(surface.triangulation.num_faces());
  double total = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      faces[f].vertex[k] = surface.triangulation.vertex[3 * static_cast<Index>(f) + Index(k)];
    }
    const Eigen::Vector3d& p = surface.position[faces[f].vertex[0]];
    const Eigen::Vector3d a = surface.position[faces[f].vertex[1]] - p;
    const Eigen::Vector3d b = surface.position[faces[f].vertex[2]] - p;
    const double x = a.norm(), y = a.cross(b).norm() / x;
    const double along = a.dot(b) / x;
    faces[f].area = 0.5 * x * y;
    faces[f].gradient.row(1) << 1 / x, -along / (x * y);
    faces[f].gradient.row(2) << 0, 1 / y;
    faces[f].gradient.row(0) = -faces[f].gradient.row(1) - faces[f].gradient.row(2);
    total += faces[f].area;
  }
  for (FlatFace& face : faces) {
    face.area /= total;
    face.gradient *= std::sqrt(total);
  }
  return faces;
}

Matrix2d Jacobian(const FlatFace& face, const VertexUv& uv) {
  Matrix2d j = Matrix2d::Zero();
  for (int k = 0; k < 3; ++k) {
    const std::complex<double>& z = uv[face.vertex[k]];
    j += Vector2d(z.real(), z.imag()) * face.gradient.row(k);
  }
  return j;
}

/// Means of s^2 + t^2 and of 1/s^2 + 1/t^2 = (s^2 + t^2) / det^2.
struct Means {
  double stretch = 0, shrink = 0;
};

Means MeansOf(const std::vector<FlatFace>& faces, const VertexUv& uv) {
  Means means;
  for (const FlatFace& face : faces) {
    const Matrix2d j = Jacobian(face, uv);
    const double det = j.determinant();
    if (!(det > 0)) return {kInfinity, kInfinity};
    means.stretch += face.area * j.squaredNorm();
    means.shrink += face.area * j.squaredNorm() / (det * det);
  }
  return means;
}

double ValueOf(const std::vector<FlatFace>& faces, const VertexUv& uv) {
  const Means means = MeansOf(faces, uv);
  return 0.5 * (means.stretch + means.shrink) - 2;
}

void Scale(double by, VertexUv* uv) {
  for (std::complex<double>& z : *uv) z *= by;
}

double BestScale(const Means& means) { return std::pow(means.shrink / means.stretch, 0.25); }

/// The smallest t > 0 at which det(j + t d) vanishes.
double StepToCollapse(const Matrix2d& j, const Matrix2d& d) {
  const double c = j.determinant(), a = d.determinant();
  const double b = j(0, 0) * d(1, 1) + d(0, 0) * j(1, 1) - j(0, 1) * d(1, 0) - d(0, 1) * j(1, 0);
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return kInfinity;
  // Of 2 c / (-b +- root), which divides by no small a; c > 0.
  const double root = std::sqrt(discriminant);
  double least = kInfinity;
  for (const double below : {-b + root, -b - root}) {
    if (below > 0) least = std::min(least, 2 * c / below);
  }
  return least;
}

class Slim {
 public:
  Slim(const Surface& surface, VertexUv start)
      : faces_(FlatFaces(surface)),
        n_(static_cast<Index>(start.size())),
        uv_(std::move(start)),
        factor_(MakeCholesky()) {
    Scale(BestScale(MeansOf(faces_, uv_)), &uv_);
    value_ = ValueOf(faces_, uv_);
  }

  /// The relative gain; 0 where there is none.
  double Step() {
    VertexUv direction;
    if (!Direction(&direction)) return 0;
    double length = 1, slope = 0;
    for (const FlatFace& face : faces_) {
      const Matrix2d j = Jacobian(face, uv_), d = Jacobian(face, direction);
      length = std::min(length, kToTheFlip * StepToCollapse(j, d));
      slope += face.area * GradientOf(j).cwiseProduct(d).sum();
    }
    for (int i = 0; i < kMostHalvings; ++i, length /= 2) {
      VertexUv next = uv_;
      for (Index v = 0; v < n_; ++v) next[v] += length * direction[v];
      const double value = ValueOf(faces_, next);
      if (!(value <= value_ + kArmijo * length * slope)) continue;
      const double gain = (value_ - value) / (1 + std::abs(value_));
      uv_ = std::move(next);
      value_ = value;
      return gain;
    }
    return 0;
  }

  VertexUv TakeUv() { return std::move(uv_); }

 private:
  /// dE / dJ = U diag(s - 1/s^3) V' = J - J^-T (J J')^-1.
  static Matrix2d GradientOf(const Matrix2d& j) {
    const Matrix2d inverse = j.inverse();
    return j - inverse.transpose() * (inverse * inverse.transpose());
  }

  /// From here to the minimum of sum A |W (J - R)|^2, R the rotation nearest to J, and
  /// W^2 = U diag((s + 1) (s^2 + 1) / (2 s^3)) U'.
  bool Direction(VertexUv* direction) {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n_);
    entries_.clear();
    for (const FlatFace& face : faces_) AddFace(face, &right);
    for (Index i = 0; i < 2 * n_; ++i) {
      entries_.emplace_back(i, i, kProximal);
      right[i] += kProximal * (i < n_ ? uv_[i].real() : uv_[i - n_].imag());
    }
    SparseMatrix lower(2 * n_, 2 * n_);
    lower.setFromTriplets(entries_.begin(), entries_.end());
    if (!factor_->Factorize(lower)) return false;
    const Eigen::VectorXd x = factor_->Solve(right);
    direction->resize(uv_.size());
    for (Index v = 0; v < n_; ++v)
      (*direction)[v] = {x[v] - uv_[v].real(), x[n_ + v] - uv_[v].imag()};
    return x.allFinite();
  }

  void AddFace(const FlatFace& face, Eigen::VectorXd* right) {
    const Matrix2d j = Jacobian(face, uv_);
    Eigen::SelfAdjointEigenSolver<Matrix2d> left;
    left.computeDirect(j * j.transpose());
    const Matrix2d u = left.eigenvectors();
    const Eigen::Array2d s = left.eigenvalues().array().sqrt();
    const Eigen::Array2d squares = (s + 1) * (s * s + 1) / (2 * s.cube());
    const Matrix2d weight = face.area * u * squares.matrix().asDiagonal() * u.transpose();
    // The rotation nearest to J is (J J')^-1/2 J.
    const Matrix2d wanted = weight * u * s.inverse().matrix().asDiagonal() * u.transpose() * j;
    for (int k = 0; k < 3; ++k) {
      const Vector2d pull = wanted * face.gradient.row(k).transpose();
      for (int r = 0; r < 2; ++r) (*right)[face.vertex[k] + r * n_] += pull[r];
      for (int l = 0; l < 3; ++l) AddPair(face, weight, k, l);
    }
  }

  void AddPair(const FlatFace& face, const Matrix2d& weight, int k, int l) {
    const double product = face.gradient.row(k).dot(face.gradient.row(l));
    for (int r = 0; r < 2; ++r) {
      for (int s = 0; s < 2; ++s) {
        const Index i = face.vertex[k] + r * n_, j = face.vertex[l] + s * n_;
        if (i >= j) entries_.emplace_back(i, j, weight(r, s) * product);
      }
    }
  }

  const std::vector<FlatFace> faces_;
  const Index n_;
  VertexUv uv_;
  double value_;
  std::vector<Eigen::Triplet<double>> entries_;
  std::unique_ptr<SparseCholesky> factor_;
};

}  // namespace

double SymmetricDirichletOf(const Surface& surface, const VertexUv& uv) {
  const Means means = MeansOf(FlatFaces(surface), uv);
  return std::sqrt(means.stretch * means.shrink) - 2;
}

SlimMap MinimizeBySlim(const Surface& surface, VertexUv start, int most_steps, double least_gain) {
  Slim slim(surface, std::move(start));
  SlimMap map;
  for (int idle = 0; map.steps < most_steps && idle < kMostIdle; ++map.steps) {
    idle = slim.Step() < least_gain ? idle + 1 : 0;
  }
  map.uv = slim.TakeUv();
  return map;
}

}  // namespace cirque
