// The page of experiment_report: what is on it, and the maps packed into it.
#include <zlib.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/io/png.h"

#include "experiments/common/map_view/map_payload.h"
#include "experiments/common/map_view/sha256.h"
#include "experiments/common/map_view/uv_map.h"
#include "experiments/experiment_report/figures.h"
#include "experiments/experiment_report/page.h"
#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque::experiment_report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string Decode(const std::string& base64) {
  static const std::string kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int held = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(kDigits.find(c));
    held += 6;
    if (held >= 8) bytes.push_back(static_cast<char>(bits >> (held -= 8) & 0xff));
  }
  return bytes;
}

std::string Inflate(const std::string& deflated, std::size_t size) {
  std::string bytes(size, '\0');
  uLongf length = size;
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                       reinterpret_cast<const Bytef*>(deflated.data()), deflated.size()),
            Z_OK);
  bytes.resize(length);
  return bytes;
}

/// The next `count` numbers of `planes` bytes, as the header of byte_stream.h says they are kept.
std::vector<std::uint32_t> Take(const std::string& bytes, std::size_t count, int planes,
                                std::size_t* at) {
  std::vector<std::uint32_t> values;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t code = 0;
    for (int plane = 0; plane < planes; ++plane) {
      code |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[*at + plane * count + i]))
              << (8 * plane);
    }
    value += code % 2 == 0 ? code / 2 : ~(code / 2);
    if (planes == 2) value &= 0xffff;
    values.push_back(value);
  }
  *at += count * planes;
  return values;
}

TEST(ByteStream, RoundTrip) {
  const std::vector<std::uint16_t> shorts = {0, 65535, 0, 32768, 1, 32767, 65535, 65534};
  const std::vector<std::uint32_t> words = {7, 0, 4294967295u, 2147483648u, 1, 70000};
  ByteStream stream;
  stream.AddShorts(shorts);
  stream.AddWords(words);
  const std::string bytes = Inflate(Decode(Base64(Deflate(stream.bytes()))), 1000);
  ASSERT_EQ(bytes.size(), 2 * shorts.size() + 4 * words.size());
  std::size_t at = 0;
  EXPECT_EQ(Take(bytes, shorts.size(), 2, &at),
            std::vector<std::uint32_t>(shorts.begin(), shorts.end()));
  EXPECT_EQ(Take(bytes, words.size(), 4, &at), words);
}

TEST(ByteStream, QuantizingIsNearestAndClamps) {
  EXPECT_THAT(Quantize({-1, 0, 1.0 / 65535, 0.5, 1, 2, std::nan("")}, 0, 1),
              ElementsAre(0, 0, 1, 32768, 65535, 65535, 0));
  EXPECT_THAT(Quantize({3, 3}, 3, 3), ElementsAre(0, 0));
}

TEST(ByteStream, Base64OfKnownTexts) {  // RFC 4648, section 10
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
}

UvMap Pyramid(double apex_angle) {
  const TemporaryFolder folder;
  auto map = ReadUvMap(folder.Write("map.obj", PyramidObj(apex_angle)));
  EXPECT_TRUE(map.ok()) << map.status().message();
  return *std::move(map);
}

TEST(UvMap, SeamAndConeOfACutPyramid) {
  const UvMap map = Pyramid(5);
  EXPECT_EQ(map.point_uv.size(), 6u);  // the base corner at the seam has two
  EXPECT_EQ(map.seams.size(), 2u);     // both sides of one edge
  EXPECT_EQ(map.boundary.size(), 4u);
  ASSERT_EQ(map.cones.size(), 1u);
  EXPECT_EQ(map.cones[0].first, 0);
  EXPECT_NEAR(map.cones[0].second, 5, 1e-12);
}

TEST(UvMap, WithoutConeThereIsNone) { EXPECT_TRUE(Pyramid(2 * kPi - 1e-5).cones.empty()); }

