#include "experiments/circle_patterns/prescriptions.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/cuts/shortest_path.h"

namespace cirque {
namespace {

/// The vertex that bears this number, counted from 1, in the file.
StatusOr<Index> VertexOf(std::string_view word, const FileNumbers& numbers) {
  Index number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = error == std::errc() && end == word.data() + word.size();
  const auto found = std::find(numbers.vertex.begin(), numbers.vertex.end(), number - 1);
  if (whole && found != numbers.vertex.end()) {
    return static_cast<Index>(found - numbers.vertex.begin());
  }
  return Status::InvalidInput(fmt::format(
      "cut_paths: '{}' is no vertex of the surface; write pairs such as 12-40,40-7", word));
}

/// Shortest paths between the pairs "a-b,c-d".
StatusOr<Cut> CutAlongPaths(std::string_view text, const Triangulation& t,
                            const EdgeLengths& lengths, const FileNumbers& numbers) {
  std::vector<std::pair<Index, Index>> ends;
  while (!text.empty()) {
    const std::string_view pair = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), pair.size() + 1));
    const std::size_t dash = std::min(pair.find('-'), pair.size());
    const auto from = VertexOf(pair.substr(0, dash), numbers);
    if (!from.ok()) return from.status();
    const auto to = VertexOf(pair.substr(std::min(dash + 1, pair.size())), numbers);
    if (!to.ok()) return to.status();
    ends.emplace_back(*from, *to);
  }
  return CutAlongShortestPaths(t, lengths.value, ends);
}

}  // namespace

StatusOr<std::optional<ConeTargets>> PrescribedTargets(const CirclePatternsJob& job,
                                                       const Triangulation& t,
                                                       const FileVertices& vertices) {
  if (job.angle_sums.empty() && job.cones.empty()) return std::optional<ConeTargets>();
  StatusOr<ConeTargets> targets = job.angle_sums.empty()
                                      ? ReadConeFile(job.cones, t, vertices)
                                      : ReadAngleSumFile(job.angle_sums, t, vertices);
  if (!targets.ok()) return targets.status();
  return std::optional<ConeTargets>(*std::move(targets));
}

StatusOr<std::optional<Cut>> PrescribedCut(const CirclePatternsJob& job, const Triangulation& t,
                                           const EdgeLengths& lengths, const FileNumbers& numbers) {
  if (job.cut.empty() && job.cut_paths.empty()) return std::optional<Cut>();
  StatusOr<Cut> cut = job.cut.empty() ? CutAlongPaths(job.cut_paths, t, lengths, numbers)
                                      : ReadCutFile(job.cut, t, numbers);
  if (!cut.ok()) return cut.status();
  return std::optional<Cut>(*std::move(cut));
}

}  // namespace cirque
