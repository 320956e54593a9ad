#include "services/mmi/world/narrator_reader.hpp"

#include <algorithm>

#include "services/mmi/troubles/trouble_messages.hpp"

namespace markservo::mmi {
namespace {

bool has(const std::vector<Trouble>& troubles, const Trouble& wanted) {
  return std::any_of(troubles.begin(), troubles.end(),
                     [&wanted](const Trouble& one) { return identity_of(one) == identity_of(wanted); });
}

StateChange change_of(const Trouble& trouble, std::int64_t at, bool begins) {
  StateChange change;
  change.at = at;
  change.key = trouble.subject;
  change.kind = ChangeKind::kTrouble;
  change.state = name_of(trouble.code);
  change.text = begins ? trouble.text : "over: " + trouble.text;
  change.level = begins ? Level::kBad : Level::kGood;
  return change;
}

}  // namespace

NarratorReader::NarratorReader(const robot::RobotDescription& robot, const Parameters& parameters)
    : parameters_(parameters), watch_(robot.stop_devices, {}, parameters.typed), events_(parameters.events) {}

ReadReport NarratorReader::observe(const std::string& channel, const void* data, std::size_t size, std::int64_t at,
                                   double now) {
  ReadReport read = read_report(channel, data, size);
  if (const auto change = changes_.observe(read.report, at, now)) events_.add(*change);
  const std::string bad = observe_message(channel, data, size, at, now, watch_, state_);
  if (read.bad.empty()) read.bad = bad;
  advance(at, now);
  return read;
}

void NarratorReader::advance(std::int64_t at, double now) {
  if (judged_ && now - *judged_ < parameters_.troubles_every) return;
  judged_ = now;
  const std::vector<Trouble>& troubles = watch_.step(now);
  if (troubles == troubles_) return;
  compare(at, troubles);
  troubles_ = troubles;
  ++version_;
}

void NarratorReader::compare(std::int64_t at, const std::vector<Trouble>& now) {
  for (const Trouble& trouble : troubles_) {
    if (!has(now, trouble)) events_.add(changes_.tell(change_of(trouble, at, false)));
  }
  for (const Trouble& trouble : now) {
    if (!has(troubles_, trouble)) events_.add(changes_.tell(change_of(trouble, at, true)));
  }
}

}  // namespace markservo::mmi
