#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/bench/latency/frame_ledger.hpp"

namespace markservo::bench {

// What was seen of one route with one kind of frames.
struct RouteResult {
  FrameLedger frames;   // with only the answers listened to
  FrameLedger watched;  // with every stage listened to
};

// One kind of frames through both.
struct KindResult {
  std::string key;  // as in the report: encoding and rate
  RouteResult chain;
  RouteResult floor;
};

// Per kind: p50 and p99 in ms of chain and floor, their ratio, frames sent and lost, and the p50 of each hop. Null
// where nothing was answered.
nlohmann::ordered_json latency_json(const std::vector<KindResult>& kinds, const std::vector<std::string>& stages);

// Adds to jpeg_30 what unpacking costs: `imdecode_pair_ms`, one cv::imdecode of both pictures, as given, and
// `unpacking_ratio`, what the chain takes longer for JPEG than for raw frames at 30 Hz, floors deducted, in these.
void add_unpacking(nlohmann::ordered_json& report, double imdecode_pair_ms);

// The same for a person.
std::string latency_text(const nlohmann::ordered_json& report);

}  // namespace markservo::bench
