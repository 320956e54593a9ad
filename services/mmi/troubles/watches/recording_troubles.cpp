#include "services/mmi/troubles/watches/recording_troubles.hpp"

namespace markservo::mmi {

void RecordingTroubles::observe(const RecorderWord& word, double now) {
  Recording* recording = known_or_new(recordings_, {word.host, word.folder}, now);
  if (recording == nullptr) return;
  const bool same = !recording->word.folder.empty() && recording->word.recording == word.recording;
  if (!same) recording->since = {now, word.at};
  recording->word = word;
  recording->last = {now, word.at};
  recording->heard = now;
}

void RecordingTroubles::find(const Remedies& remedies, double now, Findings& found) const {
  const Recording* newest = nullptr;
  for (const auto& [place, recording] : recordings_) {
    const bool goes_on = recording.word.recording && now - recording.heard <= parameters_.silent;
    if (goes_on) return;
    if (newest == nullptr || recording.heard > newest->heard) newest = &recording;
  }
  if (newest == nullptr) return;
  const RecorderWord& word = newest->word;
  if (word.recording) {
    found.push_back({{TroubleCode::kRecordingEnded, word.folder, newest->last.utime,
                      "the recorder says nothing any more", remedies.recorder_silent(word.folder)},
                     newest->last.now});
  } else if (!word.why.empty()) {
    found.push_back({{TroubleCode::kRecordingEnded, word.folder, newest->since.utime,
                      "nothing is recorded any more: " + word.why, remedies.recording_ended()},
                     newest->since.now});
  }
}

}  // namespace markservo::mmi
