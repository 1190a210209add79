#include "python/bindings/factors.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "kernel/support/failure.h"
#include "kernel/support/memory.h"
#include "kernel/support/out_of_memory.h"
#include "python/bindings/bindings.h"

namespace hottel::python {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Take = double (*)(const ExchangeMatrix&, std::uint32_t, std::size_t);

Take taking(const std::string& quantity) {
  if (quantity == "factor")
    return [](const ExchangeMatrix& m, std::uint32_t i, std::size_t k) { return m.row(i)[k].factor.value; };
  if (quantity == "lower")
    return [](const ExchangeMatrix& m, std::uint32_t i, std::size_t k) { return m.bounds(i, k).lower; };
  if (quantity == "upper")
    return [](const ExchangeMatrix& m, std::uint32_t i, std::size_t k) { return m.bounds(i, k).upper; };
  if (quantity == "visibility")
    return [](const ExchangeMatrix& m, std::uint32_t i, std::size_t k) { return m.row(i)[k].visibility; };
  throw UsageError("there is 'factor', 'lower', 'upper' and 'visibility', not '" + quantity + "'");
}

// What stands where a pair has no entry.
double without_entry(const std::string& quantity, bool proves_zeros) {
  if (quantity == "visibility") return kNan;
  return quantity == "upper" && !proves_zeros ? 1 : 0;
}

std::vector<std::string> names_of(const ExchangeMatrix& matrix) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i <= matrix.sky(); ++i) names.push_back(matrix.name(i));
  return names;
}

}  // namespace

const MatrixWithVisibility& PythonFactors::visibility() const {
  if (!visibility_) visibility_ = with_visibility_();
  return *visibility_;
}

const std::shared_ptr<const ExchangeMatrix>& PythonFactors::matrix_with(const std::string& quantity) const {
  return quantity == "visibility" ? visibility().matrix : matrix_;
}

py::array PythonFactors::entries(const std::string& quantity) const {
  const Take take = taking(quantity);
  const std::shared_ptr<const ExchangeMatrix> matrix = matrix_with(quantity);
  if (quantity == "factor") return shared(matrix->factors(), matrix);
  if (quantity == "visibility") return shared(matrix->visibilities(), matrix);
  const py::str key(quantity);
  if (!bounds_.contains(key)) {
    std::vector<double> values;
    {
      const py::gil_scoped_release released;
      values.reserve(matrix->entry_count());
      for (std::uint32_t i = 0; i < matrix->size(); ++i)
        for (std::size_t k = 0; k < matrix->row(i).size(); ++k) values.push_back(take(*matrix, i, k));
    }
    bounds_[key] = frozen(std::move(values));
  }
  return bounds_[key];
}

namespace {

// The beginnings of rows, with that of the sky's and the end.
template <class T>
py::array beginnings(const ExchangeMatrix& matrix) {
  std::vector<T> result;
  result.reserve(matrix.begins().size() + 1);
  for (const std::size_t begin : matrix.begins()) result.push_back(static_cast<T>(begin));
  result.push_back(static_cast<T>(matrix.entry_count()));
  return frozen(std::move(result));
}

}  // namespace

std::pair<py::array, py::array> PythonFactors::places() const {
  const std::span<const std::uint32_t> columns = matrix_->columns();
  // A matrix of scipy has one type for both. Columns below 2^31 are the same numbers with a sign.
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (matrix_->entry_count() <= kMost && matrix_->size() < kMost)
    return {beginnings<std::int32_t>(*matrix_),
            shared(std::span(reinterpret_cast<const std::int32_t*>(columns.data()), columns.size()), matrix_)};
  return {beginnings<std::int64_t>(*matrix_), frozen(std::vector<std::int64_t>(columns.begin(), columns.end()))};
}

std::vector<double> PythonFactors::dense_values(const std::string& quantity) const {
  const Take take = taking(quantity);
  const bool is_visibility = quantity == "visibility";
  const ExchangeMatrix& matrix = *matrix_with(quantity);
  const std::size_t n = matrix.size() + std::size_t{1};
  if (n * n > memory_allowed() / sizeof(double)) throw OutOfMemory("a dense matrix");
  const py::gil_scoped_release released;
  std::vector<double> values(n * n, is_visibility ? kNan : 0);
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    double* const row = values.data() + i * n;
    if (matrix.has_row(i)) std::fill(row, row + n, without_entry(quantity, proves_zeros_));
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) row[matrix.row(i)[k].to] = take(matrix, i, k);
  }
  if (is_visibility)
    for (const auto& [from, to] : visibility_->hidden) values[from * n + to] = 0;
  return values;
}

