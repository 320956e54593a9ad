#include "common/motion/command_inbox.hpp"

#include <algorithm>

namespace markservo::motion {
namespace {

// As many as a hostile one may make us remember. A forgotten sender's command could be executed again only while it is
// fresh, so this many within 2 s would be needed.
constexpr std::size_t kSenders = 4096;

}  // namespace

CommandHeard CommandInbox::hear(const CommandStamp& command, std::int64_t now, bool always) {
  const auto sender = std::find_if(senders_.begin(), senders_.end(),
                                   [&command](const Sender& one) { return one.session == command.session; });
  // One that must be obeyed and says nothing of who sends it is new each time: to stop once too often is safe.
  const bool nameless = always && (command.session < 1 || command.id < 1);
  const bool again = !nameless && sender != senders_.end() && command.id <= sender->last_id;
  if (again && !always) return CommandHeard::kAgain;
  if (!always && !why_stale(command, now).empty()) return CommandHeard::kStale;
  session_ = command.session;
  id_ = command.id;
  if (again) return CommandHeard::kAgain;
  if (nameless) return CommandHeard::kExecute;
  if (sender != senders_.end()) senders_.erase(sender);
  senders_.push_back({command.session, command.id});
  if (senders_.size() > kSenders) senders_.pop_front();
  return CommandHeard::kExecute;
}

}  // namespace markservo::motion
