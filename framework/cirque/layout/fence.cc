#include "cirque/layout/fence.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cirque/math/boundary_sweep.h"
#include "cirque/math/box_tree.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

Eigen::Vector2d Point(const Complex& z) { return {z.real(), z.imag()}; }

/// Whatever their distance.
Contact ContactOf(Index vertex, const Fence::Side& side, const Eigen::VectorXcd& z) {
  const Complex along = z[side.tip] - z[side.tail], to = z[vertex] - z[side.tail];
  const double share = std::clamp(std::real(std::conj(along) * to) / std::norm(along), 0.0, 1.0);
  const Complex away = to - share * along;
  const double distance = std::abs(away);
  return {vertex, side.tail, side.tip, share, away / distance, distance};
}

}  // namespace

void Fence::SetReach(const Eigen::VectorXcd& z, double share) {
  for (Side& side : sides) side.reach = share * std::abs(z[side.tip] - z[side.tail]);
}

std::vector<Contact> Fence::Contacts(const Eigen::VectorXcd& z, double times) const {
  std::vector<BoxTree::Box> boxes;
  boxes.reserve(sides.size());
  for (const Side& side : sides) {
    boxes.emplace_back(Point(z[side.tail]));
    boxes.back().extend(Point(z[side.tip]));
  }
  const BoxTree tree(std::move(boxes));
  std::vector<Contact> contacts;
  for (const Side& at : sides) {
    const Index v = at.tail;
    const Eigen::Vector2d p = Point(z[v]), reach = Eigen::Vector2d::Constant(times * at.reach);
    tree.VisitMeeting({p - reach, p + reach}, [&](Index s) {
      if (sides[s].tail == v || sides[s].tip == v) return;
      Contact contact = ContactOf(v, sides[s], z);
      contact.reach = times * std::min(at.reach, sides[s].reach);
      if (!(contact.distance >= contact.reach)) contacts.push_back(contact);
    });
  }
  return contacts;
}

double Fence::Value(const Eigen::VectorXcd& z) const {
  if (!(weight > 0)) return 0;
  double sum = 0;
  for (const Contact& contact : Contacts(z)) {
    if (!(contact.distance > 0)) return std::numeric_limits<double>::infinity();
    const double excess = contact.reach / contact.distance - 1;
    sum += excess * excess;
  }
  return weight * sum;
}

bool Fence::IsCrossed(const Eigen::VectorXcd& z) const {
  std::vector<DirectedSegment> segments;
  segments.reserve(sides.size());
  for (const Side& side : sides) segments.push_back({Point(z[side.tail]), Point(z[side.tip])});
  return FindOverlap(segments).has_value();
}

}  // namespace cirque
