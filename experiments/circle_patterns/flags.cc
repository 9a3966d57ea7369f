#include "experiments/circle_patterns/flags.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "cirque/angles/registry.h"
#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/solver/solver_strategy.h"

namespace cirque {
namespace {

const OptionTable<ProgramSettings>& SettingsTable() {
  using S = ProgramSettings;
  static const OptionTable<S> kTable(
      "circle_patterns",
      {Option<S>("measures", &S::measures,
                 "files of distortion measures, a comma between: .csv (per face), .json (per map), "
                 ".ply or .ply:MEASURE (colours)")
           .About("Output"),
       Option<S>("threads", &S::threads,
                 "most threads of loops over faces and edges; 0: as CIRQUE_NUM_THREADS says, else "
                 "all cores")
           .Between(0, 1e6)
           .About("Program"),
       Option<S>("certificate_help", &S::certificate_help,
                 "writes the reference of certificates, in Markdown")
           .About("Program"),
       Option<S>("help", &S::help, "this text").About("Program")});
  return kTable;
}

const OptionTable<CirclePatternsJob>& InputTable() {
  using J = CirclePatternsJob;
  static const OptionTable<J> kTable("circle_patterns", [] {
    std::vector<Option<J>> rows = {
        {"io", &J::input, "mesh: .obj, .off, .ply or .stl"},
        {"ic", &J::input_con, ".con: an intrinsic metric, instead of -io"},
        {"no", &J::layout_only,
         "no optimisation: cut and lay out the metric of -ic, which is flat already"},
        {"iv", &J::cones, "cone file: 'vertex min max' a line, angle sums in multiples of pi"},
        {"angle_sums", &J::angle_sums,
         "file of one target angle sum in radians per vertex, instead of -iv"},
        {"ie", &J::cut, "edge-cut file: 'from to face' a line; without it a short cut is found"},
        {"cut_paths", &J::cut_paths,
         "'a-b,c-d': open shortest paths between these vertices, counted from 1, instead of -ie"},
        {"fill_holes", &J::fill_holes,
         "close all boundary loops but the longest for the solve; the fill is not written"}};
    for (Option<J>& row : rows) row = std::move(row).About("Input");
    return rows;
  }());
  return kTable;
}

const OptionTable<CirclePatternsJob>& OutputTable() {
  using J = CirclePatternsJob;
  static const OptionTable<J> kTable("circle_patterns", [] {
    std::vector<Option<J>> rows = {
        {"oo", &J::output, ".obj, with the map as texture coordinates; of the sphere also .ply"},
        {"oc", &J::con, ".con: the flat metric on the triangulation where it was solved"},
        {"flip_back", &J::flip_back, "-oc after undoing every flip that the flat metric allows"},
        {"certificate", &J::certificate,
         "file for the certificate; empty: OUTPUT.certificate.json"},
        {"latlong", &J::latlong, "sphere: .obj with latitude and longitude as texture"}};
    for (Option<J>& row : rows) row = std::move(row).About("Output");
    return rows;
  }());
  return kTable;
}

const OptionTable<DomainRequest>& DomainTable() {
  static const OptionTable<DomainRequest> kTable(
      "circle_patterns",
      {Option<DomainRequest>("domain", &DomainRequest::name,
                             "shape to map onto; its vertices are counted from 1")
           .Checked([](const std::string& name) { return Domains().Find(name).status(); })
           .OneOf(Domains().Names())
           .About("Domain")});
  return kTable;
}

/// The flags that stand for what a domain reads or gives, where they are not called like it.
std::vector<std::string> FlagsFor(const std::string& member) {
  static const std::map<std::string, std::vector<std::string>> kFlags = {
      {"targets", {"iv", "angle_sums"}},  {"cut", {"ie", "cut_paths"}},
      {"metric", {"ic", "no"}},           {"flat", {"oc", "flip_back"}},
      {"uv", {"measures", "fill_holes"}}, {"position", {"latlong"}}};
  const auto found = kFlags.find(member);
  return found == kFlags.end() ? std::vector<std::string>{member} : found->second;
}

/// The flags that the domain takes and not every domain does.
std::vector<std::string> FlagsOf(const Domain& domain) {
  std::vector<std::string> flags;
  for (const auto* members : {&domain.reads, &domain.gives}) {
    for (const std::string& member : *members) {
      for (const std::string& flag : FlagsFor(member)) flags.push_back(flag);
    }
  }
  return flags;
}

/// Refuses an unknown domain, and flags that are given and that this domain does not read.
Status CheckDomainFlags(const std::string& name,
                        const std::function<bool(const std::string&)>& is_given) {
  const StatusOr<Domain> domain = Domains().Find(name);
  if (!domain.ok()) return domain.status();
  const std::vector<std::string> own = FlagsOf(*domain);
  for (const std::string& other : Domains().Names()) {
    for (const std::string& flag : FlagsOf(*Domains().Find(other))) {
      if (!is_given(flag) || std::find(own.begin(), own.end(), flag) != own.end()) continue;
      return Status::InvalidInput(
          fmt::format("--domain={} takes no --{}; it takes {}", name, flag, Join(own)));
    }
  }
  return Status();
}

}  // namespace

CirclePatternsFlags::CirclePatternsFlags() {
  line_.Add(InputTable(), &job_);
  line_.Add(OutputTable(), &job_);
  line_.Add(DomainTable(), &job_.domain);
  AddShapeFlags();
  line_.Add(ParameterizeOptionTable(), &job_.options);
  line_.Add(SettingsTable(), &settings_);
}

/// Kept as texts: which vertices they name turns out when the mesh is there.
void CirclePatternsFlags::AddShapeFlags() {
  for (const Option<DomainOptions>& option : DomainOptionTable().options()) {
    const OptionInfo& info = option.info();
    const bool is_vertex = info.unit == kVertexUnit;
    OptionInfo in_help = info;
    if (is_vertex) in_help.default_text.clear();
    line_.Add({std::move(in_help), [this, &info, is_vertex](const std::string& text) {
                 job_.domain.shape[info.name] = text;
                 if (is_vertex) return Status();
                 OptionInfo as_flag = info;
                 as_flag.name = "--" + as_flag.name;
                 return ParseValue(as_flag, text).status();
               }});
  }
}

Status CirclePatternsFlags::Parse(const std::vector<std::string>& arguments) {
  StatusOr<std::vector<std::string>> others = line_.Parse(arguments);
  if (!others.ok()) return others.status();
  others_ = *std::move(others);
  if (arguments.size() != 1 || others_.size() != 1) return Status();
  // The thesis's other way to call the program: all options in one text file.
  const std::string path = others_.front();
  std::ifstream file(path);
  if (!file) return Status::InvalidInput(path + ": cannot read this file of options; see --help");
  std::vector<std::string> words;
  for (std::string word; file >> word;) words.push_back(word);
  others = line_.Parse(words);
  if (!others.ok()) return others.status().In(path);
  others_ = *std::move(others);
  return Status();
}

Status CirclePatternsFlags::CheckFiles() const {
  const auto refuse = [](const std::string& why) { return Status::InvalidInput(why); };
  const CirclePatternsJob& job = job_;
  const ParameterizeOptions plain;
  const bool by_file = !job.cones.empty() || !job.angle_sums.empty();
  const std::string& refine_map = job.options.refine_map;
  const bool as_it_is =
      (refine_map == plain.refine_map || refine_map == "none") && job.options.seams == plain.seams;
  if (!others_.empty()) {
    return refuse("unexpected argument '" + others_.front() + "'; see --help");
  }
  if (job.input.empty() && job.input_con.empty()) return refuse("-io IN is missing; see --help");
  if (!job.input.empty() && !job.input_con.empty()) return refuse("give one of -io and -ic");
  if (!job.options.cones.empty() && by_file) {
    return refuse("give the cones by -cones or by a file (-iv, -angle_sums), not both");
  }
  if (job.layout_only && job.input_con.empty()) {
    return refuse("-no lays out a flat metric: name it with -ic");
  }
  if (job.layout_only && !as_it_is) {
    return refuse("-no lays out the metric as it is: leave out -refine_map and -seams");
  }
  if (!job.cut.empty() && !job.cut_paths.empty()) return refuse("give one of -ie and -cut_paths");
  if (job.flip_back && job.con.empty()) {
    return refuse("-flip_back is about the metric of -oc, which is missing");
  }
  if (job.output.empty() && (job.input_con.empty() || job.con.empty())) {
    return refuse("-oo OUT is missing; see --help");
  }
  return Status();
}

Status CirclePatternsFlags::CheckDomain() const {
  const auto is_given = [this](const std::string& flag) { return line_.IsGiven(flag); };
  if (Status s = CheckDomainFlags(job_.domain.name, is_given); !s.ok()) return s;
  if (is_given("corners") && is_given("sides")) {
    return Status::InvalidInput("give --corners or --sides, not both");
  }
  const bool by_file = is_given("iv") || is_given("angle_sums");
  if (job_.domain.name == "polygon" && by_file && (is_given("corners") || is_given("sides"))) {
    return Status::InvalidInput(
        "the file of angle sums names the polygon's corners; leave out --corners and --sides");
  }
  return Status();
}

/// A config may name solvers that this build lacks; a command line that does is told at once.
Status CirclePatternsFlags::CheckSolvers() const {
  const Status radii = MakeSolverStrategy(job_.options.radii_solver).status();
  if (!radii.ok()) return radii.In("--radii_solver");
  return MakeAngleSolver(job_.options.angle_solver).status().In("--angle_solver");
}

StatusOr<CirclePatternsJob> CirclePatternsFlags::Job() const {
  for (const auto check : {&CirclePatternsFlags::CheckFiles, &CirclePatternsFlags::CheckDomain,
                           &CirclePatternsFlags::CheckSolvers}) {
    if (Status s = (this->*check)(); !s.ok()) return s;
  }
  StatusOr<std::vector<MeasureFile>> measures = ParseMeasureFiles(settings_.measures);
  if (!measures.ok()) return measures.status().In("--measures");
  CirclePatternsJob job = job_;
  job.measures = *std::move(measures);
  if (Status s = CheckOptions(job.options); !s.ok()) return s;
  return job;
}

}  // namespace cirque
