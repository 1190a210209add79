#include "viewer/edit/typed_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hottel::typed_numbers_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(TypedNumbers, AreExactAndApartByBlanksCommasOrSemicolons) {
  for (const char* text : {"0.1 -2/3", "0.1,-2/3", "  0.1 , -2/3 ", "1e-1;\t-2/3"}) {
    const auto typed = typed_numbers(text);
    ASSERT_TRUE(typed.value) << text;
    EXPECT_THAT(*typed.value, ElementsAre(Rational(1, 10), Rational(-2, 3)));
    EXPECT_EQ(typed.problem, "");
  }
  EXPECT_THAT(*typed_numbers("  ").value, IsEmpty());
}

TEST(TypedNumbers, SayWhatIsWrong) {
  for (const char* text : {",1", "1,", "1,,2", "1 ; , 2", ","}) {
    const auto typed = typed_numbers(text);
    EXPECT_FALSE(typed.value) << text;
    EXPECT_THAT(typed.problem, HasSubstr("a number is missing"));
  }
  EXPECT_EQ(typed_numbers("1 1/0").problem, "this is not a number: '1/0'");
  EXPECT_EQ(typed_numbers("wide").problem, "this is not a number: 'wide'");
  EXPECT_FALSE(typed_numbers("1\n2").value);
}

TEST(TypedSpectrum, IsOneNumberOrThree) {
  const auto grey = typed_spectrum("0.5", SpectrumKind::kFraction);
  ASSERT_TRUE(grey.value);
  EXPECT_EQ(*grey.value, Spectrum::scalar(Rational(1, 2)));
  EXPECT_TRUE(grey.value->is_scalar);
  const auto warm = typed_spectrum("1 0.9 0.8", SpectrumKind::kFraction);
  ASSERT_TRUE(warm.value);
  EXPECT_EQ(warm.value->value[2], Rational(4, 5));
  EXPECT_FALSE(warm.value->is_scalar);
  for (const char* text : {"", "1 2", "1 2 3 4"}) EXPECT_FALSE(typed_spectrum(text, SpectrumKind::kQuantity).value);
  EXPECT_THAT(typed_spectrum("1 2", SpectrumKind::kQuantity).problem, HasSubstr("there are 2"));
}

TEST(TypedSpectrum, IsInItsRange) {
  EXPECT_EQ(typed_spectrum("1.5", SpectrumKind::kFraction).problem, "it must be from 0 to 1");
  EXPECT_TRUE(typed_spectrum("1.5", SpectrumKind::kQuantity).value);
  EXPECT_EQ(typed_spectrum("1 -1 1", SpectrumKind::kQuantity).problem, "it must not be negative");
  EXPECT_THAT(typed_spectrum("x", SpectrumKind::kFraction).problem, HasSubstr("is not a number"));
}

}  // namespace
}  // namespace hottel::typed_numbers_test
