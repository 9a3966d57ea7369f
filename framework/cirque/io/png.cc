#include "cirque/io/png.h"

#include <zlib.h>

#include <cstdint>
#include <new>

namespace cirque {
namespace {

const Bytef* BytesOf(const std::string& bytes) {
  return reinterpret_cast<const Bytef*>(bytes.data());
}

void AppendBigEndian(std::uint32_t value, std::string* bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) *bytes += static_cast<char>((value >> shift) & 0xFF);
}

/// Length, name, data, and their checksum.
void AppendChunk(const std::string& name, const std::string& data, std::string* png) {
  AppendBigEndian(static_cast<std::uint32_t>(data.size()), png);
  const std::string both = name + data;
  *png += both;
  AppendBigEndian(
      static_cast<std::uint32_t>(crc32(0, BytesOf(both), static_cast<uInt>(both.size()))), png);
}

}  // namespace

std::string Deflate(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string deflated(size, '\0');
  const int state = compress(reinterpret_cast<Bytef*>(deflated.data()), &size, BytesOf(bytes),
                             static_cast<uLong>(bytes.size()));
  if (state != Z_OK) throw std::bad_alloc();  // the bound always holds
  deflated.resize(size);
  return deflated;
}

std::string FormatPng(int width, int height, PngColour colour, const std::string& rows, int bits) {
  std::string png("\x89PNG\r\n\x1a\n", 8), header;
  AppendBigEndian(static_cast<std::uint32_t>(width), &header);
  AppendBigEndian(static_cast<std::uint32_t>(height), &header);
  header += static_cast<char>(bits);
  header += static_cast<char>(colour);
  header += std::string(3, '\0');  // the one kind of all else
  AppendChunk("IHDR", header, &png);
  AppendChunk("IDAT", Deflate(rows), &png);
  AppendChunk("IEND", "", &png);
  return png;
}

}  // namespace cirque
