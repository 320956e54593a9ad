// A log in, a log out: every event handled, and the same bytes written run after run.

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <lcm/lcm-cpp.hpp>

#include "common/bus/log_not_written.hpp"
#include "tests/unit/bus/bus_fixture.hpp"

namespace markservo::bus {
namespace {

class Replay : public BusTest {
 protected:
  Replay() : folder_(std::filesystem::temp_directory_path() / ("markservo-replay-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    lcm::LCM log("file://" + path("in.lcm") + "?mode=w");
    for (std::int64_t utime = 1; utime <= 50; ++utime) {
      auto state = joint_state(utime);
      state.session = 7;
      state.seq = utime;
      log.publish("JOINT_STATE", &state);
    }
  }
  ~Replay() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  BusParameters from_log(const std::string& out) const {
    BusParameters result;
    result.urls = {"file://" + path("in.lcm") + "?speed=0", "file://" + path(out) + "?mode=w"};
    result.service_name = "test";
    return result;
  }

  // (channel, payload) of every event of a log.
  std::vector<std::pair<std::string, std::string>> events(const std::string& name) const {
    std::vector<std::pair<std::string, std::string>> result;
    lcm::LogFile log(path(name), "r");
    while (const auto* event = log.good() ? log.readNextEvent() : nullptr) {
      result.emplace_back(event->channel,
                          std::string(static_cast<const char*>(event->data), static_cast<std::size_t>(event->datalen)));
    }
    return result;
  }

  // us, of every event of a log.
  std::vector<std::int64_t> event_times(const std::string& name) const {
    std::vector<std::int64_t> times;
    lcm::LogFile log(path(name), "r");
    while (const auto* event = log.good() ? log.readNextEvent() : nullptr) times.push_back(event->timestamp);
    return times;
  }

  void run_through(const std::string& out) const {
    Bus bus(from_log(out));
    auto publisher = bus.advertise(made_up<JointState>("ECHO"));
    bus.on_latest(channels::kJointState, [&](const JointState& state) {
      auto echo = joint_state(state.utime * 2);
      publisher.publish(echo);
    });
    bus.spin();
  }

  std::filesystem::path folder_;
};

TEST_F(Replay, HandlesEveryEventEvenOfALatestSubscription) {
  run_through("out.lcm");
  EXPECT_EQ(events("out.lcm").size(), 50U);
}

TEST_F(Replay, ReadsALogWhateverItsPathIsCalled) {
  const std::string log = "mode=walk.lcm";
  std::filesystem::copy(path("in.lcm"), path(log));
  BusParameters parameters = from_log("out.lcm");
  parameters.urls.in = "file://" + path(log) + "?speed=0";
  int heard = 0;
  {
    Bus bus(parameters);
    bus.on_latest(channels::kJointState, [&heard](const JointState& /*state*/) { ++heard; });
    bus.spin();
  }
  EXPECT_EQ(heard, 50);
  EXPECT_EQ(std::filesystem::file_size(path(log)), std::filesystem::file_size(path("in.lcm")));
}

TEST(BusUrl, TellsByItsParametersAloneWhetherALogIsWritten) {
  for (const char* written : {"file://x?mode=w", "file://x?speed=0&mode=w", "file://x?mode=r&mode=w"}) {
    EXPECT_TRUE(is_written_file(written)) << written;
  }
  for (const char* read : {"file:///mode=w/x", "file://x?mode=r", "file://x?mode=walk", "file://x?xmode=w",
                           "file://x?mode=w&mode=r", "udpm://?mode=w"}) {
    EXPECT_FALSE(is_written_file(read)) << read;
  }
}

TEST_F(Replay, WritesTheSameBytesTwice) {
  run_through("first.lcm");
  run_through("second.lcm");
  EXPECT_EQ(events("first.lcm"), events("second.lcm"));
}

TEST_F(Replay, GivesEventsTheTimesOfTheirMessages) {
  run_through("out.lcm");
  const std::vector<std::int64_t> times = event_times("out.lcm");
  ASSERT_EQ(times.size(), 50U);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(times[i], 2 * (static_cast<std::int64_t>(i) + 1));
}

TEST_F(Replay, GivesWhatTellsNoTimeThatOfTheNewestMessageHeard) {
  {
    Bus bus(from_log("out.lcm"));
    bus.on_latest(channels::kJointState, [&](const JointState& state) {
      if (state.utime == 30) bus.publish_raw("RAW", "bytes", 5);
    });
    bus.spin();
  }
  EXPECT_EQ(event_times("out.lcm"), std::vector<std::int64_t>{30});
}

TEST_F(Replay, WritesALogOfTheSameTimesWhereThereIsNothingToRead) {
  BusParameters parameters;
  parameters.urls = {"memq://", "file://" + path("source.lcm") + "?mode=w"};
  parameters.service_name = "test";
  parameters.source = true;
  {
    Bus bus(parameters);
    auto publisher = bus.advertise(channels::kJointState);
    for (const std::int64_t utime : {1'700'000'000'000'000, 1'700'000'000'066'667, 1'700'000'000'466'667}) {
      auto state = joint_state(utime);
      publisher.publish(state);
    }
  }
  EXPECT_EQ(event_times("source.lcm"),
            (std::vector<std::int64_t>{1'700'000'000'000'000, 1'700'000'000'066'667, 1'700'000'000'466'667}));
}

TEST_F(Replay, SaysThatALogCannotBeWritten) {
  BusParameters parameters = from_log("no/such/folder.lcm");
  try {
    Bus bus(parameters);
    ADD_FAILURE() << "it was opened";
  } catch (const BusUnavailable& error) {
    EXPECT_EQ(error.what(),
              "log " + path("no/such/folder.lcm") +
                  " cannot be written: No such file or directory; allowed: a file in a folder that can be "
                  "written");
  }
}

TEST_F(Replay, EndsWhereItsLogTakesNoMore) {
  BusParameters parameters = from_log("");
  parameters.urls.out = "file:///dev/full?mode=w";
  Bus bus(parameters);
  int heard = 0;
  bus.on_latest(channels::kJointState, [&](const JointState& /*state*/) {
    ++heard;
    const std::string much(1'000'000, 'x');
    bus.publish_raw("RAW", much.data(), much.size());
  });
  bus.spin();
  EXPECT_LE(heard, 2) << "what else it would do is in vain";
  EXPECT_EQ(bus.status().channels[0].refused, 0) << "no fault of the message's";
  EXPECT_THROW(bus.finish(), LogNotWritten);
}

TEST_F(Replay, WritesNoHeartbeat) {
  Bus bus(from_log("quiet.lcm"));
  bus.set_state("ready");
  bus.spin();
  EXPECT_TRUE(events("quiet.lcm").empty());
}

TEST_F(Replay, OfAMissingLogIsRefusedBeforeLcmCrashesOnIt) {
  auto missing = from_log("out.lcm");
  missing.urls.in = "file://" + path("no.lcm") + "?speed=0";
  EXPECT_THROW(Bus{missing}, BusUnavailable);
}

}  // namespace
}  // namespace markservo::bus
