// Pictures and pages of one map.
#include <zlib.h>

#include <array>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/domain.h"
#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "experiments/circle_patterns/pictures.h"
#include "experiments/common/map_view/picture.h"
#include "experiments/common/map_view/raster.h"
#include "experiments/common/map_view/stroke_font.h"
#include "experiments/common/map_view/uv_map.h"
#include "experiments/common/map_view/view_page.h"
#include "tests/common/run_program.h"
#include "tests/common/surfaces.h"
#include "tests/experiments/report_fixtures.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

using Pixel = std::array<int, 4>;

Pixel At(const RgbaImage& image, int x, int y) {
  const std::uint8_t* p = &image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)];
  return {p[0], p[1], p[2], p[3]};
}

std::uint32_t Number(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
  }
  return number;
}

/// Reads what EncodePng writes, every checksum verified.
RgbaImage DecodePng(const std::string& png) {
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  RgbaImage image;
  std::string rows;
  for (std::size_t at = 8; at < png.size();) {
    const std::uint32_t length = Number(png, at);
    const std::string content = png.substr(at + 4, 4 + length);
    EXPECT_EQ(
        crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())),
        Number(png, at + 8 + length));
    const std::string name = content.substr(0, 4);
    if (name == "IHDR") {
      image.width = static_cast<int>(Number(content, 4));
      image.height = static_cast<int>(Number(content, 8));
      EXPECT_EQ(content.substr(12), std::string("\x08\x06\0\0\0", 5));
    } else if (name == "IDAT") {
      rows.resize(static_cast<std::size_t>(image.height) * (4 * image.width + 1));
      uLongf size = rows.size();
      EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                           reinterpret_cast<const Bytef*>(content.data() + 4), length),
                Z_OK);
      EXPECT_EQ(size, rows.size());
    }
    at += 12 + length;
  }
  const std::size_t length = 4 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) {
    const char* row = rows.data() + y * (length + 1);
    EXPECT_EQ(row[0], 1);
    const std::size_t first = image.rgba.size();
    for (std::size_t i = 0; i < length; ++i) {
      const int left = i < 4 ? 0 : image.rgba[first + i - 4];
      image.rgba.push_back(static_cast<std::uint8_t>(row[1 + i] + left));
    }
  }
  return image;
}

TEST(Raster, EdgesAreSmoothAndNearThingsHideFarOnes) {
  Raster raster(10, 4);
  const Rgb red(1, 0, 0), blue(0, 0, 1);
  // Half of the pixels of column 4: the diagonal x + y = 9 of a large triangle, and a strip.
  raster.Rectangle({0, 0}, {4.5, 4}, red);
  raster.Triangle({{{6, 0, 1}, {10, 0, 1}, {6, 4, 1}}},
                  [&](const Eigen::Vector3d&) { return red; });
  raster.Triangle({{{6, 0, 2}, {10, 0, 2}, {6, 4, 2}}},
                  [&](const Eigen::Vector3d&) { return blue; });
  const RgbaImage image = raster.Finish();
  EXPECT_EQ(At(image, 1, 1), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(At(image, 5, 1), (Pixel{0, 0, 0, 0}));
  EXPECT_EQ(At(image, 6, 1), (Pixel{255, 0, 0, 255}));  // not blue: that lies behind
  const Pixel edge = At(image, 4, 1);
  EXPECT_TRUE(edge[3] > 60 && edge[3] < 200) << edge[3];
  EXPECT_EQ(edge[0], 255);  // only its opacity is less
  const Pixel diagonal = At(image, 8, 1);
  EXPECT_TRUE(diagonal[3] > 60 && diagonal[3] < 200) << diagonal[3];
}

TEST(Raster, AColourIsAskedForWithBarycentricCoordinates) {
  Raster raster(9, 9);
  raster.Triangle({{{0, 0, 0}, {18, 0, 0}, {0, 18, 0}}},
                  [&](const Eigen::Vector3d& b) { return b.cast<float>(); });
  const Pixel pixel = At(raster.Finish(), 8, 4);  // centre (8.5, 4.5)
  EXPECT_NEAR(pixel[0], 255 * (1 - 13 / 18.), 2);
  EXPECT_NEAR(pixel[1], 255 * 8.5 / 18, 2);
  EXPECT_NEAR(pixel[2], 255 * 4.5 / 18, 2);
}

TEST(Png, ComesBackBitByBit) {
  RgbaImage image = {5, 3, {}};
  for (int i = 0; i < 60; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * 37 % 256));
  const RgbaImage back = DecodePng(EncodePng(image));
  EXPECT_EQ(back.width, 5);
  EXPECT_EQ(back.height, 3);
  EXPECT_EQ(back.rgba, image.rgba);
}

