#include "experiments/circle_patterns/flags.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "cirque/angles/registry.h"
#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/io/io.h"
#include "cirque/solver/solver_strategy.h"

#include "experiments/circle_patterns/pictures.h"
#include "experiments/common/options_file.h"

namespace cirque {
namespace {

constexpr char kStream[] = "-";
constexpr int kLongestFlag = 64;

/// "layout" of "--layout=directions".
std::string FlagIn(const std::string& word) {
  const std::string name = word.substr(word.starts_with("--") ? 2 : 1);
  return name.substr(0, name.find('='));
}

/// Of files of meshes and metrics.
std::vector<std::string> SurfaceExtensions() {
  std::vector<std::string> extensions = ReadableExtensions();
  extensions.push_back("con");
  return extensions;
}

/// Without the ending of packed files.
std::string Unpacked(const std::string& path) {
  return path.ends_with(".gz") ? path.substr(0, path.size() - 3) : path;
}

/// Whether a file is, by its name, something that can be mapped.
bool IsSurfaceFile(const std::string& path) {
  const std::vector<std::string> known = SurfaceExtensions();
  const std::string extension = MeshExtension(Unpacked(path));
  return path.starts_with("/dev/") ||
         std::find(known.begin(), known.end(), extension) != known.end();
}

/// "DIR/NAME_uv.obj" for the input "DIR/NAME.EXT".
std::string OutputFor(const CirclePatternsJob& job) {
  const std::string& input = job.input.empty() ? job.input_con : job.input;
  if (input.starts_with("/dev/")) return kStream;
  std::filesystem::path path = Unpacked(input);
  return path.replace_filename(path.stem().string() + "_uv.obj").string();
}

/// The flags that stand for what a domain reads or gives, where they are not called like it.
std::vector<std::string> FlagsFor(const std::string& member) {
  static const std::map<std::string, std::vector<std::string>> kFlags = {
      {"targets", {"iv", "angle_sums"}},
      {"cut", {"ie", "cut_paths"}},
      {"rotations", {"rotations", "meet_rotations"}},
      {"metric", {"ic", "no"}},
      {"flat", {"oc", "flip_back"}},
      {"uv", {"measures", "fill_holes", "uv", "uv_margin", "scale_pieces"}},
      {"position", {"latlong"}}};
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

/// The domains that take a flag that not every domain does.
std::vector<std::string> DomainsWith(const std::string& flag) {
  std::vector<std::string> domains;
  for (const std::string& name : Domains().Names()) {
    const std::vector<std::string> flags = FlagsOf(*Domains().Find(name));
    if (std::find(flags.begin(), flags.end(), flag) != flags.end()) domains.push_back(name);
  }
  return domains;
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
          fmt::format("--domain={} takes no --{}, which is for --domain={}; it takes {}", name,
                      flag, Join(DomainsWith(flag), "|"), Join(own)));
    }
  }
  return Status();
}

}  // namespace

CirclePatternsFlags::CirclePatternsFlags() {
  line_.Add(DomainTable(), &job_.domain);
  line_.Add(JobTable(), &job_);
  line_.Add(MeshOptionTable(), &job_.mesh);
  AddShapeFlags();
  line_.Add(ParameterizeOptionTable(), &job_.options);
  line_.Add(SettingsTable(), &settings_);
  line_.AddQuestions();
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
  if (arguments.size() == 1 && others_.size() == 1) {
    const StatusOr<bool> is_options = IsFileOfOptions(others_.front());
    if (!is_options.ok()) return is_options.status();
    if (*is_options) {
      if (Status s = ParseFile(others_.front()); !s.ok()) return s;
    }
  }
  if (!IsAsked()) TakeFiles();
  return Status();
}

/// The thesis's other way to call the program: all options in one text file. It begins with a flag,
/// which no mesh does.
StatusOr<bool> CirclePatternsFlags::IsFileOfOptions(const std::string& path) const {
  if (path == kStream) return false;
  const bool is_mesh = IsSurfaceFile(path);
  std::ifstream file(path, std::ios::binary);
  std::string word;
  if (!file || std::filesystem::is_directory(path)) {
    // Where it is named like a mesh, the reader of meshes says what is wrong with it.
    if (is_mesh) return false;
    return Status::InvalidInput(path + ": cannot read this file of options; see --help");
  }
  file >> std::setw(kLongestFlag) >> word;
  if (word.starts_with('-') && (!is_mesh || line_.Knows(FlagIn(word)))) return true;
  if (is_mesh) return false;
  return Status::InvalidInput(fmt::format(
      "{}: neither a file of options, which begins with one (-io), nor a mesh by its name ({})",
      path, Join(SurfaceExtensions())));
}

