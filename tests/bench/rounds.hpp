#pragma once

// Timing by Google Benchmark in rounds: each round times every contender once, in random order, so that what the
// machine does meanwhile falls on all alike and a ratio taken within a round is fair.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace markservo::bench {

struct Contender {
  std::string name;
  int calls = 1;                          // per round, each on the next image pair
  std::function<void(std::size_t)> call;  // with the pair's number
  std::int64_t vector_target = 0;         // of Highway, the only one allowed; 0: the best this processor has
};

// Per contender the thread's processor time of one call, ms: a round's mean, one a round.
using Times = std::map<std::string, std::vector<double>>;

// Calls go through the pairs 0 .. num_pairs - 1 in turn, over all rounds. To be called once.
Times run_rounds(const std::vector<Contender>& contenders, int num_rounds, std::size_t num_pairs);

// Over the rounds.
double median_time(const Times& times, const std::string& name);
// Of the ratio within each round.
double median_ratio(const Times& times, const std::string& numerator, const std::string& denominator);

}  // namespace markservo::bench
