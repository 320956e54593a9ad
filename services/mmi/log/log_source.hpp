#pragma once

#include <memory>
#include <string>

#include "common/logs/log_files.hpp"
#include "services/mmi/log/log_index.hpp"
#include "services/mmi/log/log_story_reader.hpp"
#include "services/mmi/source.hpp"

namespace markservo::mmi {

// A log, each client at a time of its own. Opens no bus and sends nothing.
class LogSource final : public Source {
 public:
  // `path`: a log, or a recording's folder; of channels that begin with `prefix`. Throws ConfigurationError,
  // LogFileError.
  LogSource(const std::string& path, const std::string& prefix, const robot::RobotDescription& robot,
            std::string tag_field, const text::TypedCommand& typed = {});

  // Finds out more of the log's events. False when all are known.
  bool read_on() { return story_.read(kEventsAtOnce); }

  const LogIndex& index() const { return index_; }
  bool damaged() const { return log_.damaged(); }

  std::unique_ptr<Shown> shown() override;
  WorldReader& world() override;
  std::string stop(const std::string& reason) override;
  const VersionedText& stop_state() const override { return no_stop_; }

 private:
  static constexpr std::size_t kEventsAtOnce = 500;  // 10 ms: a client that seeks does not wait longer

  std::unique_ptr<WorldReader> new_world() const;

  logs::LogSet log_;
  LogIndex index_;
  robot::RobotDescription robot_;
  std::string tag_field_;
  text::TypedCommand typed_;
  LogStoryReader story_;
  VersionedText no_stop_;
  std::unique_ptr<Shown> at_end_;  // for who asks without a time
};

}  // namespace markservo::mmi
