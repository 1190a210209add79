// Drives hard cases in space into their degeneracy, over thirty orders of magnitude, and writes
// docs/hard_cases_in_space.md: the error of the exact method and of all others, against factors of 60 digits.
//
//   report_hard_cases_in_space FOLDER      FOLDER/hard_cases_in_space.md, .csv, FOLDER/images/hard_case_in_space_*.png
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "benchmarks/reports/space/hard_scenes.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/space/methods/method_catalogue.h"
#include "viewer/picture/log_plot.h"

namespace hottel {
namespace {

struct Contender {
  std::string label, method;
  double tolerance = 1e-9;
};
const std::vector<Contender> kContenders = {{"exact", "exact"},
                                            {"exact, tolerance 1e-14", "exact", 1e-14},
                                            {"center", "center"},
                                            {"center-vis", "center-vis"},
                                            {"vertices", "vertices"},
                                            {"gauss:4", "gauss:4"},
                                            {"points:4", "points:4"},
                                            {"hemicube:256", "hemicube:256"},
                                            {"rays:16384:sobol", "rays:16384:sobol"}};
constexpr double kBroken = 1e-6;       // a relative error that nobody would call a rounding error
constexpr double kLargestDrawn = 1e3;  // of relative errors

// One factor by one method. Nothing of it (NaN) where the method refuses the scene.
struct Found {
  double value = std::numeric_limits<double>::quiet_NaN();
  HardErrors errors{};
  bool is_refused = true, is_held = false;  // held: the factor is within proven bounds and the tolerance, and not lost
};

struct Curve {
  Contender contender;
  std::vector<Found> found;  // by decade, from the first
};

struct Result {
  const HardScene3* scene;
  std::vector<Curve> curves;
};

Found measured(const HardScene3& scene, const PreparedScene3& prepared, const Contender& contender,
               const LongReal& factor) {
  static const MethodCatalogue3 methods = methods_3();
  Found found;
  try {
    MethodReport report;
    const ExchangeRequest request{
        .granularity = scene.granularity, .wants_visibility = false, .tolerance = contender.tolerance};
    const ExchangeMatrix matrix = methods.make(contender.method)->compute(prepared, request, report);
    const std::uint32_t from = matrix.find(scene.from).value(), to = matrix.find(scene.to).value();
    found.is_refused = false;
    found.value = matrix.factor(from, to).value;
    found.errors = hard_errors(found.value, factor);
    for (std::size_t k = 0; k < matrix.row(from).size(); ++k) {
      if (matrix.row(from)[k].to != to) continue;
      const Enclosure bounds = matrix.bounds(from, k);
      found.is_held = LongReal(bounds.lower) <= factor && factor <= LongReal(bounds.upper) &&
                      found.errors.absolute <= contender.tolerance;
    }
  } catch (const RequestError&) {
  }
  return found;
}

Result sweep(const HardScene3& scene) {
  Result result{&scene, {}};
  for (const Contender& contender : kContenders) result.curves.push_back({contender, {}});
  for (int k = 1; k <= kHardDecades; ++k) {
    const Rational d = hard_parameter(scene, k);
    const PreparedScene3 prepared = prepare(parse_scene_3(hard_scene_json(scene, d), scene.name));
    const LongReal factor = scene.factor(d);
    for (Curve& curve : result.curves) curve.found.push_back(measured(scene, prepared, curve.contender, factor));
  }
  return result;
}

std::string decade(const HardScene3& scene, std::size_t index) {
  return fmt::format("1e{}", scene.direction * static_cast<int>(index + 1));
}

LogPlot plot_of(const Result& result) {
  LogPlot plot;
  plot.width = 1200;
  plot.height = 640;
  plot.title = result.scene->title;
  plot.subtitle = result.scene->closed_form;
  plot.x_title = "d";
  plot.y_title = "relative error of the view factor";
  for (const Curve& curve : result.curves) {
    LogPlotCurve drawn{curve.contender.label, {}};
    for (std::size_t k = 0; k < curve.found.size(); ++k) {
      if (!curve.found[k].is_refused)
        drawn.points.push_back({std::pow(10, result.scene->direction * static_cast<double>(k + 1)),
                                std::min(curve.found[k].errors.relative, kLargestDrawn)});
    }
    plot.curves.push_back(drawn);
  }
  return plot;
}

std::string row_of(const Result& result, const Curve& curve) {
  double relative = 0, absolute = 0;
  std::string broken = "never";
  for (std::size_t k = curve.found.size(); k-- > 0;) {
    const Found& found = curve.found[k];
    if (found.is_refused) continue;
    relative = std::max(relative, found.errors.relative);
    absolute = std::max(absolute, found.errors.absolute);
    if (found.errors.relative > kBroken) broken = "d = " + decade(*result.scene, k);
  }
  return fmt::format("| `{}` | {:.1e} | {:.1e} | {} |\n", curve.contender.label, absolute, relative, broken);
}

// "1e1 to 1e3 and 1e7"
std::string decades_where(const Result& result, const Curve& curve, bool (*is_so)(const Found&)) {
  std::string text;
  for (std::size_t k = 0; k < curve.found.size(); ++k) {
    if (!is_so(curve.found[k])) continue;
    const std::size_t first = k;
    while (k + 1 < curve.found.size() && is_so(curve.found[k + 1])) ++k;
    text += (text.empty() ? "" : " and ") + decade(*result.scene, first);
    if (k > first) text += " to " + decade(*result.scene, k);
  }
  return text;
}

// What became of the exact method's promises.
std::string promises_of(const Result& result) {
  std::string text;
  for (const Curve& curve : result.curves) {
    if (curve.contender.method != "exact") continue;
    const std::string refused = decades_where(result, curve, [](const Found& found) { return found.is_refused; });
    const std::string missed =
        decades_where(result, curve, [](const Found& found) { return !found.is_refused && !found.is_held; });
    text += fmt::format("`{}`: {}", curve.contender.label,
                        missed.empty() ? "holds what it promises" : "MISSES what it promises at d = " + missed);
    text +=
        refused.empty() ? " at every d. " : fmt::format(" wherever it answers; refused by name at d = {}. ", refused);
  }
  text.pop_back();
  return text;
}

constexpr const char* kIntroduction = R"(# Hard cases in space

As [those of the plane](hard_cases.md): each case has a parameter d that drives it into its degeneracy, from 10⁻¹ to 10⁻³¹ (or
from 10 to 10³¹), and one view factor that is known independently of hottel to 60 digits: by counting lines (what two rooms
exchange through a gap is the area of the gap), or by the contour integral in closed form at 150 digits
([how](../benchmarks/reports/space/contour_measure.h)). The curves are the relative error of that factor; 1 means that nothing
of it was found, larger errors are drawn at 1000. [What the methods do](design/space/approximate_methods.md).

**In space the exact method promises other things than in the plane.** That a pair exchanges anything at all is decided by
signs, at any d. Its number is within the tolerance, which is a fraction of the smaller area (1e-9, or what `--tolerance`
says), and within proven bounds. So factors that are small themselves lose digits: they are never lost, but of a factor of
1e-20 the estimate tells no more than that it is not zero and below 1e-16. The tables tell the largest error, absolute and
relative, and above them stands whether the promises hold at every d.

This page and its pictures are made by `tools/hard_cases`; the numbers are in
[hard_cases_in_space.csv](hard_cases_in_space.csv).

)";

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.finish();
  file.commit();
}

