#include "cirque/cuts/rotation_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "cirque/io/file_input.h"

namespace cirque {
namespace {

class RotationParser {
 public:
  RotationParser(const std::string& path, std::string_view text, const Triangulation& t,
                 const FileNumbers& numbers)
      : scanner_(path, text), t_(t), numbers_(numbers) {}

  StatusOr<std::vector<LoopRotation>> Parse() {
    std::vector<LoopRotation> loops;
    while (scanner_.NextLine()) {
      const std::optional<double> rotation = scanner_.Number();
      if (!rotation || !std::isfinite(*rotation)) {
        return scanner_.Expected("a rotation in radians, then the faces of its loop");
      }
      StatusOr<DualPath> path = ParsePath();
      if (!path.ok()) return path.status();
      loops.push_back({*std::move(path), *rotation});
    }
    return loops;
  }

 private:
  StatusOr<DualPath> ParsePath() {
    std::vector<Index> faces;
    while (!scanner_.AtLineEnd()) {
      const StatusOr<Index> face = ParseFace();
      if (!face.ok()) return face.status();
      faces.push_back(*face);
    }
    if (faces.size() < 3) {
      return scanner_.Error(
          fmt::format("a loop passes at least three faces; here are {}", faces.size()));
    }
    DualPath path;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Index before = faces[(i + faces.size() - 1) % faces.size()];
      if (before == faces[(i + 1) % faces.size()]) {
        return scanner_.Error(fmt::format("the loop turns back in face {}", NumberOf(faces[i])));
      }
      const StatusOr<Index> entered = Between(before, faces[i]);
      if (!entered.ok()) return entered.status();
      path.entered.push_back(*entered);
    }
    return path;
  }

  StatusOr<Index> ParseFace() {
    const std::optional<long long> number = scanner_.Count();
    if (!number) return scanner_.Expected("a face (counted from 1)");
    const auto [first, last] =
        std::equal_range(numbers_.face.begin(), numbers_.face.end(), *number - 1);
    if (first == last) {
      return scanner_.Error(fmt::format("the surface has no face {}", *number));
    }
    if (last - first > 1) {
      return scanner_.Error(fmt::format(
          "face {} has more than three corners; loops are of triangles: split the polygons",
          *number));
    }
    return static_cast<Index>(first - numbers_.face.begin());
  }

  /// The halfedge of `face` on the edge that it has in common with the face before it.
  StatusOr<Index> Between(Index before, Index face) const {
    Index found = kNone;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      if (t_.twin[h] == kNone || Triangulation::Face(t_.twin[h]) != before) continue;
      if (found != kNone) {
        return scanner_.Error(fmt::format(
            "faces {} and {} have several edges in common, and the loop might cross any "
            "of them; go around",
            NumberOf(before), NumberOf(face)));
      }
      found = h;
    }
    if (found != kNone) return found;
    return scanner_.Error(
        fmt::format("faces {} and {} have no edge in common; a loop passes from "
                    "neighbour to neighbour, and from the last face to the first",
                    NumberOf(before), NumberOf(face)));
  }

  Index NumberOf(Index face) const { return numbers_.face[face] + 1; }

  TextScanner scanner_;
  const Triangulation& t_;
  const FileNumbers& numbers_;
};

}  // namespace

StatusOr<std::vector<LoopRotation>> ParseRotations(const std::string& path, std::string_view text,
                                                   const Triangulation& t,
                                                   const FileNumbers& numbers) {
  return RotationParser(path, text, t, numbers).Parse();
}

StatusOr<std::vector<LoopRotation>> ReadRotationFile(const std::string& path,
                                                     const Triangulation& t,
                                                     const FileNumbers& numbers) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  return ParseRotations(path, *content, t, numbers);
}

}  // namespace cirque
