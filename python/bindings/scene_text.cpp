#include "python/bindings/scene_text.h"

#include "kernel/support/failure.h"
#include "python/bindings/errors.h"
#include "python/bindings/numbers.h"

namespace hottel::python {
namespace {

constexpr int kMaxDepth = 64;  // deeper than any scene, and than what contains itself

class SceneWriter {
 public:
  explicit SceneWriter(bool is_binary) : is_binary_(is_binary), quote_(py::module_::import("json").attr("dumps")) {}

  void write(const py::handle& value, const std::string& place, int depth) {
    if (depth > kMaxDepth) throw InputError({std::string(kNoFile), 0}, place + " is nested too deep");
    if (py::isinstance<py::bool_>(value))
      text_ += value.cast<bool>() ? "true" : "false";
    else if (py::isinstance<py::str>(value))
      text_ += quoted(value);
    else if (py::isinstance<py::dict>(value))
      write_object(py::reinterpret_borrow<py::dict>(value), place, depth);
    else if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value))
      write_list(py::reinterpret_borrow<py::sequence>(value), place, depth);
    else if (const auto number = number_text(value, is_binary_, place))
      text_ += *number;
    else if (py::isinstance(value, py::module_::import("numpy").attr("ndarray")))
      write(py::object(value.attr("tolist")()), place, depth + 1);
    else
      throw py::type_error(place + " is " + type_of(value) + ", which no scene holds");
  }

  std::string take() { return std::move(text_); }

 private:
  static std::string type_of(const py::handle& value) {
    return py::str(py::type::handle_of(value).attr("__name__")).cast<std::string>();
  }
  std::string quoted(const py::handle& text) { return quote_(text).cast<std::string>(); }

  void write_object(const py::dict& object, const std::string& place, int depth) {
    text_ += '{';
    bool is_first = depth > 0 || object.contains("hottel");
    if (!is_first) text_ += R"("hottel":1)";  // what a file begins with
    for (const auto& [key, value] : object) {
      if (!py::isinstance<py::str>(key))
        throw py::type_error((place.empty() ? "the scene" : place) + " has a key that is " + type_of(key) +
                             ", not str");
      if (!is_first) text_ += ',';
      is_first = false;
      text_ += quoted(key) + ':';
      const std::string name = py::repr(key).cast<std::string>();  // whatever it holds, this can be printed
      write(value, (place.empty() ? "" : place + '.') + name.substr(1, name.size() - 2), depth + 1);
    }
    text_ += '}';
  }

  void write_list(const py::sequence& list, const std::string& place, int depth) {
    text_ += '[';
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (k > 0) text_ += ',';
      write(py::object(list[k]), place + '[' + std::to_string(k) + ']', depth + 1);
    }
    text_ += ']';
  }

  const bool is_binary_;
  const py::object quote_;
  std::string text_;
};

}  // namespace

std::string scene_text(const py::dict& scene, bool is_binary) {
  SceneWriter writer(is_binary);
  writer.write(scene, "", 0);
  return writer.take();
}

}  // namespace hottel::python
