#include "io/foreign/plane/foreign_matrix.h"

#include "geometry/name.h"
#include "geometry/plane/exchange/element_table.h"
#include "io/foreign/foreign_command.h"
#include "io/foreign/matched_matrix.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// What a method that reads knows of itself: where from.
class Foreign2 : public ElementMethod2 {
 public:
  Foreign2(const std::string& family, const std::string& source)
      : info_{family + ":" + source, family, 0, Guarantee::kEstimated, source} {}
  const MethodInfo& info() const override { return info_; }
  std::optional<double> declared_error(const PreparedScene2&) const override { return std::nullopt; }
  bool works_by_elements() const override { return false; }  // rows are read as they are asked for

 protected:
  const std::string& source() const { return info_.reference; }

 private:
  MethodInfo info_;
};

class FromFile2 final : public Foreign2 {
 public:
  explicit FromFile2(const std::string& file) : Foreign2("file", file) {}
  ExchangeMatrix compute_elements(const PreparedScene2& prepared, const std::function<void(double)>&,
                                  MethodReport& report) const override {
    return match_foreign_matrix(read_foreign_matrix(source()), elements_of(prepared, Granularity::kElement), report);
  }
};

class FromCommand2 final : public Foreign2 {
 public:
  explicit FromCommand2(const std::string& command) : Foreign2("run", command) {}
  ExchangeMatrix compute_elements(const PreparedScene2& prepared, const std::function<void(double)>&,
                                  MethodReport& report) const override {
    const ScratchFolder scratch;
    const CommandRun run = run_foreign_command(source(), prepared.scene.file, scratch);
    report.seconds = run.seconds;
    try {
      return match_foreign_matrix(read_foreign_matrix(run.output), elements_of(prepared, Granularity::kElement),
                                  report);
    } catch (const InputError& error) {
      throw RequestError("what the command " + quoted_name(source()) + " wrote cannot be used: " + error.what());
    }
  }
};

std::string after_colon(std::string_view variant, const char* what) {
  if (variant.size() < 2) throw UsageError(what);
  return std::string(variant.substr(1));
}

}  // namespace

MethodFamily2 file_family_2() {
  return {.name = "file",
          .pattern = "file:PATH",
          .what = "read from a file: csv, Matrix Market, NumPy or View3D",
          .reference = "io/foreign/foreign_file.h",
          .guarantee = Guarantee::kEstimated,
          .sweep = {},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod2> {
            return std::make_unique<FromFile2>(after_colon(variant, "the method file: needs a path, file:PATH"));
          }};
}

MethodFamily2 run_family_2() {
  return {.name = "run",
          .pattern = "run:CMD",
          .what = "computed by a command, with {scene} and {out} in it",
          .reference = "io/foreign/foreign_command.h",
          .guarantee = Guarantee::kEstimated,
          .sweep = {},
          .make = [](std::string_view variant) -> std::unique_ptr<ExchangeMethod2> {
            return std::make_unique<FromCommand2>(after_colon(variant, "the method run: needs a command, run:CMD"));
          }};
}

bool is_foreign_2(const std::string& method) {
  const std::string family = family_of_method(method);
  return family == "file" || family == "run";
}

MethodCatalogue2 all_methods_2() {
  MethodCatalogue2 methods = methods_2();
  methods.add(file_family_2());
  methods.add(run_family_2());
  return methods;
}

}  // namespace hottel
