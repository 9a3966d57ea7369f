#include "cirque/cuts/part_into_charts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/count.h"
#include "cirque/cuts/dual_flow.h"
#include "cirque/cuts/dual_graph.h"

namespace cirque {
namespace {

constexpr int kMoves = 6;   ///< of the seeds
constexpr int kSweeps = 4;  ///< over all borders, at most
constexpr std::array kNearer = {1.2, 2.0, 5.0};
constexpr double kBetter = 1 - 1e-6;  ///< of a border's price, to be worth the change

/// All costs in the units of flows.
constexpr double kWholeCost = 1LL << 40;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Parts {
 public:
  Parts(const DualGraph& graph, Index count) : graph_(graph), part_(graph.size(), kNone) {
    ChooseSeeds(count);
    for (int move = 0; move < kMoves && MoveSeeds(); ++move) Grow();
    for (const DualGraph::Joint& joint : graph_.joints()) whole_ += joint.cost;
    changes_.assign(count, 1);
  }

  /// Parts neighbours anew until no border gets better. Error: cancelled.
  Status Improve(const std::atomic<bool>* cancelled) {
    if (!(whole_ > 0)) return Status();
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      bool better = false;
      for (const auto& pair : Neighbours()) {
        if (cancelled && *cancelled) return Status(StatusCode::kCancelled, "cancelled");
        // Once more only where another neighbour changed one of the two since.
        auto& [done_a, done_b] = done_[pair];
        auto& [a, b] = pair;
        if (done_a == changes_[a] && done_b == changes_[b]) continue;
        if (PartAnew(a, b)) better = true, ++changes_[a], ++changes_[b];
        done_a = changes_[a], done_b = changes_[b];
      }
      if (!better) break;
    }
    return Status();
  }

  bool IsBorder(const DualGraph::Joint& joint) const { return part_[joint.a] != part_[joint.b]; }

 private:
  /// Each as far as can be from those before; the first as far as can be from any.
  void ChooseSeeds(Index count) {
    const auto anywhere = [](Index, Index) { return true; };
    std::vector<double> distance(graph_.size(), kInfinity);
    const auto farthest = [&] {
      return static_cast<Index>(std::max_element(distance.begin(), distance.end()) -
                                distance.begin());
    };
    Spread(
        graph_, {0}, anywhere, [](Index, Index) {}, &distance);
    for (double& d : distance) {
      if (d == kInfinity) d = -1;
    }
    Index next = farthest();
    distance.assign(graph_.size(), kInfinity);
    while (static_cast<Index>(seed_.size()) < count) {
      const auto own = static_cast<Index>(seed_.size());
      seed_.push_back(next);
      part_[next] = own;
      Spread(
          graph_, {next}, anywhere, [&](Index node, Index) { part_[node] = own; }, &distance);
      next = farthest();
    }
  }

  void Grow() {
    std::vector<double> distance(graph_.size(), kInfinity);
    for (Index p = 0; p < static_cast<Index>(seed_.size()); ++p) part_[seed_[p]] = p;
    Spread(
        graph_, seed_, [](Index, Index) { return true; },
        [&](Index node, Index from) { part_[node] = part_[from]; }, &distance);
  }

  /// Every seed to where its part is farthest from others. False where all stay.
  bool MoveSeeds() {
    std::vector<Index> border;
    for (const DualGraph::Joint& joint : graph_.joints()) {
      if (IsBorder(joint)) border.push_back(joint.a), border.push_back(joint.b);
    }
    std::vector<double> depth(graph_.size(), kInfinity);
    Spread(
        graph_, border, [&](Index from, Index to) { return part_[from] == part_[to]; },
        [](Index, Index) {}, &depth);
    const std::vector<Index> before = seed_;
    for (Index node = 0; node < graph_.size(); ++node) {
      Index& seed = seed_[part_[node]];
      if (depth[node] != kInfinity && depth[node] > depth[seed]) seed = node;
    }
    return seed_ != before;
  }

