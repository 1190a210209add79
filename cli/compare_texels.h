// hottel compare --texels: a lightmap of another program, against the exact light of the same texels.
#pragma once

#include <functional>
#include <string>

#include "cli/comparing.h"
#include "io/external/external_texels.h"
#include "io/results/texel_report.h"

namespace hottel {

// A lightmap that is to be judged, read and found to fit the scene.
struct TexelFile {
  ExternalTexels read;
  Face face;
  std::string name;  // of the face
  Grid3 grid;
};

// Reads what --texels names: FILE, whose face FILE.json tells, or NAME=FILE. Throws UsageError where neither tells the
// face, UnknownName and UsageError where NAME is none or has no texels, InputError naming the file where it is no array
// of texels, or its FILE.json names such a face or says that the texels lie elsewhere.
TexelFile texel_file(const std::string& option, const Scene3& scene);

struct ComparedTexels {
  JudgedTexels judged;
  std::string picture;  // bytes of texel_errors.png
};

// Holds it against the light that is gathered at the middles of the texels (texels_3), by the radiosities of the
// elements of the scene. Its FILE.json says which quantity a file has, else it is radiosity: by channel where it has a
// third index, else their mean, of two bands their sum. progress: fraction done. Throws InputError naming the file
// where it has other channels, or no texel can be compared; RequestError where there is no exact light.
ComparedTexels judge_texels(const TexelFile& file, const MethodComparison3& comparison, double beyond,
                            const std::function<void(double)>& progress);

}  // namespace hottel
