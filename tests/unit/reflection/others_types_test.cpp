// Message types of another LCM system, read from its files when a tool runs. The fingerprints and bytes are those of
// the Python code that lcm-gen 1.3.1 makes of these texts.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include "common/reflection/message_value.hpp"
#include "common/reflection/type_files.hpp"
#include "common/reflection/value_text.hpp"

namespace markservo::reflection {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRover = R"(package rover;

enum mode_t { IDLE = 0, DRIVE, BRAKE = 0x10, FAULT = -1 }

struct wheel_t {
  double speed;
  mode_t mode;
}

struct motor_command_t {
  const int32_t WHEELS = 4;
  const int8_t MOST = 0x7f, LEAST = -2;
  const double GAIN = 2.5e-1;
  const int8_t OFF = 0, ON = 1;
  int64_t timestamp;
  int16_t num;
  wheel_t wheels[0x4];
  double matrix[2][03];
  mode_t modes[num];
  int8_t kind;
}
)";

constexpr const char* kMotorCommand =
    "23d0b39b22dd75ff00060a241820224000020000000000000000000000003fe0000000000000000000103ff0000000000000000000103ff800"
    "0000000000000000103ff000000000000040000000000000004008000000000000401000000000000040140000000000004018000000000000"
    "ffffffff0000000701";

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  return bytes;
}

class OthersTypes : public ::testing::Test {
 protected:
  OthersTypes() { fs::create_directories(folder_ + "/below"); }
  ~OthersTypes() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + "/" + name, std::ios::binary) << text;
    return folder_ + "/" + name;
  }
  static std::string complaint(const std::vector<std::string>& paths) {
    try {
      types_with(paths);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  }
  static std::uint64_t fingerprint(const TypeCatalog& types, const std::string& name) {
    const MessageType* type = types.find(name);
    return type == nullptr ? 0 : type->fingerprint;
  }

  std::string folder_ = fs::temp_directory_path() / ("others_types_test." + std::to_string(getpid()));
};

TEST_F(OthersTypes, HaveTheFingerprintsThatLcmGenComputes) {
  const TypeCatalog types = types_with({file("rover.lcm", kRover)});
  EXPECT_EQ(fingerprint(types, "rover.mode_t"), 0x21066d6f658c94fa);
  EXPECT_EQ(fingerprint(types, "rover.wheel_t"), 0x513fa069935300d3);
  EXPECT_EQ(fingerprint(types, "rover.motor_command_t"), 0x23d0b39b22dd75ff);
  EXPECT_NE(types.find("TargetPose"), nullptr) << "ours are known besides";
  EXPECT_EQ(shown_name(*types.find("TargetPose")), "TargetPose");
  EXPECT_EQ(shown_name(*types.find("motor_command_t")), "rover.motor_command_t");
}

TEST_F(OthersTypes, DecodeHexadecimalAndOctalSizesEnumerationsAndNestedTypes) {
  const TypeCatalog types = types_with({file("rover.lcm", kRover)});
  const auto bytes = bytes_of(kMotorCommand);
  const DecodedMessage message = decode(types, bytes.data(), bytes.size());
  ASSERT_EQ(message.error, "");
  std::map<std::string, std::string> texts;
  for (const Leaf& leaf : leaves(message.fields)) texts[leaf.path] = text_of(*leaf.field, leaf.value);
  EXPECT_EQ(texts.at("timestamp"), "1700000000123456");
  EXPECT_EQ(texts.at("wheels[3].speed"), "1.5");
  EXPECT_EQ(texts.at("wheels[0].mode"), "IDLE");
  EXPECT_EQ(texts.at("wheels[3].mode"), "BRAKE");
  EXPECT_EQ(texts.at("matrix[1][2]"), "6");
  EXPECT_EQ(texts.at("modes[0]"), "FAULT");
  EXPECT_EQ(texts.at("modes[1]"), "7") << "no name";
  EXPECT_EQ(texts.at("kind"), "1") << "another's constants name nothing";
}

TEST_F(OthersTypes, HaveValuesOfAnEnumerationThatIsAMessageItself) {
  const TypeCatalog types = types_with({file("rover.lcm", kRover)});
  const auto bytes = bytes_of("21066d6f658c94fa00000010");
  const DecodedMessage message = decode(types, bytes.data(), bytes.size());
  ASSERT_EQ(message.error, "");
  const auto found = leaves(message.fields);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(text_of(*found[0].field, found[0].value), "BRAKE");
}

