#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "tests/system/fault_campaign/fault.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {

// Counts what it sends; it struck when some of that was heard on the bus.
class SpeakingFault : public Fault {
 public:
  using Fault::Fault;

  std::set<std::string> words() const override { return words_of_channel(plan().channel); }
  void strike(Bench& bench) override {
    heard_before_ = bench.own_heard();
    next_ = Bench::now();
  }
  void end(Bench& bench) override { heard_ = bench.own_heard() - heard_before_; }
  std::string evidence() const override {
    return sent_ > 0 && heard_ > 0
               ? text("%ld sent, %ld heard on the bus", static_cast<long>(sent_), static_cast<long>(heard_))
               : "";
  }

 protected:
  void send(Bench& bench, const std::string& channel, const Bytes& data) {
    bench.send(channel, data);
    ++sent_;
  }
  // How many are due by now at `rate`.
  int due(double rate) {
    int count = 0;
    for (; next_ <= Bench::now() && count < 20; ++count) next_ += static_cast<std::int64_t>(1e6 / rate);
    return count;
  }

 private:
  std::int64_t sent_ = 0;
  std::int64_t heard_before_ = 0;
  std::int64_t heard_ = 0;
  std::int64_t next_ = 0;
};

}  // namespace markservo::campaign
