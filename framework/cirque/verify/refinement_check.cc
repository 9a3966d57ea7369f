#include "cirque/verify/refinement_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cirque/core/grouping.h"
#include "cirque/core/text.h"
#include "cirque/verify/report_words.h"
#include "cirque/verify/set_aside.h"

namespace cirque::verify {
namespace {

constexpr double kAreaTolerance = 1e-12;
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();

using Edge = std::pair<Index, Index>;
using Point3 = Eigen::Vector3d;

class RefinementChecker {
 public:
  RefinementChecker(const PolygonSoup& in, const PolygonSoup& out, const std::vector<Index>& group)
      : in_(in),
        out_(out),
        pieces_(SortIntoBuckets(group, in.num_polygons())),
        may_set_aside_(MaySetAside(in)) {}

  RefinementReport Run() {
    report_.num_faces = in_.num_polygons();
    report_.num_pieces = out_.num_polygons();
    for (std::size_t v = 0; v < in_.position.size(); ++v) {
      if (out_.position[v] != in_.position[v]) moved_.push_back(static_cast<Index>(v));
    }
    for (Index f = 0; f < in_.num_polygons(); ++f) CountSides(f);
    for (Index f = 0; f < in_.num_polygons(); ++f) CheckFace(f);
    Tell("vertices that are not where IN has them", moved_);
    Tell("faces whose pieces do not have their border", without_border_);
    Tell("faces whose edges have points beside them, or out of order", off_edge_);
    Tell("faces whose edges have other points from their other side", unlike_);
    Tell("faces with a piece turned over", turned_);
    Tell("faces whose pieces have another area", wrong_area_);
    return std::move(report_);
  }

 private:
  void Tell(const char* what, std::vector<Index> ids) {
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    if (!ids.empty()) {
      report_.errors.push_back(fmt::format("{} {} ({})", ids.size(), what, IdList(ids)));
    }
  }

  void CheckFace(Index f) {
    const Index count = pieces_.first[f + 1] - pieces_.first[f];
    if (count > report_.most_pieces) {
      report_.most_pieces = count;
      report_.most_pieces_in = f;
    }
    if (count == 0 && may_set_aside_[f]) {
      report_.set_aside.push_back(f);
      return;
    }
    std::vector<Index> border = Border(f);
    if (border.empty() || !SplitAtCorners(f, border)) without_border_.push_back(f);
    const bool is_triangle = in_.first_corner[f + 1] - in_.first_corner[f] == 3;
    if (is_triangle) {
      CompareAreas(f);
    } else {
      ++report_.num_polygons;
    }
  }

  void CountSides(Index f) {
    const Index first = in_.first_corner[f], end = in_.first_corner[f + 1];
    for (Index c = first; c < end; ++c) {
      const Edge edge = std::minmax(in_.corner[c], in_.corner[c + 1 == end ? first : c + 1]);
      ++num_faces_at_[edge];
    }
  }

  /// The vertices round the pieces of a face, from its first corner on; empty where they are not
  /// one loop through it.
  std::vector<Index> Border(Index f) const {
    std::map<Edge, int> side;  // how often it is there, minus how often its reverse
    for (Index i = pieces_.first[f]; i < pieces_.first[f + 1]; ++i) {
      const Index first = out_.first_corner[pieces_.item[i]];
      const Index end = out_.first_corner[pieces_.item[i] + 1];
      for (Index c = first; c < end; ++c) {
        const Index a = out_.corner[c], b = out_.corner[c + 1 == end ? first : c + 1];
        ++side[{a, b}];
        --side[{b, a}];
      }
    }
    std::map<Index, Index> next;
    for (const auto& [edge, times] : side) {
      if (times > 1) return {};
      if (times == 1 && !next.emplace(edge.first, edge.second).second) return {};
    }
    const Index start = in_.corner[in_.first_corner[f]];
    std::vector<Index> border;
    for (auto at = next.find(start); at != next.end() && border.size() < next.size();
         at = next.find(at->second)) {
      border.push_back(at->first);
      if (at->second == start) break;
    }
    return border.size() == next.size() ? border : std::vector<Index>();
  }

