// A room, and files and commands that say what its view factors are.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/plane/prepared/element_table.h"
#include "geometry/plane/prepared/prepared_scene.h"
#include "io/external/external_command.h"
#include "io/external/external_method.h"
#include "io/files/output_file.h"
#include "io/scene/scene_json.h"
#include "kernel/support/failure.h"
#include "solver/plane/methods/method_catalogue.h"
#include "tests/temporary_folder.h"

namespace hottel {

// A room of four walls, each with a material in front only: 8 faces.
inline constexpr char kRoom[] = R"({"hottel": 1, "dimension": 2, "materials": {"white": {"reflectivity": 0.5}},
  "edges": [{"name": "a", "points": [[0, 0], [0, 3]], "material": "white"},
            {"name": "b", "points": [[0, 3], [4, 3]], "material": "white"},
            {"name": "c", "points": [[4, 3], [4, 0]], "material": "white"},
            {"name": "d", "points": [[4, 0], [0, 0]], "material": "white"}]})";

class ExternalRoomTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  std::string write(const std::string& name, std::string_view text) const {
    write_output_file(path(name), text);
    return path(name);
  }

  PreparedScene2 room() const { return prepare(read_scene_2(write("room.json", kRoom))); }

  ExchangeMatrix matched(const PreparedScene2& prepared, const std::string& name, std::string_view text) {
    write(name, text);
    report_ = {};
    return planar().make("file:" + path(name))->compute(prepared, {.granularity = Granularity::kElement}, report_);
  }

  // The message of reading a file and matching it with the room, without the folder.
  std::string why(const std::string& name, std::string_view text) {
    const PreparedScene2 prepared = room();
    try {
      matched(prepared, name, text);
    } catch (const InputError& error) {
      std::string message = error.what();
      EXPECT_THAT(message, testing::StartsWith(path("")));
      return message.substr(path("").size());
    }
    return "nothing is wrong";
  }

  static MethodCatalogue2 planar() {
    MethodCatalogue2 methods("in the plane");
    add_external_methods<ElementMethod2>(methods);
    return methods;
  }

  TemporaryFolder directory_;
  MethodReport report_;
};

}  // namespace hottel