Status CirclePatternsFlags::ParseFile(const std::string& path) {
  const StatusOr<std::vector<std::string>> words = ReadOptionsFile(path);
  if (!words.ok()) return words.status();
  StatusOr<std::vector<std::string>> others = line_.Parse(*words);
  if (!others.ok()) return others.status().In(path);
  others_ = *std::move(others);
  return Status();
}

/// IN and OUT by their places, as far as flags have not named them; OUT by IN where nothing is to
/// be written at all.
void CirclePatternsFlags::TakeFiles() {
  CirclePatternsJob& job = job_;
  const auto take = [this](std::string* target) {
    *target = others_.front();
    others_.erase(others_.begin());
  };
  const bool has_input = !job.input.empty() || !job.input_con.empty();
  const bool by_place = !has_input && !others_.empty();
  if (by_place) take(MeshExtension(others_.front()) == "con" ? &job.input_con : &job.input);
  if (job.output.empty() && !others_.empty()) take(&job.output);
  if (job.input == kStream) job.input = "/dev/stdin";
  if (by_place && job.output.empty() && job.con.empty()) job.output = OutputFor(job);
  if (job.output == kStream) job.output = "/dev/stdout";
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
  if (job.input.empty() && job.input_con.empty()) {
    return refuse("no mesh is given: circle_patterns IN OUT; see --help");
  }
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
  if (!job.projective.empty() && job.options.pattern != PatternKind::kEquivalence) {
    return refuse(
        "-projective is of conformal equivalence, circle patterns have linear maps: give "
        "-pattern=equivalence too, or -exact instead");
  }
  if (AsksForExact(job) && !job.input_con.empty()) {
    return refuse(
        "-exact writes points of a surface, which a metric has none of: leave out -ic and -no");
  }
  if (!job.input_con.empty() && (!job.view.empty() || !job.picture.empty())) {
    return refuse("a metric has no surface to be shown: leave out -view and -picture");
  }
  if (!job.cut.empty() && !job.cut_paths.empty()) return refuse("give one of -ie and -cut_paths");
  if (job.meet_rotations && job.rotations.empty()) {
    return refuse("-meet_rotations is about the rotations of -rotations, which are missing");
  }
  if (job.layout_only && !job.rotations.empty()) {
    return refuse("-no lays a metric out as it is: leave out -rotations");
  }
  if (job.flip_back && job.con.empty()) {
    return refuse("-flip_back is about the metric of -oc, which is missing");
  }
  if (job.options.solve_at > 0 && (!job.input_con.empty() || !job.con.empty())) {
    return refuse(
        "-solve_at takes meshes, and has no flat metric of all faces: leave out -ic, -oc");
  }
  if (job.output.empty() && (job.input_con.empty() || job.con.empty())) {
    return refuse("no output is given: circle_patterns IN OUT; see --help");
  }
  return Status();
}

Status CirclePatternsFlags::CheckDomain() const {
  const auto is_given = [this](const std::string& flag) { return line_.IsGiven(flag); };
  if (Status s = CheckDomainFlags(job_.domain.name, is_given); !s.ok()) return s;
  const OptionMap& shape = job_.domain.shape;
  if (!job_.input_con.empty() && !shape.empty()) {
    return Status::InvalidInput("a metric has no points to be put in a place: leave out -ic or -" +
                                shape.begin()->first);
  }
  const auto symmetric = shape.find("symmetric");
  if (!job_.con.empty() && symmetric != shape.end() && symmetric->second != "false") {
    return Status::InvalidInput(
        "-symmetric solves one half, and has no flat metric of all faces: leave out -oc");
  }
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

bool CirclePatternsFlags::IsAsked() const {
  return line_.help_topic() || line_.IsGiven("version") || settings_.certificate_help;
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
  if (Status s = CheckPictures(job.view, job.picture); !s.ok()) return s;
  if (Status s = CheckOptions(job.options); !s.ok()) return s;
  return job;
}

}  // namespace cirque
