#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "cirque/energy/energy.h"
#include "cirque/energy/energy_source.h"

namespace cirque {

/// The energy of a part; both arguments outlive it.
using EnergyPartMaker = std::function<std::unique_ptr<Energy>(const Triangulation& triangulation,
                                                              const EnergyData& data)>;

/// By the works of their sources, one line an entry.
const std::map<std::string, EnergyPartMaker>& EnergyPartMakers();

}  // namespace cirque
