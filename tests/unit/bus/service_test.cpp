#include "common/bus/service.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <markservo/ServiceStatus.hpp>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/bus/environment_variable.hpp"

namespace markservo::bus {
namespace {

class OneSetting : public Service {
 public:
  void add_options(CLI::App& app) override {
    app.add_option("--gain", gain, "A gain")->capture_default_str();
    app.add_option("--word", words, "Words");
    app.add_option("--count", count, "A whole number")->check(CLI::Range(-1000, 1000))->capture_default_str();
  }
  void configure(const std::string&) override {
    if (gain < 0.0) throw ConfigurationError("gain is negative; allowed: 0 or more");
  }
  void start(Bus& bus) override {
    started = true;
    if (waits) bus.set_state("waiting", "for work");
    bus.stop();
  }
  void run(Bus& bus) override {
    state = bus.status().state;
    if (!says.empty()) bus.publish_raw("SAID", says.data(), says.size());
  }
  double gain = 0.5;
  std::vector<std::string> words;
  int count = 7;
  bool waits = false;
  std::string says;  // on the bus
  bool started = false;
  std::string state;
};

class ServiceMain : public ::testing::Test {
 protected:
  ServiceMain() : file_(std::filesystem::temp_directory_path() / ("markservo-service-" + std::to_string(getpid()))) {}
  ~ServiceMain() override { std::filesystem::remove(file_); }

  int run(std::vector<std::string> arguments, const std::string& program = "one-setting") {
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    argv.reserve(arguments.size());
    for (auto& argument : arguments) argv.push_back(argument.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_service({"one-setting", "A test"}, service_, static_cast<int>(argv.size()), argv.data());
    output_ = testing::internal::GetCapturedStdout();
    errors_ = testing::internal::GetCapturedStderr();
    return code;
  }
  void write_config(const std::string& text) { std::ofstream(file_) << text; }

  std::filesystem::path file_;
  OneSetting service_;
  std::string output_;
  std::string errors_;
};

TEST_F(ServiceMain, EndsWithZeroWhenStopped) {
  EXPECT_EQ(run({"--lcm-url", "memq://"}), kExitStopped);
}

TEST_F(ServiceMain, GoesOnTheBusThatLcmsVariableNamesAndSaysSo) {
  const test::EnvironmentVariable ours("MARKSERVO_LCM_URL", std::nullopt);
  const test::EnvironmentVariable of_lcm("LCM_DEFAULT_URL", "memq://");
  EXPECT_EQ(run({}), kExitStopped);
  EXPECT_NE(errors_.find("on memq:// (the bus that LCM_DEFAULT_URL names)"), std::string::npos) << errors_;
}

// A robot's service waits for its network, but an address where nobody serves may be a slip.
TEST_F(ServiceMain, IsRefusedInOneLineByAServerThatIsMissing) {
  const test::EnvironmentVariable ours("MARKSERVO_LCM_URL", std::nullopt);
  EXPECT_EQ(run({"--lcm-url", "tcpq://127.0.0.1:1"}), kExitBusUnavailable);
  EXPECT_NE(errors_.find("no LCM server at 127.0.0.1:1 (Connection refused)"), std::string::npos) << errors_;
  EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1) << errors_;
  const test::EnvironmentVariable of_lcm("LCM_DEFAULT_URL", "tcpq://127.0.0.1:1");
  EXPECT_EQ(run({}), kExitBusUnavailable);
  EXPECT_NE(errors_.find("(the bus that LCM_DEFAULT_URL names)"), std::string::npos) << errors_;
  EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1) << errors_;
}

TEST_F(ServiceMain, SpeaksInTheNameOfTheCommandThatWasTyped) {
  EXPECT_EQ(run({"--gain"}, "markservo setting"), kExitBadConfiguration);
  EXPECT_EQ(errors_.rfind("setting: ", 0), 0U) << errors_;
  EXPECT_NE(errors_.find("; see markservo setting --help\n"), std::string::npos) << errors_;
  EXPECT_EQ(run({"--gain"}, "build/release/bin/one-setting"), kExitBadConfiguration);
  EXPECT_EQ(errors_.rfind("one-setting: ", 0), 0U) << errors_;
  EXPECT_NE(errors_.find("; see one-setting --help\n"), std::string::npos) << errors_;
}

TEST_F(ServiceMain, ReadsItsConfigFileAndPrintsAllSettings) {
  write_config("gain=0.25\n");
  EXPECT_EQ(run({"--config", file_.string(), "--print-config"}), kExitStopped);
  EXPECT_NE(output_.find("gain=0.25"), std::string::npos);
  EXPECT_NE(output_.find("lcm-url"), std::string::npos);
}

TEST_F(ServiceMain, ChecksItsConfigurationWithoutABus) {
  write_config("gain=0.25\n");
  EXPECT_EQ(run({"--config", file_.string(), "--check", "--lcm-url", "file:///nowhere/no.lcm"}), kExitStopped);
  EXPECT_NE(output_.find("valid"), std::string::npos);
  EXPECT_FALSE(service_.started);
  EXPECT_EQ(run({"--gain", "-1", "--check"}), kExitBadConfiguration);
  EXPECT_NE(errors_.find("negative"), std::string::npos);
}

TEST_F(ServiceMain, IsReadyUnlessItSaysThatItWaits) {
  run({"--lcm-url", "memq://"});
  EXPECT_EQ(service_.state, "ready");
  service_.waits = true;
  run({"--lcm-url", "memq://"});
  EXPECT_EQ(service_.state, "waiting");
}

TEST_F(ServiceMain, RefusesAnUnknownKey) {
  write_config("gian=0.25\n");
  EXPECT_EQ(run({"--config", file_.string()}), kExitBadConfiguration);
  EXPECT_NE(errors_.find(file_.string() + ": line 1: key 'gian' is unknown; allowed: the options that --help lists"),
            std::string::npos)
      << errors_;
}

TEST_F(ServiceMain, RefusesAKeyThatStandsTwice) {
  write_config("gain=0.25\n\ngain=0.5\n");
  EXPECT_EQ(run({"--config", file_.string()}), kExitBadConfiguration);
  EXPECT_NE(errors_.find("line 3: key 'gain' stands twice, first on line 1; allowed: once"), std::string::npos)
      << errors_;
}

TEST_F(ServiceMain, RefusesAKeyWithoutAValue) {
  write_config("gain=\n");
  EXPECT_EQ(run({"--config", file_.string()}), kExitBadConfiguration);
  EXPECT_NE(errors_.find("line 1: key 'gain' has no value"), std::string::npos) << errors_;
}

TEST_F(ServiceMain, GathersTheValuesOfAnOptionThatTakesMany) {
  write_config("word=one\ngain=0.25\nword=two\nword=[three, four]\n");
  EXPECT_EQ(run({"--config", file_.string(), "--check"}), kExitStopped);
  EXPECT_EQ(service_.words, (std::vector<std::string>{"one", "two", "three", "four"}));
}

TEST_F(ServiceMain, TakesAPathWithSpacesFromItsConfigFile) {
  write_config("robot-file=/home of/my robot.yaml   # mine\n");
  EXPECT_EQ(run({"--config", file_.string(), "--print-config"}), kExitStopped);
  EXPECT_NE(output_.find("robot-file=\"/home of/my robot.yaml\""), std::string::npos) << output_;
}

TEST_F(ServiceMain, ReadsTheSettingsThatItPrints) {
  write_config("gain=0.25\nrobot-file=\"/home of/my #1/robot.yaml\"   # mine\n");
  run({"--config", file_.string(), "--print-config"});
  const std::string printed = output_;
  write_config(printed);
  EXPECT_EQ(run({"--config", file_.string(), "--print-config"}), kExitStopped);
  EXPECT_EQ(output_, printed);
}

TEST_F(ServiceMain, RefusesAWrongTypeAndABadValueInOneLine) {
  EXPECT_EQ(run({"--gain", "much"}), kExitBadConfiguration);
  EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1);
  EXPECT_EQ(run({"--gain", "-1"}), kExitBadConfiguration);
  EXPECT_NE(errors_.find("negative"), std::string::npos);
}

