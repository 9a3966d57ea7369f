#include "experiments/run_experiment/config/mesh_condition.h"

#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/core/triangulation.h"
#include "cirque/domains/map_mesh.h"
#include "cirque/io/io.h"

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/file_content.h"

namespace cirque {
namespace {

struct Fact {
  const char* name;
  double MeshFacts::*value;
};

constexpr Fact kFacts[] = {{"triangles", &MeshFacts::triangles},
                           {"vertices", &MeshFacts::vertices},
                           {"components", &MeshFacts::components},
                           {"genus", &MeshFacts::genus},
                           {"loops", &MeshFacts::loops}};

using Operand = std::function<double(const MeshFacts&)>;
using Comparison = bool (*)(double, double);

const std::map<std::string, Comparison>& Comparisons() {
  static const std::map<std::string, Comparison> kTable = {
      {"==", [](double a, double b) { return a == b; }},
      {"!=", [](double a, double b) { return a != b; }},
      {"<", [](double a, double b) { return a < b; }},
      {"<=", [](double a, double b) { return a <= b; }},
      {">", [](double a, double b) { return a > b; }},
      {">=", [](double a, double b) { return a >= b; }}};
  return kTable;
}

bool IsOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_';
}

bool IsOfComparison(char c) { return c == '=' || c == '!' || c == '<' || c == '>'; }

/// Words, numbers, comparisons, and every other character by itself, without the spaces between.
std::vector<std::string> TokensOf(const std::string& text) {
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    while (i < text.size() && IsOfWord(text[i])) ++i;
    if (i == begin) {
      while (i < text.size() && IsOfComparison(text[i])) ++i;
    }
    if (i == begin) ++i;
    std::string token = text.substr(begin, i - begin);
    if (!std::isspace(static_cast<unsigned char>(token[0]))) tokens.push_back(std::move(token));
  }
  return tokens;
}

/// Recursive descent: `or` binds least, `not` most.
class Parser {
 public:
  explicit Parser(const std::string& text) : tokens_(TokensOf(text)) {}

  StatusOr<MeshCondition> Parse() {
    MeshCondition condition = Alternatives();
    if (error_.ok() && next_ < tokens_.size()) Expect("'and' or 'or'");
    return error_.ok() ? StatusOr<MeshCondition>(std::move(condition)) : error_;
  }

 private:
  MeshCondition Alternatives() {
    MeshCondition left = Conjunction();
    while (Take("or")) {
      left = [left, right = Conjunction()](const MeshFacts& m) { return left(m) || right(m); };
    }
    return left;
  }

  MeshCondition Conjunction() {
    MeshCondition left = Negation();
    while (Take("and")) {
      left = [left, right = Negation()](const MeshFacts& m) { return left(m) && right(m); };
    }
    return left;
  }

  MeshCondition Negation() {
    if (Take("not")) return [of = Negation()](const MeshFacts& m) { return !of(m); };
    if (!Take("(")) return Compared();
    MeshCondition inside = Alternatives();
    if (!Take(")")) Expect("')'");
    return inside;
  }

  MeshCondition Compared() {
    const Operand left = ReadOperand();
    const auto found = Comparisons().find(Peek());
    if (found == Comparisons().end()) {
      Expect("one of == != < <= > >=");
      return [](const MeshFacts&) { return false; };
    }
    ++next_;
    return [left, compare = found->second, right = ReadOperand()](const MeshFacts& m) {
      return compare(left(m), right(m));
    };
  }

  Operand ReadOperand() {
    const std::string word = Peek();
    for (const Fact& fact : kFacts) {
      if (word == fact.name) {
        ++next_;
        return [value = fact.value](const MeshFacts& m) { return m.*value; };
      }
    }
    if (const std::optional<double> number = ParseNumber(word)) {
      ++next_;
      return [value = *number](const MeshFacts&) { return value; };
    }
    const std::string nearest = NearestWord(word, FactNames());
    Expect("a number or one of " + Join(FactNames()) +
           (nearest.empty() ? "" : "; did you mean '" + nearest + "'"));
    return [](const MeshFacts&) { return 0.0; };
  }

