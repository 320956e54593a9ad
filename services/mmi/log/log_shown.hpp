#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "services/mmi/feed/shown.hpp"
#include "services/mmi/log/log_index.hpp"

namespace markservo::mmi {

// A log at a time of one client's own: at each instant all that had been heard until then.
class LogShown final : public Shown {
 public:
  struct Parameters {
    double heard_before = 6.0;     // s that are heard anew for an instant: rates and silences are of the last 5 s
    double pictures_before = 1.0;  // s, likewise: a picture and its answers
    double longest_step = 0.5;     // s of the clock: a client that stalled does not leap
    double patience = 0.1;         // s, which a picture's answers take at most
  };
  using MakeWorld = std::function<std::unique_ptr<WorldReader>()>;

  // `index` and `events` must outlive this. Stands at the log's first complete picture, or at its end where it has
  // none.
  LogShown(const LogIndex& index, const EventLog& events, MakeWorld make_world)
      : LogShown(index, events, std::move(make_world), Parameters{}) {}
  LogShown(const LogIndex& index, const EventLog& events, MakeWorld make_world, const Parameters& parameters);

  WorldReader& world() override { return *world_; }
  std::uint64_t generation() const override { return generation_; }
  void advance(double now) override;
  VersionedText play() const override;
  std::string control(const ClientWord& message) override;
  const EventLog& events() override { return events_; }
  std::int64_t utime() override { return at_; }

 private:
  void seek(std::int64_t at);
  void step(int frames);
  void hear(std::size_t event);
  double seconds(std::int64_t at) const;  // since the log's begin
  // us, when the picture that is event `event` has all of its answers.
  std::int64_t complete_at(std::size_t picture) const;

  const LogIndex& index_;
  const EventLog& events_;
  MakeWorld make_world_;
  Parameters parameters_;
  std::unique_ptr<WorldReader> world_;
  std::uint64_t generation_ = 0;
  std::int64_t at_ = 0;    // us, of the log
  std::size_t heard_ = 0;  // events
  bool playing_ = false;
  double speed_ = 1.0;
  std::uint64_t changes_ = 1;          // of what play() tells
  std::optional<double> advanced_at_;  // s
};

}  // namespace markservo::mmi
