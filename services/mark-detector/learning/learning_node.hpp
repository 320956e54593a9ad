#pragma once

// LEARN_REQUEST in, LEARN_RESULT out: a mark's colour learned for who asks on the bus, in a thread of its own, so that
// frames do not wait for it.
//
// Each request is worked on once, when all pieces of its picture are there. Repeated, it gets the same answer again, at
// its first piece; while it is worked on, none. Refused with a reason are: one that is 2 s older than the newest frame
// or newer than the next could be, so that none of a recording is obeyed; one for which the two that may wait leave no
// room; one of another writer than who asked within the last 5 s.

#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <markservo/LearnRequest.hpp>
#include <markservo/LearnResult.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/bus.hpp"
#include "common/bus/options.hpp"
#include "common/motion/command_inbox.hpp"
#include "services/mark-detector/learning/colour_learning.hpp"
#include "services/mark-detector/learning/picture_assembly.hpp"
#include "services/mark-detector/mark_detector.hpp"

namespace markservo {
class StereoFrame;
}

namespace markservo::mark_detector {

struct LearningSettings {
  std::string robot_file;
  LearningParameters learning;
  Parameters detection;
  std::string obstacle;  // why nothing is learned for the bus; empty if it is
};

class LearningNode {
 public:
  // Lets the running detector go by a mark's new colour; false if it does not look for that mark.
  using Adopt = std::function<bool(const std::string& mark, const robot::ColourInterval& colour)>;

  void add_to(CLI::App& app);
  void start(bus::Bus& bus, LearningSettings settings, Adopt adopt);

  // The newest frame: what is asked must be of its time and size.
  void observe(const StereoFrame& frame);

 private:
  struct Frame {
    std::int64_t utime = 0;     // us
    std::int64_t heard_at = 0;  // us of a clock that nobody sets
    int width = 0;              // px
    int height = 0;             // px
  };
  // A request whose picture is not all there.
  struct Incomplete {
    std::int64_t session = 0;
    std::int64_t request_id = 0;
    PictureAssembly left;
  };
  struct Job {
    LearnRequest request;
    std::vector<std::uint8_t> left;  // the picture, raw or JPEG
  };

  void on_request(const LearnRequest& request);
  bool answer_again(const LearnRequest& request);
  bool is_waiting(const LearnRequest& request) const;
  std::string objection_of_now(const LearnRequest& request) const;
  std::string objection_to_asker(const LearnRequest& request);
  bool take_up(const LearnRequest& request);
  std::optional<std::vector<std::uint8_t>> picture_with(const LearnRequest& request);
  void begin();
  void finish();
  LearnResult learn(const Job& job) const;
  void save(LearnResult& result) const;
  void adopt_written(LearnResult& result) const;
  void refuse(const LearnRequest& request, const std::string& why);
  void reject(const LearnRequest& request, const std::string& why);
  void answer(LearnResult result);

  bool may_save_ = false;
  LearningSettings settings_;
  Adopt adopt_;
  bool replaying_ = false;  // a log
  std::optional<bus::Publisher<LearnResult>> results_;
  motion::CommandInbox inbox_{"LEARN_REQUEST", "STEREO_FRAME"};
  std::optional<Frame> newest_;
  std::int64_t asker_ = 0;              // the session that was taken last
  std::int64_t asked_utime_ = 0;        // us, when
  std::deque<Incomplete> incomplete_;   // the last ones
  std::deque<Job> waiting_;             // the first is worked on
  std::deque<LearnResult> answers_;     // the last ones, for who asks again
  std::future<LearnResult> under_way_;  // last: its end is waited for before the rest goes
};

}  // namespace markservo::mark_detector
