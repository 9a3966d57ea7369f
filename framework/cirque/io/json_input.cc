#include "cirque/io/json_input.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace cirque {
namespace {

using Json = nlohmann::json;

/// Whether brackets outside of strings lie deeper in one another than they may. Where the text is
/// malformed the answer does not matter: what follows is not read.
bool IsTooDeep(std::string_view text) {
  int levels = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') in_string = !in_string;
    if (in_string) {
      i += c == '\\' ? 1 : 0;
      continue;
    }
    if (c == '[' || c == '{') ++levels;
    if (c == ']' || c == '}') --levels;
    if (levels > kMostJsonLevels) return true;
  }
  return false;
}

/// Follows a parser that would build the value, and stops it where that gets too deep.
class LevelCheck final : public Json::json_sax_t {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(Json::number_integer_t) override { return true; }
  bool number_unsigned(Json::number_unsigned_t) override { return true; }
  bool number_float(Json::number_float_t, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(Json::binary_t&) override { return true; }
  bool key(std::string&) override { return true; }
  bool start_object(std::size_t) override { return Enter(); }
  bool end_object() override { return Leave(); }
  bool start_array(std::size_t) override { return Enter(); }
  bool end_array() override { return Leave(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
    return false;
  }

 private:
  bool Enter() { return ++levels_ <= kMostJsonLevels; }
  bool Leave() { return --levels_ >= 0; }

  int levels_ = 0;
};

std::optional<Json> Found(Json value) {
  if (value.is_discarded()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<Json> ParseJson(std::string_view text) {
  if (IsTooDeep(text)) return std::nullopt;
  return Found(Json::parse(text, nullptr, /*allow_exceptions=*/false));
}

std::optional<Json> ParseCbor(std::string_view bytes) {
  LevelCheck check;
  if (!Json::sax_parse(bytes, &check, Json::input_format_t::cbor)) return std::nullopt;
  return Found(Json::from_cbor(bytes, /*strict=*/true, /*allow_exceptions=*/false));
}

}  // namespace cirque
