// Edits of materials of given net flux and of two bands leave what a scene may hold.
#include "viewer/edit/material_edits.h"

#include <gtest/gtest.h>

#include "geometry/scene_table.h"

namespace hottel::material_edits_test {
namespace {

Material given(const Rational& flux) {
  Material material;
  material.name = "given";
  set_given_flux(Rational(1, 2), flux, material);
  return material;
}

void expect_valid(const Material& material) {
  SceneTable table;
  table.has_bands = material.has_bands;
  table.materials = {material};
  EXPECT_NO_THROW(validate_table(table)) << material_text(material);
}

TEST(MaterialEdits, StepFluxesOfEitherSignUpAndDown) {
  Material material = given(-10);
  edit_material(material, "more emission");
  EXPECT_EQ(material.emission, Spectrum::scalar(-8));
  edit_material(material, "less emission");
  EXPECT_EQ(material.emission, Spectrum::scalar(-10));
  EXPECT_TRUE(material.has_given_flux());
  expect_valid(material);
}

TEST(MaterialEdits, AFluxBelowZeroIsNoEmission) {
  for (const char* edit : {"less reflectivity", "colour"}) {
    Material material = given(-10);
    edit_material(material, edit);
    EXPECT_FALSE(material.has_given_flux());
    EXPECT_TRUE(material.emission.is_zero()) << edit;
    expect_valid(material);
  }
  Material typed = given(-10);
  EXPECT_EQ(read_material("reflectivity 0.5", typed), "");
  expect_valid(typed);
}

TEST(MaterialEdits, OfTwoBandsHaveTwoValuesAfterwards) {
  for (const char* edit : {"less reflectivity", "more reflectivity", "less emission", "more emission", "colour"}) {
    Material material = given(-10);
    set_bands(Rational(1, 2), 3, material);
    edit_material(material, edit);
    EXPECT_EQ(material.reflectivity.value[1], material.reflectivity.value[2]) << edit;
    EXPECT_EQ(material.emission.value[1], material.emission.value[2]) << edit;
    expect_valid(material);
  }
}

TEST(SettleBands, MakesWhatIsAddedSolar) {
  SceneTable table;
  table.materials = {{"lamp", Spectrum::scalar(Rational(1, 4)), Spectrum::scalar(5)}};
  table.lights.emplace_back().power = Spectrum::scalar(7);
  settle_bands(table);
  EXPECT_FALSE(table.materials[0].has_bands);
  table.has_bands = true;
  settle_bands(table);
  settle_bands(table);
  EXPECT_EQ(table.materials[0].emission, in_bands(5, 0));
  EXPECT_EQ(table.materials[0].reflectivity, in_bands(Rational(1, 4), Rational(1, 4)));
  EXPECT_EQ(table.lights[0].power, in_bands(7, 0));
}

}  // namespace
}  // namespace hottel::material_edits_test
