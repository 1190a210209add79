#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/near_names.h"
#include "geometry/plane/generate/generators.h"
#include "geometry/space/generate/generators.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"
#include "python/bindings/numbers.h"
#include "python/bindings/scene.h"

namespace hottel::python {
namespace {

// What is asked for, by names of options of the program.
struct GenerateKeywords {
  std::optional<std::uint64_t> n, k;
  std::uint64_t seed = 0;
  std::optional<std::string> view;
  std::optional<Rational> length;
  std::optional<int> digits;
  bool bottoms = true;
};

const GeneratorKind3* kind_in_space(const std::string& name) {
  const auto& kinds = generator_kinds_3();
  const auto kind = std::ranges::find(kinds, name, &GeneratorKind3::name);
  return kind == kinds.end() ? nullptr : &*kind;
}

void require_kind(const std::string& name) {
  std::vector<std::string> kinds;
  for (const GeneratorKind2& kind : generator_kinds_2()) kinds.push_back(kind.name);
  for (const GeneratorKind3& kind : generator_kinds_3()) kinds.push_back(kind.name);
  if (std::ranges::find(kinds, name) != kinds.end()) return;
  std::string all;
  for (const std::string& kind : kinds) all += (all.empty() ? "" : ", ") + kind;
  throw UnknownName("there is no kind of scene called '" + name + "'; the kinds are " + all, name, kinds);
}

GeneratorRequest2 request_of(const std::string& kind, const GenerateKeywords& asked) {
  GeneratorRequest2 request;
  request.kind = kind;
  request.n = asked.n.value_or(request.n);
  request.seed = asked.seed;
  request.digits = asked.digits.value_or(0);
  request.k = asked.k.value_or(0);
  if (!asked.bottoms) throw UsageError("bottoms are for kinds in space only");
  if (kind != "clutter" && (asked.view || asked.length)) throw UsageError("view and length are for clutter only");
  if (kind != "lattice" && asked.k) throw UsageError("k is for lattice only");
  if (asked.view && asked.length) throw UsageError("view and length exclude each other");
  if (asked.view && *asked.view != "short" && *asked.view != "long")
    throw UsageError("view is 'short' or 'long', not '" + *asked.view + "'");
  if (asked.view) request.length = *asked.view == "short" ? kShortView : kLongView;
  if (asked.length) request.length = *asked.length;
  return request;
}

ValidScene generated(const std::string& name, const GenerateKeywords& asked) {
  const GeneratorKind3* const kind = kind_in_space(name);
  if (kind == nullptr) return generate_2(request_of(name, asked));
  if (asked.digits || asked.view || asked.length || asked.k)
    throw UsageError("digits, view, length and k: kinds in space have no such option");
  return generate_3({name, asked.n.value_or(kind->usual_n), asked.seed, asked.bottoms});
}

PythonScene generate(const std::string& kind, std::optional<std::uint64_t> n, std::uint64_t seed,
                     std::optional<int> digits, std::optional<std::uint64_t> k, std::optional<std::string> view,
                     const py::object& length, bool bottoms) {
  require_kind(kind);
  GenerateKeywords asked{n, k, seed, std::move(view), std::nullopt, digits, bottoms};
  if (!length.is_none()) asked.length = rational_of(length, false, "length");
  const py::gil_scoped_release released;
  return PythonScene(generated(kind, asked));
}

}  // namespace

void add_generate(py::module_& module) {
  module.def(
      "generate", &generate, py::arg("kind"), py::arg("n") = py::none(), py::arg("seed") = 0, py::kw_only(),
      py::arg("digits") = py::none(), py::arg("k") = py::none(), py::arg("view") = py::none(),
      py::arg("length") = py::none(), py::arg("bottoms") = true,
      "Returns a scene made to order, Scene: seeded, the same on every machine, as `hottel generate` makes it.\n\n"
      "kind: a str, 'room', 'clutter', ..., in space 'room-boxes', 'town', ...; docs/generate.md has all. n: of\n"
      "edges, in space as the kind says. digits: significant ones of every coordinate. view ('short', 'long') "
      "or\nlength: of clutter. k: of lattice. bottoms: whether boxes have faces where they stand. UsageError "
      "for what\nthere is not, and for what is out of range.\n\n"
      ">>> town = hottel.generate(\"town\", n=2, seed=1)\n"
      ">>> town.dimension, town == hottel.generate(\"town\", n=2, seed=1)\n"
      "(3, True)\n");
}

}  // namespace hottel::python
