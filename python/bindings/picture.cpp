#include "python/bindings/picture.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "geometry/plane/prepared/prepared_scene.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "io/files/output_file.h"
#include "kernel/support/failure.h"
#include "python/bindings/bindings.h"
#include "viewer/picture/plane/drawable.h"
#include "viewer/picture/plane/scene_picture.h"
#include "viewer/picture/space/render_picture.h"
#include "viewer/window/space/first_light.h"

namespace hottel::python {
namespace {

// The pixels of a PNG as png_file writes it: rows of bytes, each less the one above it.
py::array pixels_of(const std::string& png) {
  const auto number = [&png](std::size_t place) {
    std::size_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = 256 * value + static_cast<unsigned char>(png[place + k]);
    return value;
  };
  const std::size_t width = number(16), height = number(20);
  std::string packed;
  for (std::size_t place = 8; place + 12 <= png.size(); place += 12 + number(place))
    if (png.compare(place + 4, 4, "IDAT") == 0) packed.append(png, place + 8, number(place));
  const std::string rows =
      py::module_::import("zlib").attr("decompress")(py::bytes(packed)).cast<py::bytes>().cast<std::string>();
  const std::size_t bytes = 3 * width;
  HOTTEL_REQUIRE(rows.size() == height * (1 + bytes));
  std::vector<std::uint8_t> values(height * bytes);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t k = 0; k < bytes; ++k)
      values[y * bytes + k] = static_cast<std::uint8_t>(static_cast<unsigned char>(rows[y * (1 + bytes) + 1 + k]) +
                                                        (y == 0 ? 0 : values[(y - 1) * bytes + k]));
  return frozen(std::move(values), {static_cast<py::ssize_t>(height), static_cast<py::ssize_t>(width), 3});
}

PictureFormat format_of(const std::string& name) {
  const auto format = picture_format("." + name);
  if (!format) throw UsageError("a picture is 'png', 'svg' or 'pdf', not '" + name + "'");
  return *format;
}

}  // namespace

PythonPicture::PythonPicture(Draw draw, const Waiting& waiting) : draw_(std::move(draw)) {
  files_[PictureFormat::kPng] =
      without_lock(waiting, [this](const StageProgress&) { return draw_(PictureFormat::kPng); });
  pixels_ = pixels_of(files_[PictureFormat::kPng]);
}

const std::string& PythonPicture::drawn(PictureFormat format) const {
  const auto known = files_.find(format);
  if (known != files_.end()) return known->second;
  std::string made = without_lock({}, [&](const StageProgress&) { return draw_(format); });
  return files_.emplace(format, std::move(made)).first->second;
}

py::bytes PythonPicture::file(const std::string& format) const { return py::bytes(drawn(format_of(format))); }

void PythonPicture::save(const std::string& path) const {
  const auto format = picture_format(path);
  if (!format) throw UsageError("a picture is written as .png, .svg or .pdf, not '" + path + "'");
  write_output_file(path, drawn(*format));
}

std::uint32_t width_of_picture(std::int64_t size) {
  if (size < 0 || size > kMaxPictureSide)
    throw UsageError("size is a width from 1 to " + std::to_string(kMaxPictureSide) +
                     " pixels, or 0 for the usual, not " + std::to_string(size));
  return static_cast<std::uint32_t>(size);
}

namespace {

PythonPicture::Draw plan_of(const Scene2& scene, std::uint32_t width, bool has_axes) {
  if (width > 0 && width < kMinPictureWidth)
    throw UsageError("size of a plan is " + std::to_string(kMinPictureWidth) + " at least");
  require_drawable(scene);
  const auto prepared = std::make_shared<const PreparedScene2>(prepare(scene));
  ScenePicture2 picture;
  if (width > 0) picture.sheet.width = width;
  picture.sheet.has_axes = has_axes;
  return [prepared, picture](PictureFormat format) { return scene_picture_2(*prepared, picture, format); };
}

// Every face in the light that it may have, as a solution says it.
RadiositySolution first_light(const Scene3& scene, const ElementTable3& table) {
  const ElementPaint3 paint = light_before_factors_3(scene, table);
  RadiositySolution solution;
  solution.channels.resize(paint.channels);
  for (std::size_t c = 0; c < paint.channels; ++c)
    for (std::uint32_t i = 0; i < table.count(); ++i) {
      solution.channel_names.assign(paint.channels, "");
      ElementRadiosity element;
      element.radiosity = paint.value(i)[c];
      solution.channels[c].elements.push_back(element);
    }
  return solution;
}

// A scene in the dark is shown by the light of a sky.
Scene3 with_some_light(Scene3 scene) {
  const bool is_lit = !scene.lights.empty() || scene.sky_emission.value[0] > 0 ||
                      std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
                        return std::any_of(material.emission.value.begin(), material.emission.value.end(),
                                           [](const Rational& value) { return value > 0; });
                      });
  if (!is_lit)
    for (Rational& value : scene.sky_emission.value) value = 1;
  return scene;
}

PythonPicture::Draw view_of(const Scene3& scene, std::uint32_t width) {
  const auto prepared = std::make_shared<const PreparedScene3>(prepare(with_some_light(scene)));
  const auto view = std::make_shared<const RenderedView3>(
      *prepared, Granularity::kFace, first_light(prepared->scene, *prepared->elements(Granularity::kFace)),
      RenderOptions3{.wanted_width = width});
  return [prepared, view](PictureFormat format) { return view->file(format); };
}

}  // namespace

PythonPicture scene_picture(const PythonScene& scene, std::int64_t size, bool has_axes) {
  const std::uint32_t width = width_of_picture(size);
  if (!scene.is_plane() && has_axes) throw UsageError("axes are for plans in the plane");
  auto draw = without_lock({}, [&](const StageProgress&) {
    if (scene.is_plane()) return plan_of(scene.in_plane(), width, has_axes);
    return view_of(scene.in_space(), width);
  });
  return PythonPicture(std::move(draw), {});
}

void add_picture(py::module_& module) {
  py::class_<PythonPicture> type(module, "Picture",
                                 "A picture: pixels as an array, and files of every format. A notebook shows it.");
  type.def_property_readonly("pixels", &PythonPicture::pixels,
                             "Red, green and blue, uint8 of shape (height, width, 3), the upper row first. Read only.")
      .def("file", &PythonPicture::file, py::arg("format") = "png",
           "Returns the bytes of a file, 'png', 'svg' or 'pdf': those that the program writes. UsageError for another\n"
           "format.")
      .def(
          "save", [](const PythonPicture& picture, const std::filesystem::path& path) { picture.save(path.string()); },
          py::arg("path"),
          "Writes a file, .png, .svg or .pdf by its ending; one that is there is replaced when the new one is whole.\n"
          "UsageError for another ending, OSError where it cannot be written.")
      .def("_repr_png_", [](const PythonPicture& picture) { return picture.file("png"); })
      .def("__repr__", [](const PythonPicture& picture) {
        return "<hottel.Picture of " + std::to_string(picture.pixels().shape(1)) + " x " +
               std::to_string(picture.pixels().shape(0)) + " pixels>";
      });
}

}  // namespace hottel::python
