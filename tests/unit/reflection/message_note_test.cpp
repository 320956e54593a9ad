#include "common/reflection/message_note.hpp"

#include <gtest/gtest.h>

#include <markservo/StopRequest.hpp>
#include <markservo/TargetPose.hpp>
#include <vector>
#include "tests/unit/encoded.hpp"

namespace markservo::reflection {
namespace {

using test::encoded;

using reflection::TypeCatalog;

MessageNote note_of_bytes(const std::vector<std::uint8_t>& bytes) {
  return note_of(TypeCatalog::ours(), bytes.data(), bytes.size());
}

TEST(MessageNote, ReadsTypeSessionAndSeq) {
  TargetPose pose{};
  pose.session = 12;
  pose.seq = 34;
  const MessageNote note = note_of_bytes(encoded(pose));
  EXPECT_EQ(note.type, "TargetPose");
  EXPECT_EQ(note.fingerprint, static_cast<std::uint64_t>(TargetPose::getHash()));
  EXPECT_TRUE(note.decodes);
  EXPECT_EQ(note.session, 12);
  EXPECT_EQ(note.seq, 34);
}

TEST(MessageNote, KnowsATypeWithoutSeq) {
  StopRequest stop{};
  stop.session = 12;
  const MessageNote note = note_of_bytes(encoded(stop));
  EXPECT_EQ(note.session, 12);
  EXPECT_EQ(note.seq, -1);
}

TEST(MessageNote, NamesTheTypeOfABrokenMessage) {
  std::vector<std::uint8_t> bytes = encoded(TargetPose{});
  bytes.pop_back();
  const MessageNote note = note_of_bytes(bytes);
  EXPECT_EQ(note.type, "TargetPose");
  EXPECT_FALSE(note.decodes);
}

TEST(MessageNote, DoesNotBlameATypeThatIsNotOurs) {
  const MessageNote note = note_of_bytes(std::vector<std::uint8_t>(24, 0x5a));
  EXPECT_EQ(note.type, "");
  EXPECT_EQ(note.fingerprint, 0x5a5a5a5a5a5a5a5aU);
  EXPECT_TRUE(note.decodes);
}

TEST(MessageNote, BlamesWhatIsTooShortForAnyType) {
  const MessageNote note = note_of_bytes(std::vector<std::uint8_t>(7, 0));
  EXPECT_FALSE(note.fingerprint.has_value());
  EXPECT_FALSE(note.decodes);
}

}  // namespace
}  // namespace markservo::reflection
