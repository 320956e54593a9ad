#include "services/simulator/readers/rfid_reader_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace markservo::simulator {
namespace {

constexpr std::int64_t kBegin = 5'000'000;

const robot::RobotDescription& test_robot() {
  static const robot::RobotDescription robot =
      robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
  return robot;
}

const robot::TagField& hall() {
  return test_robot().floor_tags->field("hall");
}

RfidReaderModel hall_reader(const RfidReaderParameters& parameters = {}, std::uint64_t seed = 1) {
  return {*test_robot().rfid, parameters, TagFloor(hall(), {}, 1), seed};
}

const Eigen::Vector2d& place_of(const std::string& uid) {
  for (const robot::FloorTag& tag : hall().tags) {
    if (tag.uid == uid) return tag.p_W;
  }
  throw std::invalid_argument("no tag " + uid);
}

// The robot stands at `pose` for `rounds` rounds; all answers of that time.
std::vector<TagRound> stand(RfidReaderModel& reader, const geometry::PlanePose& pose, int rounds) {
  std::vector<TagRound> answers;
  for (std::int64_t utime = kBegin; utime <= kBegin + rounds * 100'000 + 400'000; utime += 2'000) {
    reader.observe(utime, pose);
    for (TagRound& round : reader.take_arrived(utime)) answers.push_back(std::move(round));
  }
  answers.resize(static_cast<std::size_t>(rounds));
  return answers;
}

// The robot drives along x from `x` at `speed` (m/s) for 2 s in steps of `step_us`.
std::vector<TagRound> drive(RfidReaderModel& reader, double x, double speed, std::int64_t step_us) {
  std::vector<TagRound> answers;
  for (std::int64_t t = 0; t <= 2'000'000; t += step_us) {
    reader.observe(kBegin + t, {x + speed * static_cast<double>(t) * 1e-6, 2.03, 0.0});
    for (TagRound& round : reader.take_arrived(kBegin + t)) answers.push_back(std::move(round));
  }
  return answers;
}

bool same(const std::vector<TagRound>& a, const std::vector<TagRound>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].utime != b[i].utime || a[i].hits.size() != b[i].hits.size()) return false;
    for (std::size_t k = 0; k < a[i].hits.size(); ++k) {
      if (a[i].hits[k].uid != b[i].hits[k].uid || std::abs(a[i].hits[k].rssi - b[i].hits[k].rssi) > 1e-6) return false;
    }
  }
  return true;
}

int count_of(const std::vector<TagRound>& rounds, const std::string& uid) {
  int count = 0;
  for (const TagRound& round : rounds) {
    for (const TagHit& hit : round.hits) count += hit.uid == uid ? 1 : 0;
  }
  return count;
}

// The sum over tags near `p_W` of (reads - expected)^2 / variance, and the number of tags.
std::pair<double, int> read_misfit(const std::vector<TagRound>& rounds, const Eigen::Vector2d& p_W, double missed) {
  const robot::RfidDescription& rfid = *test_robot().rfid;
  double misfit = 0.0;
  int tags = 0;
  for (const robot::FloorTag& tag : hall().tags) {
    const double distance = (tag.p_W - p_W).norm();
    if (distance > 0.13) continue;
    const double p = (1.0 - missed) * rfid.read_probability /
                     (1.0 + std::exp((distance - rfid.reading_radius) / rfid.edge_softness));
    const auto n = static_cast<double>(rounds.size());
    misfit += std::pow(count_of(rounds, tag.uid) - n * p, 2) / (n * p * (1.0 - p));
    ++tags;
  }
  return {misfit, tags};
}

TEST(RfidReaderModel, ReadsEveryTagAsOftenAsItsDistanceSays) {
  for (const double missed : {0.0, 0.3}) {
    RfidReaderParameters parameters;
    parameters.missed = missed;
    RfidReaderModel reader = hall_reader(parameters);
    // Off the grid's symmetry, so that the distances differ.
    const auto answers = stand(reader, {2.021, 2.043, 0.7}, 2000);
    const auto [misfit, tags] = read_misfit(answers, {2.021, 2.043}, missed);
    ASSERT_GE(tags, 4);
    EXPECT_LT(misfit, tags + 4.0 * std::sqrt(2.0 * tags)) << tags << " tags, missed " << missed;
  }
}

