#include "bench/registration.h"

#include <glog/logging.h>

namespace cirque {

bool RegisterBySize(const std::string& name, std::initializer_list<int> sizes,
                    const std::function<void(benchmark::State&, int size)>& run) {
  FLAGS_minloglevel = google::GLOG_ERROR;
  auto* registered = benchmark::RegisterBenchmark(name.c_str(), [run](benchmark::State& state) {
    run(state, static_cast<int>(state.range(0)));
  });
  for (const int size : sizes) registered->Arg(size);
  registered->Unit(benchmark::kMillisecond);
  return true;
}

void CountFaces(benchmark::State& state, int faces) {
  state.counters["faces"] = faces;
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * faces);
}

}  // namespace cirque
