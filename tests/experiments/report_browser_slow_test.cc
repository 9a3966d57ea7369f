// Pages and models in a browser: they are drawn, sorted, and nothing is complained of.
#include <cstdint>
#include <cstdlib>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque {
namespace {

using testing::HasSubstr;
using testing::Not;

// Waits for the maps to be drawn, compares either canvas with its background, looks whether
// turning, zooming, flattening, colours and wires change the picture, sorts the table by time, and
// writes what it found into the page for --dump-dom.
constexpr char kProbe[] = R"(<script type="module">
const found = [];
const byId = (id) => document.getElementById(id);
const pixels = (canvas) => {
  const gl = canvas.getContext("webgl2"), data = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return data;
};
const differing = (one, other) => {
  let number = 0;
  for (let i = 0; i < one.length; i += 4) {
    number += one[i] !== other(i) || one[i + 1] !== other(i + 1) || one[i + 2] !== other(i + 2);
  }
  return number / (one.length / 4);
};
const wait = (ready) => new Promise((done) => {
  const look = () => (ready() ? done() : setTimeout(look, 1));
  look();
});
const act = async (name, how) => {
  const before = pixels(byId("surface"));
  how();
  await new Promise((done) => setTimeout(done, 100));
  const after = pixels(byId("surface"));
  found.push(name + (differing(before, (i) => after[i]) > 1e-3 ? " changes" : " does nothing"));
};
const set = (id, value) => () => {
  byId(id).value = value;
  byId(id).dispatchEvent(new Event("input"));
};
await wait(() => [...document.querySelectorAll("canvas")].every((c) => c.dataset.faces > 0));
for (const canvas of document.querySelectorAll("canvas")) {
  const data = pixels(canvas);
  found.push(`${canvas.id} ${differing(data, (i) => data[i % 4]) > 0.01 ? "drawn" : "blank"}`);
}
await act("turn", () => byId("surface").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" })));
await act("wire", () => byId("wire").click());
await act("zoom", () => byId("surface").dispatchEvent(new WheelEvent("wheel", { deltaY: 300 })));
await act("colours", set("shading", 1));
await act("flat", set("morph", 1));
const heads = [...document.querySelectorAll("#runs th")];
const time = heads.findIndex((head) => head.textContent.startsWith("time"));
for (const direction of ["up", "down"]) {
  heads[time].querySelector("button").click();
  const rows = [...document.querySelectorAll("#runs tbody tr")];
  found.push(direction + " " + rows.map((row) => row.cells[0].textContent).join(""));
}
const report = document.createElement("pre");
report.textContent = ["PROBE", found.join("; "), "END"].join(" ");
document.body.append(report);
</script></body>)";

// The browser's virtual time runs ahead of its screen, which then never asks for a frame.
constexpr char kFrames[] =
    "<script>window.requestAnimationFrame = (paint) => setTimeout(paint, 1);</script></head>";

// The map that is chosen and drawn when the page opens, whether the page has gone to it, and the
// link after another one has been chosen.
constexpr char kLinkProbe[] = R"(<script type="module">
const byId = (id) => document.getElementById(id);
const wait = (ready) => new Promise((done) => {
  const look = () => (ready() ? done() : setTimeout(look, 1));
  look();
});
await wait(() => byId("surface").dataset.faces > 0 && byId("facts").textContent !== "");
const choose = byId("choose"), found = [choose.selectedOptions[0].textContent];
found.push(Math.abs(byId("maps").getBoundingClientRect().top) < innerHeight ? "in sight" : "away");
choose.value = 0;
choose.dispatchEvent(new Event("change"));
found.push(location.hash);
const report = document.createElement("pre");
report.textContent = ["PROBE", found.join("; "), "END"].join(" ");
document.body.append(report);
</script></body>)";

