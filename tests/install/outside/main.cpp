#include <hottel.h>

#include <iostream>

int main(int, char** argv) {
  const hottel::Simulation2 simulation(hottel::read_scene_2(argv[1]));
  const auto factors = simulation.factors();
  const hottel::ExchangeMatrix& matrix = factors->matrix;
  for (std::uint32_t from = 0; from < matrix.size(); ++from)
    for (const hottel::FactorEntry& entry : matrix.row(from))
      std::cout << matrix.name(from) << " -> " << matrix.name(entry.to) << " " << entry.factor.value << "\n";
}
