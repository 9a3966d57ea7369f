#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/domains/domain.h"

namespace cirque {

using DomainMap = Status (*)(const Surface&, const DomainOptions&, const ParameterizeOptions&,
                             const SolveControl&, Parameterization*);

/// A shape that surfaces are mapped to.
struct Domain {
  std::string name;
  /// What it reads of those flags of circle_patterns, and keys of a config's methods, that not
  /// every domain reads.
  std::vector<std::string> reads;
  DomainMap map;  ///< null: plane (Parameterize) and sphere (MapToSphere), which have their own
};

/// The table, one line a domain.
const std::vector<Domain>& Domains();

/// "plane, sphere, disk, ...".
std::vector<std::string> DomainNames();

/// The domain of that name; null: there is none.
const Domain* FindDomain(const std::string& name);

/// Whether some domain reads it that this one does not.
bool IsForeign(const Domain& domain, const std::string& flag);

}  // namespace cirque
