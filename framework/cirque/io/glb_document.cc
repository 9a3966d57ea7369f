#include "cirque/io/glb_document.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace cirque {
namespace {

// Numbers of the glTF 2.0 specification.
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kUnsignedInt = 5125, kFloat = 5126;
constexpr int kNoTarget = 0, kArrayBuffer = 34962, kElementArrayBuffer = 34963;

void Append(std::uint32_t value, std::string* bytes) {
  for (int shift = 0; shift < 32; shift += 8) {  // little-endian
    *bytes += static_cast<char>((value >> shift) & 0xFF);
  }
}

}  // namespace

void GlbDocument::PutFloat(double value, double* rounding) {
  const auto rounded = static_cast<float>(value);
  *rounding = std::max(*rounding, std::abs(static_cast<double>(rounded) - value));
  std::uint32_t bits;
  std::memcpy(&bits, &rounded, sizeof bits);
  Append(bits, &buffer_);
}

void GlbDocument::PutIndex(std::uint32_t index) { Append(index, &buffer_); }

int GlbDocument::EndView(int target) {
  Json view = {{"buffer", 0}, {"byteOffset", begin_}, {"byteLength", buffer_.size() - begin_}};
  if (target != kNoTarget) view["target"] = target;
  buffer_.resize((buffer_.size() + 3) / 4 * 4);
  begin_ = buffer_.size();
  return Add("bufferViews", view);
}

int GlbDocument::EndAccessor(int target, int type, std::size_t count, const char* shape) {
  return Add("accessors", {{"bufferView", EndView(target)},
                           {"componentType", type},
                           {"count", count},
                           {"type", shape}});
}

int GlbDocument::EndFloats(std::size_t count, const char* shape) {
  return EndAccessor(kArrayBuffer, kFloat, count, shape);
}

int GlbDocument::EndIndices() {
  const std::size_t count = (buffer_.size() - begin_) / sizeof(std::uint32_t);
  return EndAccessor(kElementArrayBuffer, kUnsignedInt, count, "SCALAR");
}

int GlbDocument::AddTexture(const std::string& name, const std::string& png, const Json& sampler) {
  buffer_ += png;
  const int view = EndView(kNoTarget);
  const int source =
      Add("images", {{"bufferView", view}, {"mimeType", "image/png"}, {"name", name}});
  return Add("textures", {{"sampler", Add("samplers", sampler)}, {"source", source}});
}

int GlbDocument::Add(const char* list, const Json& item) {
  json_[list].push_back(item);
  return static_cast<int>(json_[list].size()) - 1;
}

TextPieces GlbDocument::Assemble() {
  json_["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
  std::string json = json_.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string head, between;
  Append(kMagic, &head);
  Append(kVersion, &head);
  const std::size_t kHeaders = 12 + 8 + 8;
  Append(static_cast<std::uint32_t>(kHeaders + json.size() + buffer_.size()), &head);
  Append(static_cast<std::uint32_t>(json.size()), &head);
  Append(kJsonChunk, &head);
  Append(static_cast<std::uint32_t>(buffer_.size()), &between);
  Append(kBinaryChunk, &between);
  return {head, std::move(json), between, std::move(buffer_)};
}

}  // namespace cirque
