#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "services/mmi/feed/shown.hpp"
#include "services/mmi/log/log_index.hpp"

namespace markservo::mmi {

// A log at a time of one client's own: at each instant all that had been heard until then. What a client wishes is done
// when it is next asked for, the newest alone: one that wishes much costs no more.
class LogShown final : public Shown {
 public:
  struct Parameters {
    double heard_before = 6.0;     // s that are heard anew for an instant: rates and silences are of the last 5 s
    double pictures_before = 1.0;  // s, likewise: a picture and its answers
    double longest_step = 0.5;     // s of the clock: a client that stalled does not leap
    double patience = 0.1;         // s, which a picture's answers take
  };
  using MakeWorld = std::function<std::unique_ptr<WorldReader>()>;

  // `index` and `events` must outlive this. Stands at the log's first complete picture, or at its end where it has
  // none.
  LogShown(const LogIndex& index, const EventLog& events, MakeWorld make_world)
      : LogShown(index, events, std::move(make_world), Parameters{}) {}
  LogShown(const LogIndex& index, const EventLog& events, MakeWorld make_world, const Parameters& parameters);

  WorldReader& world() override;
  std::uint64_t generation() override;
  void advance(double now) override;
  VersionedText play() override;
  std::shared_ptr<const Frame> picture() override;
  std::string control(const ClientWord& message) override;
  const EventLog& events() override { return events_; }
  std::int64_t utime() override;

 private:
  // The instant and the steps from it that were wished for last.
  struct Wish {
    std::optional<std::int64_t> at;  // us; nothing: where it stands
    int frames = 0;
  };

  // Does what was wished.
  void fulfil();
  void begin();
  void seek(std::int64_t at);
  void step(int frames);
  bool is_picture(std::size_t event) const;
  void hear(std::size_t event);
  double seconds(std::int64_t at) const;  // since the log's begin
  // The instant at which the picture has its answers.
  void show_picture(std::size_t number);

  const LogIndex& index_;
  const EventLog& events_;
  MakeWorld make_world_;
  Parameters parameters_;
  std::unique_ptr<WorldReader> world_;
  std::uint64_t generation_ = 0;
  std::int64_t at_ = 0;    // us, of the log
  std::size_t heard_ = 0;  // events
  Wish wish_;
  std::optional<std::int64_t> stepped_to_;  // us: arrival of the picture that is shown, whatever is newer
  bool playing_ = false;
  double speed_ = 1.0;
  std::uint64_t changes_ = 1;          // of what play() tells
  std::optional<double> advanced_at_;  // s
};

}  // namespace markservo::mmi