TEST_F(ServiceMain, TakesWholeNumbersAsPeopleWriteThem) {
  for (const char* number : {"0640", "0x40", "-010", "+", "1.5"}) {
    EXPECT_EQ(run({"--count", number, "--check"}), kExitBadConfiguration) << number;
    EXPECT_EQ(service_.count, 7) << number;
  }
  write_config("count=0640\n");
  EXPECT_EQ(run({"--config", file_.string(), "--check"}), kExitBadConfiguration);
  EXPECT_NE(errors_.find("--count: '0640'; allowed: a whole number, without zeros before it"), std::string::npos)
      << errors_;
  write_config("count=-640\n");
  EXPECT_EQ(run({"--config", file_.string(), "--check"}), kExitStopped) << errors_;
  EXPECT_EQ(service_.count, -640);
  EXPECT_EQ(run({"--count", "0", "--check"}), kExitStopped) << errors_;
  EXPECT_EQ(service_.count, 0);
}

// What is small stays in a buffer until the end.
TEST_F(ServiceMain, FailsInOneLineWhereItsLogIsNotWritten) {
  for (const std::size_t size : {std::size_t{10}, std::size_t{1'000'000}}) {
    service_.says = std::string(size, 'x');
    EXPECT_EQ(run({"--lcm-in", "memq://", "--lcm-out", "file:///dev/full?mode=w"}), kExitFailed) << size;
    EXPECT_NE(errors_.find("log /dev/full cannot be written: No space left on device; allowed: "), std::string::npos)
        << errors_;
    EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1) << errors_;
  }
}

TEST_F(ServiceMain, EndsWithThreeWithoutABus) {
  EXPECT_EQ(run({"--lcm-url", "file:///nowhere/no.lcm"}), kExitBusUnavailable);
  EXPECT_NE(errors_.find("no.lcm"), std::string::npos);
}

}  // namespace
}  // namespace markservo::bus
