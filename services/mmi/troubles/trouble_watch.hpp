#pragma once

// All that is wrong with a robot, from what is heard of it. No bus, no clock: `now` is s of a clock that does not go
// back, live the host's steady clock, in a log the log's own time.

#include <string>
#include <vector>

#include "common/text/typed_command.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/session_names.hpp"
#include "services/mmi/troubles/trouble.hpp"
#include "services/mmi/troubles/trouble_list.hpp"
#include "services/mmi/troubles/watches/base_troubles.hpp"
#include "services/mmi/troubles/watches/camera_troubles.hpp"
#include "services/mmi/troubles/watches/clock_troubles.hpp"
#include "services/mmi/troubles/watches/loss_troubles.hpp"
#include "services/mmi/troubles/watches/mark_troubles.hpp"
#include "services/mmi/troubles/watches/process_troubles.hpp"
#include "services/mmi/troubles/watches/recording_troubles.hpp"
#include "services/mmi/troubles/watches/stop_troubles.hpp"
#include "services/mmi/troubles/watches/task_troubles.hpp"
#include "services/mmi/troubles/watches/writer_troubles.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct TroubleParameters {
  BaseTroubleParameters base;
  CameraTroubleParameters camera;
  ClockTroubleParameters clock;
  LossTroubleParameters loss;
  MarkTroubleParameters mark;
  ProcessTroubleParameters process;
  RecordingTroubleParameters recording;
  StopTroubleParameters stop;
  WriterTroubleParameters writer;
  TroubleListParameters list;
};

class TroubleWatch {
 public:
  // `stop_devices` as in robot.yaml; `typed`: as what the person knows the commands that mend.
  explicit TroubleWatch(std::vector<std::string> stop_devices, TroubleParameters parameters = {},
                        text::TypedCommand typed = {});

  // Of every message of the table of channels, whatever it says besides.
  void observe(const AnyWord& word, double now);
  void observe(const TaskWord& word, double now);
  void observe(const ServoWord& word, double now);
  void observe(const BaseWord& word, double now);
  void observe(const PoseWord& word, double now);
  void observe(const StopWord& word, double now);
  void observe(const MarksWord& word, double now);
  void observe(const ServiceWord& word, double now);
  void observe(const ProcessWord& word, double now);
  void observe(const RecorderWord& word, double now);

  // The troubles at `now`, the worst first; to be called every 0.1 s or oftener. They hold until the next call.
  const std::vector<Trouble>& step(double now);

 private:
  std::vector<std::string> stop_devices_;
  TroubleParameters parameters_;
  text::TypedCommand typed_;
  Remedies remedies_;
  SessionNames names_;
  BaseTroubles base_;
  CameraTroubles camera_;
  ClockTroubles clock_;
  LossTroubles loss_;
  MarkTroubles mark_;
  ProcessTroubles process_;
  RecordingTroubles recording_;
  StopTroubles stop_;
  TaskTroubles task_;
  WriterTroubles writer_;
  TroubleList list_;
};

}  // namespace markservo::mmi
