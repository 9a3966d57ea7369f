#pragma once

#include <cstddef>
#include <string>

namespace cirque {

/// "1 triangle", "3 triangles", "2 vertices", "2 patches": how many there are, in a message's words.
/// The last word of `singular` must form its plural by s, or by es after ch, or be "vertex".
std::string Count(std::size_t number, const std::string& singular);

}  // namespace cirque
