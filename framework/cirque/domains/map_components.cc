#include "cirque/domains/map_components.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "cirque/angles/registry.h"
#include "cirque/core/parallel.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

/// A control whose callbacks come from one thread at a time, and name the component.
class SharedControl {
 public:
  explicit SharedControl(const SolveControl& control) : control_(control) {}

  SolveControl Of(const std::string& name) {
    SolveControl own;
    own.cancelled = control_.cancelled;
    if (control_.callback) {
      own.callback = [this](const IterationRecord& record, const Eigen::VectorXd& x) {
        const std::lock_guard lock(mutex_);
        return control_.callback(record, x);
      };
    }
    if (control_.on_stage) {
      own.on_stage = [this, name](std::string_view stage) {
        const std::lock_guard lock(mutex_);
        control_.on_stage(name + std::string(stage));
      };
    }
    return own;
  }

 private:
  const SolveControl& control_;
  std::mutex mutex_;
};

bool IsCancelled(const SolveControl& control) {
  return control.cancelled != nullptr && control.cancelled->load();
}

/// Whether a solver spreads over processes, which do one thing at a time.
bool IsDistributed(const ComponentJob& job) {
  const ParameterizeOptions& options = job.request.options;
  return IsDistributedStrategy(options.radii_solver) ||
         IsDistributedAngleSolver(options.angle_solver);
}

MappedComponent MapOne(const ComponentJob& job, const SolveControl& control) {
  MappedComponent mapped;
  if (IsCancelled(control)) {
    mapped.status = {StatusCode::kCancelled, "cancelled by the caller"};
    return mapped;
  }
  StatusOr<SurfaceMap> map = MapSurface(job.surface, job.request, control, &mapped.map.certificate);
  mapped.status = map.status();
  if (map.ok()) mapped.map = *std::move(map);
  return mapped;
}

constexpr Index kWorthThreads = 2000;  // with fewer triangles in all, threads take longer to begin

bool AreWorthThreads(const std::vector<ComponentJob>& jobs) {
  Index faces = 0;
  for (const ComponentJob& job : jobs) faces += job.surface.triangulation.num_faces();
  return faces >= kWorthThreads && std::none_of(jobs.begin(), jobs.end(), IsDistributed);
}

/// The jobs by the size of their surfaces, the largest first.
std::vector<Index> LargestFirst(const std::vector<ComponentJob>& jobs) {
  std::vector<Index> order(jobs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return jobs[a].surface.triangulation.num_faces() > jobs[b].surface.triangulation.num_faces();
  });
  return order;
}

}  // namespace

std::vector<MappedComponent> MapComponents(const std::vector<ComponentJob>& jobs,
                                           const SolveControl& control) {
  std::vector<MappedComponent> mapped(jobs.size());
  if (jobs.size() == 1) {
    mapped[0] = MapOne(jobs[0], control);
    return mapped;
  }
  SharedControl shared(control);
  const std::vector<Index> order = LargestFirst(jobs);
  const auto map = [&](int k) {
    const Index i = order[k];
    mapped[i] = MapOne(jobs[i], shared.Of(fmt::format("component {} of {}, ", i + 1, jobs.size())));
    mapped[i].map.certificate.component = jobs[i].component;
  };
  const auto count = static_cast<int>(jobs.size());
  if (AreWorthThreads(jobs)) {
    ParallelQueue(count, map);
  } else {
    for (int k = 0; k < count; ++k) map(k);
  }
  return mapped;
}