  /// Whether the corners of the face come in its own order, or all in the reverse; what is between
  /// two of them is compared with their edge.
  bool SplitAtCorners(Index f, std::vector<Index> border) {
    const Index first = in_.first_corner[f], n = in_.first_corner[f + 1] - first;
    const auto corner = [&](Index k) { return in_.corner[first + k % n]; };
    const auto second = std::find(border.begin(), border.end(), corner(1));
    const auto last = std::find(border.begin(), border.end(), corner(n - 1));
    if (second == border.end() || last == border.end()) return false;
    if (second > last) std::reverse(border.begin() + 1, border.end());
    border.push_back(corner(0));
    std::size_t at = 0;
    for (Index k = 0; k < n; ++k) {
      std::vector<Index> chain = {border[at]};
      while (chain.size() == 1 || chain.back() != corner(k + 1)) {
        if (++at == border.size()) return false;
        chain.push_back(border[at]);
      }
      CheckChain(f, std::move(chain));
    }
    return at + 1 == border.size();
  }

  void CheckChain(Index f, std::vector<Index> chain) {
    const Point3 &a = out_.position[chain.front()], &b = out_.position[chain.back()];
    const Point3 along = b - a;
    const double slack =
        kRounding * std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
    double before = 0;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const Point3 from_a = out_.position[chain[i]] - a;
      const double length = along.norm(), position = from_a.dot(along) / length;
      const double beside = (from_a - position / length * along).norm();
      if (beside > slack + kRounding * length || position < before - slack ||
          position > length + slack) {
        off_edge_.push_back(f);
      }
      before = position;
    }
    if (chain.front() > chain.back()) std::reverse(chain.begin(), chain.end());
    const Edge edge(chain.front(), chain.back());
    const auto [known, is_new] = chains_.emplace(edge, chain);
    // Of an edge of more than two faces every sheet has points of its own.
    if (!is_new && known->second != chain && num_faces_at_[edge] == 2) unlike_.push_back(f);
  }

  static Point3 TwiceArea(const Point3& a, const Point3& b, const Point3& c) {
    return (b - a).cross(c - a);
  }

  void CompareAreas(Index f) {
    const Index* v = &in_.corner[in_.first_corner[f]];
    const Point3 &a = in_.position[v[0]], &b = in_.position[v[1]], &c = in_.position[v[2]];
    const Point3 whole = TwiceArea(a, b, c);
    const double area = whole.norm();
    if (!(area > 0)) return;
    double sum = 0, least = 0, most = 0;
    for (Index i = pieces_.first[f]; i < pieces_.first[f + 1]; ++i) {
      const Index first = out_.first_corner[pieces_.item[i]];
      for (Index k = first + 1; k + 1 < out_.first_corner[pieces_.item[i] + 1]; ++k) {
        const double piece =
            TwiceArea(out_.position[out_.corner[first]], out_.position[out_.corner[k]],
                      out_.position[out_.corner[k + 1]])
                .dot(whole) /
            area;
        sum += piece;
        least = std::min(least, piece);
        most = std::max(most, piece);
      }
    }
    const double size = std::max(
        {a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>(), c.lpNorm<Eigen::Infinity>()});
    const double perimeter = (b - a).norm() + (c - b).norm() + (a - c).norm();
    const double rounding = kRounding * size * perimeter;
    // Pieces of a face that IN lists the other way round are all turned.
    if (least < -rounding && most > rounding) turned_.push_back(f);
    const double error = std::max(0.0, std::abs(std::abs(sum) - area) - rounding) / area;
    report_.area_error = std::max(report_.area_error, error);
    if (error > kAreaTolerance) wrong_area_.push_back(f);
  }