int run(const std::filesystem::path& folder) {
  std::string page = kIntroduction, csv = "case,parameter,method,value,absolute_error,relative_error,held\n";
  for (const HardScene3& scene : hard_scenes_3()) {
    const Result result = sweep(scene);
    const std::string picture = "images/hard_case_in_space_" + scene.name + ".png";
    write_file(folder / picture, log_plot(plot_of(result), PictureFormat::kPng));
    page += fmt::format("## {}\n\n{}\n\n    {}\n\n![{}]({})\n\n{}\n\n", scene.title, scene.story, scene.closed_form,
                        scene.title, picture, promises_of(result));
    page += fmt::format(
        "| method | largest error | largest relative error | relative error above {:.0e} from |\n"
        "|---|--:|--:|---|\n",
        kBroken);
    for (const Curve& curve : result.curves) {
      page += row_of(result, curve);
      for (std::size_t k = 0; k < curve.found.size(); ++k) {
        const Found& found = curve.found[k];
        csv += fmt::format("{},{},\"{}\",{},{},{},{}\n", scene.name, decade(scene, k), curve.contender.label,
                           found.is_refused ? "refused" : shortest(found.value),
                           found.is_refused ? "" : shortest(found.errors.absolute),
                           found.is_refused ? "" : shortest(found.errors.relative),
                           curve.contender.method != "exact" || found.is_refused ? ""
                           : found.is_held                                       ? "yes"
                                                                                 : "no");
      }
    }
    page += "\n";
    std::printf("%s\n", scene.name.c_str());
    std::fflush(stdout);
  }
  page.pop_back();
  write_file(folder / "hard_cases_in_space.csv", csv);
  write_file(folder / "hard_cases_in_space.md", page);
  return 0;
}

}  // namespace
}  // namespace hottel

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "report_hard_cases_in_space FOLDER\n");
    return 2;
  }
  try {
    return hottel::run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "report_hard_cases_in_space: %s\n", error.what());
    return 1;
  }
}
