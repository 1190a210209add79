// How often the program makes of a scene what it has to make once. The linker puts functions of this file in the place
// of those whose symbols are HOTTEL_COUNTED_... (tests/CMakeLists.txt), and they go on to these. When the program ends
// the counts are written to the file that HOTTEL_COUNTS names.
#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>

#include "geometry/element.h"

namespace hottel {

struct Scene2;
struct Scene3;

namespace {

struct Counts {
  std::atomic<int> validations{0}, arrangements{0}, occluders{0};
  std::array<std::atomic<int>, kGranularities> tables{};

  ~Counts() {
    const char* const file = std::getenv("HOTTEL_COUNTS");
    if (file == nullptr) return;
    std::ofstream out(file);
    out << "validations " << validations << "\narrangements " << arrangements << "\noccluders " << occluders;
    out << "\ntables of faces " << tables[0] << ", of elements " << tables[1] << ", of groups " << tables[2] << '\n';
  }
};
Counts counts;

void count_table(Granularity granularity) { ++counts.tables.at(static_cast<std::size_t>(granularity)); }

}  // namespace

void validation_2(const Scene2& scene) __asm__("__real_" HOTTEL_COUNTED_VALIDATION_2);
void counted_validation_2(const Scene2& scene) __asm__("__wrap_" HOTTEL_COUNTED_VALIDATION_2);
void counted_validation_2(const Scene2& scene) {
  ++counts.validations;
  validation_2(scene);
}

void validation_3(const Scene3& scene) __asm__("__real_" HOTTEL_COUNTED_VALIDATION_3);
void counted_validation_3(const Scene3& scene) __asm__("__wrap_" HOTTEL_COUNTED_VALIDATION_3);
void counted_validation_3(const Scene3& scene) {
  ++counts.validations;
  validation_3(scene);
}

void most_of_validation_3(const Scene3& scene) __asm__("__real_" HOTTEL_COUNTED_MOST_OF_VALIDATION_3);
void counted_most_of_validation_3(const Scene3& scene) __asm__("__wrap_" HOTTEL_COUNTED_MOST_OF_VALIDATION_3);
void counted_most_of_validation_3(const Scene3& scene) {
  ++counts.validations;
  most_of_validation_3(scene);
}

// Constructors are functions of the place of the object, and then of their arguments.
void arrangement_2(void* self, const Scene2& scene, const void* division,
                   bool conflicts) __asm__("__real_" HOTTEL_COUNTED_ARRANGEMENT_2);
void counted_arrangement_2(void* self, const Scene2& scene, const void* division,
                           bool conflicts) __asm__("__wrap_" HOTTEL_COUNTED_ARRANGEMENT_2);
void counted_arrangement_2(void* self, const Scene2& scene, const void* division, bool conflicts) {
  ++counts.arrangements;
  arrangement_2(self, scene, division, conflicts);
}

void arrangement_3(void* self, const Scene3& scene) __asm__("__real_" HOTTEL_COUNTED_ARRANGEMENT_3);
void counted_arrangement_3(void* self, const Scene3& scene) __asm__("__wrap_" HOTTEL_COUNTED_ARRANGEMENT_3);
void counted_arrangement_3(void* self, const Scene3& scene) {
  ++counts.arrangements;
  arrangement_3(self, scene);
}

void occluders_3(void* self, const void* polygons) __asm__("__real_" HOTTEL_COUNTED_OCCLUDERS_3);
void counted_occluders_3(void* self, const void* polygons) __asm__("__wrap_" HOTTEL_COUNTED_OCCLUDERS_3);
void counted_occluders_3(void* self, const void* polygons) {
  ++counts.occluders;
  occluders_3(self, polygons);
}

void table_2(void* self, const Scene2& scene, const void* arrangement, const void* division,
             Granularity granularity) __asm__("__real_" HOTTEL_COUNTED_TABLE_2);
void counted_table_2(void* self, const Scene2& scene, const void* arrangement, const void* division,
                     Granularity granularity) __asm__("__wrap_" HOTTEL_COUNTED_TABLE_2);
void counted_table_2(void* self, const Scene2& scene, const void* arrangement, const void* division,
                     Granularity granularity) {
  count_table(granularity);
  table_2(self, scene, arrangement, division, granularity);
}

void table_3(void* self, const Scene3& scene, const void* arrangement, const void* occluders,
             Granularity granularity) __asm__("__real_" HOTTEL_COUNTED_TABLE_3);
void counted_table_3(void* self, const Scene3& scene, const void* arrangement, const void* occluders,
                     Granularity granularity) __asm__("__wrap_" HOTTEL_COUNTED_TABLE_3);
void counted_table_3(void* self, const Scene3& scene, const void* arrangement, const void* occluders,
                     Granularity granularity) {
  count_table(granularity);
  table_3(self, scene, arrangement, occluders, granularity);
}

}  // namespace hottel
