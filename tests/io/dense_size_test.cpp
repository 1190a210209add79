// The sizes that are foretold for files of all pairs, against the files.
#include <gtest/gtest.h>

#include <string>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/results/factor_files.h"
#include "io/scene/scene_json.h"

namespace hottel::dense_size_test {
namespace {

struct Written {
  std::uint64_t bytes = 0;
  Sink sink() {
    return [this](std::string_view text) { bytes += text.size(); };
  }
};

TEST(DenseSize, IsThatOfTheFile) {
  const std::string scenes = std::string(HOTTEL_SOURCE_DIR) + "/scenes/";
  for (const char* file : {"analytic/triangle_345.json", "showcase/apartment.json"})
    for (const Granularity granularity : {Granularity::kFace, Granularity::kElement, Granularity::kGroup}) {
      Scene2 scene = read_scene_2(scenes + file);
      for (std::size_t s = 0; s < scene.surfaces.size(); s += 3) scene.surfaces[s].elements = 2;
      const PreparedScene2 prepared =
          prepare(scene, granularity == Granularity::kElement ? Divided2::kYes : Divided2::kNo);
      const ExchangeMatrix matrix = exact_exchange(prepared, {.granularity = granularity});
      const FactorTable table{prepared.scene, matrix, granularity, {}, {}};
      const auto foretold = [&](FactorFormat format) { return dense_size(scene, granularity, format); };
      Written npy, binary, text, csv;
      write_factors_npy(table, npy.sink());
      EXPECT_EQ(npy.bytes, foretold(FactorFormat::kNpy).bytes) << file;
      EXPECT_EQ(foretold(FactorFormat::kNpy).rows, matrix.size() + 1) << file;
      write_factors_view3d_binary(table, binary.sink());
      EXPECT_EQ(binary.bytes, foretold(FactorFormat::kView3dBinary).bytes) << file;
      write_factors_view3d_text(table, text.sink());
      EXPECT_GE(text.bytes, foretold(FactorFormat::kView3dText).bytes) << file;
      write_dense_csv(table, DenseQuantity::kFactor, csv.sink());
      EXPECT_GE(csv.bytes, foretold(FactorFormat::kCsv).bytes) << file;
    }
}

TEST(DenseSize, DoesNotOverflow) {
  Scene2 scene;
  scene.surfaces.resize(5000);
  for (Surface& surface : scene.surfaces) surface.elements = 1'000'000;
  EXPECT_GE(dense_size(scene, Granularity::kElement, FactorFormat::kNpy).bytes, std::uint64_t{1} << 63);
}

}  // namespace
}  // namespace hottel::dense_size_test
