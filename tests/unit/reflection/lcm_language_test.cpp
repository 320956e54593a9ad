#include "common/reflection/lcm_language.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "common/reflection/type_catalog.hpp"
#include "tests/unit/lcmtypes/all_types.hpp"

namespace markservo::reflection {
namespace {

template <class M>
class FingerprintOf : public ::testing::Test {};
TYPED_TEST_SUITE(FingerprintOf, AllTypes);

TYPED_TEST(FingerprintOf, ATypeIsTheOneThatLcmGenComputes) {
  const MessageType* type = TypeCatalog::ours().find(TypeParam::getTypeName());
  ASSERT_NE(type, nullptr);
  EXPECT_EQ(type->fingerprint, static_cast<std::uint64_t>(TypeParam::getHash()));
  EXPECT_EQ(TypeCatalog::ours().find(type->fingerprint), type);
}

template <class... M>
std::size_t count_of(::testing::Types<M...>) {
  return sizeof...(M);
}

TEST(TypeCatalog, HasEveryTypeOfTheProjectAndNoOther) {
  EXPECT_EQ(TypeCatalog::ours().all().size(), count_of(AllTypes{}));
  EXPECT_EQ(TypeCatalog::ours().find(std::uint64_t{1}), nullptr);
  EXPECT_EQ(TypeCatalog::ours().find("example_t"), nullptr);
}

TEST(LcmLanguage, UnderstandsCommentsConstantsListsOfFieldsAndConstantSizes) {
  const auto types = parse_types(
      "package a.b; /* two\n lines */ struct first_t { const int32_t X = 1, Y = 2; int32_t n, m; // end\n"
      "double p[n][3]; other_t o; c.third_t t[m]; } struct other_t { byte b; }",
      "test");
  ASSERT_EQ(types.size(), 2U);
  EXPECT_EQ(types[0].full_name(), "a.b.first_t");
  ASSERT_EQ(types[0].fields.size(), 5U);
  EXPECT_EQ(types[0].fields[2].dimensions[0].length_field, 0);
  EXPECT_EQ(types[0].fields[2].dimensions[1].size, 3);
  EXPECT_EQ(types[0].fields[3].type_name, "a.b.other_t");
  EXPECT_EQ(types[0].fields[4].type_name, "c.third_t");
}

TEST(LcmLanguage, GivesEachRowOfConstantsThatCountsFromZeroToOneField) {
  const auto types = parse_types(
      "struct s { const int32_t MOST = 9; const int8_t A = 0; const int8_t B = 1; const int8_t X = 0, Y = 1, Z = 2;\n"
      "int8_t list[2]; int32_t n; int8_t first; int8_t second; int8_t third; const double C = -0.5; }",
      "test");
  using Names = std::map<std::int64_t, std::string>;
  std::vector<Names> names;
  for (const Field& field : types.at(0).fields) names.push_back(field.value_names);
  EXPECT_EQ(names, (std::vector<Names>{{}, {}, {{0, "A"}, {1, "B"}}, {{0, "X"}, {1, "Y"}, {2, "Z"}}, {}}));
}

const std::string& name_of_value(const char* type, const char* field, std::int8_t value) {
  for (const Field& one : TypeCatalog::ours().find(std::string(type))->fields) {
    if (one.name == field) return one.value_names.at(value);
  }
  throw std::invalid_argument(field);
}

TEST(LcmLanguage, NamesTheProjectsStatesAsTheirConstantsAreCalled) {
  EXPECT_EQ(name_of_value("LocatedMark", "role", DetectedMark::ROLE_MANIPULATOR), "ROLE_MANIPULATOR");
  EXPECT_EQ(name_of_value("LocatedMark", "status", LocatedMark::SEEN_BY_ONE), "SEEN_BY_ONE");
  EXPECT_EQ(name_of_value("LocatedMark", "cue", LocatedMark::CUE_OUTLINE), "CUE_OUTLINE");
  EXPECT_EQ(name_of_value("BaseGoal", "kind", BaseGoal::DRIVE), "DRIVE");
  EXPECT_EQ(name_of_value("BaseGoal", "frame", BaseGoal::ROBOT), "ROBOT");
  EXPECT_EQ(name_of_value("TaskState", "state", TaskState::HOLD_LIFTED), "HOLD_LIFTED");
  EXPECT_EQ(name_of_value("TaskState", "result", TaskState::RESULT_FAILED), "RESULT_FAILED");
  for (const MessageType* type : TypeCatalog::ours().all()) {
    for (const Field& field : type->fields) {
      EXPECT_TRUE(field.kind != Kind::kInt8 || !field.value_names.empty()) << type->name << "." << field.name;
    }
  }
}

std::string complaint(const std::string& text) {
  try {
    TypeCatalog(parse_types(text, "x.lcm"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(LcmLanguage, SaysInWhichLineWhatIsWrong) {
  EXPECT_EQ(complaint("package a;\nstruct s {\n double x[k];\n}"),
            "x.lcm:3: array size 'k'; allowed here: a whole number above 0, a constant, or an integer field before it");
  EXPECT_EQ(complaint("struct s { double n; double x[n]; }"),
            "x.lcm:1: array size 'n'; allowed here: a whole number above 0, a constant, or an integer field before it");
  for (const char* size : {"0", "08", "0x", "3e", "-1", "99999999999", "0x7fffffff", "]"}) {
    EXPECT_NE(complaint("struct s { double x[" + std::string(size) + "]; }").find("array size '"), std::string::npos)
        << size;
  }
  EXPECT_EQ(complaint("union u { }"), "x.lcm:1: 'union'; allowed here: package, struct or enum");
  EXPECT_EQ(complaint("struct s { const int8_t A = 1.5; }"),
            "x.lcm:1: constant A = '1.5'; allowed here: a whole number");
  EXPECT_EQ(complaint("enum e { A = 1,\n B = 0x1 }"), "x.lcm:2: B = 1; allowed here: a value that no other name has");
  EXPECT_EQ(complaint("enum e { A = x }"), "x.lcm:1: A = 'x'; allowed here: a whole number");
  EXPECT_EQ(complaint("struct s { double 9; }"), "x.lcm:1: '9'; allowed here: a name");
  EXPECT_EQ(complaint("struct s { double x; double x; }"), "x.lcm:1: a second field 'x'; allowed here: a new name");
  EXPECT_EQ(complaint("struct s { double x"), "x.lcm:1: ''; allowed here: ';'");
  EXPECT_EQ(complaint("struct s { const int8_t A = 1"), "x.lcm:1: the text ends; allowed here: more of a type");
  EXPECT_EQ(complaint("struct s { t x; }"), "type s, field x: type t is not defined");
  EXPECT_EQ(complaint("struct s { } struct s { }"), "type s is defined twice; allowed: once");
  EXPECT_EQ(complaint("struct s { s children[2]; }"), "");
}

}  // namespace
}  // namespace markservo::reflection
