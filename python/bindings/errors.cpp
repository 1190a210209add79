#include "python/bindings/errors.h"

#include <array>
#include <exception>
#include <filesystem>

#include "geometry/near_names.h"
#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"
#include "python/bindings/bindings.h"
#include "python/bindings/words.h"

namespace hottel::python {

std::string surface_in(std::string_view reason) {
  for (const std::string_view noun : {"edge ", "polygon ", "polyline ", "mesh ", "surface ", ""}) {
    if (!reason.starts_with(noun) || reason.substr(noun.size(), 1) != "'") continue;
    const std::string_view rest = reason.substr(noun.size() + 1);
    const std::size_t end = rest.find('\'');
    return end == std::string_view::npos ? "" : std::string(rest.substr(0, end));
  }
  return "";
}

namespace {

// They live as long as the interpreter.
PyObject *input_error = nullptr, *request_error = nullptr, *usage_error = nullptr;

PyObject* new_error(py::module_& module, const char* name, const py::object& bases, const char* doc) {
  PyObject* const type = PyErr_NewExceptionWithDoc((std::string("hottel.") + name).c_str(), doc, bases.ptr(), nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.attr(name) = py::handle(type);
  return type;
}

py::list list_of(const std::vector<std::string>& hints) {
  py::list list;
  for (const std::string& hint : hints) list.append(in_python(hint));
  return list;
}

py::object text_or_none(const std::string& text) { return text.empty() ? py::object(py::none()) : py::str(text); }

// Sets a Python error with a message and its hints below it.
py::object made(PyObject* type, const std::string& sentence, const std::vector<std::string>& hints) {
  std::string message = in_python(sentence);
  for (const std::string& hint : hints) message += "\n  " + in_python(hint);
  py::object error = py::reinterpret_borrow<py::object>(type)(message);
  error.attr("hints") = py::tuple(list_of(hints));
  return error;
}

void set_input_error(const InputError& failure) {
  const FileLine& where = failure.where();
  const std::string reason = std::string(failure.what()).substr(where.text().size() + 2);
  const bool has_file = std::filesystem::path(where.file).filename() != kNoFile;
  const py::object error = made(input_error, has_file ? failure.what() : reason, failure.hints());
  error.attr("reason") = in_python(reason);
  error.attr("surface") = text_or_none(surface_in(reason));
  error.attr("file") = text_or_none(has_file ? where.file : "");
  error.attr("line") = has_file && where.line > 0 ? py::object(py::int_(where.line)) : py::object(py::none());
  PyErr_SetObject(input_error, error.ptr());
}

void set_error(PyObject* type, const std::string& message, const std::vector<std::string>& hints = {}) {
  PyErr_SetObject(type, made(type, message, hints).ptr());
}

void translate(std::exception_ptr failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const InputError& error) {
    set_input_error(error);
  } catch (const UnknownName& error) {
    set_error(usage_error, error.what(), error.hints());
  } catch (const UsageError& error) {
    set_error(usage_error, error.what());
  } catch (const RequestError& error) {
    set_error(request_error, error.what());
  } catch (const OutputError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  } catch (const Interrupted& error) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
  }
}

}  // namespace

void add_errors(py::module_& module) {
  const py::object base = py::reinterpret_steal<py::object>(
      new_error(module, "Error", py::reinterpret_borrow<py::object>(PyExc_Exception),
                "What hottel refuses. str(error) is one line, and hints below it; .hints is a tuple of these."));
  const auto with = [&base](PyObject* other) { return py::make_tuple(base, py::handle(other)); };
  input_error = new_error(module, "InputError", with(PyExc_ValueError),
                          "A scene, its file or an array is wrong.\n\n"
                          ".reason: one sentence. .surface: the name of the surface that it is about, or None.\n"
                          ".file and .line: where it stands, or None. .hints: what helps.");
  request_error = new_error(module, "RequestError", with(PyExc_RuntimeError),
                            "The scene is fine, but what was asked of it cannot be had: memory or a tolerance that\n"
                            "does not suffice, a broken promise to be closed, a solution that does not exist.");
  usage_error = new_error(module, "UsageError", with(PyExc_ValueError),
                          "An argument that there is not, or that makes no sense here: a name, a method, a number out\n"
                          "of range. .hints: names that were perhaps meant.");
  py::register_exception_translator(translate);
}

}  // namespace hottel::python
