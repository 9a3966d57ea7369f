#include "experiments/run_experiment/config/yaml_document.h"

#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

namespace cirque {
namespace {

constexpr std::size_t kMostBytes = 1 << 20;  // yaml-cpp takes hundreds of times as much
constexpr std::size_t kMostLevels = 20;      // a config has four
constexpr double kMostValues = 1e6;

/// What a config must not be, and where it is that.
struct Refusal {
  YAML::Mark mark;
  std::string why;
};

/// Walks through the documents of a text before anything is built of them, and throws a Refusal
/// where there is more than a config can mean.
class DocumentCheck final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override {
    if (num_documents_++ > 0) Refuse(mark, "the file must hold one YAML document, without '---'");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { Count(mark, anchor, 1); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto meant = values_of_.find(anchor);
    if (meant == values_of_.end()) Refuse(mark, "an alias inside of what it stands for");
    Count(mark, YAML::NullAnchor, meant->second);
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string&) override {
    Count(mark, anchor, 1);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    Enter(mark, anchor);
  }
  void OnSequenceEnd() override { Leave(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    Enter(mark, anchor);
  }
  void OnMapEnd() override { Leave(); }

 private:
  /// A list or map that is being read, with all that is in it so far.
  struct Level {
    YAML::Mark mark;
    YAML::anchor_t anchor;
    double values;
  };

  [[noreturn]] static void Refuse(const YAML::Mark& mark, const std::string& why) {
    throw Refusal{mark, why};
  }

  void Count(const YAML::Mark& mark, YAML::anchor_t anchor, double values) {
    if (anchor != YAML::NullAnchor) values_of_[anchor] = values;
    if (open_.empty()) return;
    open_.back().values += values;
    if (open_.back().values > kMostValues) {
      Refuse(mark, fmt::format("more than {} values; is an alias used too often?", kMostValues));
    }
  }

  void Enter(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (open_.size() == kMostLevels) {
      Refuse(mark, fmt::format("lists and maps nested deeper than {} levels", kMostLevels));
    }
    open_.push_back({mark, anchor, 1});
  }

  void Leave() {
    const Level level = open_.back();
    open_.pop_back();
    Count(level.mark, level.anchor, level.values);
  }

  int num_documents_ = 0;
  std::vector<Level> open_;
  std::map<YAML::anchor_t, double> values_of_;  ///< of what is read already, aliases written out
};

/// What to do about the two slips that the parser's words do not name.
std::string Advice(const std::string& text, const YAML::Mark& mark) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i <= mark.line && std::getline(lines, line);) ++i;
  if (line.substr(0, line.find_first_not_of(" \t")).find('\t') != std::string::npos) {
    return "; the line begins with a tab, and YAML indents by spaces";
  }
  const std::size_t first = line.find(": ");
  if (first != std::string::npos && line.find(": ", first + 2) != std::string::npos) {
    return "; a value with ': ' in it stands in quotes";
  }
  return "";
}

}  // namespace

std::optional<YAML::Node> ParseYaml(const std::string& text, Diagnostics* problems) {
  if (text.size() > kMostBytes) {
    problems->Add(
        {}, fmt::format("the file has {} bytes, a config at most {}", text.size(), kMostBytes));
    return std::nullopt;
  }
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    DocumentCheck check;
    while (parser.HandleNextDocument(check)) continue;
    const YAML::Node document = YAML::Load(text);
    if (!document.IsNull()) return document;
    problems->Add({}, "the file is empty; see --help_config");
  } catch (const Refusal& refusal) {
    problems->Add(PlaceOf(refusal.mark), refusal.why);
  } catch (const YAML::Exception& error) {
    problems->Add(PlaceOf(error.mark), "not valid YAML: " + error.msg + Advice(text, error.mark));
  }
  return std::nullopt;
}

}  // namespace cirque
