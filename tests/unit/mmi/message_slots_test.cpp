#include "services/mmi/scene/message_slots.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <markservo/MarkDetection.hpp>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RecorderStatus.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskState.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/unit/encoded.hpp"

namespace markservo::mmi {
namespace {

template <class M>
Bytes bytes_of(const M& message) {
  return std::make_shared<const std::vector<std::uint8_t>>(test::encoded(message));
}

Bytes task(std::int64_t seq) {
  TaskState message{};
  message.session = std::numeric_limits<std::int64_t>::max();
  message.seq = seq;
  message.reason = "as \"told\" \xff";
  return bytes_of(message);
}

Bytes stop_of(const std::string& device) {
  StopState message{};
  message.device = device;
  return bytes_of(message);
}

Bytes raw(std::size_t size) {
  return std::make_shared<const std::vector<std::uint8_t>>(size);
}

std::string key(const Bytes& bytes) {
  return key_of(reflection::TypeCatalog::ours(), *bytes);
}

std::vector<std::string> names(const std::vector<const MessageSlots::Slot*>& slots) {
  std::vector<std::string> names;
  for (const auto* slot : slots) names.push_back(slot->channel + slot->key);
  return names;
}

TEST(KeyOfAMessage, TellsTheManyOfAChannelApart) {
  EXPECT_EQ(key(stop_of("arm")), "arm");
  ServiceStatus service{};
  service.name = "visual-servo";
  service.host = "robot";
  EXPECT_EQ(key(bytes_of(service)), "visual-servo@robot");
  ProcessStatus process{};
  process.name = "recorder";
  process.host = "desk";
  EXPECT_EQ(key(bytes_of(process)), "recorder@desk");
  RecorderStatus recorder{};
  recorder.folder = "/logs/a";
  recorder.host = "robot";
  EXPECT_EQ(key(bytes_of(recorder)), "robot:/logs/a");
}

TEST(KeyOfAMessage, IsEmptyOfAllElse) {
  EXPECT_EQ(key(task(1)), "");
  EXPECT_EQ(key(raw(0)), "");
  EXPECT_EQ(key(raw(100)), "");
  std::vector<std::uint8_t> broken = *stop_of("arm");
  broken.pop_back();
  EXPECT_EQ(key_of(reflection::TypeCatalog::ours(), broken), "");
}

TEST(SlotsOfMessages, KeepTheNewestOfEachChannelAndKey) {
  MessageSlots slots;
  slots.observe("STOP_STATE", stop_of("arm"), 1);
  slots.observe("STOP_STATE", stop_of("base"), 2);
  slots.observe("TASK_STATE", task(1), 3);
  slots.observe("TASK_STATE", task(2), 4);
  EXPECT_EQ(slots.size(), 3u);
  EXPECT_EQ(slots.find("TASK_STATE", "")->at, 4);
  EXPECT_EQ(slots.find("STOP_STATE", "arm")->at, 1);
  EXPECT_EQ(slots.find("STOP_STATE", ""), nullptr);
}

TEST(SlotsOfMessages, GiveAReaderWhatIsNewSinceItsLastOldestFirst) {
  MessageSlots slots;
  slots.observe("A", raw(8), 1);
  slots.observe("B", raw(8), 2);
  EXPECT_EQ(names(slots.since(0)), (std::vector<std::string>{"A", "B"}));
  const std::uint64_t read = slots.version();
  EXPECT_TRUE(slots.since(read).empty());
  slots.observe("C", raw(8), 3);
  slots.observe("A", raw(8), 4);
  EXPECT_EQ(names(slots.since(read)), (std::vector<std::string>{"C", "A"}));
  EXPECT_EQ(names(slots.since(0)), (std::vector<std::string>{"B", "C", "A"}));
}

TEST(SlotsOfMessages, ShowAMessageExactly) {
  MessageSlots slots;
  const auto& slot = slots.observe("TASK_STATE", task(7), 5);
  EXPECT_EQ(slot.json().find('\n'), std::string::npos);
  const auto json = nlohmann::ordered_json::parse(slot.json());
  EXPECT_EQ(json["channel"], "TASK_STATE");
  EXPECT_EQ(json["key"], "");
  EXPECT_EQ(json["at"], "5");
  EXPECT_EQ(json["message"]["session"], "9223372036854775807");
  EXPECT_EQ(json["message"]["seq"], "7");
  EXPECT_EQ(json["message"]["reason"], "as \"told\" \xef\xbf\xbd");
  EXPECT_FALSE(json.contains("bad"));
}

TEST(SlotsOfMessages, MakeTheTextOfAMessageOnce) {
  MessageSlots slots;
  slots.observe("TASK_STATE", task(7), 5);
  const char* text = slots.find("TASK_STATE", "")->json().data();
  slots.observe("OTHER", raw(8), 6);
  EXPECT_EQ(slots.find("TASK_STATE", "")->json().data(), text);
}

TEST(SlotsOfMessages, SayWhyBytesAreNoMessage) {
  MessageSlots slots;
  const auto& unknown = slots.observe("ELSEWHERE", raw(100), 5);
  const auto json = nlohmann::ordered_json::parse(unknown.json());
  EXPECT_FALSE(json["bad"].get<std::string>().empty());
  EXPECT_FALSE(json.contains("message"));
  EXPECT_TRUE(nlohmann::ordered_json::parse(slots.observe("EMPTY", raw(0), 6).json()).contains("bad"));
}

TEST(SlotsOfMessages, ShowNoNumberThatJsonHasNot) {
  StereoFrame frame{};
  frame.calibration.fx = std::numeric_limits<double>::quiet_NaN();
  MessageSlots slots;
  const auto json = nlohmann::ordered_json::parse(slots.observe("STEREO_FRAME", bytes_of(frame), 5).json());
  EXPECT_TRUE(json["message"]["calibration"]["fx"].is_null());
}

TEST(SlotsOfMessages, TellLongArraysOfBytesByTheirNumber) {
  StereoFrame frame{};
  frame.left_size = 8192;
  frame.left.resize(8192);
  frame.right_size = 8193;
  frame.right.resize(8193);
  MessageSlots slots;
  const auto json = nlohmann::ordered_json::parse(slots.observe("STEREO_FRAME", bytes_of(frame), 5).json());
  EXPECT_TRUE(json["message"]["left"].is_string());
  EXPECT_EQ(json["message"]["right"]["bytes"], 8193);
}

TEST(SlotsOfMessages, LetTheOldestGoWhenThereAreTooMany) {
  MessageSlots::Parameters parameters;
  parameters.slots_max = 3;
  MessageSlots slots(parameters);
  for (const char* channel : {"A", "B", "C"}) slots.observe(channel, raw(8), 1);
  slots.observe("A", raw(8), 2);
  EXPECT_EQ(slots.size(), 3u);
  slots.observe("D", raw(8), 3);
  EXPECT_EQ(names(slots.since(0)), (std::vector<std::string>{"C", "A", "D"}));
  EXPECT_EQ(slots.find("B", ""), nullptr);
}

TEST(SlotsOfMessages, HoldNoMoreBytesThanAllowedButForTheNewest) {
  MessageSlots::Parameters parameters;
  parameters.bytes_max = 100;
  MessageSlots slots(parameters);
  for (int i = 0; i < 20; ++i) slots.observe("A", raw(60), i);
  slots.observe("B", raw(40), 1);
  EXPECT_EQ(slots.size(), 2u);
  slots.observe("C", raw(41), 1);
  EXPECT_EQ(names(slots.since(0)), (std::vector<std::string>{"B", "C"}));
  slots.observe("D", raw(1000), 1);
  EXPECT_EQ(names(slots.since(0)), (std::vector<std::string>{"D"}));
  slots.observe("E", raw(1), 1);
  EXPECT_EQ(names(slots.since(0)), (std::vector<std::string>{"E"}));
}

TEST(MessageSlots, ShowAHugeTextByItsSize) {
  MessageSlots slots;
  TaskState message{};
  message.reason = std::string(1 << 20, '\x01');
  const auto json = nlohmann::json::parse(slots.observe("TASK_STATE", bytes_of(message), 1).json());
  EXPECT_EQ(json.count("message"), 0U);
  EXPECT_NE(json["bad"].get<std::string>().find("up to 262144 are shown"), std::string::npos);
}

TEST(MessageSlots, LetInventedKeysOfOneChannelPushNoOtherOut) {
  MessageSlots slots;
  slots.observe("TASK_STATE", task(1), 1);
  for (int i = 0; i < 5000; ++i) slots.observe("STOP_STATE", stop_of("device " + std::to_string(i)), 2);
  EXPECT_NE(slots.find("TASK_STATE", ""), nullptr);
  EXPECT_NE(slots.find("STOP_STATE", "device 4999"), nullptr);
  EXPECT_EQ(slots.size(), 1U + MessageSlots::Parameters().channel_max);
}

}  // namespace
}  // namespace markservo::mmi
