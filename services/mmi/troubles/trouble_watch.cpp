#include "services/mmi/troubles/trouble_watch.hpp"

#include <algorithm>
#include <utility>

namespace markservo::mmi {

TroubleWatch::TroubleWatch(std::vector<std::string> stop_devices, TroubleParameters parameters,
                           text::TypedCommand typed)
    : stop_devices_(std::move(stop_devices)),
      parameters_(parameters),
      typed_(std::move(typed)),
      remedies_(typed_),
      base_(parameters.base),
      camera_(parameters.camera),
      clock_(parameters.clock),
      loss_(parameters.loss),
      mark_(parameters.mark),
      process_(parameters.process),
      recording_(parameters.recording),
      stop_(stop_devices_, parameters.stop),
      writer_(parameters.writer),
      list_(parameters.list) {}

void TroubleWatch::observe(const AnyWord& word, double now) {
  camera_.observe(word, now);
  clock_.observe(word, now);
  process_.observe(word, now);
  const bool invented = !word.writer_of.empty() &&
                        std::find(stop_devices_.begin(), stop_devices_.end(), word.writer_of) == stop_devices_.end();
  if (!invented) writer_.observe(word, now);
}

void TroubleWatch::observe(const TaskWord& word, double now) {
  mark_.observe(word, now);
  task_.observe(word, now);
}

void TroubleWatch::observe(const ServoWord& word, double now) {
  mark_.observe(word, now);
}

void TroubleWatch::observe(const BaseWord& word, double now) {
  base_.observe(word, now);
}

void TroubleWatch::observe(const PoseWord& word, double now) {
  base_.observe(word, now);
}

void TroubleWatch::observe(const StopWord& word, double now) {
  stop_.observe(word, now);
}

void TroubleWatch::observe(const MarksWord& word, double now) {
  mark_.observe(word, now);
}

void TroubleWatch::observe(const ServiceWord& word, double now) {
  names_.observe(word, now);
  camera_.observe(word, now);
  clock_.observe(word, now);
  loss_.observe(word, now);
  process_.observe(word, now);
  stop_.observe(word, now);
  writer_.observe(word, now);
}

void TroubleWatch::observe(const ProcessWord& word, double now) {
  process_.observe(word, now);
}

void TroubleWatch::observe(const RecorderWord& word, double now) {
  recording_.observe(word, now);
}

const std::vector<Trouble>& TroubleWatch::step(double now) {
  Findings found;
  base_.find(remedies_, now, found);
  camera_.find(names_, remedies_, now, found);
  clock_.find(names_, remedies_, now, found);
  loss_.find(remedies_, now, found);
  mark_.find(remedies_, now, found);
  process_.find(remedies_, loss_.any(now), now, found);
  recording_.find(remedies_, now, found);
  stop_.find(remedies_, now, found);
  task_.find(remedies_, found);
  writer_.find(names_, remedies_, now, found);
  return list_.step(found, now);
}

}  // namespace markservo::mmi
