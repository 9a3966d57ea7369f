#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/structure/code_text.h"

namespace cirque {

/// Which file pairs (NAME.h with NAME.cc, called by the path without extension) include which. A
/// source counts with its header: what NAME.cc includes, NAME includes.
class IncludeGraph {
 public:
  /// Adds a file (path from the top of the project) with its text.
  void Add(const std::string& path, const std::string& text);

  /// The pairs that include each other, directly or in a ring: "A, B: include each other in a ring".
  std::vector<std::string> Cycles() const;

  /// The pairs that define a base class and include a pair that derives from it:
  /// "A: includes B, whose class D derives from its class C".
  std::vector<std::string> BasesThatIncludeDerived() const;

  /// The pairs that a pair includes; empty for one that is unknown.
  std::set<std::string> Includes(const std::string& pair) const;

 private:
  std::set<std::string> ReachableFrom(const std::string& pair) const;

  std::map<std::string, std::set<std::string>> includes_;
  std::map<std::string, std::set<std::string>> classes_;  // of a pair
  std::map<std::string, std::vector<Derivation>> derivations_;
};

}  // namespace cirque
