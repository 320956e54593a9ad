#include "tests/bench/latency/latency_report.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "tests/experiments/statistics.hpp"

namespace markservo::bench {
namespace {

using experiments::percentile;

constexpr double kMsPerS = 1e3;

void add_route(nlohmann::ordered_json& json, const std::string& name, const RouteResult& result) {
  const std::vector<double> latencies = result.frames.latencies();
  json[name + "_p50_ms"] = kMsPerS * percentile(latencies, 0.50);
  json[name + "_p99_ms"] = kMsPerS * percentile(latencies, 0.99);
  json[name + "_sent"] = result.frames.num_sent();
  json[name + "_lost"] = result.frames.num_lost();
}

nlohmann::ordered_json hops_json(const RouteResult& result, const std::vector<std::string>& stages) {
  nlohmann::ordered_json json;
  for (std::size_t stage = 0; stage < stages.size(); ++stage) {
    json[stages[stage]] = kMsPerS * percentile(result.watched.hops(stage), 0.50);
  }
  return json;
}

// A number that may be null or not finite.
std::string number_text(const nlohmann::ordered_json& json) {
  if (!json.is_number() || !std::isfinite(json.get<double>())) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << json.get<double>();
  return text.str();
}

}  // namespace

nlohmann::ordered_json latency_json(const std::vector<KindResult>& kinds, const std::vector<std::string>& stages) {
  nlohmann::ordered_json report;
  for (const KindResult& kind : kinds) {
    nlohmann::ordered_json json;
    add_route(json, "chain", kind.chain);
    add_route(json, "floor", kind.floor);
    json["ratio_p50"] = json["chain_p50_ms"].get<double>() / json["floor_p50_ms"].get<double>();
    json["chain_hops_p50_ms"] = hops_json(kind.chain, stages);
    json["floor_hops_p50_ms"] = hops_json(kind.floor, stages);
    report[kind.key] = json;
  }
  return report;
}

void add_unpacking(nlohmann::ordered_json& report, double imdecode_pair_ms) {
  const auto without_floor = [&report](const char* key) {
    return report[key]["chain_p50_ms"].get<double>() - report[key]["floor_p50_ms"].get<double>();
  };
  report["jpeg_30"]["imdecode_pair_ms"] = imdecode_pair_ms;
  report["jpeg_30"]["unpacking_ratio"] = (without_floor("jpeg_30") - without_floor("raw_30")) / imdecode_pair_ms;
}

std::string latency_text(const nlohmann::ordered_json& report) {
  std::ostringstream text;
  const auto cells = [&](const std::string& first, const std::vector<std::string>& others) {
    text << std::left << std::setw(10) << first << std::right;
    for (const std::string& cell : others) text << std::setw(16) << cell;
    text << "\n";
  };
  text << "From STEREO_FRAME sent to JOINT_COMMAND received, ms; the floor is the bus alone: as many messages of the\n"
          "same sizes through empty processes.\n\n";
  cells("", {"chain p50", "chain p99", "floor p50", "floor p99", "chain / floor", "lost of sent"});
  for (const auto& [key, kind] : report.items()) {
    const int lost = kind["chain_lost"].get<int>() + kind["floor_lost"].get<int>();
    const int sent = kind["chain_sent"].get<int>() + kind["floor_sent"].get<int>();
    cells(key, {number_text(kind["chain_p50_ms"]), number_text(kind["chain_p99_ms"]), number_text(kind["floor_p50_ms"]),
                number_text(kind["floor_p99_ms"]), number_text(kind["ratio_p50"]),
                std::to_string(lost) + " of " + std::to_string(sent)});
  }
  if (report.contains("jpeg_30") && report["jpeg_30"].contains("unpacking_ratio")) {
    text << "\nJPEG costs " << number_text(report["jpeg_30"]["unpacking_ratio"])
         << " of one cv::imdecode of both pictures (" << number_text(report["jpeg_30"]["imdecode_pair_ms"])
         << " ms), beyond raw frames and the floor.\n";
  }
  text << "\nThe p50 of each hop, up to its message received by a listener that hears them all, ms (in brackets: the\n"
          "floor's):\n\n";
  bool headed = false;
  for (const auto& [key, kind] : report.items()) {
    std::vector<std::string> names;
    std::vector<std::string> values;
    for (const auto& [stage, chain_ms] : kind["chain_hops_p50_ms"].items()) {
      names.push_back(stage);
      values.push_back(number_text(chain_ms) + " (" + number_text(kind["floor_hops_p50_ms"][stage]) + ")");
    }
    if (!headed) cells("", names);
    headed = true;
    cells(key, values);
  }
  return text.str();
}

}  // namespace markservo::bench
