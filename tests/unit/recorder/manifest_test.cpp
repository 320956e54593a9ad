#include "services/recorder/manifest/manifest.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "services/recorder/manifest/manifest_words.hpp"

namespace markservo::recorder {
namespace {

constexpr std::int64_t kStart = 1'700'000'000'000'000;  // 2023-11-14 22:13:20 UTC
constexpr std::int64_t kSecond_us = 1'000'000;
const LoggerEnd kKilled{LoggerEnd::Who::kLogger, true, SIGKILL};
const std::string kWhy = "lcm-logger was killed by signal 9 (SIGKILL)";

Json begun() {
  RecordingPlan plan;
  plan.lcm_url = "udpm://?ttl=0";
  plan.note = "a 'note'";
  ManifestBeginning beginning;
  beginning.name = "today";
  beginning.start_utime = kStart;
  beginning.host = "here";
  beginning.types = {{"StereoFrame", "0x1"}};
  beginning.configuration = {{"sha256", ""}, {"files", Json::array()}};
  return begun_manifest(beginning, plan);
}

// What log-tool info --json prints of one part.
Json found() {
  return Json::parse(R"({"files": [{"path": "/logs/today/log.lcm", "bytes": 2500000, "events": 30,
                                    "damage": [{"offset": 7, "bytes": 3}]},
                                   {"path": "/logs/today/log.lcm.01", "damage": []}],
                         "channels": [{"channel": "A", "events": 10, "lost": 2}, {"channel": "B", "events": 20, "lost": null}]})");
}

