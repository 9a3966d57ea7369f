#include "experiments/circle_patterns/measures.h"

namespace cirque {

Status WriteMeasures(const CirclePatternsJob& job, const Triangulation& t,
                     const EdgeLengths& lengths, const CornerUv& uv,
                     const std::vector<Eigen::Vector3d>& position, const std::vector<Index>& corner,
                     std::ostream& report) {
  if (job.measures.empty()) return Status();
  const MapMeasures measures = MeasureMap(t, lengths, uv);
  if (Status s = WriteMeasureFiles(job.measures, position, corner, measures); !s.ok()) return s;
  for (const MeasureFile& file : job.measures) report << "measures    " << file.path << "\n";
  return Status();
}

}  // namespace cirque
