#include "tests/storm/lattice_scene.h"

#include <random>

#include "tests/oracle/random_scene_2.h"

namespace hottel::storm {

namespace {

bool are_on_one_line(const LatticeEdge& e, const LatticeEdge& f) {
  const auto turn = [&](long x, long y) { return (e.bx - e.ax) * (y - e.ay) - (e.by - e.ay) * (x - e.ax); };
  return turn(f.ax, f.ay) == 0 && turn(f.bx, f.by) == 0;
}

}  // namespace

LatticeScene lattice_scene(std::uint64_t number, int k) {
  std::mt19937_64 random(number * 1009 + static_cast<std::uint64_t>(k));
  const auto below = [&](int count) { return static_cast<long>(random() % static_cast<std::uint64_t>(count)); };
  LatticeScene scene;
  scene.number = number;
  scene.k = k;
  if (number % 3 == 0) scene.lattice = {{0, 0, 0, k}, {0, k, k, k}, {k, k, k, 0}, {k, 0, 0, 0}};
  const std::size_t count = scene.lattice.size() + 3 + static_cast<std::size_t>(below(2 * k + 1));
  while (scene.lattice.size() < count) {
    // One in eight lies on the line of another.
    const bool is_on_line = !scene.lattice.empty() && below(8) == 0;
    const LatticeEdge* other =
        is_on_line ? &scene.lattice[static_cast<std::size_t>(below(static_cast<int>(scene.lattice.size())))] : nullptr;
    LatticeEdge edge{};
    do edge = {below(k + 1), below(k + 1), below(k + 1), below(k + 1)};
    while ((edge.ax == edge.bx && edge.ay == edge.by) || (other && !are_on_one_line(*other, edge)));
    scene.lattice.push_back(edge);
  }
  for (const LatticeEdge& edge : scene.lattice)
    scene.edges.push_back(
        {edge.ax, edge.ay, edge.bx, edge.by, static_cast<int>(below(3)), static_cast<int>(below(4)) - 1});
  oracle::settle_conflicts(scene.edges);
  return scene;
}

}  // namespace hottel::storm
