#include "cirque/io/ply_body.h"

#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "cirque/io/byte_order.h"

namespace cirque {
namespace {

class TextBody final : public PlyBody {
 public:
  explicit TextBody(TextScanner scanner) : scanner_(std::move(scanner)) {}

  bool NextElement() override { return scanner_.NextLine(); }
  std::optional<double> Number(PlyType) override { return scanner_.Number(); }
  Status Missing(std::string_view what) override { return scanner_.Expected(what); }
  Status Error(std::string_view message) const override { return scanner_.Error(message); }

 private:
  TextScanner scanner_;
};

class BinaryBody final : public PlyBody {
 public:
  BinaryBody(std::string path, std::string_view bytes, ByteOrder order)
      : path_(std::move(path)), bytes_(bytes), order_(order) {}

  bool NextElement() override { return at_ < bytes_.size(); }

  std::optional<double> Number(PlyType type) override {
    switch (type) {
      case PlyType::kInt8:
        return Take<std::int8_t>();
      case PlyType::kUint8:
        return Take<std::uint8_t>();
      case PlyType::kInt16:
        return Take<std::int16_t>();
      case PlyType::kUint16:
        return Take<std::uint16_t>();
      case PlyType::kInt32:
        return Take<std::int32_t>();
      case PlyType::kUint32:
        return Take<std::uint32_t>();
      case PlyType::kFloat32:
        return Take<float>();
      case PlyType::kFloat64:
        return Take<double>();
    }
    return std::nullopt;
  }

  Status Missing(std::string_view what) override {
    return Error(fmt::format("expected {}, got the end of the file; is it cut off?", what));
  }

  Status Error(std::string_view message) const override {
    return Status::InvalidInput(
        fmt::format("{}: byte {} after the header: {}", path_, at_, message));
  }

 private:
  template <class T>
  std::optional<double> Take() {
    if (bytes_.size() - at_ < sizeof(T)) return std::nullopt;
    const T value = ReadBytes<T>(bytes_.substr(at_), order_);
    at_ += sizeof(T);
    return static_cast<double>(value);
  }

  std::string path_;
  std::string_view bytes_;
  ByteOrder order_;
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<PlyBody> MakePlyBody(PlyEncoding encoding, const std::string& path,
                                     TextScanner scanner) {
  if (encoding == PlyEncoding::kText) return std::make_unique<TextBody>(std::move(scanner));
  const ByteOrder order =
      encoding == PlyEncoding::kLittleEndian ? ByteOrder::kLittle : ByteOrder::kBig;
  return std::make_unique<BinaryBody>(path, scanner.BytesAfterLine(), order);
}

}  // namespace cirque