TEST(Paste, MixesWhereItIsNotOpaqueAndStaysInside) {
  RgbaImage page = {2, 1, {255, 255, 255, 255, 255, 255, 255, 255}};
  Paste({2, 1, {0, 0, 0, 51, 9, 9, 9, 255}}, 1, 0, &page);
  EXPECT_EQ(At(page, 0, 0), (Pixel{255, 255, 255, 255}));
  EXPECT_EQ(At(page, 1, 0), (Pixel{204, 204, 204, 255}));
}

TEST(StrokeFont, HasWhatLegendsSayAndItsWidthIsWhereItEnds) {
  for (const char c : std::string("surface, with the squares of its image jkvxyz 0123456789 "
                                  "log(a / A) - [] |a + b|^2 = : ; sigma_max .pq")) {
    EXPECT_TRUE(HasGlyph(c)) << c;
  }
  EXPECT_FALSE(HasGlyph('Q'));
  EXPECT_EQ(TextWidth("", 9), 0);
  EXPECT_GT(TextWidth("mm", 9), 1.9 * TextWidth("m", 9));
  Raster raster(60, 20);
  DrawText("log", 5, 15, 9, Rgb(0, 0, 0), &raster);
  const RgbaImage image = raster.Finish();
  int most = 0;
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < 20; ++y) most = At(image, x, y)[3] > 0 ? std::max(most, x) : most;
  }
  EXPECT_NEAR(most, 5 + TextWidth("log", 9), 2);
}

UvMap Pyramid() {
  const TemporaryFolder folder;
  auto map = ReadUvMap(folder.Write("map.obj", PyramidObj(5)));
  EXPECT_TRUE(map.ok()) << map.status().message();
  return *std::move(map);
}

/// How many pixels are of this colour, up to rounding.
int Count(const RgbaImage& image, const Pixel& wanted) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    bool same = true;
    for (std::size_t k = 0; k < 3; ++k) same &= std::abs(image.rgba[i + k] - wanted[k]) < 4;
    count += same;
  }
  return count;
}

// Where the sides of seams differ nothing flat is glued, and vertices on them are no cones.
TEST(UvMap, HasConesWhereSeamsMatchOnly) {
  for (const SeamKind seams : {SeamKind::kRigid, SeamKind::kFree}) {
    const Surface blob = GeneratedSurface("blob", 400);
    MapRequest request;
    request.options.seams = seams;
    const StatusOr<SurfaceMap> map = MapSurface(blob, request);
    ASSERT_TRUE(map.ok()) << map.status().message();
    const UvMap view = MakeUvMap(blob, map->uv);
    EXPECT_GT(view.seams.size(), 4u);
    double curvature = 0;
    for (const auto& [v, sum] : view.cones) curvature += 2 * kPi - sum;
    EXPECT_NEAR(curvature, seams == SeamKind::kRigid ? 4 * kPi : 0, 1e-6);
  }
}

TEST(Picture, ShowsFacesSeamsConesAndFlips) {
  UvMap map = Pyramid();
  const Pixel seam = {224, 31, 89, 255}, cone = {237, 115, 13, 255}, flip = {217, 26, 26, 255};
  const RgbaImage image = DecodePng(PicturePng(map));
  EXPECT_GT(Count(image, seam), 100);
  EXPECT_GT(Count(image, cone), 10);
  EXPECT_EQ(Count(image, flip), 0);
  EXPECT_GT(Count(image, {255, 255, 255, 255}), image.width * image.height / 4);
  for (Eigen::Vector2d& uv : map.uv.value) uv.y() *= -1;
  EXPECT_GT(Count(DecodePng(PicturePng(MakeUvMap(map.surface, map.uv))), flip), 10000);
}

