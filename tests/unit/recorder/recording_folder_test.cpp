#include "services/recorder/folder/recording_folder.hpp"

#include <gtest/gtest.h>

#include "services/recorder/manifest/manifest_file.hpp"
#include "services/recorder/refusal.hpp"
#include "tests/unit/recorder/scratch_folder.hpp"

namespace markservo::recorder {
namespace {

constexpr std::int64_t kNow = 1'700'000'000'000'000;

std::string objection_to(const std::string& path) {
  try {
    RecordingFolder::made(path);
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.code(), 2);
    return refusal.what();
  }
  return {};
}

TEST(RecordingFolder, IsMadeWithWhatItLiesIn) {
  const ScratchFolder scratch("recording_folder_test");
  const RecordingFolder folder = RecordingFolder::made(scratch.path("a/b"));
  EXPECT_TRUE(scratch.has("a/b"));
  EXPECT_EQ(folder.name(), "b");
  EXPECT_EQ(folder.file("x"), scratch.path("a/b/x"));
}

TEST(RecordingFolder, IsRefusedWhereSomethingIs) {
  const ScratchFolder scratch("recording_folder_test");
  scratch.write("there/log.lcm", "something");
  EXPECT_EQ(objection_to(scratch.path("there")),
            scratch.path("there") + ": exists already; allowed: a new name, or an empty folder");
  EXPECT_NE(objection_to(scratch.path("there/log.lcm")).find("exists already"), std::string::npos);
  EXPECT_NE(objection_to(scratch.path("there/log.lcm/x")).find("cannot be made: "), std::string::npos);
}

TEST(RecordingFolder, LeavesNothingBehindWhereNothingWasRecorded) {
  const ScratchFolder scratch("recording_folder_test");
  const RecordingFolder folder = RecordingFolder::made(scratch.path("made"));
  scratch.write("made/log.lcm", "");
  EXPECT_TRUE(folder.reserve());
  EXPECT_TRUE(write_manifest(folder.path(), Json{{"a", 1}}));
  remove_manifest(folder.path());
  folder.undo();
  EXPECT_FALSE(scratch.has("made"));
}

TEST(RecordingFolder, StaysWhereItWasThereBefore) {
  const ScratchFolder scratch("recording_folder_test");
  std::filesystem::create_directory(scratch.path("empty"));
  RecordingFolder::made(scratch.path("empty")).undo();
  EXPECT_TRUE(scratch.has("empty"));
}

TEST(RecordingFolder, IsNamedByTheTimeAndNotTwice) {
  const ScratchFolder scratch("recording_folder_test");
  const auto folder = RecordingFolder::dated(scratch.path("logs"), kNow);
  ASSERT_TRUE(folder.has_value());
  // 2023-11-14 22:13:20 UTC, wherever this runs.
  EXPECT_EQ(folder->name().size(), std::string("2023-11-14_22-13-20").size());
  EXPECT_EQ(folder->name().substr(0, 9), "2023-11-1");
  EXPECT_EQ(folder->name().substr(16), "-20");
  EXPECT_FALSE(RecordingFolder::dated(scratch.path("logs"), kNow).has_value());
}

TEST(RecordingFolder, IsLockedByOneAtATime) {
  const ScratchFolder scratch("recording_folder_test");
  RecordingFolder one = RecordingFolder::made(scratch.path("logs"));
  EXPECT_TRUE(one.lock());
  EXPECT_FALSE(RecordingFolder::existing(scratch.path("logs")).lock());
  { const RecordingFolder moved = std::move(one); }
  EXPECT_TRUE(RecordingFolder::existing(scratch.path("logs")).lock()) << "the lock ends with the one who has it";
  EXPECT_FALSE(RecordingFolder::existing(scratch.path("absent")).lock());
}

TEST(RecordingFolder, KnowsItsParts) {
  const ScratchFolder scratch("recording_folder_test");
  const RecordingFolder folder = RecordingFolder::made(scratch.path("logs"));
  EXPECT_EQ(folder.recorded_bytes(), 0);
  scratch.write("logs/log.lcm.10", "12345");
  scratch.write("logs/log.lcm.9", "123");
  scratch.write("logs/manifest.json", "{}");
  const std::vector<Part> parts = folder.parts();
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "log.lcm.9");
  EXPECT_EQ(parts[1].bytes, 5);
  EXPECT_EQ(folder.recorded_bytes(), 8);
  folder.remove("log.lcm.9");
  EXPECT_EQ(folder.parts().size(), 1U);
  EXPECT_GT(folder.free_mb(), 0);
}

TEST(Latest, PointsToTheFolderThatWasNamedLast) {
  const ScratchFolder scratch("recording_folder_test");
  scratch.write("one/x", "1");
  scratch.write("two/x", "2");
  point_latest_to(scratch.path(), "one");
  EXPECT_EQ(scratch.read("latest/x"), "1");
  point_latest_to(scratch.path(), "two");
  EXPECT_EQ(scratch.read("latest/x"), "2");
}

TEST(ManifestFile, IsReadAsItWasWritten) {
  const ScratchFolder scratch("recording_folder_test");
  EXPECT_TRUE(read_manifest(scratch.path()).is_null());
  EXPECT_TRUE(write_manifest(scratch.path(), Json{{"b", 1}, {"a", 2}}));
  EXPECT_EQ(scratch.read("manifest.json"), "{\n  \"b\": 1,\n  \"a\": 2\n}\n");
  EXPECT_FALSE(scratch.has("manifest.json.new"));
  EXPECT_EQ(read_manifest(scratch.path()), (Json{{"b", 1}, {"a", 2}}));
  scratch.write("manifest.json", "{\"b\":");
  EXPECT_TRUE(read_manifest(scratch.path()).is_null());
  EXPECT_FALSE(write_manifest(scratch.path("absent"), Json()));
}

}  // namespace
}  // namespace markservo::recorder
