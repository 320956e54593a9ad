// What a browser may say to mmi: any texts, one a line, to a client of a log.

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <string>

#include "services/mmi/feed/client_feed.hpp"
#include "tests/fuzz/require.hpp"

namespace markservo::mmi {
namespace {

using fuzz::require;

constexpr int kMostTexts = 20;

const robot::RobotDescription& the_robot() {
  static const robot::RobotDescription robot =
      robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
  return robot;
}

class Nothing final : public Shown {
 public:
  WorldReader& world() override { return world_; }
  std::string control(const ClientWord& /*word*/) override { return {}; }
  const EventLog& events() override { return world_.events(); }
  std::int64_t utime() override { return 0; }

 private:
  WorldReader world_{the_robot(), ""};
};

class Host final : public FeedHost {
 public:
  const std::string& hello() const override { return hello_; }
  bool admits(const std::string& token) const override { return token.empty(); }
  std::string stop(const std::string& /*reason*/) override { return {}; }
  const VersionedText& stop_state() const override { return stop_; }
  PictureMaker& pictures() override { return pictures_; }
  double now() const override { return now_; }

  double now_ = 0.0;

 private:
  std::string hello_ = "{";
  VersionedText stop_;
  PictureMaker pictures_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzedDataProvider data(bytes, size);
  Host host;
  ClientFeed feed(host, std::make_unique<Nothing>());
  for (int i = 0; i < kMostTexts && data.remaining_bytes() > 0; ++i) {
    const bool greeted = feed.greeted();
    const std::string refusal = feed.hear(data.ConsumeRandomLengthString());
    require(refusal.empty() || feed.greeted() == greeted, "who is refused is not greeted by it");
    host.now_ += 0.1;
    int sent = 0;
    while (feed.next()) ++sent;
    require(sent <= 2, "a quiet world is told once");
    require(sent == 0 || feed.greeted(), "nothing is told before the hello");
  }
  return 0;
}

}  // namespace markservo::mmi
