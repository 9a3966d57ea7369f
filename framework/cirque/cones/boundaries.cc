#include "cirque/cones/boundaries.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cirque/cones/given_file.h"
#include "cirque/cones/log_scale_norm.h"
#include "cirque/cones/registry.h"
#include "cirque/core/text.h"

namespace cirque {
namespace {

constexpr int kMostRounds = 4;  ///< of settling vertices

/// Log scales on the boundary, from a problem whose open vertices may change.
using LogScales = std::function<Eigen::VectorXd(const BoundaryProblem&)>;

/// Predicts, settles what is beyond bounds and predicts again, a few times.
StatusOr<Eigen::VectorXd> ChooseByLogScale(const LogScales& choose, BoundaryProblem* problem) {
  Eigen::VectorXd sums;
  for (int round = 0; round < kMostRounds; ++round) {
    sums = problem->AngleSums(problem->LogScale(choose(*problem)));
    if (!problem->SettleBeyondBounds(sums)) break;
  }
  return problem->FitToGaussBonnet(sums);
}

class Isometric final : public BoundaryShape {
 public:
  explicit Isometric(NoOptions /*options*/ = {}) {}

  StatusOr<Eigen::VectorXd> Choose(BoundaryProblem* problem) const override {
    return ChooseByLogScale(
        [](const BoundaryProblem& of) -> Eigen::VectorXd {
          return Eigen::VectorXd::Zero(of.area().size());
        },
        problem);
  }
};

struct LeastOptions {
  double share = 1;   ///< of the way from the isometric boundary
  double filter = 1;  ///< of sum len^2 (b_i - b_j)^2, for a surface of area 1
  int steps = 0;      ///< of descent by the finished metric
};

struct LeastMaxOptions : LeastOptions {
  int power = 8;
};

template <class O>
std::vector<Option<O>> LeastRows() {
  return {
      Option<O>("share", &O::share, "of the way there from the isometric boundary").Between(0, 1),
      Option<O>("filter", &O::filter, "weight of differences along the boundary, against noise")
          .Between(0, 1e6),
      Option<O>("steps", &O::steps,
                "the most steps by the finished metric after the prediction; on a disk none that "
                "makes the image overlap itself")
          .Between(0, 1000)};
}

const OptionTable<LeastOptions>& LeastAreaTable() {
  static const OptionTable<LeastOptions> kTable("least_area", LeastRows<LeastOptions>());
  return kTable;
}

const OptionTable<LeastMaxOptions>& LeastMaxTable() {
  using O = LeastMaxOptions;
  static const OptionTable<O> kTable(
      "least_max",
      Joined<O>(LeastRows<O>(),
                {Option<O>("power", &O::power, "the p of the L^p norm").Between(2, 64)}));
  return kTable;
}

class LeastNorm final : public BoundaryShape {
 public:
  explicit LeastNorm(const LeastMaxOptions& options) : options_(options) {}
  explicit LeastNorm(const LeastOptions& options) : options_{options, 2} {}

  BoundaryDescent descent() const override {
    return {options_.steps, options_.power, options_.filter};
  }

  StatusOr<Eigen::VectorXd> Choose(BoundaryProblem* problem) const override {
    return ChooseByLogScale(
        [this](const BoundaryProblem& of) -> Eigen::VectorXd {
          return options_.share * LeastNormLogScale(of, options_.power, options_.filter);
        },
        problem);
  }

 private:
  LeastMaxOptions options_;
};

struct StraightOptions {
  int corners = 4;
};

const OptionTable<StraightOptions>& StraightTable() {
  using O = StraightOptions;
  static const OptionTable<O> kTable(
      "straight", {Option<O>("corners", &O::corners, "of every boundary loop").Between(3, 1e6)});
  return kTable;
}

class Straight final : public BoundaryShape {
 public:
  explicit Straight(const StraightOptions& options) : options_(options) {}

