#include "cirque/layout/stretch_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cirque/linear/registry.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr double kShareOfWay = 0.9;   ///< to where a triangle has no area
constexpr double kLongestStep = 256;  ///< where triangles are far too small, steps are too short
constexpr double kForesight = 1.25;   ///< reaches from where contacts may come in the next steps
constexpr int kHeld = -1;             ///< the slot of an entry that is none

/// The symmetric matrix [a c; c b] by its eigenvalues and the first eigenvector.
struct Eigen2 {
  Eigen2(double a, double b, double c) {
    const double mean = (a + b) / 2, difference = (a - b) / 2;
    const double radius = std::hypot(difference, c);
    larger = mean + radius, smaller = mean - radius;
    const double angle = radius > 0 ? std::atan2(c, difference) / 2 : 0;
    cosine = std::cos(angle), sine = std::sin(angle);
  }
  double larger, smaller, cosine, sine;
};

/// The least t > 0 with c0 + c1 t + c2 t^2 = 0, c0 > 0; infinite: none.
double FirstRoot(double c0, double c1, double c2) {
  const double discriminant = c1 * c1 - 4 * c0 * c2;
  const double divisor = discriminant < 0 ? 0 : std::sqrt(discriminant) - c1;
  return divisor > 0 ? 2 * c0 / divisor : std::numeric_limits<double>::infinity();
}

double Cross(const Complex& x, const Complex& y) { return std::imag(std::conj(x) * y); }

}  // namespace

StretchSystem::StretchSystem(const MapPart& part, const StretchEnergy& energy, double unit)
    : part_(part),
      energy_(energy),
      unit_(unit),
      rail_(part.unknowns, kNone),
      frame_(part.unknowns, 1.0),
      gradient_(part.unknowns),
      penalty_(static_cast<Eigen::Index>(part.seams.size())),
      cholesky_(MakeCholesky()) {
  NumberUnknowns();
  LayOutPattern();
  FindAllSlots();
}

void StretchSystem::NumberUnknowns() {
  for (std::size_t r = 0; r < part_.rails.size(); ++r) {
    rail_[part_.rails[r].vertex] = static_cast<Index>(r);
  }
  first_.resize(part_.unknowns);
  for (Index v = 0; v < part_.unknowns; ++v) {
    first_[v] = size_;
    size_ += rail_[v] == kNone ? 2 : 1;
  }
}

std::array<Index, 2> StretchSystem::UnknownsOf(Index v) const {
  if (v >= part_.unknowns) return {kNone, kNone};
  return {first_[v], rail_[v] == kNone ? first_[v] + 1 : kNone};
}

void StretchSystem::LayOutPattern() {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(15 * part_.faces.size() + 64 * part_.seams.size() + size_);
  for (Index i = 0; i < size_; ++i) entries.emplace_back(i, i, 0.0);
  const auto add = [&](Index v, Index w) {
    for (const Index i : UnknownsOf(v)) {
      for (const Index j : UnknownsOf(w)) {
        if (i != kNone && j != kNone && i > j) entries.emplace_back(i, j, 0.0);
      }
    }
  };
  for (Index v = 0; v < part_.unknowns; ++v) add(v, v);
  for (const BeltramiFace& face : part_.faces) {
    add(face.vertex[1], face.vertex[0]);
    add(face.vertex[2], face.vertex[0]);
    add(face.vertex[2], face.vertex[1]);
  }
  for (const SeamConstraint& seam : part_.seams) {
    for (const Index v : seam.vertex) {
      for (const Index w : seam.vertex) add(v, w);
    }
  }
  for (const std::array<Index, 3>& contact : foreseen_) {
    for (const Index v : contact) {
      for (const Index w : contact) add(v, w);
    }
  }
  lower_.resize(size_, size_);
  lower_.setFromTriplets(entries.begin(), entries.end());
}

void StretchSystem::FindAllSlots() {
  face_slots_.clear(), seam_slots_.clear();
  face_slots_.reserve(part_.faces.size());
  for (const BeltramiFace& face : part_.faces) face_slots_.push_back(FindSlots<3>(face.vertex));
  for (const SeamConstraint& seam : part_.seams) seam_slots_.push_back(FindSlots<4>(seam.vertex));
}

/// The pattern is kept while it has all contacts that there are; a new one has those, too, that the
/// next steps may bring.
void StretchSystem::FindContacts(const Eigen::VectorXcd& z) {
  if (!part_.fence || !(part_.fence->weight > 0)) return;
  const auto vertices = [](const Contact& c) {
    return std::array<Index, 3>{c.vertex, c.tail, c.tip};
  };
  contacts_ = part_.fence->Contacts(z);
  const bool foreseen = std::all_of(contacts_.begin(), contacts_.end(), [&](const Contact& c) {
    return std::binary_search(foreseen_.begin(), foreseen_.end(), vertices(c));
  });
  if (!foreseen) {
    foreseen_.clear();
    for (const Contact& c : part_.fence->Contacts(z, kForesight)) foreseen_.push_back(vertices(c));
    std::sort(foreseen_.begin(), foreseen_.end());
    LayOutPattern();
    FindAllSlots();
  }
  contact_slots_.clear();
  for (const Contact& c : contacts_) contact_slots_.push_back(FindSlots<3>(vertices(c)));
}