py::array PythonFactors::dense(const std::string& quantity) const {
  if (!dense_.contains(quantity)) {
    const auto n = static_cast<py::ssize_t>(matrix_->size()) + 1;
    dense_[py::str(quantity)] = frozen(dense_values(quantity), {n, n});
  }
  return dense_[py::str(quantity)];
}

namespace {

// The double nearest to the area of each row, NaN for the sky.
py::array areas_of(const PythonFactors& factors) {
  std::vector<double> areas;
  for (const Element& element : factors.matrix().elements()) areas.push_back(element.area.value);
  areas.push_back(kNan);
  return frozen(std::move(areas));
}

// Where rows begin, columns, and a quantity.
py::tuple arrays_of(const PythonFactors& factors, const std::string& quantity) {
  const py::array values = factors.entries(quantity);
  const auto [begins, columns] = factors.places();
  return py::make_tuple(begins, columns, values);
}

py::object sparse(const PythonFactors& factors, const std::string& quantity, bool copy) {
  const py::tuple arrays = arrays_of(factors, quantity);
  const std::size_t n = factors.matrix().size() + std::size_t{1};
  return py::module_::import("scipy.sparse")
      .attr("csr_matrix")(py::make_tuple(arrays[2], arrays[1], arrays[0]), py::arg("shape") = py::make_tuple(n, n),
                          py::arg("copy") = copy);
}

// The place and the row of a name; UsageError where it has none.
std::uint32_t row_called(const ExchangeMatrix& matrix, const std::string& name) {
  const std::uint32_t row = require_element(matrix, name);
  if (row == matrix.sky() || !matrix.has_row(row))
    throw UsageError("'" + name + "' has no row: it is the sky, or has no material or no area");
  return row;
}

py::dict pair(const PythonFactors& factors, const std::pair<std::string, std::string>& names) {
  const ExchangeMatrix& matrix = factors.matrix();
  const std::uint32_t i = row_called(matrix, names.first), j = require_element(matrix, names.second);
  py::dict result;
  double value = 0;
  Enclosure bounds{0, factors.proves_zeros() ? 0.0 : 1.0};
  Guarantee guarantee = factors.proves_zeros() ? Guarantee::kExact : Guarantee::kEstimated;
  const auto row = matrix.row(i);
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k].to != j) continue;
    value = row[k].factor.value;
    bounds = matrix.bounds(i, k);
    guarantee = matrix.guarantee(i, k);
  }
  result["factor"] = value;
  result["lower"] = bounds.lower;
  result["upper"] = bounds.upper;
  result["guarantee"] = to_string(guarantee);
  return result;
}

py::tuple seen_by(const PythonFactors& factors, const std::string& from) {
  const ExchangeMatrix& matrix = factors.matrix();
  std::vector<std::string> names;
  for (const FactorEntry& entry : matrix.row(row_called(matrix, from))) names.push_back(matrix.name(entry.to));
  return tuple_of(names);
}

py::tuple seeing(const PythonFactors& factors, const std::string& to) {
  const ExchangeMatrix& matrix = factors.matrix();
  const std::uint32_t j = require_element(matrix, to);
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i))
      for (const FactorEntry& entry : matrix.row(i))
        if (entry.to == j) names.push_back(matrix.name(i));
  return tuple_of(names);
}

// The columns of `hottel factors`, a line a pair.
py::dict columns_of(const PythonFactors& factors) {
  const ExchangeMatrix& matrix = factors.matrix();
  py::list from, to, guarantees;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      from.append(matrix.name(i));
      to.append(matrix.name(matrix.row(i)[k].to));
      guarantees.append(to_string(matrix.guarantee(i, k)));
    }
  py::dict columns;
  columns["from"] = from;
  columns["to"] = to;
  for (const char* quantity : {"factor", "lower", "upper"}) columns[quantity] = factors.entries(quantity);
  columns["guarantee"] = guarantees;
  return columns;
}

std::string short_text(const PythonFactors& factors) {
  const ExchangeMatrix& matrix = factors.matrix();
  return "<hottel.Factors of " + std::to_string(matrix.size()) + " faces and the sky, " +
         std::to_string(matrix.entry_count()) + " that are not 0, " + to_string(matrix.guarantee()) + ">";
}

