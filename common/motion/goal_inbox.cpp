#include "common/motion/goal_inbox.hpp"

#include <algorithm>
#include <cmath>

#include "common/motion/sole_writer.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::motion {
namespace {

constexpr double kAlone_s = 1.0;  // s without another's word after which one sends alone
// As many as a hostile one may make us remember: more than can speak between two repetitions of one.
constexpr std::size_t kSenders = 4096;

// Whether a repetition at `utime` tells more of the goal's age than the one at `known`. The later one does, unless it
// is ahead of the clock by more than the other is behind: a clock that went back leaves such times.
bool fresher(std::int64_t utime, std::int64_t known, std::int64_t now) {
  if (now == 0) return utime > known;
  return std::abs(seconds_between(utime, now)) < std::abs(seconds_between(known, now));
}

bool within(double age, std::int64_t from, std::int64_t to) {
  return std::abs(seconds_between(from, to)) <= age;
}

// Whether so much was heard of the goal's sender already.
template <class Senders>
bool knows(const Senders& senders, const GoalStamp& goal) {
  return std::any_of(senders.begin(), senders.end(), [&goal](const auto& sender) {
    return sender.session == goal.session && goal.id <= sender.last_id;
  });
}

// `id` of `session` was heard: what is not above it is nothing new.
template <class Senders>
void remember(std::int64_t session, std::int64_t id, Senders& senders) {
  const auto known =
      std::find_if(senders.begin(), senders.end(), [session](const auto& sender) { return sender.session == session; });
  if (known != senders.end()) {
    id = std::max(id, known->last_id);
    senders.erase(known);
  }
  senders.push_back({session, id});
  if (senders.size() > kSenders) senders.pop_front();
}

}  // namespace

GoalHeard GoalInbox::hear(const GoalStamp& goal, std::int64_t now, double age, bool latched) {
  if (goal.session == 0) return GoalHeard::kEnded;
  if (now != 0 && !within(age, goal.utime, now)) return GoalHeard::kStale;
  if (goal.id > largest_id(goal.session)) return GoalHeard::kBeyond;
  const std::int64_t moment = now != 0 ? now : goal.utime;
  const bool second_spoke = second_.has_value() && second_->session != goal.session;
  const bool again = goal_ && goal.session == goal_->session && goal.id == goal_->id;
  const bool ignored_before = knows(ignored_, goal);
  const bool nothing_new = !again && (ignored_before || knows(senders_, goal));
  if (goal.session != holder_) {
    holder_heard_at_ = std::min(holder_heard_at_, moment);  // a clock that went back
    if (holder_ != 0 && seconds_between(holder_heard_at_, moment) <= age) {
      second_ = Second{goal.session, moment};
      remember(goal.session, goal.id, ignored_);
      return GoalHeard::kSecond;
    }
    if (!nothing_new) take_floor(goal.session, moment);
  }
  if (nothing_new && ignored_before && !latched) in_vain_ = Second{goal.session, moment};
  if (goal.session != holder_) return GoalHeard::kEnded;
  holder_heard_at_ = moment;
  // Both spoke before either had repeated itself for long: nobody knows who was first.
  const bool unknown_first = holder_is_first_ && second_spoke && within(age, holder_since_, moment);
  // Nor after a reset, until one has been silent for long enough.
  contested_ = unknown_first || (contested_ && second_spoke && within(kAlone_s, second_->heard_at, moment));
  if (contested_) {
    end();
    return GoalHeard::kContested;
  }
  if (again) {
    if (fresher(goal.utime, goal_->utime, now)) goal_->utime = goal.utime;
    return GoalHeard::kAgain;
  }
  if (nothing_new) return GoalHeard::kEnded;
  remember(goal.session, goal.id, senders_);
  if (latched) return GoalHeard::kEnded;
  goal_ = goal;
  return GoalHeard::kNew;
}

std::int64_t GoalInbox::largest_id(std::int64_t session) const {
  for (const auto* senders : {&senders_, &ignored_}) {
    for (const Sender& sender : *senders) {
      if (sender.session == session) return std::max(sender.last_id, std::int64_t{0}) + kLongestIdStep;
    }
  }
  return kLargestFirstId;
}

std::string GoalInbox::why_beyond(const GoalStamp& goal) const {
  return "goal_id is " + std::to_string(goal.id) + "; allowed from session " + std::to_string(goal.session) +
         ": up to " + std::to_string(largest_id(goal.session));
}

void GoalInbox::take_floor(std::int64_t session, std::int64_t now) {
  if (goal_ && goal_->session != session) end();
  holder_is_first_ = holder_ == 0;
  holder_ = session;
  holder_since_ = now;
  second_.reset();
}

bool GoalInbox::end_unless_fresh(std::int64_t now, double age) {
  if (!goal_ || fresh(now, age)) return false;
  end();
  holder_ = 0;
  second_.reset();
  ignored_.clear();
  return true;
}

bool GoalInbox::fresh(std::int64_t now, double age) const {
  return goal_ && within(age, goal_->utime, now);
}

std::string GoalInbox::two() const {
  return two_write(channel_, holder_, second_ ? second_->session : 0);
}

std::string GoalInbox::second(std::int64_t now, double age) const {
  if (!second_ || !within(age, second_->heard_at, now)) {
    const bool in_vain = in_vain_ && within(age, in_vain_->heard_at, now) && !fresh(now, age);
    if (!in_vain) return "";
    return channel_ + " of session " + std::to_string(in_vain_->session) +
           " was ignored while another sent: it needs a new goal_id";
  }
  return "a second one sends " + channel_ + ": session " + std::to_string(second_->session) + " is not obeyed, " +
         std::to_string(holder_) + " is";
}

}  // namespace markservo::motion
