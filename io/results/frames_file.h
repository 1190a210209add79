// What the frames of an animation took, as a file that is read again when an animation goes on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "solver/animation.h"

namespace hottel {

// One line of frames.csv.
struct FrameLine {
  double time = 0;  // seconds
  FrameCounts counts;
  double picture_seconds = 0;
  std::string sum;  // frame_sum()
};

// What was made before, and of what.
struct FramesMade {
  std::string key;                            // of the scene and of what was asked of it
  std::map<std::uint32_t, FrameLine> frames;  // by number
};

// The name of a frame's picture: "frame_00012.png".
std::string frame_file_name(std::uint32_t frame);

// SHA-256 over the key of an animation, the cells before it in frames.csv, and the picture: what has it is of this
// animation, and whole.
std::string frame_sum(const std::string& key, std::uint32_t frame, const FrameLine& line, std::string_view picture);

// frames.csv: frame,time,elements,activated,computed,read,seconds,picture_seconds,row_defect,sum.
std::string frames_csv(const FramesMade& made);

// animation.json: {"hottel", "scene", "key", "frames_per_second", "frames", "files"}.
std::string animation_json(const std::string& scene, const std::string& key, double frames_per_second,
                           std::uint32_t frames, const std::vector<std::string>& files);

// Reads what a folder has of an animation: nothing where either file is not there, or is none. Frames of which the line
// or the picture is missing or is not as it was written are not among it. COST: that of reading all pictures.
FramesMade read_frames(const std::filesystem::path& folder);

}  // namespace hottel
