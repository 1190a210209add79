#include "python/bindings/radiosity.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "geometry/near_names.h"
#include "geometry/unit_of_length.h"
#include "io/results/temperature_files.h"
#include "python/bindings/bindings.h"
#include "solver/radiosity/element_temperatures.h"

namespace hottel::python {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// What a guarantee of a solution is called: nothing is estimated of an exact one.
std::string guarantee_of(const RadiositySolution& solution) { return to_string(solution.guarantee); }

// An array of shape (rows, channels) of value(row, channel).
py::array filled(std::size_t rows, std::size_t channels, const std::function<double(std::size_t, std::size_t)>& value) {
  std::vector<double> values;
  values.reserve(rows * channels);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < channels; ++c) values.push_back(value(r, c));
  return frozen(std::move(values), {static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(channels)});
}

void set_rows(const ExchangeMatrix& matrix, const std::vector<std::uint32_t>& rows, NumberTable& table) {
  std::vector<double> areas;
  for (const std::uint32_t i : rows) {
    table.names.push_back(matrix.name(i));
    areas.push_back(matrix.elements()[i].area.value);
  }
  table.areas = frozen(std::move(areas));
}

py::dict energy_of(const RadiositySolution& solution, bool is_in_watts) {
  const auto told = [is_in_watts](double power) { return is_in_watts ? power : kNan; };
  py::dict energy;
  energy["emitted"] = told(solution.energy.emitted);
  energy["absorbed"] = told(solution.energy.absorbed);
  energy["to_sky"] = told(solution.energy.to_sky);
  energy["defect"] = told(solution.energy.defect);
  return energy;
}

}  // namespace

PythonRadiosity radiosity_table(const SceneTable& scene, const ExchangeMatrix& matrix,
                                const RadiositySolution& solution) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i)) rows.push_back(i);
  PythonRadiosity table;
  table.what = "radiosities";
  table.channels = solution.channel_names;
  table.guarantee = guarantee_of(solution);
  table.energy = energy_of(solution, has_known_unit(scene));
  table.notes = solution.notes;
  set_rows(matrix, rows, table);
  const auto add = [&](const char* name, double (*value)(const ElementRadiosity&)) {
    table.columns[name] = filled(rows.size(), solution.channels.size(), [&](std::size_t r, std::size_t c) {
      return value(solution.channels[c].elements[rows[r]]);
    });
  };
  add("radiosity", [](const ElementRadiosity& e) { return e.radiosity; });
  add("lower", [](const ElementRadiosity& e) { return e.lower; });
  add("upper", [](const ElementRadiosity& e) { return e.upper; });
  add("emission", [](const ElementRadiosity& e) { return e.emission; });
  add("reflectivity", [](const ElementRadiosity& e) { return e.reflectivity; });
  add("irradiance", [](const ElementRadiosity& e) { return e.irradiance; });
  add("net", [](const ElementRadiosity& e) { return e.net(); });
  return table;
}

PythonTemperatures temperature_table(const SceneTable& scene, const ExchangeMatrix& matrix,
                                     const RadiositySolution& solution) {
  const ElementTemperatures temperatures(scene.materials);
  const std::size_t channels = solution.channels.size(), elements = has_temperatures(scene) ? matrix.size() : 0;
  const BoundedTemperature none{kNan, kNan, kNan};
  std::vector<std::uint32_t> rows;
  std::vector<BoundedTemperature> found;  // by row and channel
  for (std::uint32_t i = 0; i < elements; ++i) {
    if (!matrix.has_row(i)) continue;
    std::vector<BoundedTemperature> of_row;
    bool is_any = false;
    for (std::size_t c = 0; c < channels; ++c) {
      const auto t = temperatures.of(*matrix.elements()[i].material, solution, c, i);
      is_any = is_any || t.has_value();
      of_row.push_back(t.value_or(none));
    }
    if (!is_any) continue;
    rows.push_back(i);
    found.insert(found.end(), of_row.begin(), of_row.end());
  }
  PythonTemperatures table;
  table.what = "temperatures";
  table.channels = solution.channel_names;
  table.guarantee = guarantee_of(solution);
  set_rows(matrix, rows, table);
  const auto add = [&](const char* name, double BoundedTemperature::*member) {
    table.columns[name] =
        filled(rows.size(), channels, [&](std::size_t r, std::size_t c) { return found[r * channels + c].*member; });
  };
  add("temperature", &BoundedTemperature::value);
  add("lower", &BoundedTemperature::lower);
  add("upper", &BoundedTemperature::upper);
  return table;
}

