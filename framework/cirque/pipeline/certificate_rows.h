#pragma once

#include <optional>
#include <span>

#include "cirque/pipeline/certificate.h"

/// The tables behind CertificateFields.
namespace cirque::internal {

/// The member of a summary that may be absent.
template <auto Group, auto Member>
std::optional<double> ReadMember(const Certificate& certificate) {
  const auto& summary = certificate.*Group;
  if (!summary) return std::nullopt;
  const auto& value = *summary.*Member;
  if constexpr (requires { value.has_value(); }) {
    return value ? std::optional<double>(*value) : std::nullopt;
  } else {
    return static_cast<double>(value);
  }
}

/// A line of a table: CertificateField as it stands in the program.
struct CertificateRow {
  const char *name, *summary, *unit, *meaning;
  std::optional<double> (*value)(const Certificate&);
};

/// Of what is solved: from the triangulation to the metric.
std::span<const CertificateRow> SolveRows();

/// Of what the metric becomes: from the layout on.
std::span<const CertificateRow> MapRows();

}  // namespace cirque::internal
