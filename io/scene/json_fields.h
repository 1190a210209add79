// Typed access to a JSON document that refuses what it does not understand.
//
// Every function throws InputError at the line of the value, in one sentence that begins with the subject.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/material.h"
#include "io/scene/exact_json.h"
#include "kernel/rational.h"

namespace hottel {

// What a message is about: "edge 'lamp'" and perhaps a part of it, "elements". REQUIRES texts that outlive it.
struct Subject {
  std::string_view owner;
  std::string_view part = {};

  // "edge 'lamp': elements"
  std::string text() const { return std::string(owner) + (part.empty() ? "" : ": ") + std::string(part); }
};

// Throws InputError with the file and the line of a value: one sentence, and at most three hints.
[[noreturn]] void refuse(const JsonValue& at, const std::string& text, std::vector<std::string> hints = {});

// Refuses a value of another kind, naming both kinds. REQUIRES a value, as do all functions here that read one; to
// refuse is to throw InputError at the line of the value.
void require_kind(const JsonValue& value, JsonKind kind, const Subject& subject);

// Sets values[i] to the member called keys[i], or leaves it where there is none. Refuses other keys, naming those that
// are known, and what is no object. REQUIRES as many values as keys.
void read_members(const JsonValue& object, const Subject& subject, std::span<const std::string_view> keys,
                  std::span<JsonValue> values);

// The same into a new array: a key that the object lacks is no value.
template <std::size_t N>
std::array<JsonValue, N> read_members(const JsonValue& object, const Subject& subject,
                                      const std::array<std::string_view, N>& keys) {
  std::array<JsonValue, N> values;
  read_members(object, subject, std::span<const std::string_view>(keys), std::span<JsonValue>(values));
  return values;
}

// Refuses an object without this member, at the line of the object.
void require_member(const JsonValue& member, std::string_view key, const JsonValue& object, const Subject& subject);

// The contents of a string, true or false; other kinds are refused.
std::string read_string(const JsonValue& value, const Subject& subject);
bool read_boolean(const JsonValue& value, const Subject& subject);

// An integer from 1 to `most`, as a JSON number; "3.0" and "3e0" are 3.
std::uint32_t read_count(const JsonValue& value, std::uint32_t most, const Subject& subject);

// The exact value of a JSON number, or of a string that parse_rational understands ("4/3"). Refuses more than
// kMaxNumberLength characters, and exponents beyond kMaxNumberExponent.
Rational read_number(const JsonValue& value, const Subject& subject);

// A number for every channel, or a list of three: r, g, b. Only a number makes a scalar spectrum; three
// equal ones do not.
Spectrum read_spectrum(const JsonValue& value, const Subject& subject);

}  // namespace hottel