// Of a page with one map: both canvases drawn, turned (the image turns on the sphere only).
constexpr char kViewProbe[] = R"(<script type="module">
const byId = (id) => document.getElementById(id);
const pixels = (canvas) => {
  const gl = canvas.getContext("webgl2"), data = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  return data;
};
const wait = (ready) => new Promise((done) => {
  const look = () => (ready() ? done() : setTimeout(look, 1));
  look();
});
await wait(() => [...document.querySelectorAll("canvas")].every((c) => c.dataset.faces > 0));
const found = [byId("choose").parentElement.style.display];
for (const canvas of document.querySelectorAll("canvas")) {
  const before = pixels(canvas), corner = before.slice(0, 4);
  found.push(`${canvas.id} ${before.some((c, i) => c !== corner[i % 4]) ? "drawn" : "blank"}`);
  let red = 0;
  for (let i = 0; i < before.length; i += 4) red += before[i] === 217 && before[i + 1] < 40;
  found.push(red > 20 ? "flipped" : "right");
}
found.push(byId("caption").textContent.split(":")[0]);
const report = document.createElement("pre");
report.textContent = ["PROBE", found.join("; "), "END"].join(" ");
document.body.append(report);
</script></body>)";

/// Prints the DOM after the page has run, and the browser's log.
ProgramResult Browse(const std::string& page, const std::string& profile) {
  return RunShell(
      "timeout 60 chromium --headless --no-sandbox --use-angle=swiftshader "
      "--enable-unsafe-swiftshader --disable-dev-shm-usage --user-data-dir=" +
      profile + " --enable-logging=stderr --virtual-time-budget=600000 --dump-dom file://" + page);
}

constexpr char kNoChromium[] = "chromium is not installed (Debian: apt-get install chromium)";

bool HasChromium() { return std::system("command -v chromium > /dev/null") == 0; }

/// The page with the probe's scripts in it, which its policy would not let run.
std::string WriteProbed(const TemporaryFolder& folder, std::string html, const std::string& probe) {
  const std::size_t policy = html.find("<meta http-equiv=");
  html.erase(policy, html.find('\n', policy) - policy);
  html.replace(html.find("</head>"), 7, kFrames);
  html.replace(html.rfind("</body>"), 7, probe);
  return folder.Write("probed.html", html);
}

/// The report of that folder with the probe in it.
std::string WriteProbed(const TemporaryFolder& folder, const std::string& probe) {
  EXPECT_EQ(RunProgram("experiment_report " + folder.path()).exit_status, 0);
  return WriteProbed(folder, folder.Read("report.html"), probe);
}

/// What the probe wrote; the DOM's beginning where it wrote nothing.
std::string Found(const std::string& dom) {
  std::smatch found;
  return std::regex_search(dom, found, std::regex("PROBE ([^<]*) END")) ? found[1].str()
                                                                        : dom.substr(0, 3000);
}

// Sorted by number, not by text; a run without a time stays last.
TEST(ReportInBrowserSlow, DrawsSortsAndHasNoErrors) {
  if (!HasChromium()) GTEST_SKIP() << kNoChromium;
  const TemporaryFolder folder;
  folder.Write("maps/a.obj", PyramidObj(5));
  nlohmann::json a = ReportRecord("a", "m", 10), b = ReportRecord("b", "m", 9);
  nlohmann::json c = ReportRecord("c", "m", 100), d = ReportRecord("d", "m", 0);
  a["map"] = "maps/a.obj";
  d["outcome"] = "timeout";
  d["seconds"] = nlohmann::json::object();
  folder.Write("results.jsonl", JsonLines({a, b, c, d}));
  const std::string page = WriteProbed(folder, kProbe);
  const std::string dom = Browse(page, folder.Path("profile")).output;
  EXPECT_EQ(Found(dom),
            "surface drawn; image drawn; turn changes; wire changes; zoom changes; "
            "colours changes; flat changes; up bacd; down cabd");
  EXPECT_THAT(dom, Not(HasSubstr("CONSOLE")));
}

/// A report of two maps and a run without one.
void WriteTwoMaps(const TemporaryFolder& folder) {
  nlohmann::json a = ReportRecord("a", "m", 1), b = ReportRecord("b", "m", 2);
  folder.Write("maps/a.obj", PyramidObj(5));
  folder.Write("maps/b.obj", PyramidObj(4));
  a["map"] = "maps/a.obj";
  b["map"] = "maps/b.obj";
  folder.Write("results.jsonl", JsonLines({a, b, ReportRecord("c", "m", 3)}));
}

