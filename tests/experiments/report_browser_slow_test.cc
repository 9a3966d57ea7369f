// The page of experiment_report in a browser: it draws, sorts, and complains of nothing.
#include <cstdlib>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/run_program.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque {
namespace {

using testing::HasSubstr;
using testing::Not;

// Waits for the maps to be drawn, sorts the table by time, counts the pixels of either canvas that
// are not its background, and writes what it found into the page for --dump-dom.
constexpr char kProbe[] = R"(<script type="module">
const found = [];
const pixels = (canvas) => {
  const gl = canvas.getContext("webgl2"), data = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  let drawn = 0;
  for (let i = 0; i < data.length; i += 4) drawn += data[i] !== data[0] || data[i + 2] !== data[2];
  return drawn / (canvas.width * canvas.height);
};
const probe = () => {
  const canvases = [...document.querySelectorAll("canvas")];
  if (!canvases.every((canvas) => canvas.dataset.faces > 0)) return setTimeout(probe, 50);
  for (const canvas of canvases) found.push(`${canvas.id} ${pixels(canvas) > 0.05 ? "drawn" : "blank"}`);
  const heads = [...document.querySelectorAll("#runs th")];
  const time = heads.findIndex((head) => head.textContent.startsWith("time"));
  const order = () => [...document.querySelectorAll("#runs tbody tr")].map((row) => row.cells[0].textContent).join("");
  heads[time].querySelector("button").click();
  found.push("up " + order());
  heads[time].querySelector("button").click();
  found.push("down " + order());
  const report = document.createElement("pre");
  report.textContent = ["PROBE", found.join("; "), "END"].join(" ");
  document.body.append(report);
};
probe();
</script></body>)";

/// Prints the DOM after the page has run, and the browser's log.
ProgramResult Browse(const std::string& page, const std::string& profile) {
  return RunShell(
      "timeout 60 chromium --headless --no-sandbox --use-angle=swiftshader "
      "--enable-unsafe-swiftshader --disable-dev-shm-usage --user-data-dir=" +
      profile + " --enable-logging=stderr --virtual-time-budget=20000 --dump-dom file://" + page);
}

TEST(ReportInBrowserSlow, DrawsSortsAndHasNoErrors) {
  if (std::system("command -v chromium > /dev/null") != 0) {
    GTEST_SKIP() << "chromium is not installed (Debian: apt-get install chromium)";
  }
  const TemporaryFolder folder;
  folder.Write("maps/a.obj", PyramidObj(5));
  nlohmann::json a = ReportRecord("a", "m", 10), b = ReportRecord("b", "m", 9);
  nlohmann::json c = ReportRecord("c", "m", 100), d = ReportRecord("d", "m", 0);
  a["map"] = "maps/a.obj";
  d["outcome"] = "timeout";
  d["seconds"] = nlohmann::json::object();
  folder.Write("results.jsonl", JsonLines({a, b, c, d}));
  ASSERT_EQ(RunProgram("experiment_report " + folder.path()).exit_status, 0);
  std::string html = folder.Read("report.html");
  html.replace(html.rfind("</body>"), 7, kProbe);
  const std::string dom = Browse(folder.Write("probed.html", html), folder.Path("profile")).output;
  std::smatch found;
  ASSERT_TRUE(std::regex_search(dom, found, std::regex("PROBE ([^<]*) END")))
      << dom.substr(0, 3000);
  // By number, not by text; without a time: last.
  EXPECT_EQ(found[1], "surface drawn; image drawn; up bacd; down cabd");
  EXPECT_THAT(dom, Not(HasSubstr("CONSOLE")));
}

}  // namespace
}  // namespace cirque
