#include "experiments/circle_patterns/request.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/cuts/rotation_file.h"
#include "cirque/cuts/shortest_path.h"

namespace cirque {
namespace {

/// Vertices of a surface by the numbers, counted from 1, that they have in their mesh file.
class FileNumbering {
 public:
  /// `count`: of the vertices in the file, isolated ones included.
  FileNumbering(const Surface& surface, Index count);

  /// "3,17,4", or a single vertex. `flag` names it in messages.
  StatusOr<std::vector<Index>> Read(const std::string& flag, const std::string& text) const;

 private:
  StatusOr<Index> ReadOne(const std::string& flag, const std::string& text) const;

  std::vector<Index> of_file_;
};

FileNumbering::FileNumbering(const Surface& surface, Index count) : of_file_(count, kNone) {
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    if (surface.soup_vertex[v] != kNone) of_file_[surface.soup_vertex[v]] = v;
  }
}

StatusOr<Index> FileNumbering::ReadOne(const std::string& flag, const std::string& text) const {
  Index number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) {
    return Status::InvalidInput(
        fmt::format("--{}: '{}' is no vertex; give its number, from 1", flag, text));
  }
  const auto count = static_cast<Index>(of_file_.size());
  if (number < 1 || number > count || of_file_[number - 1] == kNone) {
    return Status::InvalidInput(fmt::format(
        "--{}: no face has vertex {}; the mesh has vertices 1 to {}", flag, number, count));
  }
  return of_file_[number - 1];
}

StatusOr<std::vector<Index>> FileNumbering::Read(const std::string& flag,
                                                 const std::string& text) const {
  std::vector<Index> vertices;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const StatusOr<Index> vertex = ReadOne(flag, word.empty() ? "," : word);
    if (!vertex.ok()) return vertex.status();
    vertices.push_back(*vertex);
    begin = end + 1;
  }
  return vertices;
}

/// The options of the shape, with the surface's vertices.
StatusOr<DomainOptions> OptionsOf(const DomainRequest& request, const FileNumbering& numbers) {
  OptionMap shape = request.shape;
  for (const OptionInfo& option : DomainOptionTable().Infos()) {
    const auto given = shape.find(option.name);
    if (option.unit != kVertexUnit || given == shape.end()) continue;
    const StatusOr<std::vector<Index>> vertices = numbers.Read(option.name, given->second);
    if (!vertices.ok()) return vertices.status();
    given->second = ToText(*vertices);
  }
  std::erase_if(shape, [](const auto& entry) { return entry.second.empty(); });
  DomainOptions options;
  const Status status = DomainOptionTable().Set(shape, &options);
  return status.ok() ? StatusOr<DomainOptions>(options) : status;
}

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

/// Shortest paths between the pairs "a-b,c-d", along sides of faces.
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
  Eigen::VectorXd costs = lengths.value;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (numbers.IsInside(e)) costs[e] = std::numeric_limits<double>::infinity();
  }
  return CutAlongShortestPaths(t, costs, ends);
}

/// Whether a file or an option of the job numbers edges or loops as the mesh's file does.
bool NamesEdges(const CirclePatternsJob& job) {
  return !(job.cut.empty() && job.cut_paths.empty() && job.rotations.empty());
}

}  // namespace

StatusOr<MapRequest> RequestOf(const CirclePatternsJob& job, Index num_file_vertices,
                               const Surface& surface) {
  MapRequest request;
  request.domain = job.domain.name;
  request.options = job.options;
  request.options.exact = AsksForExact(job);
  request.measure_visibility = !job.certificate.empty();
  auto shape = OptionsOf(job.domain, FileNumbering(surface, num_file_vertices));
  if (!shape.ok()) return shape.status();
  request.shape = *std::move(shape);
  auto targets = PrescribedTargets(
      job, surface.triangulation, {num_file_vertices, surface.soup_vertex}, &request.cone_rounding);
  if (!targets.ok()) return targets.status();
  request.targets = *std::move(targets);
  if (!NamesEdges(job)) return request;
  const FileNumbers numbers = NumbersInFile(surface);
  auto cut = PrescribedCut(job, surface.triangulation, MeasureEdgeLengths(surface), numbers);
  if (!cut.ok()) return cut.status();
  request.cut = *std::move(cut);
  auto rotations = RotationsAlongLoops(job, surface.triangulation, numbers);
  if (!rotations.ok()) return rotations.status();
  request.rotations = *std::move(rotations);
  return request;
}

StatusOr<std::optional<ConeTargets>> PrescribedTargets(
    const CirclePatternsJob& job, const Triangulation& t, const FileVertices& vertices,
    std::optional<ConeRoundingSummary>* rounding) {
  if (job.angle_sums.empty() && job.cones.empty()) return std::optional<ConeTargets>();
  ConeFileRounding done;
  StatusOr<ConeTargets> targets = job.angle_sums.empty()
                                      ? ReadConeFile(job.cones, t, vertices, &done)
                                      : ReadAngleSumFile(job.angle_sums, t, vertices);
  if (!targets.ok()) return targets.status();
  if (done.cones > 0) *rounding = {done.cones, done.missed, done.largest};
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

StatusOr<std::shared_ptr<const PrescribedRotations>> RotationsAlongLoops(
    const CirclePatternsJob& job, const Triangulation& t, const FileNumbers& numbers) {
  if (job.rotations.empty()) return std::shared_ptr<const PrescribedRotations>();
  StatusOr<std::vector<LoopRotation>> loops = ReadRotationFile(job.rotations, t, numbers);
  if (!loops.ok()) return loops.status();
  return std::make_shared<const PrescribedRotations>(
      PrescribedRotations{*std::move(loops), job.meet_rotations});
}

}  // namespace cirque
