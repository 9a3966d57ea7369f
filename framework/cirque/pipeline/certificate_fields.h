#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cirque/pipeline/certificate.h"

namespace cirque {

inline constexpr char kCertificateSchema[] = "cirque-certificate";
inline constexpr int kCertificateVersion = 1;

/// One number of a certificate.
struct CertificateField {
  std::string name;     ///< in certificates and records; of several summaries at most one has it
  std::string summary;  ///< what it belongs to, for people
  std::string unit;     ///< "rad", "s", "MiB"; empty: none
  std::string meaning;
  std::optional<double> (*value)(const Certificate&);  ///< nothing: the run did not come to it

  std::string Label() const { return unit.empty() ? meaning : meaning + " [" + unit + "]"; }
};

/// The numbers, in the order of the stages, but for the family corner_vertex_0, corner_vertex_1, ...
const std::vector<CertificateField>& CertificateFields();

/// The times of stages, in the order of the stages.
const std::vector<CertificateField>& SecondsFields();

/// All numbers that the certificate holds, by name; NaN where a solver did not need one.
std::map<std::string, double> NumbersOf(const Certificate& certificate);

/// The times that it holds, by stage [s].
std::map<std::string, double> SecondsOf(const Certificate& certificate);

/// The page docs/certificate.md.
std::string CertificateReference();

}  // namespace cirque
