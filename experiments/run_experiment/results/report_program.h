#pragma once

#include <string>

namespace cirque {

/// Has the program experiment_report, where it lies beside this one, write its page of the results
/// in `folder` and say where it is.
void WriteReport(const std::string& folder);

}  // namespace cirque
