#pragma once

// How well tags answer: the reader's read probability, learnt from the tags well inside the footprint, and for each tag
// the suspicion that it is gone.

#include <vector>

namespace markservo::rfid_localizer {

struct TagReliabilityParameters {
  double read_probability = 0.95;  // of a tag well inside, before any read: robot.yaml's
  double trials = 30.0;            // how many reads that is worth
  double memory = 300.0;           // reads that count: the reader's surroundings change
  double gone = 0.01;              // probability that a tag of the map is not there or dead, before any read
  double gone_after_read = 1e-3;   // the same right after a read: tags die, though seldom
};

class TagReliability {
 public:
  TagReliability(std::size_t tags, const TagReliabilityParameters& parameters);

  // Probability that `tag` answers when it is well inside the footprint.
  double of(int tag) const { return (1.0 - gone_[static_cast<std::size_t>(tag)]) * read_probability(); }
  double read_probability() const { return reads_ / trials_; }
  double gone(int tag) const { return gone_[static_cast<std::size_t>(tag)]; }

  // A round's outcome of a tag that was inside with probability `inside`.
  void learn(int tag, bool read, double inside);

 private:
  TagReliabilityParameters parameters_;
  double trials_;
  double reads_;
  std::vector<double> gone_;
};

}  // namespace markservo::rfid_localizer