TEST(Picture, TheVectorOneIsLightAndDarkAndNeedsNothing) {
  const std::string svg = PictureSvg(Pyramid(), "quasi_conformal");
  EXPECT_THAT(svg, testing::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THAT(svg, HasSubstr("@media (prefers-color-scheme: dark)"));
  EXPECT_THAT(svg, HasSubstr("<path class=\"seam\""));
  EXPECT_THAT(svg, HasSubstr("<circle class=\"less\""));
  EXPECT_THAT(svg, HasSubstr(">4 triangles, 1 seam edge, 1 cone; sigma_max / sigma_min: mean 1"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("href=\"http")));
}

TEST(Picture, ItsSizeDoesNotGrowWithTheMesh) {
  const auto terrain = [](Index faces) {
    Surface surface = GeneratedSurface("bumpy_terrain", faces);
    CornerUv uv;
    for (const Index v : surface.triangulation.vertex) {
      uv.value.push_back(surface.position[v].head<2>());
    }
    return MakeUvMap(std::move(surface), std::move(uv));
  };
  const std::size_t small = PictureSvg(terrain(2000)).size(),
                    large = PictureSvg(terrain(40000)).size();
  EXPECT_LT(large, 2 * small);
}

TEST(ViewPage, HoldsTheMapAndItsFacts) {
  const std::string html = ViewPage("<b>", Pyramid(), {{"outcome", "ok & well"}});
  EXPECT_THAT(html, HasSubstr("<h1>&lt;b&gt;</h1>"));
  EXPECT_THAT(html, HasSubstr("<td>ok &amp; well</td>"));
  EXPECT_THAT(html, HasSubstr("\"faces\":4"));
  for (const std::string outside : {"http://", "https://", "<script src", "@import", "url("}) {
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  }
}

TEST(CheckPictures, NamesSayWhatToWrite) {
  EXPECT_TRUE(CheckPictures("", "").ok());
  EXPECT_TRUE(CheckPictures("a.html", "b.c/d.svg:quasi_conformal").ok());
  EXPECT_EQ(PictureFile("b.c/d.svg:quasi_conformal"), "b.c/d.svg");
  EXPECT_EQ(PictureFile("c:d/e.png"), "c:d/e.png");
  EXPECT_THAT(CheckPictures("a.pdf", "").message(), HasSubstr("name it .html"));
  EXPECT_THAT(CheckPictures("", "a.pdf").message(), HasSubstr(".svg or .png"));
  EXPECT_THAT(CheckPictures("", "a.png:quasi_confromal").message(),
              HasSubstr("did you mean 'quasi_conformal'?"));
}

TEST(CirclePatterns, ShowsThePlaneAndTheSphere) {
  const TemporaryFolder folder;
  const std::string in = folder.Path("in.obj");
  ASSERT_TRUE(WriteMesh(in, *GenerateMesh("blob", {400, 1})).ok());
  for (const std::string domain : {"plane", "sphere"}) {
    const ProgramResult run =
        RunProgram("circle_patterns --domain=" + domain + " " + in + " " + folder.Path("out.obj") +
                   " --view=" + folder.Path("a.html") + " --picture=" + folder.Path("a.png"));
    ASSERT_EQ(run.exit_status, 0) << run.output;
    const bool on_sphere = domain == "sphere";
    EXPECT_THAT(folder.Read("a.html"),
                HasSubstr(on_sphere ? "\"sphere\":true" : "\"sphere\":false"));
    // The globe shows what the plane has not: a white middle between its two sides.
    const RgbaImage image = DecodePng(folder.Read("a.png"));
    EXPECT_GT(Count(image, {255, 255, 255, 255}), 10000);
    EXPECT_EQ(Count(image, {217, 26, 26, 255}), 0);
  }
}

}  // namespace
}  // namespace cirque