TEST(MapPayload, PositionsAndCornersComeBack) {
  const UvMap map = Pyramid(5);
  const nlohmann::json payload = MapPayload(map);
  const std::string bytes = Inflate(Decode(payload["data"]), 10000);
  std::size_t at = 0;
  std::vector<std::vector<double>> place;
  for (int k = 0; k < 5; ++k) {
    const double low = payload["boxes"][k][0], high = payload["boxes"][k][1];
    place.emplace_back();
    for (const std::uint32_t step : Take(bytes, k < 3 ? 5 : 6, 2, &at)) {
      place.back().push_back(low + step / 65535.0 * (high - low));
    }
  }
  // The pyramid lies flat without distortion: ratio 1 and logarithm 0, the scales' ends and
  // middles.
  EXPECT_THAT(Take(bytes, 4, 2, &at), testing::Each(0));
  EXPECT_THAT(Take(bytes, 4, 2, &at), testing::Each(testing::AnyOf(32767, 32768)));
  const std::vector<std::uint32_t> vertex = Take(bytes, 6, 4, &at), point = Take(bytes, 12, 4, &at);
  for (Index h = 0; h < 12; ++h) {
    const Eigen::Vector3d& p = map.surface.position[map.surface.triangulation.vertex[h]];
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(place[k][vertex[point[h]]], p[k], 2e-5);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(place[3 + k][point[h]], map.uv.value[h][k], 2e-5);
  }
  EXPECT_EQ(Take(bytes, 2, 4, &at).size() + Take(bytes, 4, 4, &at).size(), 6u);
  EXPECT_EQ(at, bytes.size());
}

TEST(MapPayload, EightMapsOfFiftyThousandTrianglesFitInFifteenMegabytes) {
  UvMap map;
  map.surface = GeneratedSurface("bumpy_terrain", 50000);
  const Triangulation& mesh = map.surface.triangulation;
  for (Index h = 0; h < mesh.num_halfedges(); ++h) {
    map.uv.value.push_back(map.surface.position[mesh.vertex[h]].head<2>());
  }
  map.point = mesh.vertex;
  for (Index v = 0; v < mesh.num_vertices; ++v) {
    map.point_vertex.push_back(v);
    map.point_uv.push_back(map.surface.position[v].head<2>());
  }
  const std::string data = MapPayload(map)["data"];
  EXPECT_GT(mesh.num_faces(), 49000);
  EXPECT_GT(data.size(), 100000u);
  EXPECT_LT(data.size(), 15000000u / 8);
}

TEST(ReportPage, NamesAndMessagesAreEscaped) {
  nlohmann::json record = ReportRecord("<script>alert(1)</script>", "\"><img src=x>", 1);
  nlohmann::json failed = ReportRecord("b</table>", "m", 1);
  failed["outcome"] = "not_converged";
  failed["message"] = "gradient < 1 & more";
  failed["provenance"]["question"] = "Is 1 < 2?";
  const std::string html = ReportHtml("<b>title", ResultsOf({record, failed}), ShownMaps());
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, Not(HasSubstr("<img")));
  EXPECT_THAT(html, Not(HasSubstr("<b>title")));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt;"));
  EXPECT_THAT(html, HasSubstr("gradient &lt; 1 &amp; more"));
  EXPECT_THAT(html, HasSubstr("Is 1 &lt; 2?"));
}

