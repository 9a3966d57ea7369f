// Random small surfaces with random options, every outcome judged: results/random_surfaces.md.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <exception>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/text.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/verify/infeasibility_check.h"
#include "cirque/verify/map_check.h"
#include "cirque/verify/sphere_check.h"

#include "experiments/common/sphere_files.h"
#include "experiments/studies/random_requests.h"
#include "experiments/studies/small_surfaces.h"
#include "experiments/studies/studies.h"

DEFINE_int32(count, 1000, "how many surfaces");
DEFINE_int32(first, 1,
             "number of the first: it alone decides what the surface and its options are");
DEFINE_int32(patience, 30, "time [s] after which a map counts as hanging");
DEFINE_string(faults, "",
              "folder for the meshes of surfaces with faults, or of the only one; empty: nowhere");

namespace cirque {
namespace {

/// What became of a surface.
struct Verdict {
  std::string kind, domain, outcome;
  std::string flags;  ///< what was asked for
  std::string fault;  ///< what must not be; empty: nothing
};

/// Why the map is none; empty for a valid one.
std::string FaultOfMap(const PolygonSoup& soup, const Surface& surface, const MapRequest& request,
                       const SurfaceMap& map) {
  if (map.IsOnSphere()) {
    const PolygonSoup image = SphereMesh(soup, surface, map.position);
    const auto report = verify::VerifySphereMap(soup, image, {});
    if (!report.ok()) return report.status().message();
    return report->valid() ? "" : report->Verdict();
  }
  verify::VerifyOptions options;
  options.unit_disk = request.domain == "disk";
  // What keeps its orientation and has a convex image does not overlap. Polygons are given by their
  // angles, and may.
  const std::set<std::string> convex = {"disk", "half_plane", "rectangle", "triangle"};
  options.require_injective = convex.contains(request.domain);
  options.seams.rigid = request.domain == MapRequest().domain &&
                        request.options.seams == SeamKind::kRigid &&
                        map.certificate.outcome != kInaccurate;
  const auto report = verify::VerifyMap(soup, AttachUv(soup, surface, map.uv), options);
  if (!report.ok()) return report.status().message();
  return report->valid() ? "" : report->Verdict();
}

/// Why the proof is none; empty for a valid one.
std::string FaultOfProof(const PolygonSoup& soup, const Certificate& certificate) {
  const auto proof = verify::ParseInfeasibilityCertificate(certificate.ToJson());
  if (!proof.ok()) return proof.status().message();
  const auto report = verify::CheckInfeasibility(*proof, soup);
  if (!report.ok()) return report.status().message();
  return report->accepted() ? "" : report->Verdict();
}

bool AllFinite(const SurfaceMap& map) {
  const auto finite = [](const auto& point) { return point.allFinite(); };
  return std::all_of(map.position.begin(), map.position.end(), finite) &&
         std::all_of(map.uv.value.begin(), map.uv.value.end(), finite);
}

Verdict Judge(const SmallSurfaceKind& kind, const PolygonSoup& soup, Dice* dice) {
  Verdict verdict = {kind.name, "-", "refused mesh", "", ""};
  PreflightReport preflight;
  const StatusOr<Surface> surface = Preflight(soup, &preflight);
  if (!surface.ok()) return verdict;
  const MapRequest request = DrawRequest(*surface, dice);
  verdict.domain = request.domain;
  verdict.flags = FlagsOf(request);
  Certificate failed;
  const StatusOr<SurfaceMap> map = MapSurface(*surface, request, {}, &failed);
  verdict.outcome = map.ok() ? map->certificate.outcome : ToString(map.status().code());
  if (map.ok()) {
    verdict.fault = AllFinite(*map) ? FaultOfMap(soup, *surface, request, *map) : "not finite";
  } else if (map.status().message().empty()) {
    verdict.fault = "no message";
  } else if (map.status().code() == StatusCode::kInfeasible) {
    verdict.fault = FaultOfProof(soup, failed);
  }
  return verdict;
}

struct Drawn {
  const SmallSurfaceKind& kind;
  PolygonSoup soup;
  Dice dice;  ///< as the surface leaves them
};

Drawn Draw(int number) {
  Dice dice(static_cast<std::uint64_t>(number));
  const std::vector<SmallSurfaceKind>& kinds = SmallSurfaceKinds();
  const SmallSurfaceKind& kind = kinds[dice.Below(static_cast<int>(kinds.size()))];
  PolygonSoup soup = kind.make(&dice);
  return {kind, std::move(soup), dice};
}

std::string ReadAll(int descriptor) {
  std::string text;
  char block[4096];
  for (ssize_t size = 0; (size = read(descriptor, block, sizeof block)) > 0;) {
    text.append(block, static_cast<std::size_t>(size));
  }
  return text;
}

/// The child's part: a line "domain|outcome|flags|fault".
[[noreturn]] void JudgeInChild(Drawn drawn, int output) {
  std::signal(SIGALRM, SIG_DFL);
  alarm(static_cast<unsigned>(FLAGS_patience));
  std::string line;
  try {
    const Verdict verdict = Judge(drawn.kind, drawn.soup, &drawn.dice);
    line = verdict.domain + "|" + verdict.outcome + "|" + verdict.flags + "|" + verdict.fault;
  } catch (const std::exception& error) {
    line = std::string("-|exception||") + error.what();
  }
  const bool written = write(output, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  _exit(written ? 0 : 1);
}

/// In a process of its own, so that one that aborts or hangs is one verdict among others.
Verdict JudgeApart(const Drawn& drawn) {
  int ends[2] = {-1, -1};
  Verdict verdict = {drawn.kind.name, "-", "-", "", "no process"};
  if (pipe(ends) != 0) return verdict;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    JudgeInChild(drawn, ends[1]);
  }
  close(ends[1]);
  const std::string line = ReadAll(ends[0]);
  close(ends[0]);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return verdict;
  verdict.fault = "no verdict";
  if (WIFSIGNALED(status)) {
    verdict.outcome = WTERMSIG(status) == SIGALRM ? "hang" : "abort";
    verdict.fault = strsignal(WTERMSIG(status));
  }
  std::istringstream parts(line);
  if (std::string fault; std::getline(parts, verdict.domain, '|') &&
                         std::getline(parts, verdict.outcome, '|') &&
                         std::getline(parts, verdict.flags, '|')) {
    std::getline(parts, fault);
    verdict.fault = fault;
  }
  return verdict;
}

struct Fault {
  int number;
  Verdict verdict;
};

/// Counts of outcomes, a row for each value of a verdict's member.
std::string Table(const std::string& heading, const std::vector<Verdict>& verdicts,
                  std::string Verdict::*row) {
  std::map<std::string, std::map<std::string, int>> counts;
  std::map<std::string, int> faults;
  std::set<std::string> outcomes;
  for (const Verdict& verdict : verdicts) {
    ++counts[verdict.*row][verdict.outcome];
    outcomes.insert(verdict.outcome);
    if (!verdict.fault.empty()) ++faults[verdict.*row];
  }
  std::string text = "| " + heading, rule = "|---";
  for (const std::string& outcome : outcomes) {
    text += " | " + outcome;
    rule += "|--:";
  }
  text += " | faults |\n" + rule + "|--:|\n";
  for (auto& [name, of_row] : counts) {
    text += "| " + name;
    for (const std::string& outcome : outcomes) text += fmt::format(" | {}", of_row[outcome]);
    text += fmt::format(" | {} |\n", faults[name]);
  }
  return text + "\n";
}

std::string Page(const StudyCall& call, const std::vector<Verdict>& verdicts,
                 const std::vector<Fault>& faults) {
  std::string text = fmt::format(
      "# Random small surfaces\n\nMade by `{}`: {} surfaces made to be hard, with options, domains "
      "and boundaries drawn at random, each mapped in a process of its own. Every map is judged by "
      "the verifier, every proof that there is none checked exactly; *faults* are aborts, hangs, "
      "coordinates that are not finite, and maps and proofs that the verifier refuses.\n\n",
      call.command, verdicts.size());
  text += Table("surface", verdicts, &Verdict::kind) + Table("domain", verdicts, &Verdict::domain);
  for (const auto& [number, verdict] : faults) {
    text += fmt::format("* `studies random_surfaces --first={} --count=1` ({}, {}): {}: {}\n",
                        number, verdict.kind, verdict.flags, verdict.outcome, verdict.fault);
  }
  if (verdicts.size() == 1) text += fmt::format("Flags: {}\n", verdicts.front().flags);
  return text;
}

}  // namespace

Status RunRandomSurfaces(const StudyCall& call) {
  if (Status s = NoArguments(call); !s.ok()) return s;
  if (FLAGS_count < 1 || FLAGS_patience < 1) {
    return Status::InvalidInput("--count and --patience: at least 1");
  }
  std::vector<Verdict> verdicts;
  std::vector<Fault> faults;
  for (int number = FLAGS_first; number < FLAGS_first + FLAGS_count; ++number) {
    const Drawn drawn = Draw(number);
    verdicts.push_back(JudgeApart(drawn));
    const bool is_fault = !verdicts.back().fault.empty();
    if (is_fault) faults.push_back({number, verdicts.back()});
    if (FLAGS_faults.empty() || !(is_fault || FLAGS_count == 1)) continue;
    const std::string path = fmt::format("{}/surface-{}.obj", FLAGS_faults, number);
    if (Status s = WriteMesh(path, drawn.soup); !s.ok()) return s;
  }
  if (Status s = Deliver(Page(call, verdicts, faults)); !s.ok()) return s;
  if (faults.empty()) return Status();
  return {StatusCode::kNotConverged, fmt::format("{} surfaces with faults", faults.size())};
}

}  // namespace cirque