// The page as it is written: its policy lets its own scripts run, and no other.
TEST(ReportInBrowserSlow, ThePolicyLetsItsOwnScriptsRunAndNoOther) {
  if (!HasChromium()) GTEST_SKIP() << kNoChromium;
  const TemporaryFolder folder;
  WriteTwoMaps(folder);
  EXPECT_EQ(RunProgram("experiment_report " + folder.path()).exit_status, 0);
  std::string html = folder.Read("report.html");
  const std::string own = Browse(folder.Path("report.html"), folder.Path("profile")).output;
  EXPECT_THAT(own, Not(HasSubstr("CONSOLE")));
  EXPECT_THAT(own, HasSubstr("a - m</option>"));  // made by a script
  html.replace(html.rfind("</body>"), 7, "<script>document.title = 'alien';</script></body>");
  const std::string alien =
      Browse(folder.Write("alien.html", html), folder.Path("profile2")).output;
  EXPECT_THAT(alien, HasSubstr("Content Security Policy"));
  EXPECT_THAT(alien, Not(HasSubstr("<title>alien")));
}

// A second map is drawn beside the first, and turns with it; figures and views are saved as PNG.
constexpr char kBesideProbe[] = R"(<script type="module">
const byId = (id) => document.getElementById(id);
const wait = (ready) => new Promise((done) => {
  const look = () => (ready() ? done() : setTimeout(look, 1));
  look();
});
const picture = (id) => byId(id).toDataURL();
await wait(() => byId("surface").dataset.faces > 0 && byId("facts").textContent !== "");
const found = [document.querySelectorAll("canvas").length];
byId("beside").value = 1;
byId("beside").dispatchEvent(new Event("change"));
await wait(() => byId("surface2") && byId("surface2").dataset.faces > 0 && byId("image2").dataset.faces > 0);
found.push(document.querySelector("#second span").textContent);
for (const [turned, other] of [["surface", "surface2"], ["surface2", "surface"], ["image2", "image"]]) {
  const before = picture(other);
  byId(turned).dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
  await new Promise((done) => setTimeout(done, 100));
  found.push(other + (picture(other) === before ? " stays" : " follows"));
}
const saved = [];
const made = URL.createObjectURL;
URL.createObjectURL = (blob) => { saved.push(blob.type); return made(blob); };
HTMLAnchorElement.prototype.click = function () { saved.push(this.download); };
for (const button of document.querySelectorAll("#maps .save, .chart:first-child .save")) {
  const count = saved.length;
  button.click();
  await wait(() => saved.slice(count).some((text) => text.endsWith(".png")));
}
found.push(saved.filter((text) => text.endsWith(".png")).join(" "));
byId("beside").value = -1;
byId("beside").dispatchEvent(new Event("change"));
found.push(byId("second").hidden ? "alone" : "beside");
const report = document.createElement("pre");
report.textContent = ["PROBE", found.join("; "), "END"].join(" ");
document.body.append(report);
</script></body>)";

TEST(ReportInBrowserSlow, TwoMapsTurnTogetherAndPicturesAreSaved) {
  if (!HasChromium()) GTEST_SKIP() << kNoChromium;
  const TemporaryFolder folder;
  WriteTwoMaps(folder);
  const std::string dom = Browse(WriteProbed(folder, kBesideProbe), folder.Path("profile")).output;
  EXPECT_EQ(Found(dom),
            "2; b - m; surface2 follows; surface follows; image follows; "
            "Time_against_size.png a-m-surface.png a-m-image.png b-m-surface2.png "
            "b-m-image2.png; alone");
  EXPECT_THAT(dom, Not(HasSubstr("CONSOLE")));
}

