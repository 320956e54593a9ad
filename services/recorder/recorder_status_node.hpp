#pragma once

#include <cstdint>
#include <markservo/RecorderStatus.hpp>
#include <optional>
#include <string>

#include "common/bus/connection.hpp"
#include "common/bus/publisher.hpp"
#include "services/recorder/recording_plan.hpp"

namespace markservo::recorder {

// How a recording is at a moment.
struct RecordingWord {
  bool recording = true;
  std::int64_t bytes = 0;
  std::int64_t free_mb = 0;
  int parts = 0;
  std::string why;  // what interrupts it, or why it ended; empty when it goes on or ended as it was told
};

// Says on the bus that is recorded how the recording is: RECORDER_STATUS. It hears nothing: to listen to all frames
// would cost what recording them does. What the network does not take is missing, and harms nothing else.
class RecorderStatusNode final : private bus::MessageSink {
 public:
  // `folder`: where it records to.
  RecorderStatusNode(const RecordingPlan& plan, std::string folder);
  RecorderStatusNode(const RecorderStatusNode&) = delete;
  RecorderStatusNode& operator=(const RecorderStatusNode&) = delete;

  // Says it once a second, and at once where more than its numbers changed. `steady_us`: of a clock that nobody sets.
  void tell(const RecordingWord& word, std::int64_t steady_us);

 private:
  bool send(const bus::Outgoing& message) override;

  std::string folder_;
  bus::Connection bus_;
  bus::Publisher<RecorderStatus> statuses_;
  std::optional<RecordingWord> told_;
  std::int64_t told_us_ = 0;
};

}  // namespace markservo::recorder
