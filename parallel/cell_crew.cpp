#include "parallel/cell_crew.h"

#include <cstdint>

#include "kernel/support/failure.h"
#include "parallel/message.h"

namespace hottel {
namespace {

class LedLight : public SharedWork<LitCells> {
 public:
  explicit LedLight(std::unique_ptr<LedWork> work) : work_(std::move(work)) {}

  WorkTurn<LitCells> next() override {
    const WorkTurn<FoundBytes> turn = work_->next();
    if (!turn.there) return {.here = turn.here};
    LitCells lit = read_lit(turn.there->bytes);
    HOTTEL_REQUIRE(lit.tasks == turn.there->tasks);
    return {.there = std::move(lit)};
  }
  void stop() override { work_->stop(); }

 private:
  std::unique_ptr<LedWork> work_;
};

}  // namespace

std::string lit_message(const LitCells& lit) {
  MessageWriter writer;
  writer.put(std::uint64_t{lit.tasks.begin}, std::uint64_t{lit.tasks.end});
  writer.put_all(lit.values);
  return writer.bytes();
}

LitCells read_lit(std::string_view bytes) {
  MessageReader reader(bytes);
  LitCells lit;
  reader.take_into(lit.tasks.begin, lit.tasks.end);
  lit.values = reader.take_all<double>();
  HOTTEL_REQUIRE(reader.is_at_end());
  return lit;
}

std::unique_ptr<SharedWork<LitCells>> led_light(std::unique_ptr<LedWork> work) {
  return std::make_unique<LedLight>(std::move(work));
}

}  // namespace hottel
