#include "cirque/io/image.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"
#include "cirque/io/file_input.h"
#include "cirque/io/png.h"

namespace cirque {
namespace {

constexpr std::string_view kPngMark("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t kMostSamples = std::size_t{1} << 28;
constexpr int kMostSide = 1 << 24;

Status Refuse(const std::string& path, const std::string& why) {
  return Status::InvalidInput(path + ": " + why);
}

/// Whether a picture of that size is one that is read.
Status CheckSize(const std::string& path, const Image& image) {
  const bool sides =
      image.width > 0 && image.height > 0 && image.width <= kMostSide && image.height <= kMostSide;
  if (sides && static_cast<std::size_t>(image.width) * image.height <=
                   kMostSamples / static_cast<std::size_t>(image.channels)) {
    return Status();
  }
  return Refuse(path, fmt::format("a picture of {} x {}; at least 1 x 1 and at most {} samples in "
                                  "all are read",
                                  image.width, image.height, kMostSamples));
}

std::size_t BytesPerSample(const Image& image) { return image.most > 255 ? 2 : 1; }

std::size_t BytesPerRow(const Image& image) {
  return static_cast<std::size_t>(image.width) * image.channels * BytesPerSample(image);
}

/// Samples of one byte or of two, the higher first, as both formats have them.
void AppendSamples(std::string_view bytes, Image* image) {
  const std::size_t size = BytesPerSample(*image);
  for (std::size_t i = 0; i + size <= bytes.size(); i += size) {
    image->sample.push_back(size == 1 ? static_cast<unsigned char>(bytes[i])
                                      : ReadBytes<std::uint16_t>(bytes.substr(i), ByteOrder::kBig));
  }
}

std::string SamplesOf(const Image& image, int row) {
  std::string bytes;
  const std::size_t count = static_cast<std::size_t>(image.width) * image.channels;
  for (std::size_t i = row * count; i < (row + 1) * count; ++i) {
    if (image.most > 255) bytes += static_cast<char>(image.sample[i] >> 8);
    bytes += static_cast<char>(image.sample[i] & 0xFF);
  }
  return bytes;
}

// Netpbm.

/// The next number of a header, behind blanks and comments.
std::optional<int> HeaderNumber(std::string_view* rest) {
  while (!rest->empty()) {
    if (rest->front() == '#') {
      rest->remove_prefix(std::min(rest->size(), rest->find('\n')));
    } else if (std::string_view(" \t\r\n").find(rest->front()) != std::string_view::npos) {
      rest->remove_prefix(1);
    } else {
      break;
    }
  }
  int value = 0;
  const auto read = std::from_chars(rest->data(), rest->data() + rest->size(), value);
  if (read.ec != std::errc()) return {};
  rest->remove_prefix(static_cast<std::size_t>(read.ptr - rest->data()));
  return value;
}

StatusOr<Image> ParseNetpbm(const std::string& path, std::string_view content) {
  Image image;
  image.channels = content[1] == '6' ? 3 : 1;
  content.remove_prefix(2);
  for (int* number : {&image.width, &image.height, &image.most}) {
    const std::optional<int> read = HeaderNumber(&content);
    if (!read) return Refuse(path, "a header of width, height and greatest sample is expected");
    *number = *read;
  }
  if (image.most < 1 || image.most > 65535) {
    return Refuse(path,
                  fmt::format("the greatest sample is {}; 1 to 65535 is expected", image.most));
  }
  if (Status s = CheckSize(path, image); !s.ok()) return s;
  if (!content.empty()) content.remove_prefix(1);  // one blank
  const std::size_t size = BytesPerRow(image) * static_cast<std::size_t>(image.height);
  if (content.size() < size) return Refuse(path, "the file ends early; is it cut off?");
  AppendSamples(content.substr(0, size), &image);
  return image;
}

// PNG.

constexpr std::array<int, 7> kChannels = {1, 0, 3, 0, 2, 0, 4};  // by the kind of colour

struct PngChunks {
  std::string_view header;
  std::string packed;
};

StatusOr<PngChunks> SplitChunks(const std::string& path, std::string_view content) {
  constexpr std::size_t kAround = 12;  // length, name, checksum
  PngChunks chunks;
  content.remove_prefix(kPngMark.size());
  while (content.size() >= kAround) {
    const std::size_t length = ReadBytes<std::uint32_t>(content, ByteOrder::kBig);
    const std::string_view name = content.substr(4, 4);
    if (content.size() - kAround < length) break;
    const std::string_view data = content.substr(8, length);
    if (name == "IHDR") chunks.header = data;
    if (name == "IDAT") chunks.packed += data;
    if (name == "IEND") return chunks;
    content.remove_prefix(kAround + length);
  }
  return Refuse(path, "the picture ends early; is it cut off?");
}

Status ReadPngHeader(const std::string& path, std::string_view header, Image* image) {
  if (header.size() != 13) return Refuse(path, "the picture has no header");
  const auto width = ReadBytes<std::uint32_t>(header, ByteOrder::kBig);
  const auto height = ReadBytes<std::uint32_t>(header.substr(4), ByteOrder::kBig);
  image->width = static_cast<int>(std::min<std::uint32_t>(width, kMostSide + 1));
  image->height = static_cast<int>(std::min<std::uint32_t>(height, kMostSide + 1));
  const int bits = header[8], colour = header[9], interlaced = header[12];
  image->channels = colour >= 0 && colour <= 6 ? kChannels[static_cast<std::size_t>(colour)] : 0;
  if (image->channels == 0 || (bits != 8 && bits != 16) || interlaced != 0) {
    return Refuse(path,
                  "pictures with a palette, of fewer than 8 bits or interlaced are not read; save "
                  "it as plain grey or colours");
  }
  image->most = bits == 8 ? 255 : 65535;
  return CheckSize(path, *image);
}

/// What a byte is predicted to be by that on its left, that above, and that on the left of that.
int Predict(int filter, int left, int above, int corner) {
  if (filter == 1) return left;
  if (filter == 2) return above;
  if (filter == 3) return (left + above) / 2;
  if (filter != 4) return 0;
  const int guess = left + above - corner;
  const int to_left = std::abs(guess - left), to_above = std::abs(guess - above);
  const int to_corner = std::abs(guess - corner);
  if (to_left <= to_above && to_left <= to_corner) return left;
  return to_above <= to_corner ? above : corner;
}

void Unfilter(int filter, std::size_t pixel, const std::string& above, std::string* row) {
  const auto at = [](const std::string& bytes, std::size_t i) {
    return static_cast<int>(static_cast<unsigned char>(bytes[i]));
  };
  for (std::size_t i = 0; i < row->size(); ++i) {
    const int left = i < pixel ? 0 : at(*row, i - pixel);
    const int corner = i < pixel ? 0 : at(above, i - pixel);
    (*row)[i] = static_cast<char>(at(*row, i) + Predict(filter, left, at(above, i), corner));
  }
}

StatusOr<Image> ParsePng(const std::string& path, std::string_view content) {
  const StatusOr<PngChunks> chunks = SplitChunks(path, content);
  if (!chunks.ok()) return chunks.status();
  Image image;
  if (Status s = ReadPngHeader(path, chunks->header, &image); !s.ok()) return s;
  const std::size_t row_size = BytesPerRow(image);
  std::string rows((row_size + 1) * static_cast<std::size_t>(image.height), '\0');
  uLongf size = static_cast<uLongf>(rows.size());
  const int state = uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                               reinterpret_cast<const Bytef*>(chunks->packed.data()),
                               static_cast<uLong>(chunks->packed.size()));
  if (state != Z_OK || size != rows.size()) return Refuse(path, "the picture is damaged");
  const std::size_t pixel = static_cast<std::size_t>(image.channels) * BytesPerSample(image);
  std::string above(row_size, '\0');
  for (std::size_t begin = 0; begin < rows.size(); begin += row_size + 1) {
    std::string row = rows.substr(begin + 1, row_size);
    Unfilter(rows[begin], pixel, above, &row);
    AppendSamples(row, &image);
    above.swap(row);
  }
  return image;
}

Status Cannot(const std::string& path, const Image& image, const char* what) {
  return Refuse(path, fmt::format("a picture of {} channels, samples to {}, is no {}",
                                  image.channels, image.most, what));
}

}  // namespace

StatusOr<Image> ParseImage(const std::string& path, std::string_view content) {
  if (content.starts_with(kPngMark)) return ParsePng(path, content);
  if (content.starts_with("P5") || content.starts_with("P6")) return ParseNetpbm(path, content);
  return Refuse(path, "a picture as PNG, PGM (P5) or PPM (P6) is expected");
}

StatusOr<Image> ReadImage(const std::string& path) {
  const StatusOr<std::string> content = ReadFileContent(path);
  return content.ok() ? ParseImage(path, *content) : content.status();
}

Status WriteImage(const std::string& path, const Image& image) {
  const bool png = path.ends_with(".png");
  if (!png && !path.ends_with(".pgm") && !path.ends_with(".ppm")) {
    return Refuse(path, "a picture is written as .png, .pgm or .ppm; name it so");
  }
  std::string bytes;
  if (png) {
    if (image.most != 255 && image.most != 65535) return Cannot(path, image, "PNG");
    for (int row = 0; row < image.height; ++row) bytes += '\0' + SamplesOf(image, row);
    const PngColour colours[] = {PngColour::kGrey, PngColour::kGreyAlpha, PngColour::kRgb,
                                 PngColour::kRgba};
    const PngColour colour = colours[image.channels - 1];
    bytes = FormatPng(image.width, image.height, colour, bytes, image.most > 255 ? 16 : 8);
  } else {
    const bool grey = path.ends_with(".pgm");
    if (image.channels != (grey ? 1 : 3)) return Cannot(path, image, grey ? "PGM" : "PPM");
    bytes = fmt::format("P{}\n{} {}\n{}\n", grey ? 5 : 6, image.width, image.height, image.most);
    for (int row = 0; row < image.height; ++row) bytes += SamplesOf(image, row);
  }
  return WriteFileAtomically(path, bytes);
}

}  // namespace cirque