ManifestEnd ended(Json what) {
  return {"told to", kStart + 12 * kSecond_us, 0, "", {{"log.lcm", 2'400'000}, {"log.lcm.01", 100'000}},
          4,         std::move(what)};
}

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

// Others read them: log-tool, experiments, and whoever has recordings.
const std::vector<std::string> kKeys = {"format_version", "name",          "note",     "start",      "end",
                                        "ended_by",       "host",          "lcm_url",  "robot",      "lcm_version",
                                        "source",         "with_frames",   "split_mb", "keep_parts", "min_free_mb",
                                        "types",          "configuration", "logger",   "parts",      "parts_removed",
                                        "events",         "lost",          "damage",   "channels",   "gaps"};

TEST(Instant, IsUtcAndMicroseconds) {
  EXPECT_EQ(instant(kStart + 5), (Json{{"utc", "2023-11-14T22:13:20Z"}, {"utime", kStart + 5}}));
}

TEST(Manifest, HasAllItsKeysFromTheBeginning) {
  const Json manifest = begun();
  EXPECT_EQ(keys_of(manifest), kKeys);
  EXPECT_TRUE(is_manifest(manifest));
  EXPECT_FALSE(is_complete(manifest));
  EXPECT_EQ(manifest["format_version"], 1);
  EXPECT_EQ(manifest["start"]["utime"], kStart);
  EXPECT_TRUE(manifest["end"].is_null());
  EXPECT_TRUE(manifest["split_mb"].is_null());
  EXPECT_EQ(manifest["min_free_mb"], 500);
  EXPECT_TRUE(manifest["with_frames"]);
}

TEST(Manifest, KeepsItsKeysAndTheirOrderToTheEnd) {
  Json manifest = begun();
  begin_gap(&manifest, kStart + kSecond_us, kKilled, kWhy);
  end_gap(&manifest, kStart + 2 * kSecond_us);
  complete(&manifest, ended(found()));
  EXPECT_EQ(keys_of(manifest), kKeys);
  EXPECT_EQ(keys_of(manifest["gaps"][0]),
            (std::vector<std::string>{"from", "to", "exit_code", "signal", "reason", "times"}));
}

TEST(Manifest, CountsWhatWasFound) {
  Json manifest = begun();
  complete(&manifest, ended(found()));
  EXPECT_TRUE(is_complete(manifest));
  EXPECT_EQ(manifest["ended_by"], "told to");
  EXPECT_EQ(manifest["end"]["utime"], kStart + 12 * kSecond_us);
  EXPECT_EQ(manifest["logger"], (Json{{"exit_code", 0}, {"said", ""}}));
  EXPECT_EQ(manifest["parts"][1], (Json{{"file", "log.lcm.01"}, {"bytes", 100'000}}));
  EXPECT_EQ(manifest["parts_removed"], 4);
  EXPECT_EQ(manifest["events"], 30);
  EXPECT_EQ(manifest["lost"], 2) << "null is what cannot be counted";
  EXPECT_EQ(manifest["channels"].size(), 2U);
  EXPECT_EQ(manifest["damage"], Json::parse(R"([{"file": "log.lcm", "offset": 7, "bytes": 3}])"));
}

TEST(Manifest, LeavesOpenWhatNobodyCanTell) {
  Json manifest = begun();
  ManifestEnd end = ended(nullptr);
  end.logger_exit_code.reset();
  complete(&manifest, end);
  EXPECT_TRUE(manifest["channels"].is_null());
  EXPECT_TRUE(manifest["events"].is_null());
  EXPECT_TRUE(manifest["logger"]["exit_code"].is_null());
}

TEST(Manifest, CountsNothingWhereNothingWasRecorded) {
  Json manifest = begun();
  complete(&manifest, ended(nothing_found()));
  EXPECT_EQ(manifest["events"], 0);
  EXPECT_EQ(manifest["lost"], 0);
  EXPECT_EQ(manifest["channels"], Json::array());
  EXPECT_EQ(manifest["damage"], Json::array());
}

TEST(Gap, SaysFromWhenToWhenAndWhy) {
  Json manifest = begun();
  begin_gap(&manifest, kStart + kSecond_us, kKilled, kWhy);
  const Json& gap = manifest["gaps"][0];
  EXPECT_TRUE(gap["to"].is_null());
  end_gap(&manifest, kStart + 2 * kSecond_us);
  EXPECT_EQ(gap["from"]["utime"], kStart + kSecond_us);
  EXPECT_EQ(gap["to"]["utime"], kStart + 2 * kSecond_us);
  EXPECT_EQ(gap["exit_code"], 137);
  EXPECT_EQ(gap["signal"], 9);
  EXPECT_EQ(gap["reason"], kWhy);
  EXPECT_EQ(gap["times"], 1);
}

TEST(Gap, HasNoSignalWhereNoneEndedTheLogger) {
  Json manifest = begun();
  begin_gap(&manifest, kStart, {}, "its network interface went away");
  EXPECT_EQ(manifest["gaps"][0]["exit_code"], 0);
  EXPECT_TRUE(manifest["gaps"][0]["signal"].is_null());
}

TEST(Gap, EndsWithTheRecordingWhereItIsOpen) {
  Json manifest = begun();
  begin_gap(&manifest, kStart + kSecond_us, kKilled, kWhy);
  complete(&manifest, ended(nothing_found()));
  EXPECT_EQ(manifest["gaps"][0]["to"], manifest["end"]);
}

TEST(Gap, GrowsInPlaceOfAThousandAndFirst) {
  Json manifest = begun();
  for (int i = 0; i < 1003; ++i) {
    begin_gap(&manifest, kStart + i * kSecond_us, kKilled, kWhy);
    end_gap(&manifest, kStart + i * kSecond_us + 1);
  }
  EXPECT_EQ(manifest["gaps"].size(), 1000U);
  EXPECT_EQ(manifest["gaps"][998]["times"], 1);
  EXPECT_EQ(manifest["gaps"][999]["times"], 4);
  EXPECT_EQ(manifest["gaps"][999]["from"]["utime"], kStart + 999 * kSecond_us);
  EXPECT_EQ(manifest["gaps"][999]["to"]["utime"], kStart + 1002 * kSecond_us + 1);
}

TEST(ManifestText, HasNoBytesThatAreNoText) {
  Json manifest = begun();
  manifest["note"] = "\xff\xfe caf\xc3\xa9";
  EXPECT_NE(manifest_text(manifest).find("\xEF\xBF\xBD\xEF\xBF\xBD caf\xc3\xa9"), std::string::npos);
  EXPECT_EQ(manifest_text(manifest).back(), '\n');
}

TEST(IsManifest, KnowsOthers) {
  EXPECT_FALSE(is_manifest(nullptr));
  EXPECT_FALSE(is_manifest(Json::array()));
  EXPECT_FALSE(is_manifest(Json{{"format_version", 1}}));
}

TEST(ToldOfRecording, IsOneLine) {
  Json manifest = begun();
  complete(&manifest, ended(nothing_found()));
  EXPECT_EQ(told_of_recording(manifest, "scripts/log"), "12 s, 2.5 MB in 2 file(s), 0 messages on 0 channels, 0 lost");
}

TEST(ToldOfRecording, SaysThatItIsNotCounted) {
  Json manifest = begun();
  complete(&manifest, ended({}));
  EXPECT_EQ(told_of_recording(manifest, "scripts/log"),
            "12 s, 2.5 MB in 2 file(s), not counted (scripts/log info counts)");
}

TEST(ToldOfRecording, NamesGapsAndDamage) {
  Json manifest = begun();
  begin_gap(&manifest, kStart, kKilled, kWhy);
  end_gap(&manifest, kStart + 1'260'000);
  complete(&manifest, ended(found()));
  EXPECT_EQ(told_of_recording(manifest, "markservo log"),
            "12 s, 2.5 MB in 2 file(s), 30 messages on 2 channels, 2 lost, not recorded for 1.3 s, torn at the end or "
            "damaged (markservo log info tells where)");
}

TEST(ToldOfRecording, SaysThatItWasNotCountedAndWhatCounts) {
  Json manifest = begun();
  complete(&manifest, ended(nullptr));
  EXPECT_EQ(told_of_recording(manifest, "scripts/log"),
            "12 s, 2.5 MB in 2 file(s), not counted (scripts/log info counts)");
}

TEST(ToldOfGaps, NamesEachReasonOnce) {
  Json manifest = begun();
  begin_gap(&manifest, kStart, kKilled, "the one");
  end_gap(&manifest, kStart + 1'250'000);
  begin_gap(&manifest, kStart, kKilled, "another");
  end_gap(&manifest, kStart + 750'000);
  begin_gap(&manifest, kStart, kKilled, "the one");
  EXPECT_EQ(told_of_gaps(manifest), "2 s are missing (another, the one)");
}

}  // namespace
}  // namespace markservo::recorder
