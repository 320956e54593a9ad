#include "tests/bench/rounds.hpp"

#include <benchmark/benchmark.h>
#include <hwy/targets.h>

#include <memory>
#include <utility>

#include "tests/experiments/statistics.hpp"

namespace markservo::bench {
namespace {

class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) times_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
  }
  const Times& times() const { return times_; }

 private:
  Times times_;
};

// A contender as Google Benchmark runs it: a round's calls.
class TimedCalls : public benchmark::Fixture {
 public:
  TimedCalls(Contender contender, std::size_t num_pairs) : contender_(std::move(contender)), num_pairs_(num_pairs) {
    SetName(contender_.name.c_str());
    Iterations(contender_.calls)->Unit(benchmark::kMillisecond);
  }

 protected:
  void BenchmarkCase(benchmark::State& state) override {
    hwy::SetSupportedTargetsForTest(contender_.vector_target);
    contender_.call(pair_);  // code and buffers warm, images not
    for (auto unused : state) {
      (void)unused;
      pair_ = (pair_ + 1) % num_pairs_;
      contender_.call(pair_);
    }
    hwy::SetSupportedTargetsForTest(0);
  }

 private:
  Contender contender_;
  std::size_t num_pairs_;
  std::size_t pair_ = 0;
};

}  // namespace

Times run_rounds(const std::vector<Contender>& contenders, int num_rounds, std::size_t num_pairs) {
  std::string program = "perception-bench";
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  char* arguments[] = {program.data(), interleave.data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments);
  for (const Contender& contender : contenders) {
    auto calls = std::make_unique<TimedCalls>(contender, num_pairs);
    benchmark::internal::RegisterBenchmarkInternal(calls.release());  // which owns it from here on
  }
  Collector collector;
  for (int round = 0; round < num_rounds; ++round) benchmark::RunSpecifiedBenchmarks(&collector);
  benchmark::Shutdown();
  return collector.times();
}

double median_time(const Times& times, const std::string& name) {
  return experiments::median(times.at(name));
}

double median_ratio(const Times& times, const std::string& numerator, const std::string& denominator) {
  const std::vector<double>& above = times.at(numerator);
  const std::vector<double>& below = times.at(denominator);
  std::vector<double> ratios;
  for (std::size_t round = 0; round < above.size(); ++round) ratios.push_back(above[round] / below[round]);
  return experiments::median(ratios);
}

}  // namespace markservo::bench
