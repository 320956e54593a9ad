// latency-hop: an empty service. Answers each message on one channel with one of a given size on another, and does no
// more: what a hop over the bus costs by itself.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <string>
#include <vector>

#include "tests/bench/latency/hop_mark.hpp"

namespace markservo::bench {
namespace {

constexpr int kMaxBytes = 1 << 24;

struct Options {
  std::string lcm_url;
  std::string from;
  std::string to;
  int bytes = 0;
};

struct Hop {
  lcm::LCM lcm;
  std::string to;
  std::vector<std::uint8_t> answer;
};

void pass_on(const lcm::ReceiveBuffer* buffer, const std::string& /*channel*/, Hop* hop) {
  const std::optional<HopMark> mark = hop_mark(buffer->data, buffer->data_size);
  if (!mark) return;
  put_hop_mark(hop->answer.data(), *mark);
  hop->lcm.publish(hop->to, hop->answer.data(), static_cast<unsigned int>(hop->answer.size()));
}

int run(const Options& options) {
  Hop hop{lcm::LCM(options.lcm_url), options.to, std::vector<std::uint8_t>(static_cast<std::size_t>(options.bytes))};
  if (!hop.lcm.good()) {
    std::cerr << "latency-hop: bus " << options.lcm_url << ": cannot be joined\n";
    return 1;
  }
  hop.lcm.subscribeFunction(options.from, pass_on, &hop);
  while (hop.lcm.handle() == 0) {
  }
  return 1;
}

}  // namespace
}  // namespace markservo::bench

int main(int argc, char** argv) {
  using namespace markservo::bench;
  Options options;
  CLI::App app("Answers each message on one channel with one of a given size on another, and does no more.");
  app.add_option("--lcm-url", options.lcm_url, "LCM bus")->required();
  app.add_option("--from", options.from, "Channel to read")->required();
  app.add_option("--to", options.to, "Channel to write")->required();
  app.add_option("--bytes", options.bytes, "Size of the answer")
      ->required()
      ->check(CLI::Range(static_cast<int>(sizeof(HopMark)), kMaxBytes));
  CLI11_PARSE(app, argc, argv);
  return run(options);
}
