#include "cirque/domains/refine_on_shape.h"

#include "cirque/pipeline/certificate.h"
#include "cirque/pipeline/options.h"

namespace cirque {

std::string RefinementOnShape(const std::string& asked, double layout_closure) {
  return layout_closure > kAccuracy && asked == ParameterizeOptions().refine_map ? kRefineToRest
                                                                                 : asked;
}

}  // namespace cirque
