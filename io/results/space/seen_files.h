// What many points of space see, as files: in lines, as NumPy's arrays, as the pieces themselves for ParaView.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "io/results/space/seen_writer.h"

namespace hottel {

enum class SeenFormat3 { kCsv, kNpz, kVtu };

// Returns the format of a file by its ending, .csv, .npz or .vtu; nothing for others.
std::optional<SeenFormat3> seen_format_3(const std::filesystem::path& file);

// REQUIRES that scene and solids outlive it. sink: takes the bytes of the file.
std::unique_ptr<SeenWriter3> seen_writer_3(SeenFormat3 format, const SeenFileOptions3& options,
                                           std::function<void(std::string_view)> sink);

}  // namespace hottel
