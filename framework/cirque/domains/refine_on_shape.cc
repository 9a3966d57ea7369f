#include "cirque/domains/refine_on_shape.h"

#include "cirque/pipeline/options.h"

namespace cirque {

std::string RefinementOnShape(const std::string& asked, const Certificate& certificate) {
  const bool misses = certificate.layout && certificate.layout->layout_closure > kAccuracy;
  return misses && asked == ParameterizeOptions().refine_map ? kRefineToRest : asked;
}

}  // namespace cirque
