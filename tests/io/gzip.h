#pragma once

#include <string>
#include <string_view>

namespace cirque::testing {

/// `content` as one member of gzip.
std::string Gzipped(std::string_view content);

}  // namespace cirque::testing
