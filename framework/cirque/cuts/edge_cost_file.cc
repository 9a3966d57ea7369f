#include "cirque/cuts/edge_cost_file.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/io/file_content.h"
#include "cirque/io/text_scanner.h"

namespace cirque {
namespace {

using Ends = std::pair<long long, long long>;

Ends Ordered(long long a, long long b) { return a < b ? Ends(a, b) : Ends(b, a); }

class EdgeCostParser {
 public:
  EdgeCostParser(const std::string& path, std::string_view text, const Triangulation& t,
                 const std::vector<Index>& number)
      : scanner_(path, text), cost_(Eigen::VectorXd::Ones(t.num_edges())) {
    for (Index e = 0; e < t.num_edges(); ++e) {
      const Index h = t.edge_halfedge[e];
      edges_[Ordered(number[t.Tail(h)] + 1LL, number[t.Tip(h)] + 1LL)].push_back(e);
    }
  }

  StatusOr<Eigen::VectorXd> Run() {
    while (scanner_.NextLine()) {
      if (Status s = ParseLine(); !s.ok()) return s;
    }
    return std::move(cost_);
  }

 private:
  Status ParseLine() {
    const std::optional<long long> from = scanner_.Integer();
    if (!from) return scanner_.Expected("a vertex (counted from 1)");
    const std::optional<long long> to = scanner_.Integer();
    if (!to) return scanner_.Expected("the edge's other vertex (counted from 1)");
    const std::optional<double> cost = scanner_.Number();
    if (!cost || !scanner_.AtLineEnd()) return scanner_.Expected("a cost, and nothing else");
    if (!(std::isfinite(*cost) && *cost >= 0)) {
      return scanner_.Error(fmt::format("the cost {} must be finite and at least 0", *cost));
    }
    const auto found = edges_.find(Ordered(*from, *to));
    if (found == edges_.end()) {
      return scanner_.Error(fmt::format("no edge joins the vertices {} and {}", *from, *to));
    }
    const auto [line, is_new] = line_of_.emplace(found->first, scanner_.line());
    if (!is_new) {
      return scanner_.Error(
          fmt::format("the edge {} {} has a cost already, in line {}", *from, *to, line->second));
    }
    for (const Index e : found->second) cost_[e] = *cost;
    return Status();
  }

  TextScanner scanner_;
  Eigen::VectorXd cost_;
  std::map<Ends, std::vector<Index>> edges_;
  std::map<Ends, int> line_of_;
};

}  // namespace

StatusOr<Eigen::VectorXd> ParseEdgeCosts(const std::string& path, std::string_view text,
                                         const Triangulation& t,
                                         const std::vector<Index>& vertex_in_file) {
  return EdgeCostParser(path, text, t, vertex_in_file).Run();
}

StatusOr<Eigen::VectorXd> ReadEdgeCostFile(const std::string& path, const Triangulation& t,
                                           const std::vector<Index>& vertex_in_file) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  return ParseEdgeCosts(path, *content, t, vertex_in_file);
}

}  // namespace cirque
