#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "cirque/core/text.h"

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/schema.h"

namespace cirque {
namespace {

class Validator {
 public:
  Validator(const Schema& schema, Diagnostics* problems) : schema_(schema), problems_(*problems) {}

  void CheckMap(const YAML::Node& map, const std::string& path);

 private:
  using Fields = std::vector<const SchemaField*>;
  using Keys = std::map<std::string, Place>;

  Keys CheckKeys(const YAML::Node& map, const std::string& path, const Fields& fields);
  void CheckCompany(const YAML::Node& map, const Fields& fields, const Keys& keys);
  void CheckAlternatives(const YAML::Node& map, const Fields& fields, const Keys& keys);
  void CheckValue(const YAML::Node& value, Place place, const SchemaField& field);
  void CheckList(const YAML::Node& list, Place place, const SchemaField& field);
  void CheckScalar(const YAML::Node& value, const SchemaField& field);

  const Schema& schema_;
  Diagnostics& problems_;
};

std::vector<std::string> KeysOf(const std::vector<const SchemaField*>& fields) {
  std::vector<std::string> keys;
  for (const SchemaField* field : fields) keys.push_back(field->Key());
  return keys;
}

const SchemaField* FindField(const std::vector<const SchemaField*>& fields,
                             const std::string& key) {
  const auto match = std::find_if(fields.begin(), fields.end(),
                                  [&](const SchemaField* field) { return field->Key() == key; });
  return match == fields.end() ? nullptr : *match;
}

void Validator::CheckMap(const YAML::Node& map, const std::string& path) {
  if (!map.IsMap()) {
    const std::string what = path.empty() ? "the file" : "an entry of '" + path + "'";
    return problems_.Add(PlaceOf(map), fmt::format("{} must be 'key: value' lines", what));
  }
  const Fields fields = FieldsOf(schema_, path);
  const Keys keys = CheckKeys(map, path, fields);
  CheckCompany(map, fields, keys);
  CheckAlternatives(map, fields, keys);
}

/// yaml-cpp keeps the first of two equal keys without a word, so the pairs are walked one by one.
Validator::Keys Validator::CheckKeys(const YAML::Node& map, const std::string& path,
                                     const Fields& fields) {
  Keys seen;
  for (const auto& pair : map) {
    const YAML::Node &key = pair.first, &value = pair.second;
    const Place place = PlaceOf(key);
    const std::string name = key.IsScalar() ? key.Scalar() : "";
    const SchemaField* field = FindField(fields, name);
    const auto [first, is_new] = seen.emplace(name, place);
    if (field == nullptr) {
      const std::string kind = path.empty() ? "key" : "key of '" + path + "'";
      problems_.Add(place, UnknownName(kind, name, KeysOf(fields)));
    } else if (!is_new) {
      problems_.Add(place, fmt::format("'{}' is given twice (first on line {}): remove one", name,
                                       first->second.line));
    } else {
      CheckValue(value, place, *field);
    }
  }
  return seen;
}

void Validator::CheckCompany(const YAML::Node& map, const Fields& fields, const Keys& keys) {
  for (const SchemaField* field : fields) {
    const auto given = keys.find(field->Key());
    if (given == keys.end()) {
      if (field->required) {
        problems_.Add(PlaceOf(map),
                      fmt::format("the key '{}' is missing: {}", field->Key(), field->help));
      }
      continue;
    }
    const auto is_given = [&](const std::string& key) { return keys.contains(key); };
    if (!field->beside.empty() &&
        std::none_of(field->beside.begin(), field->beside.end(), is_given)) {
      problems_.Add(given->second, fmt::format("'{}' has a meaning only beside '{}'", field->Key(),
                                               Join(field->beside, "' or '")));
    }
    if (!field->brings.empty() && !is_given(field->brings)) {
      problems_.Add(given->second,
                    fmt::format("'{}' needs '{}' beside it", field->Key(), field->brings));
    }
  }
}

void Validator::CheckAlternatives(const YAML::Node& map, const Fields& fields, const Keys& keys) {
  std::map<std::string, std::vector<std::string>> known, given;
  for (const SchemaField* field : fields) {
    if (field->one_of.empty()) continue;
    known[field->one_of].push_back(field->Key());
    if (keys.contains(field->Key())) given[field->one_of].push_back(field->Key());
  }
  for (const auto& [group, names] : known) {
    if (given[group].size() == 1) continue;
    problems_.Add(PlaceOf(map), fmt::format("give exactly one of {} (here: {})", Join(names),
                                            given[group].empty() ? "none" : Join(given[group])));
  }
}

void Validator::CheckValue(const YAML::Node& value, Place place, const SchemaField& field) {
  if (value.IsNull()) {
    problems_.Add(place,
                  fmt::format("'{}' has no value; expected {}", field.Key(), Expectation(field)));
  } else if (value.IsSequence() &&
             (field.matrix || field.list || field.kind == FieldKind::kSections)) {
    CheckList(value, place, field);
  } else if (value.IsMap() && field.kind == FieldKind::kSections && field.list) {
    CheckMap(value, field.path);
  } else if (value.IsScalar() && field.kind != FieldKind::kSections) {
    CheckScalar(value, field);
  } else {
    problems_.Add(PlaceOf(value), fmt::format("'{}' must be {}", field.Key(), Expectation(field)));
  }
}

void Validator::CheckList(const YAML::Node& list, Place place, const SchemaField& field) {
  if (list.size() == 0) {
    problems_.Add(place, fmt::format("'{}' is an empty list; give at least one", field.Key()));
  }
  for (const YAML::Node& item : list) {
    if (field.kind == FieldKind::kSections) {
      CheckMap(item, field.path);
    } else if (item.IsScalar()) {
      CheckScalar(item, field);
    } else {
      problems_.Add(PlaceOf(item),
                    fmt::format("a value of '{}' must be {}", field.Key(), Expectation(field)));
    }
  }
}

bool IsAllowed(const std::string& text, const SchemaField& field) {
  const auto in_range = [&](double value) {
    return value >= field.minimum && value <= field.maximum;
  };
  switch (field.kind) {
    case FieldKind::kText:
      return !text.empty();
    case FieldKind::kInteger: {
      const std::optional<long long> value = ParseInteger(text);
      return value && in_range(static_cast<double>(*value));
    }
    case FieldKind::kNumber: {
      const std::optional<double> value = ParseNumber(text);
      return value && in_range(*value);
    }
    case FieldKind::kBoolean:
      return ParseBoolean(text).has_value();
    case FieldKind::kSections:
      return false;
  }
  return false;
}

void Validator::CheckScalar(const YAML::Node& value, const SchemaField& field) {
  const std::string& text = value.Scalar();
  const bool is_choice =
      field.choices.empty() ||
      std::find(field.choices.begin(), field.choices.end(), text) != field.choices.end();
  if (!is_choice) {
    problems_.Add(PlaceOf(value), UnknownName(field.Key(), text, field.choices));
  } else if (!IsAllowed(text, field)) {
    problems_.Add(PlaceOf(value),
                  fmt::format("'{}' must be {}, not '{}'", field.Key(), Expectation(field), text));
  } else if (field.check && text != field.default_text) {
    const Status status = field.check(text);
    if (!status.ok()) problems_.Add(PlaceOf(value), status.In(field.Key()).message());
  }
}

/// Renames what a document calls by an old word.
class Renamer {
 public:
  Renamer(const Schema& schema, const Diagnostics& places) : schema_(schema), places_(places) {}

