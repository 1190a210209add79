// The methods that the program knows, for the commands that compute by any of them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "solver/method_catalogue.h"

namespace hottel {

// All families of both dimensions for --help, a line each: pattern, what it is, and the dimension where the other one
// does not have it. Each line begins with a newline.
std::string methods_text();

// The names in lists "A,B,...", in their order, repeated ones too. What follows `run:` or `file:` after a comma and
// begins no method (of `families`), with a name or without, belongs to the command or the path. Throws UsageError for
// an empty name.
std::vector<std::string> method_names(const std::vector<std::string>& lists, const std::vector<std::string>& families);

// The names of the families of a catalogue.
template <class Prepared>
std::vector<std::string> family_names(const MethodCatalogue<Prepared>& methods) {
  std::vector<std::string> names;
  for (const MethodFamily<Prepared>& family : methods.families()) names.push_back(family.name);
  return names;
}

// A method as --methods names it: METHOD, or NAME=METHOD where METHOD is a file: or a run:.
struct NamedMethod {
  std::string method;  // without the name: "file:own.csv"
  std::string given;   // the name, where one was given

  // What it is called in tables: the name, or the method as it was asked for.
  const std::string& name() const { return given.empty() ? method : given; }
};

// Splits NAME=METHOD. What comes before the first = is a name only where `file:` or `run:` follows, and no colon and no
// comma comes before it. Throws UsageError for a name before a method of hottel's own, and for an empty one.
NamedMethod named_method(const std::string& text);

// What the curve of a method of others is called: the name that it was given; else the stem of the file, "own" of
// file:out/own.csv, unless that is one of `taken`; else the method. `:normalised` stays at its end.
std::string external_curve(const NamedMethod& method, const std::vector<std::string>& taken);

// Takes the methods out that are files of radiosities (file:PATH), not of view factors. Both keep their order. One with
// :normalised is never one. Throws InputError for a file that cannot be read.
std::vector<NamedMethod> take_radiosity_files(std::vector<NamedMethod>& methods);

// Throws UsageError where two methods are called the same, or one of others is called like a family.
void require_names_apart(const std::vector<NamedMethod>& methods, const std::vector<std::string>& families);

}  // namespace hottel
