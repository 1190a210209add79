// A scene as a dict of Python, as the text of a scene file.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace hottel::python {

// Returns the JSON text that a dict stands for: with dicts, lists, tuples, arrays, texts, truth values and numbers.
//
//   (1) a float is its shortest decimal, or with is_binary the double that it is; other numbers are exact
//   (2) "hottel": 1, which tells that a file is a scene, may be left out
//
// Throws TypeError for other objects and for keys that are no texts, InputError for what is no number, both naming
// the place, "edges[3].from[0]".
std::string scene_text(const pybind11::dict& scene, bool is_binary);

}  // namespace hottel::python
