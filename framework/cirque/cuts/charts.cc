#include "cirque/cuts/charts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "cirque/cuts/dual_flow.h"
#include "cirque/math/box_tree.h"
#include "cirque/math/overlap_geometry.h"

namespace cirque {
namespace {

/// All edges of the image in the units that cuts cost, and a closed edge: more than all of them.
constexpr double kWholeCost = 1LL << 40;
constexpr std::int64_t kClosedCost = 1LL << 41;

/// A face so many times nearer to one sheet than to the other stays with it, where cuts lie halfway.
constexpr Index kMuchNearer = 2;

using FacePair = std::pair<Index, Index>;

PlaneTriangle ImageOf(const CornerUv& uv, Index f) {
  return {uv.value[3 * f], uv.value[3 * f + 1], uv.value[3 * f + 2]};
}

/// Faces round a vertex where the image does not go round more than once lie side by side.
bool ShareInnerVertex(const Triangulation& t, const std::vector<bool>& boundary, Index f, Index g) {
  for (Index a = 3 * f; a < 3 * f + 3; ++a) {
    for (Index b = 3 * g; b < 3 * g + 3; ++b) {
      if (t.vertex[a] == t.vertex[b] && !boundary[t.vertex[a]]) return true;
    }
  }
  return false;
}

/// For every face those of its patch that it overlaps.
std::vector<std::vector<Index>> FindPartners(const Triangulation& open, const CornerUv& uv) {
  std::vector<Eigen::AlignedBox2d> boxes(open.num_faces());
  for (Index f = 0; f < open.num_faces(); ++f) {
    for (const Eigen::Vector2d& p : ImageOf(uv, f)) boxes[f].extend(p);
  }
  const BoxTree tree(boxes);
  const std::vector<bool> boundary = BoundaryVertices(open);
  const Patches patches = ConnectedPatches(open);
  std::vector<std::vector<Index>> partners(open.num_faces());
  for (Index f = 0; f < open.num_faces(); ++f) {
    tree.VisitMeeting(boxes[f], [&](Index g) {
      if (g <= f || patches.of_face[f] != patches.of_face[g]) return;
      if (ShareInnerVertex(open, boundary, f, g)) return;
      if (!InteriorsMeet(ImageOf(uv, f), ImageOf(uv, g))) return;
      partners[f].push_back(g);
      partners[g].push_back(f);
    });
  }
  for (auto& of_face : partners) std::sort(of_face.begin(), of_face.end());
  return partners;
}

/// A part of a patch that lies upon another part of it.
struct Sheets {
  std::set<Index> upper, lower;  ///< faces
};

/// What does not change from one way of parting sheets to the next.
struct Overlaps {
  explicit Overlaps(const OpenedImage& of)
      : image(of),
        open(CutOpen(of.triangulation, of.cut)),
        partners(FindPartners(open, of.uv)),
        patch(ConnectedPatches(open).of_face) {}

  const OpenedImage& image;
  const Triangulation open;
  const std::vector<std::vector<Index>> partners;  ///< F
  const std::vector<Index> patch;                  ///< F
};

class Charts {
 public:
  Charts(const Overlaps& overlaps, const std::atomic<bool>* cancelled)
      : image_(overlaps.image),
        cancelled_(cancelled),
        open_(overlaps.open),
        partners_(overlaps.partners),
        chart_(overlaps.patch) {
    for (const Index chart : chart_) num_charts_ = std::max(num_charts_, chart + 1);
    for (Index h = 0; h < open_.num_halfedges(); ++h) whole_ += Length(h);
  }

  /// Parts all pairs of sheets, one after the other, `halfway` between or where it is shortest.
  /// Error: cancelled.
  Status Run(bool halfway) {
    for (Index f = 0; f < open_.num_faces(); ++f) {
      for (Index g = PartnerInChart(f); g != kNone; g = PartnerInChart(f)) {
        if (cancelled_ && *cancelled_) return Status(StatusCode::kCancelled, "cancelled");
        Sheets sheets = SheetsOf({f, g});
        if (halfway) Widen(chart_[f], &sheets);
        Part(sheets, chart_[f]);
      }
    }
    JoinNeighbours();
    return Status();
  }

  Cut Opened() const {
    Cut cut = image_.cut;
    for (Index h = 0; h < open_.num_halfedges(); ++h) {
      if (IsBorder(h)) cut.edge[image_.triangulation.edge[h]] = true;
    }
    return cut;
  }

  /// The number of charts, then the length of their borders.
  std::pair<Index, double> Price() const {
    double length = 0;
    for (Index h = 0; h < open_.num_halfedges(); ++h) length += IsBorder(h) ? Length(h) : 0;
    return {ConnectedPatches(CutOpen(image_.triangulation, Opened())).count, length};
  }

 private:
  Index Across(Index h) const {
    return open_.twin[h] == kNone ? kNone : Triangulation::Face(open_.twin[h]);
  }

  bool IsBorder(Index h) const {
    return Across(h) != kNone && chart_[Across(h)] != chart_[Triangulation::Face(h)];
  }

  double Length(Index h) const {
    const auto& uv = image_.uv.value;
    return (uv[Triangulation::Next(h)] - uv[Triangulation::Prev(h)]).norm();
  }

  std::int64_t Cost(Index h) const {
    const bool closed = image_.closed && (*image_.closed)[image_.triangulation.edge[h]];
    return closed ? kClosedCost : std::llround(kWholeCost * Length(h) / whole_);
  }

  bool AreIn(Index chart, Index f, Index g) const {
    return chart_[f] == chart && chart_[g] == chart;
  }

  Index PartnerInChart(Index f) const {
    for (const Index g : partners_[f]) {
      if (chart_[g] == chart_[f]) return g;
    }
    return kNone;
  }

