#include "tests/storm/space/room_storm.h"

#include <fmt/core.h>

#include "io/scene/scene_json.h"
#include "tests/storm/crash_notice.h"

namespace hottel::storm {

namespace {

struct FurnishedRooms {
  using Law = RoomLaw3;
  using Subject = RoomSubject3;
  using Scene = SolidBodies3;
  using Result = RoomStormResult3;
  struct Made {
    FurnishedRoom3 room;
    const SolidBodies3& scene = room.bodies;
  };

  static int lattice(std::uint64_t, const StormOptions&) { return CrashNotice::kRooms; }
  static Made make(std::uint64_t number, const StormOptions&) { return {furnished_room_3(number)}; }
  static bool is_asked(const Law& law, const Subject& subject) {
    return !subject.is_disputed() && (law.takes_unmeasured || subject.is_measured());
  }
  static void note(const Subject& subject, Result& result) { result.disputed += subject.is_disputed() ? 1 : 0; }
  static void count(const Made& made, Result& result) {
    for (const SolidBody3& body : made.scene) result.parts += body.faces.size();
    ++result.numbers[static_cast<std::size_t>(made.room.numbers)];
  }
  template <class Fails>
  static Scene shrunk(const Scene& scene, const Fails& fails) {
    return shrunk_room_3(scene, fails);
  }
};

}  // namespace

void RoomStormResult3::add(const RoomStormResult3& other) {
  LawResult::add(other);
  for (std::size_t n = 0; n < kRoomNumbers3; ++n) numbers[n] += other.numbers[n];
  disputed += other.disputed;
}

std::string room_text_3(std::uint64_t number) {
  Scene3 scene = to_scene_3(furnished_room_3(number).bodies);
  scene.about = fmt::format("Scene {} of the storm of rooms.", number);
  return write_scene_3(scene);
}

RoomStormResult3 run_room_storm_3(const StormOptions& options, const std::vector<RoomLaw3>& which) {
  return run_laws<FurnishedRooms>(options, which);
}

std::string report(const RoomStormResult3& result, const std::vector<RoomLaw3>& which) {
  std::string text = result.text(names_of(which), "polygons");
  for (std::size_t n = 0; n < kRoomNumbers3; ++n)
    text += fmt::format("{:24} {:>12}\n", to_string(static_cast<RoomNumbers3>(n)), result.numbers[n]);
  text += fmt::format("{:24} {:>12}\n", "two materials", result.disputed);
  for (const Failed<SolidBodies3>& failure : result.examples) {
    Scene3 scene = to_scene_3(failure.scene);
    scene.about = fmt::format("Scene {} of the storm of rooms: {}.", failure.number, failure.law);
    text += fmt::format("\nscene {} breaks {}:\n{}{}", failure.number, failure.law, failure.what, write_scene_3(scene));
  }
  return text;
}

}  // namespace hottel::storm