  std::vector<std::pair<Index, Index>> Neighbours() const {
    std::vector<std::pair<Index, Index>> pairs;
    for (const DualGraph::Joint& joint : graph_.joints()) {
      if (IsBorder(joint)) pairs.push_back(std::minmax(part_[joint.a], part_[joint.b]));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  /// Distances from a part's seed within two parts.
  std::vector<double> DistancesIn(Index a, Index b, Index from) const {
    std::vector<double> distance(graph_.size(), kInfinity);
    Spread(
        graph_, {seed_[from]}, [&](Index, Index to) { return part_[to] == a || part_[to] == b; },
        [](Index, Index) {}, &distance);
    return distance;
  }

  /// The price of a border of two parts, `on_a` telling their nodes apart.
  template <class OnA>
  double Price(const std::vector<Index>& nodes, Index a, Index b, const OnA& on_a) const {
    double area_a = 0, area_b = 0, cost = 0;
    for (const Index node : nodes) {
      const bool here = on_a(node);
      (here ? area_a : area_b) += graph_.Area(node);
      if (!here) continue;
      graph_.ForEachJointAt(node, [&](const DualGraph::Joint& joint, Index across) {
        const bool within = part_[across] == a || part_[across] == b;
        if (within && !on_a(across)) cost += joint.cost;
      });
    }
    return cost * (1 / area_a + 1 / area_b);
  }

  bool PartAnew(Index a, Index b) {
    std::vector<Index> nodes;
    for (Index node = 0; node < graph_.size(); ++node) {
      if (part_[node] == a || part_[node] == b) nodes.push_back(node);
    }
    const std::vector<double> from_a = DistancesIn(a, b, a), from_b = DistancesIn(a, b, b);
    double least = kBetter * Price(nodes, a, b, [&](Index node) { return part_[node] == a; });
    std::vector<bool> best;
    for (const double nearer : kNearer) {
      // Per node which part holds it fast.
      const auto held = [&](Index node) {
        return nearer * from_a[node] <= from_b[node]   ? a
               : nearer * from_b[node] <= from_a[node] ? b
                                                       : kNone;
      };
      std::vector<bool> on_a = CheapestSides(nodes, a, b, held);
      const double price = Price(nodes, a, b, [&](Index node) { return on_a[node]; });
      if (!(price < least)) continue;
      least = price;
      best = std::move(on_a);
    }
    if (best.empty()) return false;
    for (const Index node : nodes) part_[node] = best[node] ? a : b;
    return true;
  }

  /// Per node of two parts whether it is on the side of a, where they are parted at least cost.
  template <class Held>
  std::vector<bool> CheapestSides(const std::vector<Index>& nodes, Index a, Index b,
                                  const Held& held) const {
    constexpr Index kSource = 0, kSink = 1;
    std::vector<Index> number(graph_.size(), kNone);
    Index size = 2;
    for (const Index node : nodes) {
      const Index by = held(node);
      number[node] = by == a ? kSource : by == b ? kSink : size++;
    }
    DualFlow flow(size);
    for (const Index node : nodes) {
      graph_.ForEachJointAt(node, [&](const DualGraph::Joint& joint, Index across) {
        if (node != joint.a || number[across] == kNone || number[node] == number[across]) return;
        const auto units = static_cast<std::int64_t>(kWholeCost * joint.cost / whole_);
        flow.Join(number[node], number[across], std::max<std::int64_t>(1, units));
      });
    }
    flow.SetSource(kSource), flow.SetSink(kSink);
    const std::vector<bool> side = flow.MinimumCut();
    std::vector<bool> on_a(graph_.size(), false);
    for (const Index node : nodes) on_a[node] = side[number[node]];
    return on_a;
  }

  const DualGraph& graph_;
  std::vector<Index> part_;   ///< per node
  std::vector<Index> seed_;   ///< per part a node
  double whole_ = 0;          ///< cost of all joints
  std::vector<int> changes_;  ///< per part, from 1
  std::map<std::pair<Index, Index>, std::pair<int, int>>
      done_;  ///< as they were when it was parted
};

}  // namespace

StatusOr<Cut> PartIntoCharts(const IntrinsicSurface& surface, const Eigen::VectorXd& edge_cost,
                             const Cut& given, Index count, const std::atomic<bool>* cancelled) {
  const Triangulation& t = surface.triangulation;
  CHECK_EQ(edge_cost.size(), t.num_edges());
  if (ConnectedPatches(CutOpen(t, given)).count >= count) return given;
  const DualGraph graph(surface, edge_cost, given);
  if (graph.size() < count) {
    return Status::InvalidInput(fmt::format("{} were asked for, but the surface has only {}",
                                            Count(count, "chart"), Count(graph.size(), "face")));
  }
  Parts parts(graph, count);
  if (Status s = parts.Improve(cancelled); !s.ok()) return s;
  Cut cut = given;
  for (const DualGraph::Joint& joint : graph.joints()) {
    if (parts.IsBorder(joint)) cut.edge[joint.edge] = true;
  }
  return cut;
}

}  // namespace cirque
