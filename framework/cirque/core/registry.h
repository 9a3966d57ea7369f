#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/core/text.h"

namespace cirque {

/// A table from names to things of one kind (usually factories), written out in one file, one line
/// an entry. A registry is a value that never changes: a program that adds a thing of its own makes
/// a larger table (With) and hands that on.
template <class T>
class Registry {
 public:
  /// `kind` names what is registered, in messages: "solver strategy".
  Registry(std::string kind, std::initializer_list<std::pair<std::string, T>> entries)
      : kind_(std::move(kind)), entries_(entries) {}

  /// This table and one line more: how a program adds what it has of its own, without a table that
  /// changes under others. @pre the name is new;
  /// a second one of that name could not be found, and is a broken caller.
  Registry With(std::string name, T value) const {
    CheckIsNew(kind_, name, Names());
    Registry extended = *this;
    extended.entries_.emplace_back(std::move(name), std::move(value));
    return extended;
  }

  /// The names, in the order of the table.
  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& [name, value] : entries_) names.push_back(name);
    return names;
  }

  /// The thing of that name, or an error that lists the known names and the nearest one.
  StatusOr<T> Find(const std::string& name) const {
    for (const auto& [known, value] : entries_) {
      if (known == name) return value;
    }
    return Status::InvalidInput(UnknownName(kind_, name, Names()));
  }

 private:
  std::string kind_;
  std::vector<std::pair<std::string, T>> entries_;
};

}  // namespace cirque