PythonFlux flux_table(const NetFluxes& all, const std::vector<NetFlux>& some, const std::string& guarantee) {
  PythonFlux table;
  table.what = "net fluxes";
  table.channels = all.channel_names;
  table.guarantee = guarantee;
  std::vector<double> areas;
  for (const NetFlux& flux : some) {
    table.names.push_back(flux.name);
    areas.push_back(flux.area.value_or(kNan));
  }
  table.areas = frozen(std::move(areas));
  const auto add = [&](const char* name, double NetFlux::Power::*member) {
    table.columns[name] = filled(some.size(), all.channel_names.size(), [&](std::size_t r, std::size_t c) {
      return all.are_in_watts ? some[r].by_channel[c].*member : kNan;
    });
  };
  add("net", &NetFlux::Power::value);
  add("lower", &NetFlux::Power::lower);
  add("upper", &NetFlux::Power::upper);
  return table;
}

namespace {

std::size_t index_of(const NumberTable& table, const std::string& name) {
  const auto found = std::find(table.names.begin(), table.names.end(), name);
  if (found == table.names.end())
    throw UnknownName(std::string("there are no ") + table.what + " of '" + name + "'", name, table.names);
  return static_cast<std::size_t>(found - table.names.begin());
}

// Numbers of one name: arrays by channel.
py::dict row_of(const NumberTable& table, const std::string& name) {
  const std::size_t row = index_of(table, name);
  py::dict result;
  for (const auto& [column, values] : table.columns) result[column] = values[py::int_(row)];
  return result;
}

// A line for each name and channel.
py::dict columns_of(const NumberTable& table) {
  py::list names, channels, areas;
  for (std::size_t r = 0; r < table.names.size(); ++r)
    for (const std::string& channel : table.channels) {
      names.append(table.names[r]);
      channels.append(channel);
      areas.append(table.areas[py::int_(r)]);
    }
  py::dict result;
  result["name"] = names;
  result["channel"] = channels;
  result["area"] = areas;
  for (const auto& [column, values] : table.columns) result[column] = values.attr("ravel")();
  return result;
}

template <class Table>
py::class_<Table> add_table(py::module_& module, const char* name, const char* doc) {
  py::class_<Table> type(module, name, doc);
  type.def_property_readonly(
          "names", [](const Table& table) { return tuple_of(table.names); }, "The names of the rows, a tuple of n str.")
      .def_property_readonly(
          "channels", [](const Table& table) { return tuple_of(table.channels); },
          "The names of the columns of every array, a tuple of c str: 'all'; 'r', 'g', 'b'; or bands.")
      .def_property_readonly(
          "areas", [](const Table& table) { return table.areas; },
          "Areas, float64 of shape (n,), [m2], in the plane lengths, [m]; where nobody knows the unit of the scene, "
          "in\n"
          "that. NaN for what has none. Read only.")
      .def_property_readonly(
          "guarantee", [](const Table& table) { return table.guarantee; },
          "'enclosed': lower and upper are proven of these elements. 'estimated': they are proven of the factors as\n"
          "they were computed, some of which are estimates.")
      .def(
          "index", [](const Table& table, const std::string& row) { return index_of(table, row); }, py::arg("name"),
          "Returns the row of a name, an int. UsageError where there is none.")
      .def(
          "columns", [](const Table& table) { return columns_of(table); },
          "Returns a dict of columns, a line for each name and channel: 'name', 'channel', 'area', and the arrays.")
      .def(
          "to_pandas",
          [](const Table& table) { return py::module_::import("pandas").attr("DataFrame")(columns_of(table)); },
          "Returns columns() as a pandas.DataFrame. ImportError where pandas is not installed.")
      .def(
          "__getitem__", [](const Table& table, const std::string& row) { return row_of(table, row); }, py::arg("name"))
      .def("__len__", [](const Table& table) { return table.names.size(); })
      .def("__repr__", [name](const Table& table) {
        return std::string("<hottel.") + name + " of " + std::to_string(table.names.size()) + " in " +
               std::to_string(table.channels.size()) + " channels, " + table.guarantee + ">";
      });
  return type;
}

template <class Table>
void add_column(py::class_<Table>& type, const char* name, const char* doc) {
  type.def_property_readonly(
      name, [name](const Table& table) { return py::object(table.columns[name]); }, doc);
}

}  // namespace

