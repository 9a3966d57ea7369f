#include "cirque/math/boundary_sweep.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "cirque/math/plane_order.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Point = Eigen::Vector2d;

/// A segment from left to right.
struct Chord {
  Point low, high;
  bool begins = false;  ///< whether what is covered lies above it: it runs to the right
  int segment = 0;

  /// +1 where p lies above, 0 on the line, -1 below.
  int SideOf(const Point& p) const { return OrientationSign(low, high, p); }
};

/// From below upwards. Of two that the sweep meets at once and that do not cross, the one that
/// begins later lies on one side of the other, if not at its end then at the other.
struct Below {
  using is_transparent = void;

  bool operator()(const Chord* a, const Chord* b) const {
    if (a == b) return false;
    const bool a_first = LexicographicallyLess(a->low, b->low);
    const int side = a_first ? SideFrom(*a, *b) : -SideFrom(*b, *a);
    if (side != 0) return side > 0;
    if (a->begins != b->begins) return b->begins;
    return a->segment < b->segment;
  }
  bool operator()(const Chord* a, const Point& p) const { return a->SideOf(p) > 0; }
  bool operator()(const Point& p, const Chord* a) const { return a->SideOf(p) < 0; }

 private:
  static int SideFrom(const Chord& earlier, const Chord& later) {
    const int side = earlier.SideOf(later.low);
    return side != 0 ? side : earlier.SideOf(later.high);
  }
};

class Sweep {
 public:
  Sweep(const std::vector<DirectedSegment>& segments, Contacts contacts) : contacts_(contacts) {
    chords_.reserve(segments.size());
    for (const auto& [tail, tip] : segments) {
      const bool rises = LexicographicallyLess(tail, tip);
      chords_.push_back(
          {rises ? tail : tip, rises ? tip : tail, rises, static_cast<int>(chords_.size())});
    }
    place_.resize(chords_.size(), line_.end());
  }

  std::optional<std::pair<int, int>> Run() {
    const std::vector<int> by_low = Sorted(&Chord::low), by_high = Sorted(&Chord::high);
    std::size_t begin = 0, end = 0;
    while (end < by_high.size()) {
      const Point& next_high = chords_[by_high[end]].high;
      const bool begins =
          begin < by_low.size() && !LexicographicallyLess(next_high, chords_[by_low[begin]].low);
      const Point at = begins ? chords_[by_low[begin]].low : next_high;
      int num_ends = 0;
      while (end < by_high.size() && chords_[by_high[end]].high == at) {
        line_.erase(place_[by_high[end++]]);
        ++num_ends;
      }
      for (; begin < by_low.size() && chords_[by_low[begin]].low == at; ++begin, ++num_ends) {
        place_[by_low[begin]] = line_.insert(&chords_[by_low[begin]]).first;
      }
      if (const auto found = JudgeAt(at, num_ends)) return found;
    }
    return std::nullopt;
  }

 private:
  using Line = std::set<const Chord*, Below>;

  std::vector<int> Sorted(Point Chord::*end) const {
    std::vector<int> order(chords_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
      const Point &p = chords_[a].*end, &q = chords_[b].*end;
      return p == q ? a < b : LexicographicallyLess(p, q);
    });
    return order;
  }

  /// The pairs of neighbours that came to be at this point: from the last one below it to the first
  /// one above.
  std::optional<std::pair<int, int>> JudgeAt(const Point& at, int num_ends) const {
    auto above = line_.lower_bound(at);
    const Chord* below = above == line_.begin() ? nullptr : *std::prev(above);
    for (bool is_through = true; is_through && above != line_.end(); ++above) {
      const Chord* chord = *above;
      is_through = chord->SideOf(at) == 0;
      if (below != nullptr && !Agree(*below, *chord)) {
        return std::minmax(below->segment, chord->segment);
      }
      if (contacts_ == Contacts::kEndsOnly && is_through && (chord->low != at || num_ends != 2)) {
        return std::pair(chord->segment, chord->segment);
      }
      below = chord;
    }
    if (contacts_ == Contacts::kEndsOnly && num_ends != 2) return std::pair(0, 0);
    return std::nullopt;
  }

  static bool Agree(const Chord& below, const Chord& above) {
    if (below.begins == above.begins) return false;
    const int low = below.SideOf(above.low), high = below.SideOf(above.high);
    return low * high >= 0 || above.SideOf(below.low) * above.SideOf(below.high) >= 0;
  }

  Contacts contacts_;
  std::vector<Chord> chords_;
  Line line_;
  std::vector<Line::iterator> place_;
};

}  // namespace

std::optional<std::pair<int, int>> FindOverlap(const std::vector<DirectedSegment>& segments,
                                               Contacts contacts) {
  return Sweep(segments, contacts).Run();
}

bool Intersect(const DirectedSegment& a, const DirectedSegment& b) {
  const int b_tail = OrientationSign(a.tail, a.tip, b.tail),
            b_tip = OrientationSign(a.tail, a.tip, b.tip);
  const int a_tail = OrientationSign(b.tail, b.tip, a.tail),
            a_tip = OrientationSign(b.tail, b.tip, a.tip);
  if (b_tail * b_tip < 0 && a_tail * a_tip < 0) return true;
  const auto holds = [](const DirectedSegment& s, const Point& p) {
    return p == s.tail || p == s.tip || OnOpenSegment(p, s.tail, s.tip);
  };
  return holds(a, b.tail) || holds(a, b.tip) || holds(b, a.tail) || holds(b, a.tip);
}

}  // namespace cirque
