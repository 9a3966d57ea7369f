#include "experiments/common/map_view/stroke_font.h"

#include <algorithm>
#include <map>
#include <string>

namespace cirque {
namespace {

constexpr double kHeight = 6;      ///< of figures, in the units of the table
constexpr double kGap = 1.7;       ///< between letters
constexpr double kBlank = 2.6;     ///< the width of a blank with its gap
constexpr double kThickness = .9;  ///< of lines

/// Polylines, a blank between; each point is two digits, x to the right and y down from the top of
/// the figures, whose feet are at 6.
const std::map<char, std::string_view>& Glyphs() {
  static const std::map<char, std::string_view> kTable = {{' ', ""},
                                                          {'0', "103041453616050110"},
                                                          {'1', "112026"},
                                                          {'2', "01103041420646"},
                                                          {'3', "0110304142334445361605 2333"},
                                                          {'4', "36300444"},
                                                          {'5', "40000312324345361605"},
                                                          {'6', "413010010516364544331304"},
                                                          {'7', "004016"},
                                                          {'8', "13020110304142331304051636454433"},
                                                          {'9', "423313020110304145361605"},
                                                          {'a', "4246 4332120305163645"},
                                                          {'b',
                                                           "0006 031232434536"
                                                           "1605"},
                                                          {'c', "4332120305163645"},
                                                          {'d', "4046 4332120305163645"},
                                                          {'e', "04444332120305163645"},
                                                          {'f', "30201116 0232"},
                                                          {'g', "4247381807 4332120305163645"},
                                                          {'h', "0006 0312324346"},
                                                          {'i', "0206 0000"},
                                                          {'j', "121708 1010"},
                                                          {'k', "0006 320436"},
                                                          {'l', "0006"},
                                                          {'m', "0206 0312223336 3342526366"},
                                                          {'n', "0206 0312324346"},
                                                          {'o', "123243453616050312"},
                                                          {'p', "0208 0312324345361605"},
                                                          {'q', "4248 4332120305163645"},
                                                          {'r', "0206 031232"},
                                                          {'s', "43321203143445361605"},
                                                          {'t', "10152636 0232"},
                                                          {'u', "0205163645 4246"},
                                                          {'v', "022642"},
                                                          {'w', "0216325662"},
                                                          {'x', "0246 4206"},
                                                          {'y', "0226 4218"},
                                                          {'z', "02420646"},
                                                          {'A', "062046 1434"},
                                                          {'.', "0606"},
                                                          {',', "0607"},
                                                          {':', "0303 0606"},
                                                          {';', "0303 0607"},
                                                          {'-', "0434"},
                                                          {'+', "0444 2226"},
                                                          {'=', "0343 0545"},
                                                          {'/', "0740"},
                                                          {'(', "10020517"},
                                                          {')', "00121507"},
                                                          {'[', "10000717"},
                                                          {']', "00101707"},
                                                          {'^', "021022"},
                                                          {'|', "0007"},
                                                          {'_', "0747"}};
  return kTable;
}

std::string_view GlyphOf(char character) {
  const auto found = Glyphs().find(character);
  return found == Glyphs().end() ? std::string_view() : found->second;
}

/// With the gap behind it.
double Advance(char character) {
  const std::string_view glyph = GlyphOf(character);
  if (glyph.empty()) return kBlank;
  int most = 0;
  for (std::size_t i = 0; i + 1 < glyph.size(); i += 2) {
    if (glyph[i] == ' ') ++i;
    most = std::max(most, glyph[i] - '0');
  }
  return most + kGap;
}

}  // namespace

bool HasGlyph(char character) { return Glyphs().contains(character); }

double TextWidth(std::string_view text, double size) {
  double width = 0;
  for (const char character : text) width += Advance(character);
  return text.empty() ? 0 : (width - kGap) * size / kHeight;
}

void DrawText(std::string_view text, double x, double baseline, double size, const Rgb& colour,
              Raster* raster) {
  const double unit = size / kHeight;
  for (const char character : text) {
    const std::string_view glyph = GlyphOf(character);
    bool is_first = true;
    Eigen::Vector3d before = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i + 1 < glyph.size(); i += 2) {
      if (glyph[i] == ' ') {
        ++i;
        is_first = true;
      }
      const Eigen::Vector3d at(x + unit * (glyph[i] - '0'),
                               baseline + unit * (glyph[i + 1] - '0' - kHeight), 0);
      if (!is_first) raster->Line(before, at, unit * kThickness, colour);
      before = at;
      is_first = false;
    }
    x += unit * Advance(character);
  }
}

}  // namespace cirque