void add_arrays(py::class_<PythonFactors>& type) {
  const auto dense = [&type](const char* name, const char* quantity, const char* doc) {
    type.def_property_readonly(
        name, [quantity](const PythonFactors& factors) { return factors.dense(quantity); }, doc);
  };
  dense("factors", "factor",
        "View factors, float64 of shape (n, n), n as len(names): row from, column to, the sky last. 0 in the rows of\n"
        "the sky and of what has no material. No unit. Read only.");
  dense("lower", "lower", "Proven lower bounds of `factors`, of the same shape. Read only.");
  dense("upper", "upper",
        "Proven upper bounds of `factors`, of the same shape. 0 where a pair is proven to exchange nothing; by an\n"
        "approximate method nothing is proven, and they are 1. Read only.");
  dense(
      "visibility", "visibility",
      "How much of what a pair would exchange alone it exchanges, float64 of shape (n, n), from 0 to 1; NaN where it\n"
      "would exchange nothing. Of the method 'exact'; computed when it is first asked for. Read only.\n"
      "UsageError for another method.");
  type.def_property_readonly("areas", &areas_of,
                             "Areas, float64 of shape (n,), [m2], in the plane lengths, [m]; where nobody knows the\n"
                             "unit of the scene, in that. NaN for the sky. Read only.");
}

}  // namespace

void add_factors(py::module_& module) {
  py::class_<PythonFactors> type(
      module, "Factors",
      "View factors of all pairs, with bounds. factors['a', 'b'] is one of them: a dict of\n"
      "'factor', 'lower', 'upper' and 'guarantee'; UsageError for a name that there is not.");
  type.def_property_readonly(
          "names", [](const PythonFactors& factors) { return tuple_of(names_of(factors.matrix())); },
          "The names of rows and columns, a tuple of str: 'wall', 'wall:back', 'wall#2'; 'sky' is the last.")
      .def_property_readonly(
          "guarantee", [](const PythonFactors& factors) { return to_string(factors.matrix().guarantee()); },
          "'exact': each factor is the double nearest to the true number. 'enclosed': it is within the tolerance,\n"
          "proven by lower and upper. 'estimated': some only by two rules that agree. The weakest of all pairs.");
  add_arrays(type);
  type.def("to_scipy", &sparse, py::arg("quantity") = "factor", py::kw_only(), py::arg("copy") = false,
           "Returns a scipy.sparse.csr_matrix of shape (n, n) of 'factor', 'lower', 'upper' or 'visibility' of the\n"
           "pairs that exchange something. Its arrays are those of arrays(), without a copy, and read only; with\n"
           "copy=True they are the caller's own. UsageError for another quantity.")
      .def("arrays", &arrays_of, py::arg("quantity") = "factor",
           "Returns (begins, columns, values) of the m pairs that exchange something: those of row i stand from\n"
           "begins[i] up to begins[i + 1], columns ascending. int32 of shapes (n + 1,) and (m,), float64 of shape "
           "(m,):\n"
           "the numbers of the library itself, without a copy. From 2^31 pairs on begins and columns are int64, made\n"
           "anew. Read only.\n\n"
           "quantity: as of to_scipy(). UsageError for another one.")
      .def(
          "index",
          [](const PythonFactors& factors, const std::string& name) { return require_element(factors.matrix(), name); },
          py::arg("name"), "Returns the row and column of a name, an int. UsageError where there is none.")
      .def("to_names", &seen_by, py::arg("from_name"),
           "Returns the names of what a face sees, the sky too, in order. UsageError for what has no row.")
      .def("from_names", &seeing, py::arg("to_name"),
           "Returns the names of the faces that see a face, or the sky. UsageError for a name that there is not.")
      .def(
          "columns", &columns_of,
          "Returns a dict of columns, a line for each pair that exchanges something: 'from', 'to', 'factor', 'lower',\n"
          "'upper', 'guarantee'.")
      .def(
          "to_pandas",
          [](const PythonFactors& factors) {
            return py::module_::import("pandas").attr("DataFrame")(columns_of(factors));
          },
          "Returns columns() as a pandas.DataFrame. ImportError where pandas is not installed.")
      .def("__getitem__", &pair, py::arg("pair"))
      .def("__len__", [](const PythonFactors& factors) { return factors.matrix().size() + 1; })
      .def("__repr__", &short_text);
}

}  // namespace hottel::python
