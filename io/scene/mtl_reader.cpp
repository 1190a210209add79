#include "io/scene/mtl_reader.h"

#include <unordered_map>

#include "geometry/name.h"
#include "io/scene/obj_statements.h"

namespace hottel {
namespace {

Spectrum read_spectrum(const ObjStatements& at, SpectrumKind kind) {
  const std::vector<std::string_view> words = at.words();
  const std::string keyword(at.keyword());
  if (words.size() != 1 && words.size() != 3)
    at.refuse(keyword + " must have one number or three: r, g and b", {"files of spectra are not read"});
  Spectrum result;
  for (std::size_t c = 0; c < 3; ++c) result.value[c] = at.number(words[words.size() == 1 ? 0 : c], keyword);
  result.is_scalar = result.value[1] == result.value[0] && result.value[2] == result.value[0];
  if (const auto problem = spectrum_problem(result, kind); !problem.empty())
    at.refuse(keyword + " " + std::string(problem));
  return result;
}

bool is_one_of(std::string_view word, std::string_view upper, std::string_view lower) {
  return word == upper || word == lower;
}

}  // namespace

std::vector<Material> parse_mtl(std::string_view text, const std::string& file) {
  std::vector<Material> materials;
  std::unordered_map<std::string, int> line_of;
  bool has_reflectivity = false, has_emission = false;
  for (ObjStatements at(text, file); at.next();) {
    if (at.keyword() == "newmtl") {
      Material material;
      material.name = at.rest();
      if (const auto problem = material_name_problem(material.name); !problem.empty()) at.refuse(problem);
      if (const auto [first, is_new] = line_of.emplace(material.name, at.line()); !is_new)
        at.refuse("two materials have the name " + quoted_name(material.name) + ", the other one in line " +
                  std::to_string(first->second));
      materials.push_back(std::move(material));
      has_reflectivity = has_emission = false;
      continue;
    }
    const bool is_reflectivity = is_one_of(at.keyword(), "Kd", "kd");
    if (!is_reflectivity && !is_one_of(at.keyword(), "Ke", "ke")) continue;
    if (materials.empty()) at.refuse(std::string(at.keyword()) + " stands before any newmtl");
    bool& is_given = is_reflectivity ? has_reflectivity : has_emission;
    if (is_given)
      at.refuse("material " + quoted_name(materials.back().name) + " has " + std::string(at.keyword()) + " twice");
    is_given = true;
    (is_reflectivity ? materials.back().reflectivity : materials.back().emission) =
        read_spectrum(at, is_reflectivity ? SpectrumKind::kFraction : SpectrumKind::kQuantity);
  }
  return materials;
}

}  // namespace hottel
