#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cirque/core/option.h"

namespace cirque {

enum class FieldKind { kText, kInteger, kNumber, kBoolean, kSections };

/// One key of a config. The table of them drives validation and `--help_config`.
struct SchemaField {
  std::string path =
      {};  ///< "repeats", or "meshes.file" for a key of the entries of the list `meshes`
  FieldKind kind = FieldKind::kText;
  std::string help = {};
  std::string default_text = {};  ///< as it would be written; empty: none
  bool required = false;
  bool matrix = false;  ///< a list of values makes one run for each
  bool list = false;    ///< a list of values is one value; of sections: or one map is
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {};  ///< the texts allowed; empty: any
  OptionInfo::Check check = {};           ///< of a text, further than `choices`; empty: none
  std::vector<std::string> former = {};   ///< names that the key had once
  std::map<std::string, std::string> former_choices = {};  ///< texts allowed once, as they are now
  std::string one_of = {};  ///< an entry has exactly one of the keys that name the same group
  std::vector<std::string> beside = {};  ///< may only stand beside one of these keys
  std::string brings = {};               ///< asks for this key beside it

  std::string Key() const;          ///< the last part of the path
  std::string_view Parent() const;  ///< the path without it
};

using Schema = std::vector<SchemaField>;

}  // namespace cirque
