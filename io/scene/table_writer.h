// What the writers of scenes in the plane and in space have in common: all of a scene but its shape.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "geometry/scene_table.h"

namespace hottel {

// Returns a text between quotes. REQUIRES UTF-8.
std::string json_string(const std::string& text);

// Returns a number that reads back to exactly the same: a short decimal as it is, any other between quotes. Throws
// RequestError when it has more digits than a scene file may hold (kMaxNumberLength).
std::string json_number(const Rational& value);

// Writes a list or an object that is a member of the scene: one entry a line.
class JsonBlock {
 public:
  // Writes the key and the opening bracket. REQUIRES that `out` outlives this.
  JsonBlock(std::string& out, const std::string& key, char open, char close);
  void add(const std::string& entry);
  // Writes the closing bracket.
  void end();

 private:
  std::string& out_;
  char close_;
  bool is_empty_ = true;
};

// Each appends members of the scene to `out`; what has its default is left out.

// The opening brace, the versions, the text for people, the unit, and the materials. REQUIRES unique names of
// materials.
void write_head(const SceneTable& table, int dimension, std::string& out);
// What the sky sends, and the promise that the scene is closed.
void write_sky(const SceneTable& table, std::string& out);
// One light for each place: place_members(k) are those members of light k that depend on the dimension.
void write_lights(const SceneTable& table, const std::function<std::string(std::size_t)>& place_members,
                  std::string& out);
void write_expectations(const SceneTable& table, std::string& out);

// Returns the members of a surface but for its name and shape: material, back, what is behind it, what it lies
// on, elements.
std::string surface_members(const SceneTable& table, const Surface& surface);

}  // namespace hottel
