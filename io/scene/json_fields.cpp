#include "io/scene/json_fields.h"

#include "geometry/name.h"
#include "geometry/number.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

const char* kind_name(JsonKind kind) {
  switch (kind) {
    case JsonKind::kNull:
      return "null";
    case JsonKind::kBoolean:
      return "true or false";
    case JsonKind::kNumber:
      return "a number";
    case JsonKind::kString:
      return "a string";
    case JsonKind::kArray:
      return "a list";
    case JsonKind::kObject:
      return "an object";
    case JsonKind::kKey:
      return "a key";
  }
  return "";
}

[[noreturn]] void refuse_kind(const JsonValue& value, const std::string& expected, const Subject& subject) {
  refuse(value, subject.text() + " must be " + expected + ", not " + kind_name(value.kind()));
}

}  // namespace

void refuse(const JsonValue& at, const std::string& text, std::vector<std::string> hints) {
  throw InputError({at.file(), at.line()}, text, std::move(hints));
}

void require_kind(const JsonValue& value, JsonKind kind, const Subject& subject) {
  if (value.kind() != kind) refuse_kind(value, kind_name(kind), subject);
}

void read_members(const JsonValue& object, const Subject& subject, std::span<const std::string_view> keys,
                  std::span<JsonValue> values) {
  require_kind(object, JsonKind::kObject, subject);
  for (const auto [key, value] : object.members()) {
    std::size_t i = 0;
    while (i < keys.size() && keys[i] != key.text()) ++i;
    if (i == keys.size()) {
      std::string known = "known keys:";
      for (const std::string_view k : keys) known += (k == keys.front() ? " " : ", ") + std::string(k);
      refuse(key, subject.text() + " has the unknown key " + quoted_name(key.text()), {known});
    }
    values[i] = value;
  }
}

void require_member(const JsonValue& member, std::string_view key, const JsonValue& object, const Subject& subject) {
  if (!member) refuse(object, subject.text() + " has no \"" + std::string(key) + "\"");
}

std::string read_string(const JsonValue& value, const Subject& subject) {
  require_kind(value, JsonKind::kString, subject);
  return std::string(value.text());
}

bool read_boolean(const JsonValue& value, const Subject& subject) {
  require_kind(value, JsonKind::kBoolean, subject);
  return value.text() == "true";
}

std::uint32_t read_count(const JsonValue& value, std::uint32_t most, const Subject& subject) {
  require_kind(value, JsonKind::kNumber, subject);
  const Rational number = read_number(value, subject);
  if (number.get_den() != 1 || number < 1 || number > most)
    refuse(value, subject.text() + " must be an integer from 1 to " + std::to_string(most));
  return static_cast<std::uint32_t>(number.get_num().get_ui());
}

Rational read_number(const JsonValue& value, const Subject& subject) {
  if (value.kind() != JsonKind::kNumber && value.kind() != JsonKind::kString)
    refuse_kind(value, "a number or a string that holds one", subject);
  std::optional<Rational> number = parse_rational(value.text());
  if (!number) {
    const auto [problem, hint] = number_problem(value.text());
    refuse(value, subject.text() + " " + problem, hint.empty() ? std::vector<std::string>() : std::vector{hint});
  }
  return *std::move(number);
}

Spectrum read_spectrum(const JsonValue& value, const Subject& subject) {
  if (value.kind() != JsonKind::kArray) return Spectrum::scalar(read_number(value, subject));
  if (value.size() != 3)
    refuse(value,
           subject.text() + " is one number or a list of three, r, g and b, not of " + std::to_string(value.size()));
  Spectrum result;
  result.is_scalar = false;
  std::size_t channel = 0;
  for (const JsonValue item : value.items()) result.value[channel++] = read_number(item, subject);
  return result;
}

}  // namespace hottel
