#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>

#include "cirque/core/atomic_file.h"

namespace cirque {

/// A binary glTF 2.0 file being made: its JSON, and the one buffer that views and accessors lead into.
/// Numbers are put into the buffer, then what was put is given its meaning by one of the Ends.
class GlbDocument {
 public:
  using Json = nlohmann::ordered_json;

  /// As single precision; `rounding` becomes the change by that, if it is larger.
  void PutFloat(double value, double* rounding);
  void PutIndex(std::uint32_t index);

  /// The floats put, as an accessor of `count` rows of a shape of glTF ("VEC3"). Returns its number.
  int EndFloats(std::size_t count, const char* shape);

  /// The indices put, as an accessor of corners of triangles. Returns its number.
  int EndIndices();

  /// A texture with a picture of its own and a sampler as glTF describes it. Returns its number.
  /// @pre nothing was put since the last End.
  int AddTexture(const std::string& name, const std::string& png, const Json& sampler);

  /// Appends to the list of that name ("nodes"); returns its number there.
  int Add(const char* list, const Json& item);

  Json& json() { return json_; }

  /// The file. @pre called once, at the end.
  TextPieces Assemble();

 private:
  int EndView(int target);
  int EndAccessor(int target, int type, std::size_t count, const char* shape);

  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what was put since the last End
  Json json_ = {{"asset", {{"version", "2.0"}, {"generator", "Cirque"}}}};
};

}  // namespace cirque