int StretchSystem::Slot(Index i, Index j) const {
  if (i == kNone || j == kNone) return kHeld;
  const int* begin = lower_.innerIndexPtr() + lower_.outerIndexPtr()[std::min(i, j)];
  const int* end = lower_.innerIndexPtr() + lower_.outerIndexPtr()[std::min(i, j) + 1];
  return static_cast<int>(std::lower_bound(begin, end, std::max(i, j)) - lower_.innerIndexPtr());
}

/// Of the pairs of unknowns (0,0) (1,0) (1,1) (2,0) ...
template <int kVertices>
StretchSystem::Slots<kVertices> StretchSystem::FindSlots(
    const std::array<Index, kVertices>& vertex) const {
  std::array<Index, 2 * kVertices> unknown;
  for (int k = 0; k < kVertices; ++k) {
    const auto [first, second] = UnknownsOf(vertex[k]);
    unknown[2 * k] = first, unknown[2 * k + 1] = second;
  }
  Slots<kVertices> slots;
  int at = 0;
  for (int k = 0; k < 2 * kVertices; ++k) {
    for (int l = 0; l <= k; ++l) slots[at++] = Slot(unknown[k], unknown[l]);
  }
  return slots;
}

template <int kVertices>
StretchSystem::Row<kVertices> StretchSystem::RowOf(const std::array<Index, kVertices>& vertex,
                                                   const std::array<Complex, kVertices>& w) const {
  Row<kVertices> row;
  for (int k = 0; k < kVertices; ++k) {
    const bool moves = vertex[k] < part_.unknowns;
    const Complex turned = moves ? std::conj(w[k]) * frame_[vertex[k]] : std::conj(w[k]);
    row[2 * k] = turned.real();
    row[2 * k + 1] = -turned.imag();  // Re(conj(w) i)
  }
  return row;
}

template <int kVertices>
void StretchSystem::AddRow(const Slots<kVertices>& slots, const Row<kVertices>& row,
                           double curvature) {
  if (!(curvature > 0)) return;
  int at = 0;
  for (int k = 0; k < 2 * kVertices; ++k) {
    const double scaled = curvature * row[k];
    for (int l = 0; l <= k; ++l, ++at) {
      if (slots[at] != kHeld) lower_.valuePtr()[slots[at]] += scaled * row[l];
    }
  }
}

double StretchSystem::Value(const Eigen::VectorXcd& z) const {
  double value = StretchOf(part_.faces, energy_, unit_, z);
  for (const Pull& pull : part_.pulls) value += pull.weight * std::norm(z[pull.vertex] - pull.to);
  if (part_.fence && std::isfinite(value)) value += part_.fence->Value(z);
  return value;
}

void StretchSystem::Linearize(const Eigen::VectorXcd& z, double shift) {
  FindContacts(z);
  gradient_.setZero();
  std::fill_n(lower_.valuePtr(), lower_.nonZeros(), 0.0);
  for (const Rail& rail : part_.rails) frame_[rail.vertex] = rail.Tangent(z[rail.vertex]);
  std::vector<double> stiffness(part_.faces.size());
  for (std::size_t f = 0; f < stiffness.size(); ++f) stiffness[f] = AddFace(f, z);
  for (std::size_t c = 0; c < part_.seams.size(); ++c) {
    const SeamConstraint& seam = part_.seams[c];
    const auto beside = [&](Index face) { return face == kNone ? 0 : stiffness[face]; };
    AddPenalty(c, kSeamStiffness * std::max(beside(seam.left_face), beside(seam.right_face)));
  }
  for (std::size_t c = 0; c < contacts_.size(); ++c) AddContact(c);
  for (const Pull& pull : part_.pulls) {
    gradient_[pull.vertex] += 2 * pull.weight * (z[pull.vertex] - pull.to);
    for (const Index i : UnknownsOf(pull.vertex)) {
      if (i != kNone) DiagonalEntry(&lower_, i) += 2 * pull.weight;
    }
  }
  for (Index i = 0; i < size_; ++i) {
    double& diagonal = DiagonalEntry(&lower_, i);
    // What nothing depends on stays where it is.
    diagonal = diagonal > 0 ? diagonal * (1 + shift) : 1;
  }
}

