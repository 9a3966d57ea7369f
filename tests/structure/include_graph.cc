#include "tests/structure/include_graph.h"

#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cirque {
namespace {

// The path from the top of the project without extension, of an include or a file.
std::string PairOf(const std::string& path) {
  const std::string full = path.starts_with("cirque/") ? "framework/" + path : path;
  return full.substr(0, full.rfind('.'));
}

std::set<std::string> IncludedPairs(const std::string& text) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*"([^"]+)")re");
  std::set<std::string> pairs;
  std::istringstream stream(text);
  std::string line;
  std::smatch match;
  while (std::getline(stream, line)) {
    if (std::regex_search(line, match, kInclude)) pairs.insert(PairOf(match[1]));
  }
  return pairs;
}

}  // namespace

void IncludeGraph::Add(const std::string& path, const std::string& text) {
  const std::string pair = PairOf(path);
  std::set<std::string>& included = includes_[pair];
  included.merge(IncludedPairs(text));
  included.erase(pair);
  for (const std::string& name : ClassesOf(text)) classes_[pair].insert(name);
  for (const Derivation& d : DerivationsOf(text)) derivations_[pair].push_back(d);
}

std::set<std::string> IncludeGraph::Includes(const std::string& pair) const {
  const auto found = includes_.find(pair);
  return found == includes_.end() ? std::set<std::string>() : found->second;
}

std::set<std::string> IncludeGraph::ReachableFrom(const std::string& pair) const {
  std::set<std::string> seen;
  std::vector<std::string> open = {pair};
  while (!open.empty()) {
    const std::string next = open.back();
    open.pop_back();
    for (const std::string& included : Includes(next)) {
      if (seen.insert(included).second) open.push_back(included);
    }
  }
  return seen;
}

std::vector<std::string> IncludeGraph::Cycles() const {
  std::map<std::string, std::set<std::string>> reachable;
  for (const auto& [pair, included] : includes_) reachable[pair] = ReachableFrom(pair);
  std::vector<std::string> cycles;
  std::set<std::string> told;
  for (const auto& [pair, included] : includes_) {
    if (!reachable[pair].contains(pair) || told.contains(pair)) continue;
    std::vector<std::string> ring;
    for (const std::string& other : reachable[pair]) {
      if (reachable[other].contains(pair)) ring.push_back(other);
    }
    told.insert(ring.begin(), ring.end());
    cycles.push_back(fmt::format("{}: include each other in a ring", fmt::join(ring, ", ")));
  }
  return cycles;
}

std::vector<std::string> IncludeGraph::BasesThatIncludeDerived() const {
  std::vector<std::string> faults;
  for (const auto& [pair, names] : classes_) {
    for (const std::string& included : Includes(pair)) {
      const auto found = derivations_.find(included);
      if (found == derivations_.end()) continue;
      for (const auto& [derived, base] : found->second) {
        if (!names.contains(base)) continue;
        faults.push_back(fmt::format("{}: includes {}, whose class {} derives from its class {}",
                                     pair, included, derived, base));
      }
    }
  }
  return faults;
}

}  // namespace cirque
