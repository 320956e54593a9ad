#include "tests/bench/latency/latency_report.hpp"

#include <gtest/gtest.h>

namespace markservo::bench {
namespace {

// 100 frames a second apart, the i-th (1 ..) answered after i times `unit` s.
FrameLedger answered_after_multiples_of(double unit) {
  FrameLedger ledger(1);
  for (int i = 1; i <= 100; ++i) {
    ledger.sent(i, 0.0);
    ledger.came_in(0, i, unit * i);
  }
  return ledger;
}

KindResult kind_of(const FrameLedger& chain, const FrameLedger& floor, const char* key = "raw_30") {
  return {key, {chain, chain}, {floor, floor}};
}

TEST(LatencyReport, has_half_and_all_but_a_hundredth_of_the_frames_below_its_percentiles) {
  const auto report =
      latency_json({kind_of(answered_after_multiples_of(0.002), answered_after_multiples_of(0.001))}, {"hop"});
  const auto& kind = report["raw_30"];
  EXPECT_DOUBLE_EQ(kind["chain_p50_ms"], 100.0);
  EXPECT_DOUBLE_EQ(kind["chain_p99_ms"], 198.0);
  EXPECT_DOUBLE_EQ(kind["floor_p50_ms"], 50.0);
  EXPECT_DOUBLE_EQ(kind["floor_p99_ms"], 99.0);
  EXPECT_DOUBLE_EQ(kind["ratio_p50"], 2.0);
  EXPECT_DOUBLE_EQ(kind["chain_hops_p50_ms"]["hop"], 100.0);
  EXPECT_DOUBLE_EQ(kind["floor_hops_p50_ms"]["hop"], 50.0);
}

TEST(LatencyReport, says_how_many_frames_were_lost) {
  FrameLedger chain = answered_after_multiples_of(0.001);
  chain.sent(101, 0.0);
  const auto report = latency_json({kind_of(chain, answered_after_multiples_of(0.001))}, {"hop"});
  EXPECT_EQ(report["raw_30"]["chain_lost"], 1);
  EXPECT_EQ(report["raw_30"]["chain_sent"], 101);
  EXPECT_EQ(report["raw_30"]["floor_lost"], 0);
  EXPECT_NE(latency_text(report).find("1 of 201"), std::string::npos);
}

TEST(LatencyReport, has_no_number_where_nothing_was_answered) {
  FrameLedger silent(1);
  silent.sent(1, 0.0);
  const auto report = latency_json({kind_of(silent, answered_after_multiples_of(0.001))}, {"hop"});
  const auto read_back = nlohmann::ordered_json::parse(report.dump());
  EXPECT_TRUE(read_back["raw_30"]["chain_p50_ms"].is_null());
  EXPECT_TRUE(read_back["raw_30"]["ratio_p50"].is_null());
  EXPECT_EQ(latency_text(report).find("nan"), std::string::npos);
}

TEST(LatencyReport, says_what_jpeg_costs_beyond_raw_frames) {
  const auto floor = answered_after_multiples_of(0.001);
  auto report = latency_json({kind_of(answered_after_multiples_of(0.002), floor),
                              kind_of(answered_after_multiples_of(0.003), floor, "jpeg_30")},
                             {"hop"});
  EXPECT_EQ(latency_text(report).find("imdecode"), std::string::npos);
  add_unpacking(report, 200.0);
  EXPECT_DOUBLE_EQ(report["jpeg_30"]["imdecode_pair_ms"], 200.0);
  EXPECT_DOUBLE_EQ(report["jpeg_30"]["unpacking_ratio"], 0.25);
  EXPECT_NE(latency_text(report).find("JPEG costs 0.25 of one cv::imdecode"), std::string::npos);
}

}  // namespace
}  // namespace markservo::bench
