#pragma once

// Which frames were sent, when each stage's message about them came in, and what follows: latencies and losses.

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace markservo::bench {

class FrameLedger {
 public:
  // `num_stages`: messages that follow a frame one from the other; the last one is the answer. 1 or more, else
  // std::invalid_argument.
  explicit FrameLedger(std::size_t num_stages);

  // Frame `id` goes out at `time` (s, any origin).
  void sent(std::int64_t id, double time);

  // The message of `stage` (0 ..) about frame `id` came in at `time`. The first one counts; what is unknown does not.
  // True if that answers the frame. A stage that does not exist: std::out_of_range.
  bool came_in(std::size_t stage, std::int64_t id, double time);

  std::size_t num_sent() const { return frames_.size(); }
  // Frames without an answer.
  std::size_t num_lost() const;

  // From sent to answered, s, of the frames that were answered, in the order of their ids.
  std::vector<double> latencies() const;

  // From the stage before (the first: from sent) to `stage`, s, of the frames of which both are known.
  std::vector<double> hops(std::size_t stage) const;

 private:
  struct Frame {
    double sent = 0.0;
    std::vector<double> came_in;  // of each stage; NaN: not
  };

  std::size_t num_stages_;
  std::map<std::int64_t, Frame> frames_;
};

}  // namespace markservo::bench