TEST(Sha256, KnownDigests) {  // FIPS 180-4, and of many blocks
  const auto hex = [](const std::string& text) {
    std::string digits;
    for (const std::uint8_t byte : Sha256(text)) digits += fmt::format("{:02x}", byte);
    return digits;
  };
  EXPECT_EQ(hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hex(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// Every script that the page holds is one that its policy lets run, and only these.
TEST(ReportPage, ItsPolicyNamesItsScriptsAndNothingElse) {
  const std::string html = ReportHtml("t", ResultsOf({ReportRecord("a", "m", 1)}), {});
  const std::size_t begin = html.find("script-src ") + 11;
  const std::string allowed = html.substr(begin, html.find(';', begin) - begin);
  EXPECT_THAT(allowed, Not(HasSubstr("unsafe")));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  int scripts = 0;
  for (std::size_t at = 0; (at = html.find("<script", at)) != std::string::npos; ++at) {
    const std::size_t text = html.find('>', at) + 1;
    if (html.substr(at, text - at).find("application/json") != std::string::npos) continue;
    const auto digest = Sha256(html.substr(text, html.find("</script>", text) - text));
    EXPECT_THAT(allowed, HasSubstr("'sha256-" + Base64({digest.begin(), digest.end()}) + "'"));
    ++scripts;
  }
  EXPECT_GE(scripts, 2);
  EXPECT_EQ(std::count(allowed.begin(), allowed.end(), '-'), scripts);
}

TEST(ReportPage, ExpectedFailuresStandApartFromFaults) {
  std::vector<nlohmann::json> records;
  for (const std::string outcome : {"crash", "infeasible", "time_limit", "never heard of"}) {
    records.push_back(ReportRecord(outcome + " mesh", "m", 1));
    records.back()["outcome"] = outcome;
  }
  const std::string html = FailuresHtml(ResultsOf(records).runs);
  const std::size_t expected = html.find("<h3>Expected"), limits = html.find("<h3>Limits"),
                    faults = html.find("<h3>Faults");
  ASSERT_TRUE(expected < limits && limits < faults && faults != std::string::npos) << html;
  const std::pair<const char*, std::pair<std::size_t, std::size_t>> places[] = {
      {"infeasible mesh", {expected, limits}},
      {"time_limit mesh", {limits, faults}},
      {"crash mesh", {faults, html.size()}},
      {"never heard of mesh", {faults, html.size()}}};
  for (const auto& [mesh, between] : places) {
    EXPECT_GT(html.find(mesh), between.first) << mesh;
    EXPECT_LT(html.find(mesh), between.second) << mesh;
  }
}

// A point of a chart leads to its map where the page shows that, else to its row of the table.
TEST(ReportPage, PointsLeadToTheirRuns) {
  Results results = ResultsOf({ReportRecord("a", "m", 1), ReportRecord("b", "m", 2)});
  ShownMaps maps;
  maps.keys = {results.runs[1].key};
  LinkRuns(maps, &results.runs);
  const std::string html = FiguresHtml(results.runs);
  EXPECT_THAT(html, HasSubstr("href=\"#run-" + results.runs[0].key + "\""));
  EXPECT_THAT(html, HasSubstr("href=\"#map-" + results.runs[1].key + "\""));
  EXPECT_THAT(RunsHtml(results.runs, maps.keys),
              HasSubstr("<tr id=\"run-" + results.runs[0].key + "\">"));
}

TEST(ReportPage, NeedsNoOtherFile) {
  const std::string html = ReportHtml("t", ResultsOf({ReportRecord("a", "m", 1)}), ShownMaps());
  for (const std::string outside : {"http://", "https://", "<script src", "@import", "url("}) {
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  }
}

TEST(ReportPage, MapsThatDoNotFitOrCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  folder.Write("maps/a.obj", PyramidObj(5));
  nlohmann::json kept = ReportRecord("a", "m", 1), lost = ReportRecord("b", "m", 1);
  kept["map"] = "maps/a.obj";
  lost["map"] = "maps/b.obj";
  const Results results = ResultsOf({kept, lost});
  const ShownMaps maps = CollectMaps(folder.path(), results.runs, 1000000);
  EXPECT_THAT(maps.keys, ElementsAre("a-m"));
  EXPECT_THAT(maps.left_out, ElementsAre(HasSubstr("b.obj")));
  EXPECT_THAT(ReportHtml("t", results, maps), HasSubstr("href=\"#map-a-m\""));
  EXPECT_THAT(CollectMaps(folder.path(), results.runs, 10).left_out,
              ElementsAre(HasSubstr("lack of room: 2 more")));
}

TEST(ExperimentReport, WritesPageAndTablesOrSaysWhyNot) {
  const TemporaryFolder folder;
  const ProgramResult empty = RunProgram("experiment_report " + folder.path());
  EXPECT_EQ(empty.exit_status, 2);
  EXPECT_THAT(empty.output, HasSubstr("holds no results.jsonl"));
  folder.Write("results.jsonl", JsonLines({ReportRecord("a", "m", 1)}) + "{\"torn");
  const ProgramResult written = RunProgram("experiment_report " + folder.path());
  EXPECT_EQ(written.exit_status, 0) << written.output;
  EXPECT_THAT(written.output, HasSubstr(folder.Path("report.html")));
  EXPECT_THAT(folder.Read("report.html"), HasSubstr("1 unreadable line was passed over"));
  EXPECT_EQ(nlohmann::json::parse(folder.Read("report.json")).size(), 1u);
  EXPECT_THAT(folder.Read("convergence.csv"), HasSubstr("a-m,a,m,radii,newton,2,1e-09"));
}

}  // namespace
}  // namespace cirque::experiment_report