namespace {

/// The worse the larger.
int Badness(const Certificate& certificate) {
  static const std::vector<std::string> kWorst = {
      ToString(StatusCode::kOk),           kInaccurate,
      ToString(StatusCode::kNotConverged), ToString(StatusCode::kUnrepresentable),
      ToString(StatusCode::kInfeasible),   ToString(StatusCode::kInvalidInput),
      ToString(StatusCode::kResource),     ToString(StatusCode::kCancelled)};
  const auto found = std::find(kWorst.begin(), kWorst.end(), certificate.outcome);
  return static_cast<int>(found - kWorst.begin());
}

int OverlapBadness(const std::string& overlap) {
  static const std::vector<std::string> kWorst = {kInjective, "unknown", kOverlaps};
  return static_cast<int>(std::find(kWorst.begin(), kWorst.end(), overlap) - kWorst.begin());
}

template <class T>
void AddTo(const std::optional<T>& part, std::optional<T>* sum) {
  if (part) *sum = sum->value_or(T()) + *part;
}

double Larger(double a, double b) { return !(b > a) && !std::isnan(a) ? a : b; }

void AddLayout(const LayoutSummary& part, LayoutSummary* sum) {
  sum->layout_closure = Larger(sum->layout_closure, part.layout_closure);
  sum->flipped_triangles += part.flipped_triangles;
  AddTo(part.cones, &sum->cones);
  AddTo(part.patches, &sum->patches);
  AddTo(part.cut_length, &sum->cut_length);
  AddTo(part.visible_cut_length, &sum->visible_cut_length);
  AddTo(part.float32_vanishing_triangles, &sum->float32_vanishing_triangles);
}

void AddSeams(const SeamSummary& part, SeamSummary* sum) {
  sum->seams += part.seams;
  sum->seam_length_mismatch = Larger(sum->seam_length_mismatch, part.seam_length_mismatch);
  sum->seam_rotation_mismatch = Larger(sum->seam_rotation_mismatch, part.seam_rotation_mismatch);
  sum->seam_gap = Larger(sum->seam_gap, part.seam_gap);
  sum->cone_rotation_mismatch = Larger(sum->cone_rotation_mismatch, part.cone_rotation_mismatch);
}

void AddExactMap(const ExactMapSummary& part, ExactMapSummary* sum) {
  sum->exact_triangles += part.exact_triangles;
  sum->exact_crossings += part.exact_crossings;
  sum->exact_faces_worst = std::max(sum->exact_faces_worst, part.exact_faces_worst);
  sum->exact_edges_spread += part.exact_edges_spread;
  sum->exact_largest_shift = std::max(sum->exact_largest_shift, part.exact_largest_shift);
  sum->exact_layout_closure = Larger(sum->exact_layout_closure, part.exact_layout_closure);
  sum->exact_seam_length_mismatch =
      Larger(sum->exact_seam_length_mismatch, part.exact_seam_length_mismatch);
}

void AddSeconds(const StageSeconds& part, StageSeconds* sum) {
  for (const auto member :
       {&StageSeconds::pole, &StageSeconds::corners, &StageSeconds::cones,
        &StageSeconds::triangulation, &StageSeconds::angles, &StageSeconds::radii,
        &StageSeconds::scales, &StageSeconds::rotations, &StageSeconds::injective,
        &StageSeconds::refine_cones, &StageSeconds::layout, &StageSeconds::exact,
        &StageSeconds::measures, &StageSeconds::total}) {
    AddTo(part.*member, &(sum->*member));
  }
}

}  // namespace

Certificate SummarizeComponents(std::vector<Certificate> components) {
  Certificate all;
  all.outcome = ToString(StatusCode::kOk);
  all.overlap = "injective";
  all.atlas = AtlasSummary();
  all.atlas->components = static_cast<int>(components.size());
  int worst = 0;
  Index largest = 0;
  for (const Certificate& part : components) {
    const int badness = Badness(part);
    const Index faces = part.component.value_or(ComponentSummary()).faces;
    if (badness > worst || (badness == worst && badness > 0 && faces > largest)) {
      all.outcome = part.outcome;
      all.message = part.message;
      largest = faces;
    }
    worst = std::max(worst, badness);
    AddSeconds(part.seconds, &all.seconds);
    if (badness > 1) {
      ++all.atlas->components_failed;
      continue;
    }
    if (OverlapBadness(part.overlap) > OverlapBadness(all.overlap)) all.overlap = part.overlap;
    if (part.layout) AddLayout(*part.layout, &Fill(&all.layout));
    if (part.seams) AddSeams(*part.seams, &Fill(&all.seams));
    if (part.exact_map) AddExactMap(*part.exact_map, &Fill(&all.exact_map));
  }
  all.components = std::move(components);
  return all;
}

}  // namespace cirque