  std::string Peek() const { return next_ < tokens_.size() ? tokens_[next_] : ""; }
  bool Take(const std::string& token) { return Peek() == token && ++next_; }

  /// The first thing that is wrong; the rest is passed over.
  void Expect(const std::string& what) {
    if (error_.ok()) {
      const std::string at = Peek();
      error_ = Status::InvalidInput(fmt::format(
          "{}: expected {}", at.empty() ? "at the end of the condition" : "at '" + at + "'", what));
    }
    next_ = tokens_.size();
  }

  std::vector<std::string> tokens_;
  std::size_t next_ = 0;
  Status error_;
};

/// Of the archives' members, every archive read once; of files by their paths.
class Chooser {
 public:
  Chooser(const std::vector<MeshSpec>& meshes, const MeshCondition& condition)
      : meshes_(meshes), condition_(condition), holds_(meshes.size(), false) {}

  Status Read() {
    std::map<std::string, std::map<std::string, std::size_t>> archives;
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      const MeshSpec& mesh = meshes_[i];
      if (!mesh.archive.empty()) {
        archives[mesh.archive][mesh.member] = i;
        continue;
      }
      const StatusOr<std::string> content = ReadWholeFile(mesh.file);
      if (!content.ok()) return content.status();
      Judge(i, *content);
    }
    for (const auto& [archive, members] : archives) {
      std::set<std::string> names;
      for (const auto& [name, i] : members) names.insert(name);
      const Status status = ReadArchiveMembers(
          archive, names, [&, &of = members](const std::string& name, const std::string& content) {
            Judge(of.at(name), content);
            return Status();
          });
      if (!status.ok()) return status;
    }
    return Status();
  }

  bool holds(std::size_t i) const { return holds_[i]; }
  int num_no_surface() const { return num_no_surface_; }

 private:
  void Judge(std::size_t i, const std::string& content) {
    const StatusOr<MeshFacts> facts = FactsOf(meshes_[i], content);
    if (!facts.ok()) ++num_no_surface_;
    holds_[i] = facts.ok() && condition_(*facts);
  }

  const std::vector<MeshSpec>& meshes_;
  const MeshCondition& condition_;
  std::vector<bool> holds_;
  int num_no_surface_ = 0;
};

}  // namespace

std::vector<std::string> FactNames() {
  std::vector<std::string> names;
  for (const Fact& fact : kFacts) names.emplace_back(fact.name);
  return names;
}

StatusOr<MeshCondition> ParseMeshCondition(const std::string& text) { return Parser(text).Parse(); }

StatusOr<MeshFacts> FactsOf(const MeshSpec& mesh, const std::string& content) {
  const StatusOr<PolygonSoup> soup =
      ParseMesh(mesh.member.empty() ? mesh.file : mesh.member, content);
  if (!soup.ok()) return soup.status();
  MeshParts parts;
  if (Status status = TakeApart(*soup, mesh.repair, &parts); !status.ok()) return status;
  MeshFacts facts;
  for (const Surface* surface : parts.Surfaces()) {
    const Triangulation& t = surface->triangulation;
    const double loops = static_cast<double>(BoundaryLoops(t).size());
    facts.components += 1;
    facts.triangles += t.num_faces();
    facts.vertices += t.num_vertices;
    facts.loops += loops;
    facts.genus += (2 - loops - EulerCharacteristic(t)) / 2;
  }
  return facts;
}

StatusOr<std::vector<MeshSpec>> SelectMeshes(const std::vector<MeshSpec>& meshes,
                                             const MeshCondition& condition, int* num_no_surface) {
  Chooser chooser(meshes, condition);
  if (Status status = chooser.Read(); !status.ok()) return status;
  std::vector<MeshSpec> selected;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (chooser.holds(i)) selected.push_back(meshes[i]);
  }
  *num_no_surface = chooser.num_no_surface();
  return selected;
}

}  // namespace cirque