TEST_F(OthersTypes, CountOnFromTheLargestValueOfAnEnumerationAsLcmGenDoes) {
  const TypeCatalog types = types_with({file("e.lcm", "enum e { A, B = -5, C, D = 0x10; E }")});
  EXPECT_EQ(types.find("e")->fields[0].value_names,
            (std::map<std::int64_t, std::string>{{1, "A"}, {-5, "B"}, {2, "C"}, {16, "D"}, {17, "E"}}));
}

TEST_F(OthersTypes, TakeAConstantForASizeWithTheFingerprintOfItsTextAsWritten) {
  const auto sized = [this](const std::string& constant, const std::string& size) {
    const std::string text =
        "package rover; struct sized_t { const int32_t N = " + constant + "; int64_t utime; double q[" + size + "]; }";
    return fingerprint(types_with({file("sized.lcm", text)}), "rover.sized_t");
  };
  EXPECT_EQ(sized("4", "4"), 0xdf627a0790ec866e);
  EXPECT_EQ(sized("4", "N"), 0xdf627a0790ec866e);
  EXPECT_EQ(sized("9", "0x4"), 0x85f86f137d97512d);
  EXPECT_EQ(sized("0x4", "N"), 0x85f86f137d97512d);
}

TEST_F(OthersTypes, StandInFilesAndFoldersAndMayComeTwice) {
  const std::string rover = file("rover.lcm", kRover);
  file("below/arm.lcm", "package arm; struct state_t { rover.wheel_t wheel; markservo.Vector3 p_W; }");
  file("below/notes.txt", "no type");
  const TypeCatalog types = types_with({rover, folder_});
  ASSERT_NE(types.find("arm.state_t"), nullptr);
  EXPECT_EQ(types.find("arm.state_t")->fields[1].message, TypeCatalog::ours().find("Vector3")) << "nests one of ours";
}

TEST_F(OthersTypes, MayBeAnotherVersionOfOurs) {
  const TypeCatalog types = types_with({file("TargetPose.lcm", "package markservo; struct TargetPose { int64_t x; }")});
  EXPECT_EQ(types.find(std::uint64_t{TypeCatalog::ours().find("TargetPose")->fingerprint})->fields.size(),
            TypeCatalog::ours().find("TargetPose")->fields.size());
  EXPECT_EQ(types.find("TargetPose")->fields.size(), 1U);
  EXPECT_EQ(types.find(types.find("TargetPose")->fingerprint), types.find("TargetPose"));
}

TEST_F(OthersTypes, AreRefusedWithTheFileAndTheReason) {
  const std::string allowed = "; allowed: a file in LCM's type language (struct, enum), or a folder of .lcm files";
  EXPECT_EQ(complaint({folder_ + "/none.lcm"}), folder_ + "/none.lcm: No such file or directory" + allowed);
  EXPECT_EQ(complaint({folder_ + "/below"}), folder_ + "/below: holds no .lcm file" + allowed);
  const std::string log = file("log.lcm", std::string("\xed\xa1\xda\x01\0\0", 6));
  EXPECT_EQ(complaint({log}), log + ": is no text (a log?)" + allowed);
  EXPECT_EQ(complaint({"/dev/zero"}), "/dev/zero: is no file" + allowed);
  const std::string bad = file("bad.lcm", "struct s {\n int8_t x\n}");
  EXPECT_EQ(complaint({bad}), bad + ":3: '}'; allowed here: ';'");
  const std::string nested = file("nested.lcm", "package a; struct s { t x; }");
  EXPECT_EQ(complaint({nested}),
            "type a.s, field x: type a.t is not defined; allowed: types of the files given by "
            "--types, and ours");
  const std::string one = file("one.lcm", "struct s { int8_t x; }");
  const std::string other = file("other.lcm", "struct s { int16_t x; }");
  EXPECT_EQ(complaint({one, other}),
            other + ": type s is another one in " + one + "; allowed: one definition of a type");
}

}  // namespace
}  // namespace markservo::reflection
