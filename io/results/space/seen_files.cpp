#include "io/results/space/seen_files.h"

#include <numbers>
#include <utility>

#include "geometry/scene_names.h"
#include "io/results/csv_field.h"
#include "io/results/space/seen_npz.h"
#include "io/results/space/seen_shares.h"
#include "io/results/space/seen_vtu.h"

namespace hottel {
namespace {

class SeenCsv final : public SeenWriter3 {
 public:
  SeenCsv(const SeenFileOptions3& options, std::function<void(std::string_view)> sink)
      : scene_(options.scene), sink_(std::move(sink)) {
    sink_(options.has_bounds ? "point,x,y,z,face,fraction,lower,upper,solid_angle\n"
                             : "point,x,y,z,face,fraction,solid_angle\n");
  }

  void add(const SeenByPoint3& seen) override {
    const std::string begin = begin_of(seen.eye);
    std::string text;
    if (!seen.solid)
      for_each_seen(seen, [&](const std::optional<Face>& face, double fraction, const Enclosure* bounds) {
        text += begin + (face ? csv_field(face_name(scene_, *face)) : "sky") + "," + shortest(fraction);
        if (bounds) text += "," + shortest(bounds->lower) + "," + shortest(bounds->upper);
        text += "," + shortest(solid_angle_of(fraction)) + "\n";
      });
    sink_(text);
    ++points_;
  }

  void finish() override {}

 private:
  std::string begin_of(const Point3& eye) const {
    std::string text = std::to_string(points_) + ",";
    for (const double x : to_doubles(eye)) text += shortest(x) + ",";
    return text;
  }

  const Scene3& scene_;
  std::function<void(std::string_view)> sink_;
  std::size_t points_ = 0;
};

}  // namespace

std::optional<SeenFormat3> seen_format_3(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".csv") return SeenFormat3::kCsv;
  if (ending == ".npz") return SeenFormat3::kNpz;
  if (ending == ".vtu") return SeenFormat3::kVtu;
  return std::nullopt;
}

std::unique_ptr<SeenWriter3> seen_writer_3(SeenFormat3 format, const SeenFileOptions3& options,
                                           std::function<void(std::string_view)> sink) {
  if (format == SeenFormat3::kNpz) return seen_npz_writer(options, std::move(sink));
  if (format == SeenFormat3::kVtu) return seen_vtu_writer(options, std::move(sink));
  return std::make_unique<SeenCsv>(options, std::move(sink));
}

}  // namespace hottel
