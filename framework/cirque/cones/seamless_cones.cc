#include "cirque/cones/seamless_cones.h"

#include <algorithm>
#include <utility>

#include "cirque/cones/rotation_model.h"
#include "cirque/cones/seamless_search.h"
#include "cirque/intrinsic/dual_paths.h"

namespace cirque {
namespace {

constexpr int kConesOfHandle = 12, kLeastCones = 8, kConesOfSphere = 12;

std::vector<SignedCorners> CornersOfHandles(const Triangulation& t) {
  std::vector<SignedCorners> corners;
  for (const DualPath& loop : HandleLoops(t)) corners.push_back(CornersAlong(t, loop));
  return corners;
}

}  // namespace

const OptionTable<SeamlessOptions>& SeamlessOptionTable() {
  using O = SeamlessOptions;
  static const OptionTable<O> kTable(
      "seamless",
      {Option<O>("cones", &O::cones,
                 "the most cones at the start, but for what Gauss-Bonnet needs; -1: 12 a handle "
                 "beyond the first, at least 8")
           .Between(-1, 1e6),
       {"start", &O::start, "the heuristic that comes first"},
       {"angles", &O::angles,
        "pi/2 or pi/3: of cones and rotations multiples; free: the start's angles and places, with "
        "as many cones"}});
  return kTable;
}

int SeamlessBudget(const ConeProblem& problem, ConeAngleRule angles) {
  const Triangulation& t = problem.triangulation();
  const auto loops = static_cast<Index>(BoundaryLoops(t).size());
  const Index genus = (2 - loops - EulerCharacteristic(t)) / 2;
  if (genus == 0) return angles == ConeAngleRule::kThirds ? kConesOfSphere : kLeastCones;
  return std::max<Index>(kLeastCones, kConesOfHandle * (genus - 1));
}

StatusOr<std::shared_ptr<const ConeHeuristic>> SeamlessCones::Make(const OptionMap& map,
                                                                   const StartMaker& make_start) {
  SeamlessOptions options;
  if (Status s = SeamlessOptionTable().Set(map, &options); !s.ok()) return s;
  if (options.start == "seamless") {
    return Status::InvalidInput("seamless: start = 'seamless' would never begin; name another");
  }
  if (options.angles == ConeAngleRule::kRanges) {
    return Status::InvalidInput("seamless: angles are pi/2, pi/3 or free");
  }
  if (const auto start = make_start(options.start, {}); !start.ok()) {
    return start.status().In("seamless");
  }
  return std::shared_ptr<const ConeHeuristic>(
      std::make_shared<SeamlessCones>(std::move(options), make_start));
}

StatusOr<std::vector<Cone>> SeamlessCones::Choose(const ConeProblem& problem) const {
  OptionMap start_options;
  const bool counts = options_.start != "none" && options_.start != "given";
  const int count = options_.cones >= 0 ? options_.cones : SeamlessBudget(problem, options_.angles);
  if (counts) start_options["cones"] = std::to_string(count);
  const auto start = make_start_(options_.start, start_options);
  if (!start.ok()) return start.status().In("seamless");
  StatusOr<std::vector<Cone>> cones = (*start)->Choose(problem);
  if (!cones.ok() || options_.angles == ConeAngleRule::kFree) return cones;
  cones = ApplyConeAngles(problem, *std::move(cones), {options_.angles});
  if (!cones.ok() || cones->empty()) return cones;
  const RotationModel model(problem, CornersOfHandles(problem.triangulation()));
  const double unit = kPi / (options_.angles == ConeAngleRule::kHalves ? 2 : 3);
  SeamlessSearch search(problem, model, *std::move(cones), unit);
  search.DescendArea(nullptr);
  search.Run(Eigen::VectorXd::Zero(model.size()), nullptr);
  return search.cones();
}

}  // namespace cirque
