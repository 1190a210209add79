#include "io/results/frames_file.h"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "io/files/text_file.h"
#include "kernel/rational.h"
#include "kernel/support/failure.h"
#include "kernel/version.h"

namespace hottel {
namespace {

constexpr const char* kHeader = "frame,time,elements,activated,computed,read,seconds,picture_seconds,row_defect,sum";

// Takes the next number of a line; false where there is none.
template <class Number>
bool take(std::string_view& rest, Number& number) {
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error != std::errc()) return false;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (rest.empty()) return true;
  if (rest.front() != ',') return false;
  rest.remove_prefix(1);
  return true;
}

std::optional<std::pair<std::uint32_t, FrameLine>> line_of(std::string_view text) {
  std::pair<std::uint32_t, FrameLine> result;
  FrameLine& line = result.second;
  const bool is_whole = take(text, result.first) && take(text, line.time) && take(text, line.counts.elements) &&
                        take(text, line.counts.activated) && take(text, line.counts.computed) &&
                        take(text, line.counts.read) && take(text, line.counts.seconds) &&
                        take(text, line.picture_seconds) && take(text, line.counts.row_defect);
  line.sum = text;
  return is_whole ? std::optional(result) : std::nullopt;
}

// The cells before the sum.
std::string cells_of(std::uint32_t frame, const FrameLine& line) {
  return fmt::format("{},{},{},{},{},{},{},{},{}", frame, shortest(line.time), line.counts.elements,
                     line.counts.activated, line.counts.computed, line.counts.read, shortest(line.counts.seconds),
                     shortest(line.picture_seconds), shortest(line.counts.row_defect));
}

// Whether line and picture are as they were written.
bool is_as_written(const std::filesystem::path& folder, const std::string& key, std::uint32_t frame,
                   const FrameLine& line) {
  try {
    return line.sum == frame_sum(key, frame, line, read_text_file(folder / frame_file_name(frame)));
  } catch (const InputError&) {  // it is not there
    return false;
  }
}

}  // namespace

std::string frame_file_name(std::uint32_t frame) { return fmt::format("frame_{:05}.png", frame); }

std::string frame_sum(const std::string& key, std::uint32_t frame, const FrameLine& line, std::string_view picture) {
  return sha256(key + "\n" + cells_of(frame, line) + "\n" + std::string(picture));
}

std::string frames_csv(const FramesMade& made) {
  std::string text = std::string(kHeader) + "\n";
  for (const auto& [frame, line] : made.frames) text += cells_of(frame, line) + "," + line.sum + "\n";
  return text;
}

std::string animation_json(const std::string& scene, const std::string& key, double frames_per_second,
                           std::uint32_t frames, const std::vector<std::string>& files) {
  nlohmann::ordered_json json;
  json["hottel"] = kVersion;
  json["scene"] = scene;
  json["key"] = key;
  json["frames_per_second"] = frames_per_second;
  json["frames"] = frames;
  json["files"] = files;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

FramesMade read_frames(const std::filesystem::path& folder) {
  FramesMade made;
  try {
    const auto json = nlohmann::json::parse(read_text_file(folder / "animation.json"));
    made.key = json.at("key").get<std::string>();
    std::istringstream lines(read_text_file(folder / "frames.csv"));
    std::string text;
    if (!std::getline(lines, text) || text != kHeader) return {};
    while (std::getline(lines, text)) {
      const auto line = line_of(text);
      if (line && is_as_written(folder, made.key, line->first, line->second)) made.frames.insert(*line);
    }
  } catch (const InputError&) {
    return {};
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return made;
}

}  // namespace hottel
