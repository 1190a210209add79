#include "solver/plane/light/cell_crew.h"

#include "geometry/plane/prepared/element_table.h"
#include "kernel/support/failure.h"
#include "solver/plane/light/light_rows.h"
#include "solver/plane/light/sent_out.h"

namespace hottel {

struct LightOfElements2::Inside {
  std::shared_ptr<const ElementTable2> table;
  SentOut2 sent_out;
  LightRowBands2 rows;

  Inside(const PreparedScene2& prepared, std::shared_ptr<const ElementTable2> its_table,
         const RadiositySolution& solution, const Grid2& grid)
      : table(std::move(its_table)),
        sent_out(sent_out_2(*table, solution, prepared.scene)),
        rows(prepared, grid, *table, Blacks2::kLeftOut) {}
};

LightOfElements2::LightOfElements2(const PreparedScene2& prepared, Granularity granularity,
                                   const RadiositySolution& solution, const Grid2& grid)
    : inside_(std::make_unique<const Inside>(prepared, prepared.elements(granularity), solution, grid)) {}
LightOfElements2::~LightOfElements2() = default;

std::size_t LightOfElements2::bands() const { return inside_->rows.bands(); }
std::size_t LightOfElements2::first_cell(std::size_t band) const { return inside_->rows.first_cell(band); }

void LightOfElements2::light(const WorkRange& bands, std::span<double> values) const {
  const std::size_t first = first_cell(bands.begin), channels = inside_->sent_out.channels();
  HOTTEL_REQUIRE(values.size() == (first_cell(bands.end) - first) * channels);
  for (std::size_t band = bands.begin; band < bands.end; ++band)
    inside_->rows.find(band, [&](std::size_t cell, const LightRow2& row) {
      inside_->sent_out.light(row, values.subspan((cell - first) * channels, channels));
    });
}

LitCells LightOfElements2::lit(const WorkRange& bands) const {
  HOTTEL_REQUIRE(bands.begin <= bands.end && bands.end <= this->bands());
  LitCells lit{bands, {}};
  lit.values.resize((first_cell(bands.end) - first_cell(bands.begin)) * inside_->sent_out.channels());
  light(bands, lit.values);
  return lit;
}

}  // namespace hottel
