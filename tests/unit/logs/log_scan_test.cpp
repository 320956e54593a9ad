#include "common/logs/log_scan.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <lcm/lcm-cpp.hpp>

#include "common/logs/log_files.hpp"
#include "tests/unit/logs/log_bytes.hpp"

namespace markservo::logs {
namespace {

OwnedEvent owned(const LogEvent& event) {
  return {event.number, event.utime, std::string(event.channel), std::string(event.data.text())};
}

std::vector<OwnedEvent> scanned(const std::string& bytes) {
  std::vector<OwnedEvent> events;
  for (const LogEvent& event : scan(view_of(bytes), fit_of(reflection::TypeCatalog::ours())).events)
    events.push_back(owned(event));
  return events;
}

// What lcm::LogFile gives when reading goes on after each of its errors until the end of the file.
std::vector<OwnedEvent> as_liblcm_reads(const std::string& bytes) {
  const std::string path = std::filesystem::temp_directory_path() / ("log_scan_test." + std::to_string(getpid()));
  std::ofstream(path, std::ios::binary) << bytes;
  std::vector<OwnedEvent> events;
  lcm::LogFile log(path, "r");
  // It tells an error from the end by nothing but where it stands.
  for (int failures = 0; failures < 1000 && std::feof(log.getFilePtr()) == 0;) {
    const lcm::LogEvent* event = log.readNextEvent();
    if (event == nullptr) {
      ++failures;
      continue;
    }
    events.push_back({event->eventnum, event->timestamp, event->channel,
                      std::string(static_cast<const char*>(event->data), static_cast<std::size_t>(event->datalen))});
  }
  std::filesystem::remove(path);
  return events;
}

bool contains(const std::vector<OwnedEvent>& events, const OwnedEvent& wanted) {
  return std::find(events.begin(), events.end(), wanted) != events.end();
}

class LogScan : public ::testing::Test {
 protected:
  std::mt19937 random_{11};
  std::vector<OwnedEvent> events_ = mixed_events(30, random_);
  std::string bytes_ = log_bytes(events_);

  std::size_t begin_of(std::size_t index) const {
    return log_bytes(std::vector<OwnedEvent>(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(index)))
        .size();
  }
};

TEST_F(LogScan, ReadsAWholeLogAsLiblcmDoes) {
  EXPECT_EQ(scanned(bytes_), events_);
  EXPECT_EQ(as_liblcm_reads(bytes_), events_);
  EXPECT_TRUE(scan(view_of(bytes_), fit_of(reflection::TypeCatalog::ours())).damage.empty());
}

TEST_F(LogScan, KeepsAllEventsWhereASyncWordIsCorrupt) {
  bytes_[begin_of(10) + 1] ^= 0x10;
  EXPECT_FALSE(contains(as_liblcm_reads(bytes_), events_[9])) << "liblcm drops the event before it";
  EXPECT_EQ(scanned(bytes_), events_);
  const Scan result = scan(view_of(bytes_), fit_of(reflection::TypeCatalog::ours()));
  ASSERT_EQ(result.damage.size(), 1U);
  EXPECT_EQ(result.damage[0].offset, begin_of(10));
}

TEST_F(LogScan, FindsTheLengthOfAMessageWhoseSizeLostABit) {
  for (const std::size_t index : {3U, 4U, 5U}) {
    for (const int bit : {3, 6, 20}) {
      std::string damaged = bytes_;
      damaged[begin_of(index) + 27 - static_cast<std::size_t>(bit / 8)] ^= static_cast<char>(1 << bit % 8);
      EXPECT_EQ(scanned(damaged), events_) << "event " << index << ", bit " << bit;
    }
  }
}

TEST_F(LogScan, KeepsWhatComesBeforeATruncatedEnd) {
  bytes_.resize(begin_of(20) + 40);
  EXPECT_EQ(scanned(bytes_), std::vector<OwnedEvent>(events_.begin(), events_.begin() + 20));
}

TEST_F(LogScan, FindsTheLogBehindGarbage) {
  EXPECT_EQ(scanned("garbage" + bytes_), events_);
  EXPECT_TRUE(scanned("").empty());
  EXPECT_TRUE(scanned(std::string(1000, '\xED')).empty());
}

// One corruption: where it begins and ends in the whole log's own bytes.
struct Corruption {
  std::string bytes;
  std::size_t begin;
  std::size_t end;
};

Corruption corrupted(const std::string& whole, std::mt19937& random) {
  Corruption result{whole, random() % whole.size(), 0};
  result.end = result.begin + 1;
  switch (random() % 4) {
    case 0:  // a bit turns
      result.bytes[result.begin] ^= static_cast<char>(1 << random() % 8);
      break;
    case 1:  // a piece is gone
      result.end = std::min(whole.size(), result.begin + 1 + random() % 3000);
      result.bytes.erase(result.begin, result.end - result.begin);
      break;
    case 2: {  // garbage stands between
      std::string garbage(1 + random() % 3000, '\0');
      for (char& byte : garbage) byte = static_cast<char>(random());
      result.bytes.insert(result.begin, garbage);
      result.end = result.begin;
      break;
    }
    default:  // a piece is overwritten
      result.end = std::min(whole.size(), result.begin + 1 + random() % 300);
      for (std::size_t i = result.begin; i < result.end; ++i) result.bytes[i] = static_cast<char>(random());
  }
  return result;
}

TEST_F(LogScan, KeepsEveryEventOutsideTheDamageAndNeverFewerThanLiblcm) {
  int kept_beyond_liblcm = 0;
  for (unsigned trial = 0; trial < 400; ++trial) {
    std::mt19937 random(1000 + trial);
    const std::vector<OwnedEvent> whole = mixed_events(30, random);
    const std::string bytes = log_bytes(whole);
    const Corruption damage = corrupted(bytes, random);
    const std::vector<OwnedEvent> ours = scanned(damage.bytes);
    const std::vector<OwnedEvent> theirs = as_liblcm_reads(damage.bytes);
    std::size_t begin = 0;
    for (const OwnedEvent& event : whole) {
      const std::size_t end = begin + encoded(event.view()).size();
      const bool touched = begin < damage.end && damage.begin < end;
      const bool split = damage.begin == damage.end && begin < damage.begin && damage.begin < end;
      const bool kept = contains(ours, event);
      EXPECT_TRUE(kept || touched || split) << "trial " << trial << ", event " << event.number;
      EXPECT_TRUE(kept || !contains(theirs, event)) << "trial " << trial << ", event " << event.number << ": liblcm";
      if (kept && !contains(theirs, event)) ++kept_beyond_liblcm;
      begin = end;
    }
  }
  EXPECT_GT(kept_beyond_liblcm, 50);
}

TEST_F(LogScan, EndsOnAnyBytes) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    std::string bytes(random() % 2000, '\0');
    for (char& byte : bytes) {
      static constexpr char kLikely[] = {'\xED', '\xA1', '\xDA', '\x01', 0, 'A'};
      byte = random() % 2 == 0 ? kLikely[random() % sizeof kLikely] : static_cast<char>(random());
    }
    const Scan result = scan(view_of(bytes), fit_of(reflection::TypeCatalog::ours()));
    EXPECT_LE(result.damage.size() + result.events.size(), bytes.size());
  }
}

}  // namespace
}  // namespace markservo::logs
