#pragma once

#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "cirque/pipeline/parameterize.h"

namespace cirque {

/// One field of ParameterizeOptions as a key of a config: the only place that knows both.
struct MethodField {
  using Member = std::variant<std::string ParameterizeOptions::*, double ParameterizeOptions::*,
                              int ParameterizeOptions::*>;

  std::string name;
  Member member;
  std::string help;
  double minimum = 0, maximum = 0;       ///< of a number, both allowed
  std::vector<std::string> choices;      ///< the texts allowed; empty: any
  std::vector<std::string> former = {};  ///< names that it had once
};

/// The table of fields, one line an entry.
const std::vector<MethodField>& MethodFields();

/// Sets a field from the text of a config, which has been checked against the schema.
void SetField(const MethodField& field, const std::string& text, ParameterizeOptions* options);

/// The field's value; texts and numbers keep their kind.
nlohmann::json FieldValue(const MethodField& field, const ParameterizeOptions& options);

}  // namespace cirque
