// What comparing came to, as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "python/bindings/simulation.h"
#include "solver/compare/explained_pair.h"
#include "solver/compare/grid_errors.h"
#include "solver/compare/method_result.h"
#include "solver/compare/radiosity_verdict.h"
#include "solver/compare/verdict.h"
#include "solver/plane/compare/method_comparison.h"
#include "solver/space/compare/method_comparison.h"

namespace hottel::python {

using AnyComparison = std::variant<MethodComparison2, MethodComparison3>;

// One fault of a matrix of others, in words, with its evidence by name.
struct PythonFault {
  std::string kind, words;
  std::vector<std::string> parts;
  std::uint64_t explained = 0;
  std::vector<py::tuple> worst;
};

// What is wrong with a matrix of others.
struct PythonVerdict {
  Verdict verdict;
  std::vector<PythonFault> findings;
  std::vector<py::tuple> unexplained;
  std::vector<std::string> sentences;
};

// A method, or a matrix of others, beside the exact factors.
struct PythonJudgement {
  MethodResult result;
  std::vector<ExplainedPair> worst;
  std::optional<PythonVerdict> verdict;
};

// Radiosities of others beside the exact ones.
struct PythonRadiosityJudgement {
  RadiosityVerdict verdict;
  std::vector<py::tuple> worst;
  std::vector<std::string> sentences;
};

// Light of others on a grid beside the exact light.
struct PythonGridJudgement {
  std::vector<std::string> channels;
  std::vector<GridErrors> errors;  // by channel
  std::string reading;
  std::vector<std::string> sentences;
};

void add_compare_questions(py::class_<PythonSimulation>& type);

}  // namespace hottel::python