  const PolygonSoup &in_, &out_;
  const Buckets pieces_;
  const std::vector<bool> may_set_aside_;
  std::map<Edge, std::vector<Index>> chains_;  // the points on every edge of IN
  std::map<Edge, int> num_faces_at_;           // its faces, those that may be set aside too
  std::vector<Index> moved_, without_border_, off_edge_, unlike_, turned_, wrong_area_;
  RefinementReport report_;
};

}  // namespace

StatusOr<std::vector<Index>> ReadGroups(std::string_view obj) {
  constexpr std::string_view kGroup = "g face_";
  std::vector<Index> groups;
  Index group = kNone;
  while (!obj.empty()) {
    const std::string_view line = obj.substr(0, obj.find('\n'));
    obj.remove_prefix(std::min(obj.size(), line.size() + 1));
    if (line.starts_with("g ")) {
      const std::string_view number = line.substr(std::min(kGroup.size(), line.size()));
      const auto read = std::from_chars(number.data(), number.data() + number.size(), group);
      if (!line.starts_with(kGroup) || read.ec != std::errc() || group < 1) {
        return Status::InvalidInput(
            fmt::format("'{}': a group of an exact map is 'g face_N', N from 1", line));
      }
    } else if (line.starts_with("f ")) {
      if (group == kNone) return Status::InvalidInput("a face before the first group 'g face_N'");
      groups.push_back(group - 1);
    }
  }
  return groups;
}

StatusOr<std::vector<Point3>> ReadTextureInSpace(std::string_view obj,
                                                 const PolygonSoup& obj_mesh) {
  std::vector<Point3> points;
  while (!obj.empty()) {
    const std::string_view line = obj.substr(0, obj.find('\n'));
    obj.remove_prefix(std::min(obj.size(), line.size() + 1));
    if (!line.starts_with("vt ")) continue;
    const char *at = line.data() + 3, *const end = line.data() + line.size();
    Point3& point = points.emplace_back();
    for (int k = 0; k < 3; ++k) {
      while (at < end && *at == ' ') ++at;
      const auto read = std::from_chars(at, end, point[k]);
      if (read.ec != std::errc() || !std::isfinite(point[k])) {
        return Status::InvalidInput(
            fmt::format("'{}': an exact map to the sphere has three numbers there", line));
      }
      at = read.ptr;
    }
  }
  if (points.size() != obj_mesh.position.size() || obj_mesh.corner_texture != obj_mesh.corner) {
    return Status::InvalidInput(fmt::format(
        "{} lines 'vt' for {} vertices; an exact map to the sphere says so for each, by "
        "the same number, where it lies on IN",
        points.size(), obj_mesh.position.size()));
  }
  return points;
}

StatusOr<RefinementReport> CheckRefinement(const PolygonSoup& in, const PolygonSoup& out,
                                           const std::vector<Index>& group) {
  if (static_cast<Index>(group.size()) != out.num_polygons()) {
    return Status::InvalidInput(
        fmt::format("{} faces are in groups of {}", group.size(), out.num_polygons()));
  }
  for (const Index g : group) {
    if (g >= 0 && g < in.num_polygons()) continue;
    return Status::InvalidInput(
        fmt::format("group face_{}: IN has faces 1 to {}", g + 1, in.num_polygons()));
  }
  if (out.position.size() < in.position.size()) {
    return Status::InvalidInput(
        fmt::format("{} points, fewer than the {} of IN", out.position.size(), in.position.size()));
  }
  return RefinementChecker(in, out, group).Run();
}

std::string ToText(const RefinementReport& report) {
  std::string text = Line(
      "refinement", fmt::format("{} pieces of {} faces, {} at most (of face {})", report.num_pieces,
                                report.num_faces, report.most_pieces, report.most_pieces_in));
  if (!report.set_aside.empty()) {
    text += Line("", fmt::format("without pieces, since they have no area or are there twice: {}",
                                 IdList(report.set_aside)));
  }
  text +=
      Line("areas", fmt::format("of the pieces: off by {:.3g} of the face's", report.area_error));
  for (const std::string& error : report.errors) text += Line("refinement", "INVALID: " + error);
  return text;
}

}  // namespace cirque::verify
