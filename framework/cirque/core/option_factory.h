#pragma once

#include <memory>

#include "cirque/core/option_table.h"
#include "cirque/core/status.h"

namespace cirque {

/// A factory, for registries, of a Base whose Made is constructed from its options struct O, read
/// through `table`.
template <class Base, class Made, class O>
auto FactoryOf(const OptionTable<O>& table) {
  return [table](const OptionMap& map) -> StatusOr<std::shared_ptr<const Base>> {
    O options;
    if (Status status = table.Set(map, &options); !status.ok()) return status;
    return std::shared_ptr<const Base>(std::make_shared<Made>(options));
  };
}

/// The options of what has none.
struct NoOptions {};

}  // namespace cirque
