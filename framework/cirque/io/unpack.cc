#include "cirque/io/unpack.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/io/file_input.h"

namespace cirque {
namespace {

constexpr std::string_view kGzipMark = "\x1f\x8b", kLittleMark = "\xFF\xFE", kBigMark = "\xFE\xFF";
constexpr int kGzipWindow = 15 + 16;  // zlib's way to say gzip
constexpr std::size_t kLeastLimit = std::size_t{1} << 20;
constexpr std::size_t kMostAtOnce = std::numeric_limits<uInt>::max();

/// zlib's state of unpacking, freed at the end.
class Inflater {
 public:
  Inflater() {
    if (inflateInit2(&stream_, kGzipWindow) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Unpacks one member from the front of `packed` behind `out`, which may grow to `limit` bytes.
  /// Returns why it cannot, empty where it could.
  std::string Member(std::string_view* packed, std::size_t limit, std::string* out) {
    inflateReset(&stream_);
    std::size_t size = out->size();
    int state = Z_OK;
    while (state == Z_OK) {
      if (size == out->size()) {
        if (size == limit) {
          return fmt::format(
              "swells to more than {} times its size; unpack it yourself if it is "
              "to be trusted",
              kMostSwelling);
        }
        out->resize(std::min(limit, std::max(2 * size, std::size_t{65536})));
      }
      state = Step(packed, out, &size);
    }
    out->resize(size);
    if (state == Z_STREAM_END) return "";
    if (state == Z_MEM_ERROR) throw std::bad_alloc();
    return packed->empty() ? "the packed file (gzip) ends early; is it cut off?"
                           : "the packed file (gzip) is damaged";
  }

 private:
  int Step(std::string_view* packed, std::string* out, std::size_t* size) {
    const std::size_t given = std::min(packed->size(), kMostAtOnce);
    const std::size_t room = std::min(out->size() - *size, kMostAtOnce);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed->data()));
    stream_.avail_in = static_cast<uInt>(given);
    stream_.next_out = reinterpret_cast<Bytef*>(out->data() + *size);
    stream_.avail_out = static_cast<uInt>(room);
    const int state = inflate(&stream_, Z_NO_FLUSH);
    packed->remove_prefix(given - stream_.avail_in);
    *size += room - stream_.avail_out;
    return state;
  }

  z_stream stream_ = {};
};

StatusOr<std::string> Gunzipped(const std::string& path, std::string_view packed,
                                std::vector<std::string>* warnings) {
  const std::size_t limit = std::max(kLeastLimit, kMostSwelling * packed.size());
  Inflater inflater;
  std::string out;
  while (packed.starts_with(kGzipMark)) {
    const std::string problem = inflater.Member(&packed, limit, &out);
    if (!problem.empty()) return Status::InvalidInput(path + ": " + problem);
  }
  if (!packed.empty()) {
    warnings->push_back(fmt::format("{}: what is behind the packed content, {}, is ignored", path,
                                    Count(packed.size(), "byte")));
  }
  return out;
}

void AppendUtf8(char32_t code, std::string* out) {
  const auto tail = [&](int shift) { *out += static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    *out += static_cast<char>(code);
  } else if (code < 0x800) {
    *out += static_cast<char>(0xC0 | (code >> 6));
    tail(0);
  } else if (code < 0x10000) {
    *out += static_cast<char>(0xE0 | (code >> 12));
    tail(6);
    tail(0);
  } else {
    *out += static_cast<char>(0xF0 | (code >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

/// What follows the byte order mark. Halves of pairs that stand alone become U+FFFD.
std::string Utf8(std::string_view utf16, ByteOrder order) {
  constexpr char32_t kReplacement = 0xFFFD;
  const auto unit = [&](std::size_t at) -> char32_t {
    return ReadBytes<std::uint16_t>(utf16.substr(at), order);
  };
  std::string out;
  out.reserve(utf16.size() / 2);
  for (std::size_t at = 2; at + 2 <= utf16.size(); at += 2) {
    char32_t code = unit(at);
    if (code >= 0xD800 && code < 0xE000) {
      const bool is_pair = code < 0xDC00 && at + 4 <= utf16.size() && (unit(at + 2) >> 10) == 0x37;
      code = is_pair ? 0x10000 + ((code & 0x3FF) << 10) + (unit(at + 2) & 0x3FF) : kReplacement;
      if (is_pair) at += 2;
    }
    AppendUtf8(code, &out);
  }
  return out;
}

}  // namespace

StatusOr<std::string> Unpacked(const std::string& path, std::string content,
                               std::vector<std::string>* warnings) {
  if (content.starts_with(kGzipMark)) {
    StatusOr<std::string> unpacked = Gunzipped(path, content, warnings);
    if (!unpacked.ok()) return unpacked;
    content = *std::move(unpacked);
  }
  const bool little = content.starts_with(kLittleMark);
  if (!little && !content.starts_with(kBigMark)) return content;
  warnings->push_back(path + ": UTF-16, read as the UTF-8 that it stands for");
  return Utf8(content, little ? ByteOrder::kLittle : ByteOrder::kBig);
}

StatusOr<std::string> ReadUnpacked(const std::string& path, std::vector<std::string>* warnings) {
  StatusOr<std::string> content = ReadFileContent(path == "-" ? "/dev/stdin" : path);
  return content.ok() ? Unpacked(path, *std::move(content), warnings) : content;
}

}  // namespace cirque