  bool Overlap(Index f, Index g) const {
    return std::binary_search(partners_[f].begin(), partners_[f].end(), g);
  }

  /// Calls visit(f', g') for the pairs of overlapping faces one step from a pair.
  template <class Visit>
  void ForEachPairNextTo(const FacePair& pair, const Visit& visit) const {
    const auto [f, g] = pair;
    for (Index k = 0; k < 3; ++k) {
      const Index next_f = Across(3 * f + k), next_g = Across(3 * g + k);
      if (next_f != kNone && Overlap(next_f, g)) visit(FacePair(next_f, g));
      if (next_g != kNone && Overlap(f, next_g)) visit(FacePair(f, next_g));
    }
  }

  /// The two sheets, upon each other, that a pair belongs to, as far as they are two.
  Sheets SheetsOf(const FacePair& pair) const {
    const Index chart = chart_[pair.first];
    Sheets sheets{{pair.first}, {pair.second}};
    std::set<FacePair> seen = {pair};
    std::vector<FacePair> stack = {pair};
    while (!stack.empty()) {
      const FacePair at = stack.back();
      stack.pop_back();
      ForEachPairNextTo(at, [&](const FacePair& next) {
        const auto [f, g] = next;
        if (!AreIn(chart, f, g) || sheets.lower.count(f) || sheets.upper.count(g)) return;
        if (!seen.insert(next).second) return;
        sheets.upper.insert(f);
        sheets.lower.insert(g);
        stack.push_back(next);
      });
    }
    return sheets;
  }

  /// For every face of the chart how many faces lie between it and the nearest of some.
  std::vector<Index> StepsFrom(const std::set<Index>& faces, Index chart) const {
    std::vector<Index> steps(open_.num_faces(), kNone), queue(faces.begin(), faces.end());
    for (const Index f : faces) steps[f] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (Index h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h) {
        const Index across = Across(h);
        if (across == kNone || chart_[across] != chart || steps[across] != kNone) continue;
        steps[across] = steps[queue[i]] + 1;
        queue.push_back(across);
      }
    }
    return steps;
  }

  /// Lets all faces that are much nearer to one sheet than to the other go with it.
  void Widen(Index chart, Sheets* sheets) const {
    const std::vector<Index> up = StepsFrom(sheets->upper, chart);
    const std::vector<Index> low = StepsFrom(sheets->lower, chart);
    for (Index f = 0; f < open_.num_faces(); ++f) {
      if (chart_[f] != chart) continue;
      if (kMuchNearer * up[f] <= low[f]) sheets->upper.insert(f);
      if (kMuchNearer * low[f] <= up[f]) sheets->lower.insert(f);
    }
  }

  /// Parts sheets of a chart by a shortest cut; the lower ones' side is a new chart.
  void Part(const Sheets& sheets, Index chart) {
    std::vector<Index> faces, number(open_.num_faces(), kNone);
    for (Index face = 0; face < open_.num_faces(); ++face) {
      if (chart_[face] != chart) continue;
      number[face] = static_cast<Index>(faces.size());
      faces.push_back(face);
    }
    DualFlow flow(static_cast<Index>(faces.size()));
    for (const Index face : faces) {
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        const Index across = Across(h);
        if (across == kNone || across < face || number[across] == kNone) continue;
        flow.Join(number[face], number[across], Cost(h));
      }
    }
    for (const Index face : sheets.upper) flow.SetSource(number[face]);
    for (const Index face : sheets.lower) flow.SetSink(number[face]);
    const std::vector<bool> on_upper_side = flow.MinimumCut();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (!on_upper_side[i]) chart_[faces[i]] = num_charts_;
    }
    ++num_charts_;
  }

  /// Numbers the charts anew, each one piece.
  void TakeApart() {
    Cut borders{std::vector<bool>(open_.num_edges(), false)};
    for (Index h = 0; h < open_.num_halfedges(); ++h) {
      if (IsBorder(h)) borders.edge[open_.edge[h]] = true;
    }
    chart_ = ConnectedPatches(CutOpen(open_, borders)).of_face;
  }

  /// Makes charts one that have a border and no overlap, those with the longest border first.
  void JoinNeighbours() {
    TakeApart();
    while (true) {
      std::set<FacePair> apart;
      for (Index f = 0; f < open_.num_faces(); ++f) {
        for (const Index g : partners_[f]) apart.insert(std::minmax(chart_[f], chart_[g]));
      }
      std::map<FacePair, double> border;
      for (Index h = 0; h < open_.num_halfedges(); ++h) {
        if (!IsBorder(h)) continue;
        const FacePair charts = std::minmax(chart_[Triangulation::Face(h)], chart_[Across(h)]);
        if (!apart.count(charts)) border[charts] += Length(h);
      }
      if (border.empty()) return;
      const auto longest =
          std::max_element(border.begin(), border.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      std::replace(chart_.begin(), chart_.end(), longest->first.second, longest->first.first);
    }
  }

  const OpenedImage& image_;
  const std::atomic<bool>* cancelled_;
  const Triangulation& open_;
  const std::vector<std::vector<Index>>& partners_;
  std::vector<Index> chart_;  ///< F
  Index num_charts_ = 0;
  double whole_ = 0;
};

}  // namespace

StatusOr<Cut> CutIntoCharts(const OpenedImage& image, const std::atomic<bool>* cancelled) {
  const Overlaps overlaps(image);
  Charts shortest(overlaps, cancelled), halfway(overlaps, cancelled);
  if (Status s = shortest.Run(false); !s.ok()) return s;
  if (Status s = halfway.Run(true); !s.ok()) return s;
  return halfway.Price() < shortest.Price() ? halfway.Opened() : shortest.Opened();
}

}  // namespace cirque