  /// All loops turn alike: that of a disk by 2 pi, those of an annulus by 0 (a strip). Corners are
  /// where the isometric boundary, left and right turns alike, has turned by odd multiples of half a
  /// part of its whole.
  StatusOr<Eigen::VectorXd> Choose(BoundaryProblem* problem) const override {
    const Triangulation& t = problem->surface().triangulation;
    const StatusOr<Eigen::VectorXd> isometric = Isometric().Choose(problem);
    if (!isometric.ok()) return isometric;
    const std::vector<std::vector<Index>> loops = BoundaryLoops(t);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(t.num_vertices);
    const double turning =
        kPi * static_cast<double>(problem->boundary().size()) - problem->TotalAngleSum();
    for (const Index v : problem->boundary()) sums[v] = kPi;
    for (const std::vector<Index>& loop : loops) {
      const double part = turning / static_cast<double>(loops.size()) / options_.corners;
      for (const Index v : Corners(t, loop, *isometric)) sums[v] -= part;
    }
    return problem->FitToGaussBonnet(sums);
  }

 private:
  std::vector<Index> Corners(const Triangulation& t, const std::vector<Index>& loop,
                             const Eigen::VectorXd& sums) const {
    double total = 0;
    for (const Index h : loop) total += std::abs(kPi - sums[t.Tail(h)]);
    std::vector<Index> corners;
    double turned = 0;
    for (const Index h : loop) {
      turned += std::abs(kPi - sums[t.Tail(h)]);
      const auto due = static_cast<std::size_t>(options_.corners * turned / total + 0.5);
      if (corners.size() < due && corners.size() < static_cast<std::size_t>(options_.corners)) {
        corners.push_back(t.Tail(h));
      }
    }
    return corners;
  }

  StraightOptions options_;
};

class Given final : public BoundaryShape {
 public:
  explicit Given(GivenOptions options) : options_(std::move(options)) {}

  StatusOr<Eigen::VectorXd> Choose(BoundaryProblem* problem) const override {
    const auto targets = ReadGiven(options_, problem->input().triangulation, problem->file());
    if (!targets.ok()) return targets.status();
    const StatusOr<Eigen::VectorXd> isometric = Isometric().Choose(problem);
    if (!isometric.ok()) return isometric;
    Eigen::VectorXd sums = *isometric;
    for (const Index v : problem->boundary()) {
      if (targets->lower[v] > 0) sums[v] = 0.5 * (targets->lower[v] + targets->upper[v]);
    }
    return problem->FitToGaussBonnet(sums);
  }

 private:
  GivenOptions options_;
};

using Made = StatusOr<std::shared_ptr<const BoundaryShape>>;

}  // namespace

const Registry<BoundaryShapeFactory>& BoundaryShapes() {
  static const Registry<BoundaryShapeFactory> kTable(
      "boundary", {
                      {"isometric", FactoryOf<BoundaryShape, Isometric>(
                                        OptionTable<NoOptions>("isometric", {}))},
                      {"least_area", FactoryOf<BoundaryShape, LeastNorm>(LeastAreaTable())},
                      {"least_max", FactoryOf<BoundaryShape, LeastNorm>(LeastMaxTable())},
                      {"straight", FactoryOf<BoundaryShape, Straight>(StraightTable())},
                      {"given", FactoryOf<BoundaryShape, Given>(GivenOptionTable())},
                  });
  return kTable;
}

Made ParseBoundaryShape(const std::string& text) {
  StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  if (!named.ok()) return named.status();
  const auto factory = BoundaryShapes().Find(named->name);
  if (!factory.ok()) return factory.status();
  return (*factory)(named->options);
}

std::vector<std::string> BoundaryNames() {
  std::vector<std::string> names = {kFreeBoundary};
  for (std::string& shape : BoundaryShapes().Names()) names.push_back(std::move(shape));
  return names;
}

Status CheckBoundaryShape(const std::string& text) {
  if (text == kFreeBoundary) return Status();
  const StatusOr<NameWithOptions> named = ParseNameWithOptions(text);
  const std::vector<std::string> known = BoundaryNames();
  if (named.ok() && std::find(known.begin(), known.end(), named->name) == known.end()) {
    return Status::InvalidInput(UnknownName("boundary", named->name, known));
  }
  return ParseBoundaryShape(text).status();
}

}  // namespace cirque
