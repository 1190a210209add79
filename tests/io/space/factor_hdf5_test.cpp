// View factors of space as an HDF5 file.
#include "io/results/factor_hdf5.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/space/exchange/exchange.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/files/text_file.h"
#include "io/scene/scene_json.h"
#include "tests/io/listed_in_hdf5.h"
#include "tests/temporary_folder.h"

namespace hottel::space_factor_hdf5_test {
namespace {

#ifdef HOTTEL_HDF5

TEST(SpaceFactorHdf5, HasBounds) {
  const TemporaryFolder folder;
  const PreparedScene3 prepared =
      prepare(read_scene_3(std::string(HOTTEL_SOURCE_DIR) + "/scenes/space/two_boxes.json"));
  const ExchangeMatrix matrix = exact_exchange(prepared, {.tolerance = 1e-6});
  const FactorTable table{prepared.scene, matrix};
  OutputFile out(folder / "f.h5");
  write_factors_hdf5(table, {3, "exact", ""}, out);
  out.commit();
  const std::string bytes = read_text_file(folder / "f.h5");
  expect_as_listed(bytes, table);
  EXPECT_TRUE(Hdf5Reader("f.h5", bytes).has("upper"));
  EXPECT_EQ(Hdf5Reader("f.h5", bytes).said_text("area_unit"), "m²");
}

#endif

}  // namespace
}  // namespace hottel::space_factor_hdf5_test