TEST(ReportInBrowserSlow, ALinkToAMapShowsIt) {
  if (!HasChromium()) GTEST_SKIP() << kNoChromium;
  const TemporaryFolder folder;
  WriteTwoMaps(folder);
  const std::string page = WriteProbed(folder, kLinkProbe);
  const std::string dom = Browse(page + "#map-b-m", folder.Path("profile")).output;
  EXPECT_EQ(Found(dom), "b - m; in sight; #map-a-m");
  EXPECT_THAT(dom, Not(HasSubstr("CONSOLE")));
}

TEST(ViewInBrowserSlow, DrawsThePlaneAndTheSphere) {
  if (!HasChromium()) GTEST_SKIP() << kNoChromium;
  for (const std::string domain :
       {"plane", "sphere", "plane --holonomy=pi/3 --integer_cells=900"}) {
    const TemporaryFolder folder;
    const std::string in = folder.Path("in.obj");
    ASSERT_TRUE(WriteMesh(in, *GenerateMesh("blob", {800, 1})).ok());
    ASSERT_EQ(RunProgram("circle_patterns --domain=" + domain + " " + in + " " +
                         folder.Path("out.obj") + " --view=" + folder.Path("view.html"))
                  .exit_status,
              0);
    const std::string page = WriteProbed(folder, folder.Read("view.html"), kViewProbe);
    const std::string dom = Browse(page, folder.Path("profile")).output;
    EXPECT_EQ(Found(dom), "none; surface drawn; right; image drawn; right; Image " +
                              std::string(domain == "sphere" ? "on the sphere" : "in the plane"));
    EXPECT_THAT(dom, Not(HasSubstr("CONSOLE")));
  }
}

void AddNumber(std::uint32_t number, std::string* bytes) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes->push_back(static_cast<char>(number >> shift & 0xff));
  }
}

void AddChunk(const std::string& name, std::string content, char filler, std::string* glb) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  AddNumber(static_cast<std::uint32_t>(content.size()), glb);
  *glb += name + content;
}

/// One triangle, or nothing that glTF allows.
std::string TriangleGlb(const std::string& version) {
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string chunks, glb = "glTF";
  AddChunk("JSON",
           "{\"asset\":{\"version\":\"" + version +
               "\"},\"scenes\":[{\"nodes\":[0]}],\"scene\":0,"
               "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":"
               "{\"POSITION\":0}}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
               "\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]}],"
               "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
               "\"buffers\":[{\"byteLength\":36}]}",
           ' ', &chunks);
  AddChunk(std::string("BIN\0", 4), std::string(reinterpret_cast<const char*>(corners), 36), '\0',
           &chunks);
  AddNumber(2, &glb);
  AddNumber(static_cast<std::uint32_t>(12 + chunks.size()), &glb);
  return glb + chunks;
}

// three.js is not fetched by a test: CIRQUE_THREE names the folder of its npm package.
TEST(ViewGlbSlow, ShowsAModelAndSaysWhereThereIsNone) {
  if (!HasChromium()) GTEST_SKIP() << kNoChromium;
  if (std::getenv("CIRQUE_THREE") == nullptr) GTEST_SKIP() << "CIRQUE_THREE is not set";
  const TemporaryFolder folder;
  const std::string script = ProjectPath("experiments/scripts/view_glb.mjs");
  const auto view = [&](const std::string& version) {
    return RunShell("node " + script + " " + folder.Write("a.glb", TriangleGlb(version)) + " " +
                    folder.Path("a.png"));
  };
  const ProgramResult shown = view("2.0");
  EXPECT_EQ(shown.exit_status, 0) << shown.output;
  EXPECT_THAT(shown.output, HasSubstr("{\"meshes\":1,\"triangles\":1,\"images\":0,"
                                      "\"texture_coordinates\":false"));
  EXPECT_EQ(folder.Read("a.png").substr(1, 3), "PNG");
  const ProgramResult wrong = view("1.0");
  EXPECT_EQ(wrong.exit_status, 1) << wrong.output;
  EXPECT_THAT(wrong.output, HasSubstr("view_glb: "));
}

}  // namespace
}  // namespace cirque
