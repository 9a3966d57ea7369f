// Options as texts: names with options, values, flags, and the texts that single flags hold.
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <glog/logging.h>

#include "cirque/cones/cone.h"
#include "cirque/cones/registry.h"
#include "cirque/core/option.h"
#include "cirque/domains/domain.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/metrics/measure_files.h"
#include "cirque/pipeline/options.h"

#include "experiments/circle_patterns/flags.h"
#include "experiments/circle_patterns/request.h"
#include "tests/fuzz/fuzz_target.h"

namespace cirque::testing {
namespace {

std::string Written(const NameWithOptions& parsed) {
  std::string text = parsed.name;
  char separator = ':';
  for (const auto& [key, value] : parsed.options) {
    text += separator + key + "=" + value;
    separator = ',';
  }
  return text;
}

/// Every table that takes such a text.
void RunNameWithOptions(std::string_view bytes) {
  const std::string text(bytes);
  const StatusOr<NameWithOptions> parsed = ParseNameWithOptions(text);
  if (parsed.ok()) {
    const StatusOr<NameWithOptions> again = ParseNameWithOptions(Written(*parsed));
    CHECK(again.ok()) << again.status().message();
    CHECK(again->name == parsed->name && again->options == parsed->options);
  } else {
    CheckRefusal(parsed.status(), "'" + text + "'");
  }
  for (const Status& status : {CheckConeHeuristic(text), CheckConeAngles(text)}) {
    if (!status.ok()) CheckRefusal(status, "");
  }
  const auto files = ParseMeasureFiles(text);
  if (!files.ok()) CheckRefusal(files.status(), "");
}

std::vector<std::string> LinesOf(std::string_view bytes) {
  std::istringstream stream{std::string(bytes)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Lines KEY=VALUE. What the table lets pass it writes, and reads back to the same.
template <class T>
void SetOptions(const OptionTable<T>& table, const OptionMap& map) {
  T options;
  const Status status = table.Set(map, &options);
  if (!status.ok()) return CheckRefusal(status, "");
  const Status valid = table.Validate(options);
  CHECK(valid.ok()) << valid.message();
  const OptionMap values = table.Values(options);
  T again;
  const Status repeated = table.Set(values, &again);
  CHECK(repeated.ok()) << repeated.message();
  CHECK(table.Values(again) == values);
}

void RunOptions(std::string_view bytes) {
  OptionMap map;
  for (const std::string& line : LinesOf(bytes)) {
    const std::size_t equals = std::min(line.find('='), line.size());
    map[line.substr(0, equals)] = line.substr(std::min(equals + 1, line.size()));
  }
  SetOptions(ParameterizeOptionTable(), map);
  SetOptions(DomainOptionTable(), map);
}

/// A command line, an argument a line. None of them may name a file: it would be read.
void RunFlags(std::string_view bytes) {
  std::vector<std::string> arguments = LinesOf(bytes);
  if (arguments.size() == 1) arguments.emplace_back("--");
  CirclePatternsFlags flags;
  const Status status = flags.Parse(arguments);
  if (!status.ok()) return CheckRefusal(status, "");
  const StatusOr<CirclePatternsJob> job = flags.Job();
  if (!job.ok()) return CheckRefusal(job.status(), "");
  CHECK(!job->input.empty() || !job->input_con.empty());
}

Surface Square() {
  const auto soup =
      ParseMesh("a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4\nf 2 4 5\n");
  PreflightReport report;
  StatusOr<Surface> surface = Preflight(*soup, &report);
  CHECK(surface.ok());
  return *std::move(surface);
}

/// Lists of vertices: paths to cut along, and the vertices of shapes.
void RunVertexLists(std::string_view bytes) {
  static const Surface surface = Square();
  CirclePatternsJob job;
  job.cut_paths = bytes;
  const Triangulation& t = surface.triangulation;
  const auto cut = PrescribedCut(job, t, MeasureEdgeLengths(surface), NumbersInFile(surface));
  if (!cut.ok()) CheckRefusal(cut.status(), "cut_paths");
  for (const OptionInfo& option : DomainOptionTable().Infos()) {
    if (option.unit == kVertexUnit) job.domain.shape[option.name] = bytes;
  }
  const auto request = RequestOf(job, 5, surface);
  if (!request.ok()) CheckRefusal(request.status(), "");
}

template <class T>
void AddWords(const OptionTable<T>& table, std::vector<std::string>* words) {
  for (const OptionInfo& option : table.Infos()) {
    words->push_back(option.name + "=");
    words->push_back("--" + option.name);
    words->insert(words->end(), option.words.begin(), option.words.end());
    words->insert(words->end(), option.former.begin(), option.former.end());
    if (!option.default_text.empty()) words->push_back(option.default_text);
  }
}

std::vector<std::string> Words() {
  std::vector<std::string> words = {
      ":",    ",",    "=",     "-1",     "1e9",    "nan",  "\n--", "2147483648",
      "-io=", "-oo=", "a.csv", "a.ply:", "a.json", "true", "no"};
  AddWords(ParameterizeOptionTable(), &words);
  AddWords(DomainOptionTable(), &words);
  for (const auto& names : {ConeHeuristics().Names(), Domains().Names()}) {
    words.insert(words.end(), names.begin(), names.end());
  }
  return words;
}

}  // namespace

std::vector<FuzzTarget> OptionTargets() {
  return {{"name_with_options",
           RunNameWithOptions,
           Words(),
           {"greedy:target=0.1,cones=4", "ranges:width=0.5", "mips:steps=5", "a.csv,b.ply:area"},
           {"framework/cirque/core/option.cc", "framework/cirque/cones/registry.cc"}},
          {"options",
           RunOptions,
           Words(),
           {"cones=greedy\nepsilon=0.01\nmax_iterations=7\n", "corners=1,2,3,4\nsides=5\n"},
           {"framework/cirque/core/option"}},
          {"flags",
           RunFlags,
           Words(),
           {"-io=a.obj\n-oo=b.obj\n", "-io\na.obj\n--domain=disk\n--centre=3\n--noquiet\n",
            "-ic=a.con\n-no\n-oc=b.con\n"},
           {"experiments/circle_patterns/flags", "experiments/common/flag_parsing"}},
          {"vertex_lists",
           RunVertexLists,
           {"-", ",", "1", "5", "99999999999"},
           {"2-4,3-5", "2,3"},
           {"experiments/circle_patterns/request"}}};
}

}  // namespace cirque::testing
