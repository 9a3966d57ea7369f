#pragma once

#include <random>
#include <string>

namespace cirque::testing {

/// Overwrites, inserts, deletes or cuts at random places; new bytes prefer what means something.
std::string Mutate(std::string bytes, std::mt19937* random);

}  // namespace cirque::testing
