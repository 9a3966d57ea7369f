#include "cirque/energy/energy_source.h"

namespace cirque {

void EnergyData::Send(Ranks* ranks, int to) const {
  ranks->SendArray(to, std::vector<char>(objective.begin(), objective.end()));
  ranks->SendArray(to, std::vector<double>{epsilon, static_cast<double>(angles.size())});
  ranks->Send(to, angles.data(), angles.size() * sizeof(double));
  for (const auto* values : {&lower, &upper}) ranks->SendArray(to, *values);
}

EnergyData EnergyData::Receive(Ranks* ranks) {
  EnergyData data;
  const auto name = ranks->ReceiveArray<char>(0);
  data.objective.assign(name.begin(), name.end());
  const auto numbers = ranks->ReceiveArray<double>(0);
  data.epsilon = numbers[0];
  data.angles.resize(static_cast<Eigen::Index>(numbers[1]));
  ranks->Receive(0, data.angles.data(), data.angles.size() * sizeof(double));
  for (auto* values : {&data.lower, &data.upper}) *values = ranks->ReceiveArray<double>(0);
  return data;
}

Eigen::VectorXd AtHalfedges(const MeshPart& part, const Eigen::VectorXd& of_halfedges) {
  const auto faces = static_cast<Index>(part.face.size());
  Eigen::VectorXd values(3 * faces);
  for (Index f = 0; f < faces; ++f) {
    values.segment<3>(3 * f) = of_halfedges.segment<3>(3 * part.face[f]);
  }
  return values;
}

}  // namespace cirque