TEST(RfidReaderModel, TheAntennaIsWhereTheDescriptionMountsIt) {
  robot::RfidDescription rfid = *test_robot().rfid;
  rfid.p_RF = {0.5, 0.0};
  RfidReaderModel reader(rfid, {}, TagFloor(hall(), {}, 1), 1);
  const auto answers = stand(reader, {2.0, 1.5, 0.5 * M_PI}, 50);
  for (const TagRound& round : answers) {
    for (const TagHit& hit : round.hits) EXPECT_LT((place_of(hit.uid) - Eigen::Vector2d(2.0, 2.0)).norm(), 0.2);
  }
  EXPECT_GT(count_of(answers, hall().tags[20 * 41 + 20].uid), 40);
}

TEST(RfidReaderModel, AnAnswerArrivesTheDelayAfterItsRoundsMiddle) {
  RfidReaderModel reader = hall_reader();
  for (std::int64_t utime = kBegin; utime < kBegin + 240'000; utime += 2'000) {
    reader.observe(utime, {2.0, 2.0, 0.0});
    EXPECT_TRUE(reader.take_arrived(utime).empty()) << utime - kBegin;
  }
  reader.observe(kBegin + 240'000, {2.0, 2.0, 0.0});
  const auto arrived = reader.take_arrived(kBegin + 240'000);
  ASSERT_EQ(arrived.size(), 1U);
  EXPECT_EQ(arrived[0].utime, kBegin + 240'000);
  EXPECT_TRUE(reader.take_arrived(kBegin + 240'000).empty()) << "each once";
}

TEST(RfidReaderModel, AHostThatDoesNotKnowTheWindowTellsTheTimesBetweenAnswers) {
  RfidReaderModel reader = hall_reader();
  const auto answers = stand(reader, {2.0, 2.0, 0.0}, 5);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::int64_t arrival = kBegin + 240'000 + static_cast<std::int64_t>(i) * 100'000;
    EXPECT_EQ(answers[i].utime, arrival);
    EXPECT_EQ(answers[i].window_end, arrival);
    EXPECT_EQ(answers[i].window_start, arrival - 100'000) << "the answer before; a round before the first";
    EXPECT_FALSE(answers[i].window_known);
    for (const TagHit& hit : answers[i].hits) {
      EXPECT_EQ(hit.utime, arrival);
      EXPECT_EQ(hit.read_utime, 0);
      EXPECT_FALSE(hit.read_time_known);
    }
  }
}

TEST(RfidReaderModel, AReaderWithTheHostsClockTellsTrueWindowsAndTimes) {
  RfidReaderParameters parameters;
  parameters.read_time_known = true;
  RfidReaderModel reader = hall_reader(parameters);
  const auto answers = stand(reader, {2.0, 2.0, 0.0}, 200);
  double sum = 0.0;
  int reads = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::int64_t start = kBegin + static_cast<std::int64_t>(i) * 100'000;
    EXPECT_EQ(answers[i].window_start, start);
    EXPECT_EQ(answers[i].window_end, start + 100'000);
    EXPECT_TRUE(answers[i].window_known);
    std::int64_t before = start;
    for (const TagHit& hit : answers[i].hits) {
      EXPECT_TRUE(hit.read_time_known);
      EXPECT_EQ(hit.utime, answers[i].utime);
      EXPECT_GE(hit.read_utime, before) << "in order";
      EXPECT_LT(hit.read_utime, start + 100'000);
      before = hit.read_utime;
      sum += static_cast<double>(hit.read_utime - start) * 1e-5;
      ++reads;
    }
  }
  EXPECT_NEAR(sum / reads, 0.5, 4.0 * 0.29 / std::sqrt(reads)) << "evenly over the round";
}

TEST(RfidReaderModel, ARoundIsReadWhereTheAntennaIsAtEachTagsMoment) {
  RfidReaderParameters parameters;
  parameters.read_time_known = true;
  RfidReaderModel reader = hall_reader(parameters);
  for (const TagRound& round : drive(reader, 1.0, 1.0, 2'000)) {
    for (const TagHit& hit : round.hits) {
      const double x = 1.0 + static_cast<double>(hit.read_utime - kBegin) * 1e-6;
      EXPECT_LT((place_of(hit.uid) - Eigen::Vector2d(x, 2.03)).norm(), 0.19);
    }
  }
}

TEST(RfidReaderModel, TheStepSizeDoesNotMatter) {
  RfidReaderModel fine = hall_reader();
  RfidReaderModel coarse = hall_reader();
  EXPECT_TRUE(same(drive(fine, 1.0, 0.8, 2'000), drive(coarse, 1.0, 0.8, 20'000)));
}

TEST(RfidReaderModel, TheSameSeedReadsTheSame) {
  RfidReaderModel first = hall_reader({}, 3);
  RfidReaderModel again = hall_reader({}, 3);
  RfidReaderModel other = hall_reader({}, 4);
  const auto answers = drive(first, 1.0, 0.4, 2'000);
  EXPECT_TRUE(same(answers, drive(again, 1.0, 0.4, 2'000)));
  EXPECT_FALSE(same(answers, drive(other, 1.0, 0.4, 2'000)));
}

TEST(RfidReaderModel, JitterMovesArrivalsAndKeepsTheirOrder) {
  RfidReaderParameters parameters;
  parameters.delay_jitter = 0.15;
  RfidReaderModel reader = hall_reader(parameters);
  const auto answers = stand(reader, {2.0, 2.0, 0.0}, 200);
  std::set<std::int64_t> delays;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::int64_t end = kBegin + static_cast<std::int64_t>(i + 1) * 100'000;
    EXPECT_GE(answers[i].utime, end) << "no answer before its round's end";
    EXPECT_LE(answers[i].utime, end - 50'000 + 340'000);
    delays.insert(answers[i].utime - end);
    if (i == 0) continue;
    EXPECT_GT(answers[i].utime, answers[i - 1].utime);
    EXPECT_EQ(answers[i].window_start, answers[i - 1].utime);
  }
  EXPECT_GT(delays.size(), 100U);
}

TEST(RfidReaderModel, StraysComeAtTheirRate) {
  RfidReaderParameters parameters;
  parameters.unknown_tags = 0.2;
  parameters.false_reads = 0.1;
  RfidReaderModel reader = hall_reader(parameters);
  const TagFloor floor(hall(), {}, 1);
  int unknown = 0;
  int far = 0;
  for (const TagRound& round : stand(reader, {2.0, 2.0, 0.0}, 1000)) {
    for (const TagHit& hit : round.hits) {
      if (!floor.maps(hit.uid)) {
        ++unknown;
      } else if ((place_of(hit.uid) - Eigen::Vector2d(2.0, 2.0)).norm() > 0.3) {
        ++far;
      }
    }
  }
  EXPECT_NEAR(unknown, 200, 4.0 * std::sqrt(1000 * 0.2 * 0.8));
  EXPECT_NEAR(far, 100, 4.0 * std::sqrt(1000 * 0.1 * 0.9));
}

TEST(RfidReaderModel, DuplicatesTellATagTwiceInOneRound) {
  RfidReaderParameters parameters;
  parameters.duplicates = 1.0;
  RfidReaderModel reader = hall_reader(parameters);
  for (const TagRound& round : stand(reader, {2.0, 2.0, 0.0}, 20)) {
    for (const TagHit& hit : round.hits) EXPECT_EQ(count_of({round}, hit.uid), 2);
  }
}

TEST(RfidReaderModel, NearerTagsAnswerStronger) {
  RfidReaderModel reader = hall_reader();
  double near = 0.0;
  double far = 0.0;
  int nears = 0;
  int fars = 0;
  for (const TagRound& round : stand(reader, {2.0, 2.0, 0.0}, 500)) {
    for (const TagHit& hit : round.hits) {
      const bool below = (place_of(hit.uid) - Eigen::Vector2d(2.0, 2.0)).norm() < 0.01;
      (below ? near : far) += hit.rssi;
      ++(below ? nears : fars);
    }
  }
  EXPECT_GT(near / nears, far / fars + 5.0);
}

TEST(RfidReaderModel, AReaderThatMissesAllSendsEmptyRounds) {
  RfidReaderModel reader = hall_reader();
  RfidReaderParameters parameters;
  parameters.missed = 1.0;
  reader.change(parameters);
  for (const TagRound& round : stand(reader, {2.0, 2.0, 0.0}, 20)) EXPECT_TRUE(round.hits.empty());
}

TEST(RfidReaderModel, RefusesImpossibleParametersAndTimes) {
  RfidReaderParameters parameters;
  parameters.delay = 0.04;
  EXPECT_THROW(hall_reader(parameters), std::invalid_argument) << "before its round's end";
  parameters.delay.reset();
  parameters.missed = 1.1;
  EXPECT_THROW(hall_reader(parameters), std::invalid_argument);
  RfidReaderModel reader = hall_reader();
  EXPECT_THROW(reader.change(parameters), std::invalid_argument);
  reader.observe(kBegin, {});
  EXPECT_THROW(reader.observe(kBegin, {}), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::simulator