void add_radiosity(py::module_& module) {
  auto radiosity = add_table<PythonRadiosity>(
      module, "Radiosity",
      "Radiosities of the faces or elements that have a material, [W/m2]. Arrays are\n"
      "float64 of shape (n, c). radiosity['wall'] is a dict of the arrays of one row; UsageError where there is none.");
  add_column(radiosity, "radiosity", "Radiosities, shape (n, c), [W/m2]. Read only.");
  add_column(radiosity, "lower", "Lower bounds of `radiosity`, shape (n, c); see `guarantee`. Read only.");
  add_column(radiosity, "upper", "Upper bounds of `radiosity`, shape (n, c); see `guarantee`. Read only.");
  add_column(radiosity, "emission", "What faces send out by themselves, shape (n, c), [W/m2]. Read only.");
  add_column(radiosity, "reflectivity", "Reflectivities, shape (n, c), from 0 to 1. Read only.");
  add_column(radiosity, "irradiance", "What arrives, shape (n, c), [W/m2]. Read only.");
  add_column(radiosity, "net", "radiosity - irradiance, shape (n, c), [W/m2]. Read only.");
  radiosity.def_property_readonly(
      "notes", [](const PythonRadiosity& table) { return tuple_of(table.notes); },
      "What the program tells of the solution, a tuple of str: parts that no light reaches, solvers that stopped.");
  radiosity.def_property_readonly(
      "energy", [](const PythonRadiosity& table) { return py::dict(table.energy.attr("copy")()); },
      "Where the power goes [W; W per metre of depth in the plane]: a dict of 'emitted', 'absorbed', 'to_sky', "
      "'defect'. NaN where nobody knows the unit of length.");

  auto temperatures = add_table<PythonTemperatures>(
      module, "Temperatures",
      "Temperatures [K] of the elements that have one: given by their material, or found. Arrays are float64 of\n"
      "shape (n, c), NaN in bands that have none. temperatures['wall'] is a dict of the arrays of one row.");
  add_column(temperatures, "temperature", "Temperatures, shape (n, c), [K]. Read only.");
  add_column(temperatures, "lower", "Lower bounds of `temperature`, shape (n, c), [K]. Read only.");
  add_column(temperatures, "upper", "Upper bounds of `temperature`, shape (n, c), [K]. Read only.");

  auto flux = add_table<PythonFlux>(
      module, "NetFlux",
      "Net fluxes [W; W per metre of depth in the plane], positive where more leaves than arrives. Arrays are float64\n"
      "of shape (n, c); where there are two bands the channel 'total' is the last. flux['wall'] is a dict of one row.\n"
      "NaN where nobody knows the unit of length of the scene.");
  add_column(flux, "net", "Net fluxes, shape (n, c), [W] or [W/m]. Read only.");
  add_column(flux, "lower", "Lower bounds of `net`, shape (n, c), [W] or [W/m]. Read only.");
  add_column(flux, "upper", "Upper bounds of `net`, shape (n, c), [W] or [W/m]. Read only.");
}

}  // namespace hottel::python
