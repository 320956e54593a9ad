#pragma once

// What a person is told to type.

#include <string>
#include <utility>

#include "common/text/typed_command.hpp"

namespace markservo::mmi {

// `name`, which was heard on the bus, as a word of a command that somebody may copy into a shell; `instead` where it is
// no plain name or path.
std::string typable(const std::string& name, const std::string& instead);

class Remedies {
 public:
  // `typed`: as what the person knows the commands.
  explicit Remedies(text::TypedCommand typed = {}) : typed_(std::move(typed)) {}

  std::string stop_device_silent() const;
  std::string second_writer() const;
  std::string process_dead(const std::string& process, bool comes_back) const;
  std::string process_hung(const std::string& process, bool is_killed) const;
  std::string watch_silent() const;
  std::string clock_ahead() const;
  std::string messages_lost() const;
  // `writer`: the service that shows the pictures; empty: not known.
  std::string camera_silent(const std::string& writer) const;
  std::string stop_latched() const;
  std::string mark_unseen() const;
  std::string hand_unseen() const;
  std::string pose_lost() const;
  std::string base_blocked() const;
  std::string recording_ended() const;
  // `folder`: where the recorder was killed, and its manifest can be completed.
  std::string recorder_silent(const std::string& folder) const;
  std::string target_refused(const std::string& target) const;

 private:
  text::TypedCommand typed_;
};

}  // namespace markservo::mmi