  void RenameIn(const YAML::Node& map, const std::string& path) {
    if (!map.IsMap()) return;
    const std::vector<const SchemaField*> fields = FieldsOf(schema_, path);
    for (const auto& pair : map) {
      YAML::Node key = pair.first;
      for (const SchemaField* field : fields) {
        if (Contains(field->former, key.Scalar())) Rename(field->Key(), &key);
        if (field->Key() != key.Scalar()) continue;
        for (const YAML::Node& value : ItemsOf(pair.second)) RenameValue(value, *field);
      }
    }
  }

  std::vector<std::string> notes;

 private:
  static bool Contains(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  }

  void Rename(const std::string& now, YAML::Node* word) {
    if (said_.insert(word->Scalar()).second) {
      notes.push_back(fmt::format("{}: note: '{}' is called '{}' now",
                                  places_.Locate(PlaceOf(*word)), word->Scalar(), now));
    }
    *word = now;
  }

  void RenameValue(const YAML::Node& value, const SchemaField& field) {
    if (field.kind == FieldKind::kSections) {
      RenameIn(value, field.path);
    } else if (value.IsScalar() && field.former_choices.contains(value.Scalar())) {
      YAML::Node word = value;
      Rename(field.former_choices.at(value.Scalar()), &word);
    }
  }

  const Schema& schema_;
  const Diagnostics& places_;
  std::set<std::string> said_;
};

}  // namespace

std::vector<std::string> UseNewWords(const YAML::Node& document, const Schema& schema,
                                     const Diagnostics& places) {
  Renamer renamer(schema, places);
  renamer.RenameIn(document, "");
  return renamer.notes;
}

void Validate(const YAML::Node& document, const Schema& schema, Diagnostics* problems) {
  Validator(schema, problems).CheckMap(document, "");
}

}  // namespace cirque
