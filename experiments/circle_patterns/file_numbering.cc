#include "experiments/circle_patterns/file_numbering.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace cirque {

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

}  // namespace cirque
