#include "solver/plane/light/light_columns.h"

#include "kernel/support/failure.h"

namespace hottel {

LightColumns2::LightColumns2(const Arrangement2& arrangement, const ElementTable2& table) : sky_(table.sky()) {
  HOTTEL_REQUIRE(table.covered() < Code::kBlack);
  of_side_.resize(arrangement.side_count() + 1);
  of_side_[place_after_sky(kSky)].bits_ = sky_;
  for (const PieceSideId side : arrangement.sides()) {
    const std::uint32_t label = table.of(side);
    if (label == table.covered()) continue;
    of_side_[place_after_sky(side)].bits_ = label | (table.elements()[label].material ? 0 : Code::kBlack);
  }
}

}  // namespace hottel
