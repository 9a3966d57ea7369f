// verify_map as a whole, on two meshes in one input; certificates that there is no map; targets.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glog/logging.h>
#include <nlohmann/json.hpp>

#include "cirque/io/io.h"
#include "cirque/verify/infeasibility_check.h"
#include "cirque/verify/map_check.h"
#include "cirque/verify/sphere_check.h"

#include "tests/fuzz/fuzz_target.h"

namespace cirque::testing {
namespace {

// A hexagon of equilateral triangles about vertex 1, and what is not mapped: a tetrahedron.
constexpr char kHexagon[] =
    "v 0 0 0\nv 1 0 0\nv .5 .8660254037844386 0\nv -.5 .8660254037844386 0\nv -1 0 0\n"
    "v -.5 -.8660254037844386 0\nv .5 -.8660254037844386 0\n"
    "f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 6\nf 1 6 7\nf 1 7 2\n";
constexpr char kTetrahedron[] =
    "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A number that JSON has no word for would not parse.
void CheckJson(const std::string& json) { CHECK(nlohmann::json::accept(json)) << json; }

struct Maps {
  PolygonSoup in, out;
};

/// The bytes are a letter, whose lowest bits are options, then IN and OUT as OBJ, a zero between.
constexpr char kInjective = 1, kRigid = 2, kDisk = 4, kSphere = 8;

std::optional<Maps> ReadMaps(std::string_view bytes) {
  const std::size_t zero = bytes.find('\0');
  if (zero == std::string_view::npos) return std::nullopt;
  StatusOr<PolygonSoup> in = ParseMesh("in.obj", bytes.substr(0, zero));
  StatusOr<PolygonSoup> out = ParseMesh("out.obj", bytes.substr(zero + 1));
  if (!in.ok() || !out.ok()) return std::nullopt;
  return Maps{*std::move(in), *std::move(out)};
}

void JudgePlaneMap(const Maps& maps, char flags) {
  verify::VerifyOptions options;
  options.require_injective = (flags & kInjective) != 0;
  options.seams.rigid = (flags & kRigid) != 0;
  options.unit_disk = (flags & kDisk) != 0;
  const auto report = verify::VerifyMap(maps.in, maps.out, options);
  if (!report.ok()) return CheckRefusal(report.status(), "");
  CHECK(!ToText(*report).empty());
  CheckJson(ToJson(*report));
  if (!report->valid()) return;
  CHECK(report->orientations && report->complex && report->angles);
  CHECK(report->without_uv.empty() && report->not_finite.empty());
  CHECK(std::isfinite(report->angles->smallest_angle));
}

void JudgeSphereMap(const Maps& maps) {
  const auto report = verify::VerifySphereMap(maps.in, maps.out, {});
  if (!report.ok()) return CheckRefusal(report.status(), "");
  CHECK(!ToText(*report).empty());
  CheckJson(ToJson(*report));
  if (report->valid()) CHECK_EQ(std::lround(report->degree), 1);
}

void RunVerifyMap(std::string_view bytes) {
  if (bytes.empty()) return;
  const std::optional<Maps> maps = ReadMaps(bytes.substr(1));
  if (!maps) return;
  if ((bytes.front() & kSphere) != 0) return JudgeSphereMap(*maps);
  JudgePlaneMap(*maps, bytes.front());
}

std::string Input(char options, const std::string& in, const std::string& out) {
  return std::string(1, static_cast<char>('@' + options)) + in + '\0' + out;
}

std::vector<std::string> MapSeeds() {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\n";
  const std::string uv = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  std::string hexagon_uv;
  for (int k = 0; k < 7; ++k) {
    const double angle = k * kPi / 3;
    hexagon_uv += k == 0 ? "vt 0 0\n" : fmt::format("vt {} {}\n", std::cos(angle), std::sin(angle));
  }
  const std::string faces =
      "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 1/1 4/4 5/5\nf 1/1 5/5 6/6\n"
      "f 1/1 6/6 7/7\nf 1/1 7/7 2/2\n";
  const std::string hexagon = kHexagon;
  const std::string points = hexagon.substr(0, hexagon.find('f'));
  const std::string seam = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\nvt 6 6\n";
  std::string sphere = kTetrahedron;
  for (std::size_t at = 0; (at = sphere.find('1', at)) < sphere.find('f'); at += 18) {
    sphere.replace(at, 1, "0.577350269189625765");
  }
  return {Input(0, square + "f 1 2 3\nf 1 3 4\n", square + uv + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"),
          Input(kInjective, square + "f 1 2 3 4\n", square + uv + "f 1/1 2/2 3/3 4/4\n"),
          Input(kRigid, square + "f 1 2 3\nf 1 3 4\n",
                square + seam + "f 1/1 2/2 3/3\nf 1/5 3/6 4/4\n"),
          Input(kDisk, kHexagon, points + hexagon_uv + faces),
          Input(0, kHexagon, points + hexagon_uv + faces),
          Input(kSphere, kTetrahedron, sphere)};
}

PolygonSoup Mesh(const char* text) {
  StatusOr<PolygonSoup> soup = ParseMesh("mesh.obj", text);
  CHECK(soup.ok());
  return *std::move(soup);
}

/// The hexagon's own angles, pi/3 each, are coherent for every margin up to that. So a certificate
/// that is accepted must ask for angle sums that they do not have, or leave a vertex out.
void CheckIsTrueOfHexagon(const InfeasibilityCertificate& certificate) {
  if (certificate.removed_vertex != kNone) return;
  bool asks_for_others = certificate.epsilon_over_pi > 1.0 / 3;
  for (std::size_t i = 0; i < certificate.constrained_vertex.size(); ++i) {
    const double sum = (certificate.constrained_vertex[i] == 0 ? 6 : 2) / 3.0;
    constexpr double kRounding = 1e-12;
    asks_for_others = asks_for_others || certificate.lower_over_pi[i] > sum - kRounding ||
                      certificate.upper_over_pi[i] < sum + kRounding;
    if (certificate.constrained_vertex[i] == 0 && certificate.lower_over_pi[i] == 2 &&
        certificate.upper_over_pi[i] == 2) {
      asks_for_others = false;
    }
    if (asks_for_others) return;
  }
  LOG(FATAL) << "accepted, though the hexagon's own angles are coherent";
}

void RunCertificate(std::string_view bytes) {
  const auto certificate = verify::ParseInfeasibilityCertificate(std::string(bytes));
  if (!certificate.ok()) return CheckRefusal(certificate.status(), "");
  static const PolygonSoup hexagon = Mesh(kHexagon), tetrahedron = Mesh(kTetrahedron);
  for (const PolygonSoup* mesh : {&hexagon, &tetrahedron}) {
    const auto report = verify::CheckInfeasibility(*certificate, *mesh);
    CHECK(report.ok()) << report.status().message();
    CHECK(!ToText(*report).empty());
    CheckJson(ToJson(*report));
    if (report->accepted() && mesh == &hexagon) CheckIsTrueOfHexagon(*certificate);
  }
}

std::string CertificateSeed(const std::string& multipliers, const std::string& removed) {
  return R"({"outcome": "infeasible", "infeasibility": {"epsilon_over_pi": 0.01, )" + removed +
         R"("face_multiplier": [)" + multipliers +
         R"(], "constrained_vertex": [0], "lower_over_pi": [2], "upper_over_pi": [2.5], )"
         R"("vertex_multiplier": [-1.5], "carrying_faces": [1], "carrying_vertices": [0]}})";
}

/// A file that lies in memory, for a reader that takes only paths.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view content) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
    CHECK_EQ(write(descriptor_, content.data(), content.size()),
             static_cast<ssize_t>(content.size()));
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

void RunTargets(std::string_view bytes) {
  const MemoryFile file(bytes);
  const auto targets = verify::ReadTargets(file.path(), 3);
  if (!targets.ok()) return CheckRefusal(targets.status(), file.path() + ":");
  CHECK_EQ(targets->at.size(), 3u);
  for (const auto& interval : targets->at) {
    CHECK(!interval || interval->lower_over_pi <= interval->upper_over_pi);  // no NaN either
  }
}

}  // namespace

std::vector<FuzzTarget> VerifierTargets() {
  const std::vector<std::string> obj = {"v ",
                                        "vt ",
                                        "f ",
                                        "/",
                                        "\n",
                                        std::string(1, '\0'),
                                        "nan",
                                        "inf",
                                        "1e300",
                                        "1e-320",
                                        "f 1/1 2/2 3/3\n"};
  const std::vector<std::string> json = {"\"outcome\"",
                                         "\"infeasible\"",
                                         "\"infeasibility\"",
                                         "\"epsilon_over_pi\"",
                                         "\"removed_vertex\"",
                                         "\"face_multiplier\"",
                                         "\"constrained_vertex\"",
                                         "\"lower_over_pi\"",
                                         "\"upper_over_pi\"",
                                         "\"vertex_multiplier\"",
                                         "\"carrying_faces\"",
                                         "\"carrying_vertices\"",
                                         "[",
                                         "]",
                                         "{",
                                         "}",
                                         ",",
                                         ":",
                                         "null",
                                         "1e308",
                                         "-1e-320",
                                         "4294967296",
                                         "1e999"};
  const auto of = [](std::vector<std::string> names) {
    for (std::string& name : names) name.insert(0, "framework/cirque/verify/");
    return names;
  };
  return {{"verify_map", RunVerifyMap, obj, MapSeeds(),
           of({"angle_check", "correspondence", "disk_check", "findings", "judged_mesh",
               "map_check", "mesh_match", "nearest_point", "overlap_check", "polygon_check",
               "report_", "seam_check", "sphere_", "topology", "uv_"})},
          {"certificate",
           RunCertificate,
           json,
           {CertificateSeed("0, 0, 0, 0, 0, 0", ""), CertificateSeed("1, 2, -3, 4e-300", ""),
            CertificateSeed("1, 1, 1, 1", "\"removed_vertex\": 3, ")},
           of({"certificate_file", "infeasibility_", "removed_vertex"})},
          {"targets",
           RunTargets,
           {"free", "\n", "nan", "inf", "1e400"},
           {"1\nfree\n6.25\n"},
           of({"angle_targets"})}};
}

}  // namespace cirque::testing
