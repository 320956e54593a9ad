#include "services/mmi/troubles/watches/camera_troubles.hpp"

#include <markservo/channels.hpp>

#include "common/bus/health.hpp"
#include "services/mmi/troubles/watches/service_reason.hpp"

namespace markservo::mmi {

void CameraTroubles::observe(const AnyWord& word, double now) {
  if (word.channel != channels::kStereoFrame.name) return;
  picture_ = Since{now, word.at};
  session_ = word.session;
}

void CameraTroubles::observe(const ServiceWord& word, double now) {
  const bool cannot_work = word.state == bus::kWaiting || word.state == bus::kStale;
  if (channels::has(channels::kStereoFrame.writers, word.name)) {
    writer_ = Writer{word.name, cannot_work ? word.reason : "", now};
  }
  if (!channels::has(channels::kStereoFrame.readers, word.name)) return;
  const bool of_pictures =
      cannot_work && channel_in(word.reason) == channels::kStereoFrame.name && !tells_of_a_clock(word.reason);
  const bool goes_on = reader_ && !reader_->reason.empty() && now - reader_->heard <= parameters_.word;
  Reader reader{word.name, of_pictures ? word.reason : "", word.state == bus::kStale, {now, word.at}, now};
  if (of_pictures && goes_on) reader.since = reader_->since;
  reader_ = reader;
}

std::optional<Since> CameraTroubles::missing_since(double now) const {
  if (picture_ && now - picture_->now > parameters_.silent) return picture_;
  if (!reader_ || reader_->reason.empty() || now - reader_->heard > parameters_.word) return std::nullopt;
  if (!reader_->has_had_one && now - reader_->since.now <= parameters_.patience) return std::nullopt;
  return reader_->since;
}

void CameraTroubles::find(const SessionNames& names, const Remedies& remedies, double now, Findings& found) const {
  const auto since = missing_since(now);
  if (!since) return;
  const bool spoke = picture_ && now - picture_->now > parameters_.silent;
  const bool writer_speaks = writer_ && now - writer_->heard <= parameters_.word;
  std::string writer = names.service(session_);
  if (writer.empty() && writer_speaks) writer = writer_->name;
  std::string text = "no picture comes any more";
  if (!spoke) text = reader_->has_had_one ? reader_->name + " gets no picture any more" : "no picture has come yet";
  if (writer_speaks && !writer_->reason.empty()) {
    text += " (" + writer_->name + ": " + writer_->reason + ")";
  } else if (!spoke) {
    text += " (" + reader_->reason + ")";
  }
  found.push_back(
      {{TroubleCode::kCameraSilent, "cameras", since->utime, text, remedies.camera_silent(writer)}, since->now});
}

}  // namespace markservo::mmi
