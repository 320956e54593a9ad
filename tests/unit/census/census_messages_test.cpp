#include "common/census/census_messages.hpp"

#include <gtest/gtest.h>

#include <markservo/StopState.hpp>
#include <markservo/channels.hpp>

#include "common/reflection/type_catalog.hpp"
#include "tests/unit/encoded.hpp"

namespace markservo::census {
namespace {

ServiceStatus status() {
  ServiceStatus status{};
  status.utime = 1'700'000'000'000'000;
  status.session = 5;
  status.seq = 1;
  status.name = "visual-servo";
  status.host = "here";
  status.state = "ready";
  return status;
}

std::optional<ServiceWord> heard(const ServiceStatus& message, const std::string& channel = "SERVICE_STATUS") {
  const auto bytes = test::encoded(message);
  return word_in(channel, bytes.data(), bytes.size());
}

TEST(ServiceWord, IsHeardOnItsChannelOfAnyRobot) {
  ASSERT_TRUE(heard(status()));
  EXPECT_EQ(heard(status())->name, "visual-servo");
  ASSERT_TRUE(heard(status(), "r1/SERVICE_STATUS"));
  EXPECT_EQ(heard(status(), "r1/SERVICE_STATUS")->robot, "r1");
}

TEST(ServiceWord, IsNoneOnAnotherChannel) {
  for (const char* channel : {"POSE", "", "MY_SERVICE_STATUS", "SERVICE_STATUS/x"}) {
    EXPECT_FALSE(heard(status(), channel)) << channel;
  }
}

TEST(ServiceWord, IsNoneThatBreaksARuleOfItsType) {
  ServiceStatus broken = status();
  broken.name = "evil\x1b[2J";
  EXPECT_FALSE(heard(broken));
  broken = status();
  broken.reason = std::string(201, 'x');
  EXPECT_FALSE(heard(broken));
  broken = status();
  broken.session = 0;
  EXPECT_FALSE(heard(broken));
  broken = status();
  broken.utime = -1;
  EXPECT_FALSE(heard(broken));
  broken = status();
  broken.num_channels = 1;
  broken.channels.resize(1);
  broken.channels[0].lost = -1;
  EXPECT_FALSE(heard(broken));
}

// The message's bytes with another fingerprint: another version of its type, as far as anyone can tell.
template <class M>
std::vector<std::uint8_t> of_another_version(const M& message) {
  auto bytes = test::encoded(message);
  bytes[7] ^= 1;
  return bytes;
}

TEST(ServiceWord, OfAnotherVersionTellsWhoSpeaks) {
  ServiceStatus theirs = status();
  theirs.pid = 4711;
  theirs.version = "9.0.0";
  auto bytes = of_another_version(theirs);
  bytes.push_back(0);  // a field more
  const auto word = word_in("r1/SERVICE_STATUS", bytes.data(), bytes.size());
  ASSERT_TRUE(word);
  EXPECT_EQ(word->robot, "r1");
  EXPECT_EQ(word->name, "visual-servo");
  EXPECT_EQ(word->host, "here");
  EXPECT_EQ(word->pid, 4711);
  EXPECT_EQ(word->session, 5);
  EXPECT_EQ(word->version, "9.0.0");
  EXPECT_FALSE(is_ready(word->state)) << "nobody knows";
  EXPECT_NE(word->reason.find("another version of ServiceStatus"), std::string::npos) << word->reason;
}

TEST(ServiceWord, OfAnotherVersionIsNoneWhereItsHeadMakesNoSense) {
  const auto whole = of_another_version(status());
  // Up to the version: what comes behind it may be anything.
  const std::size_t head = 8 + 3 * 8 + (4 + 13) + (4 + 5) + 4 + (4 + 1);
  EXPECT_TRUE(word_in("SERVICE_STATUS", whole.data(), head));
  for (std::size_t size = 0; size < head; ++size) {
    const std::vector<std::uint8_t> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(word_in("SERVICE_STATUS", part.data(), part.size())) << size;
  }
  ServiceStatus broken = status();
  broken.name = "evil\x1b[2J";
  const auto evil = of_another_version(broken);
  EXPECT_FALSE(word_in("SERVICE_STATUS", evil.data(), evil.size()));
  for (std::size_t at = 8; at < head; ++at) {
    auto bytes = whole;
    bytes[at] = 0xff;  // as a length it is negative
    EXPECT_NO_THROW(word_in("SERVICE_STATUS", bytes.data(), bytes.size()));
  }
}

TEST(Heard, OfAnotherVersionTellsTheWriterAndBothFingerprints) {
  StopState state{};
  state.utime = 1;
  state.session = 6;
  const auto bytes = of_another_version(state);
  const Heard heard = heard_of("r1/STOP_STATE", bytes.data(), bytes.size(), bytes.size(), 2);
  ASSERT_TRUE(heard.other_version);
  EXPECT_EQ(heard.other_version->type, "StopState");
  EXPECT_EQ(heard.other_version->our_hash, StopState::getHash());
  EXPECT_EQ(heard.hash, StopState::getHash() ^ 1);
  EXPECT_EQ(heard.other_version->session, 6);
  EXPECT_FALSE(heard.session) << "another version may have others where we read it";
}

TEST(Heard, IsNoOtherVersionOnAChannelThatIsNotOurs) {
  const auto unknown = of_another_version(StopState{});
  EXPECT_FALSE(heard_of("STRANGE", unknown.data(), unknown.size(), unknown.size(), 2).other_version);
  const auto known = test::encoded(StopState{});
  EXPECT_FALSE(heard_of("TARGET_POSE", known.data(), known.size(), known.size(), 2).other_version)
      << "another type of ours: whoever writes it took the wrong channel";
}

// What the policy for versions (lcmtypes/README.md) promises of every version, and the above relies on.
TEST(Types, BeginWithWhatEveryVersionBeginsWith) {
  for (const channels::Entry& entry : channels::kAll) {
    const reflection::MessageType* type = reflection::TypeCatalog::ours().find(std::string(entry.type));
    ASSERT_NE(type, nullptr) << entry.type;
    ASSERT_GE(type->fields.size(), 2U);
    EXPECT_EQ(type->fields[0].name, "utime") << entry.type;
    EXPECT_EQ(type->fields[0].kind, reflection::Kind::kInt64) << entry.type;
    EXPECT_EQ(type->fields[1].name, "session") << entry.type;
    EXPECT_EQ(type->fields[1].kind, reflection::Kind::kInt64) << entry.type;
  }
  const auto& head = reflection::TypeCatalog::ours().find(std::string("ServiceStatus"))->fields;
  const std::vector<std::string> expected = {"utime", "session", "seq", "name", "host", "pid", "version"};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(head.at(i).name, expected[i]);
}

}  // namespace
}  // namespace markservo::census
