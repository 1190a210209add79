// View factors that were computed elsewhere, as methods like any other: from a file, or by a command.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/name.h"
#include "io/external/external_command.h"
#include "io/external/matched_matrix.h"
#include "kernel/support/failure.h"
#include "solver/method_catalogue.h"

namespace hottel {

// Returns true for a name of the families `file` and `run`: their rows are as others made them, whatever elements are
// asked for.
bool is_external(const std::string& method);

// What follows the colon of a variant. Throws UsageError with `what` where nothing does.
std::string after_colon(std::string_view variant, const char* what);

// What a method that reads knows of itself: where from. ElementMethod: ElementMethod2 or its like in space, beside
// which prepared.elements(granularity)->elements() is there.
template <class ElementMethod, class Prepared>
class ExternalMethod : public ElementMethod {
 public:
  ExternalMethod(const std::string& family, const std::string& source)
      : info_{family + ":" + source, family, 0, Guarantee::kEstimated, source} {}
  const MethodInfo& info() const override { return info_; }
  std::optional<double> declared_error(const Prepared&) const override { return std::nullopt; }
  bool works_by_elements() const override { return false; }  // rows are read as they are asked for

 protected:
  const std::string& source() const { return info_.reference; }

 private:
  MethodInfo info_;
};

template <class ElementMethod, class Prepared>
class FromFile final : public ExternalMethod<ElementMethod, Prepared> {
 public:
  explicit FromFile(const std::string& file) : ExternalMethod<ElementMethod, Prepared>("file", file) {}
  ExchangeMatrix compute_elements(const Prepared& prepared, const std::function<void(double)>&,
                                  MethodReport& report) const override {
    return match_external_matrix(read_external_matrix(this->source()),
                                 prepared.elements(Granularity::kElement)->elements(), report);
  }
};

// A matrix that is there, called as its file is.
template <class ElementMethod, class Prepared>
class FromMatrix final : public ExternalMethod<ElementMethod, Prepared> {
 public:
  explicit FromMatrix(ExternalMatrix matrix)
      : ExternalMethod<ElementMethod, Prepared>("file", matrix.file), matrix_(std::move(matrix)) {}
  ExchangeMatrix compute_elements(const Prepared& prepared, const std::function<void(double)>&,
                                  MethodReport& report) const override {
    return match_external_matrix(matrix_, prepared.elements(Granularity::kElement)->elements(), report);
  }

 private:
  ExternalMatrix matrix_;
};

template <class ElementMethod, class Prepared>
class FromCommand final : public ExternalMethod<ElementMethod, Prepared> {
 public:
  explicit FromCommand(const std::string& command) : ExternalMethod<ElementMethod, Prepared>("run", command) {}
  ExchangeMatrix compute_elements(const Prepared& prepared, const std::function<void(double)>&,
                                  MethodReport& report) const override {
    const ScratchFolder scratch;
    const CommandRun run = run_external_command(this->source(), prepared.scene.file, scratch);
    report.seconds = run.seconds;
    try {
      return match_external_matrix(read_external_matrix(run.output),
                                   prepared.elements(Granularity::kElement)->elements(), report);
    } catch (const InputError& error) {
      throw RequestError("what the command " + quoted_name(this->source()) + " wrote cannot be used: " + error.what());
    }
  }
};

// Adds `file:PATH`, a file as in read_external_matrix, which compute() reads anew each time (MethodReport::seconds is
// nothing), and `run:CMD`, a command as in run_external_command, with Prepared::scene.file as the scene (its time is
// MethodReport::seconds; what it wrote and cannot be read is a RequestError that names the command).
template <class ElementMethod, class Prepared>
void add_external_methods(MethodCatalogue<Prepared>& methods) {
  using Made = std::unique_ptr<ExchangeMethod<Prepared>>;
  methods.add({.name = "file",
               .pattern = "file:PATH",
               .what = "read from a file: csv, Matrix Market, NumPy or View3D",
               .reference = "io/external/external_file.h",
               .guarantee = Guarantee::kEstimated,
               .sweep = {},
               .make = [](std::string_view variant) -> Made {
                 return std::make_unique<FromFile<ElementMethod, Prepared>>(
                     after_colon(variant, "the method file: needs a path, file:PATH"));
               }});
  methods.add({.name = "run",
               .pattern = "run:CMD",
               .what = "computed by a command, with {scene} and {out} in it",
               .reference = "io/external/external_command.h",
               .guarantee = Guarantee::kEstimated,
               .sweep = {},
               .make = [](std::string_view variant) -> Made {
                 return std::make_unique<FromCommand<ElementMethod, Prepared>>(
                     after_colon(variant, "the method run: needs a command, run:CMD"));
               }});
}

}  // namespace hottel
