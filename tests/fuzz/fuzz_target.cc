#include "tests/fuzz/fuzz_target.h"

#include <iterator>

#include <glog/logging.h>

namespace cirque::testing {

void CheckRefusal(const Status& status, std::string_view where) {
  CHECK(status.code() == StatusCode::kInvalidInput) << status.message();
  CHECK(status.message().starts_with(where)) << status.message();
  CHECK_GT(status.message().size(), where.size());
}

}  // namespace cirque::testing
