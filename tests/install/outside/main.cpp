#include <hottel.h>

#include <iostream>

int main(int, char** argv) {
  const hottel::PreparedScene2 scene = hottel::prepare(hottel::read_scene_2(argv[1]));
  const hottel::ExchangeMatrix factors = hottel::exact_exchange(scene);
  for (std::uint32_t from = 0; from < factors.size(); ++from)
    for (const hottel::FactorEntry& entry : factors.row(from))
      std::cout << factors.elements()[from].name << " -> " << factors.elements().at(entry.to).name << " "
                << entry.factor.value << "\n";
}