/// Returns the largest curvature of the energy along one vertex's moves, about.
double StretchSystem::AddFace(std::size_t f, const Eigen::VectorXcd& z) {
  const BeltramiFace& face = part_.faces[f];
  const auto [a, b] = DerivativesOn(face, unit_, z);
  const double p = std::norm(a), r = std::norm(b);
  const StretchTerms e = energy_.terms(p, r, energy_.weight);
  const Complex along_a = a / std::sqrt(p), along_b = r > 0 ? b / std::sqrt(r) : Complex(1);
  // Of changes of a and b along themselves, by z; across themselves: i times that.
  std::array<Complex, 3> of_a, of_b;
  const double scale = unit_ * face.scale;
  for (int k = 1; k < 3; ++k) {
    of_a[k] = scale * along_a * face.hat[k];
    of_b[k] = scale * along_b * std::conj(face.hat[k]);
  }
  of_a[0] = -of_a[1] - of_a[2], of_b[0] = -of_b[1] - of_b[2];
  const Eigen2 moduli(2 * e.p + 4 * p * e.pp, 2 * e.r + 4 * r * e.rr, 4 * std::sqrt(p * r) * e.pr);
  const auto add = [&](const Complex& x, const Complex& y, double curvature) {
    std::array<Complex, 3> w;
    for (int k = 0; k < 3; ++k) w[k] = x * of_a[k] + y * of_b[k];
    AddRow<3>(face_slots_[f], RowOf<3>(face.vertex, w), face.weight * curvature);
  };
  const Complex i(0, 1);
  add(moduli.cosine, moduli.sine, moduli.larger);
  add(-moduli.sine, moduli.cosine, moduli.smaller);
  add(i, 0, 2 * e.p);
  add(0, i, 2 * e.r);
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    largest = std::max(largest, std::norm(of_a[k]));
    if (face.vertex[k] >= part_.unknowns) continue;
    gradient_[face.vertex[k]] +=
        2 * face.weight * (e.p * std::sqrt(p) * of_a[k] + e.r * std::sqrt(r) * of_b[k]);
  }
  return face.weight * std::max({moduli.larger, 2 * e.p, 2 * e.r}) * largest;
}

void StretchSystem::AddPenalty(std::size_t c, double stiffness) {
  const SeamConstraint& seam = part_.seams[c];
  penalty_[static_cast<Eigen::Index>(c)] = stiffness;
  for (const Complex& part : {Complex(1), Complex(0, 1)}) {
    std::array<Complex, 4> w = {};
    for (int k = 0; k < 4; ++k) {
      // Both sides may end in one vertex.
      const auto first = std::find(seam.vertex.begin(), seam.vertex.end(), seam.vertex[k]);
      w[first - seam.vertex.begin()] += part * std::conj(seam.factor[k]);
    }
    AddRow<4>(seam_slots_[c], RowOf<4>(seam.vertex, w), stiffness);
  }
}

/// Of (reach / distance - 1)^2 by Gauss and Newton: what the distance's own curvature would take away
/// is left out.
void StretchSystem::AddContact(std::size_t c) {
  const Contact& contact = contacts_[c];
  const double ratio = contact.reach / contact.distance, slope = -ratio / contact.distance;
  const Complex& away = contact.away;
  const std::array<Index, 3> vertex = {contact.vertex, contact.tail, contact.tip};
  const std::array<Complex, 3> w = {away, -(1 - contact.along) * away, -contact.along * away};
  const double weight = 2 * part_.fence->weight;
  for (int k = 0; k < 3; ++k) {
    if (vertex[k] < part_.unknowns) gradient_[vertex[k]] += weight * (ratio - 1) * slope * w[k];
  }
  AddRow<3>(contact_slots_[c], RowOf<3>(vertex, w), weight * slope * slope);
}

bool StretchSystem::Factorize(const Eigen::VectorXcd& z, double shift) {
  Linearize(z, shift);
  return cholesky_->Factorize(lower_);
}

Eigen::VectorXcd StretchSystem::Solve(const Eigen::VectorXcd& b) const {
  Eigen::VectorXd right(size_);
  for (Index v = 0; v < part_.unknowns; ++v) {
    const auto [first, second] = UnknownsOf(v);
    const Complex in_frame = std::conj(frame_[v]) * b[v];
    right[first] = in_frame.real();
    if (second != kNone) right[second] = in_frame.imag();
  }
  const Eigen::VectorXd x = cholesky_->Solve(right);
  Eigen::VectorXcd result(part_.unknowns);
  for (Index v = 0; v < part_.unknowns; ++v) {
    const auto [first, second] = UnknownsOf(v);
    result[v] = frame_[v] * Complex(x[first], second == kNone ? 0 : x[second]);
  }
  return result;
}

double StretchSystem::LongestStep(const Eigen::VectorXcd& z,
                                  const Eigen::VectorXcd& direction) const {
  const auto moved = [&](Index v) { return v < part_.unknowns ? direction[v] : Complex(0); };
  double longest = kLongestStep / kShareOfWay;
  for (const std::array<Index, 3>& t : part_.triangles) {
    const Complex x = z[t[1]] - z[t[0]], y = z[t[2]] - z[t[0]];
    const Complex dx = moved(t[1]) - moved(t[0]), dy = moved(t[2]) - moved(t[0]);
    longest = std::min(longest, FirstRoot(Cross(x, y), Cross(x, dy) + Cross(dx, y), Cross(dx, dy)));
  }
  return kShareOfWay * longest;
}

}  // namespace cirque
