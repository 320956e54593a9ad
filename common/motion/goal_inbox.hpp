#pragma once

// Which goal is followed: one that its sender repeats, that is fresh, and that nothing has ended.
//
// Goals are repeated at 5 Hz. Each sender's are told apart by growing ids, and a goal is new once: what a later goal, a
// stop or another beginning has ended stays ended, though it is repeated. The first sender keeps the floor while it
// repeats; a second one is named and ignored, and may take the floor with a new goal once the first has been silent for
// goal_age: what was ignored does not begin by itself when somebody else falls silent, nor takes the floor from who
// only paused. Who takes it ends what the one before wanted.
//
// | state   | heard                                                     | then                           |
// | ------- | --------------------------------------------------------- | ------------------------------ |
// | any     | session 0, of no sender                                   | ended                          |
// | any     | a goal too old or too far ahead                           | stale; it may come again fresh |
// | any     | an id far beyond the sender's last                        | beyond                         |
// | any     | of another sender while the floor's holder repeats        | second                         |
// | any     | an id that was replaced, ended or ignored                 | ended; it takes no floor       |
// | latched | any other                                                 | ended at once                  |
// | follows | the id that is followed                                   | again: renewed                 |
// | any     | any other; from another than the holder, who is silent    | new: followed, with the floor  |
// | any     | the first again after a second, and neither is known to be the first | contested: all stops |

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace markservo::motion {

// A goal, as far as the inbox needs to know it.
struct GoalStamp {
  std::int64_t session = 0;
  std::int64_t id = 0;
  std::int64_t utime = 0;  // us
};

enum class GoalHeard { kNew, kAgain, kStale, kSecond, kEnded, kContested, kBeyond };

// A sender counts its goals. What lies beyond is of another that speaks in its name, so that the sender's own next
// goals would count as old.
inline constexpr std::int64_t kLargestFirstId = std::int64_t{1} << 52;
inline constexpr std::int64_t kLongestIdStep = 1'000'000;

class GoalInbox {
 public:
  // `channel` for the words.
  explicit GoalInbox(std::string channel) : channel_(std::move(channel)) {}

  // `now`: us, the newest time of what moves; 0 before it has any: then a goal's age is judged later, by fresh().
  // `age`: s either way from now within which a goal is fresh.
  GoalHeard hear(const GoalStamp& goal, std::int64_t now, double age, bool latched);

  // Why a goal_id is beyond what its sender can have counted to, for people.
  std::string why_beyond(const GoalStamp& goal) const;

  // Ends the goal, at a stop or another beginning: it and all before it of its sender will not be taken up again.
  void end() { goal_.reset(); }
  // Ends it likewise at another beginning, at `now` (us), unless it is fresh then. True if one was ended: its sender
  // had the floor without right, and what was ignored for it may begin.
  bool end_unless_fresh(std::int64_t now, double age);

  // The one that is followed; its utime is that of the repetition nearest to now.
  const std::optional<GoalStamp>& goal() const { return goal_; }
  // Whether that one is fresh at `now` (us).
  bool fresh(std::int64_t now, double age) const;

  // Which two send: of a contested floor.
  std::string two() const;
  // "a second one sends SERVO_GOAL: session 34 is not obeyed, 12 is"; or that one repeats in vain what was ignored,
  // while none is followed; empty when none did in the last `age` s.
  std::string second(std::int64_t now, double age) const;

 private:
  struct Sender {
    std::int64_t session;
    std::int64_t last_id;  // of the goals taken from it
  };
  struct Second {
    std::int64_t session = 0;
    std::int64_t heard_at = 0;  // us, of now
  };

  std::int64_t largest_id(std::int64_t session) const;
  void take_floor(std::int64_t session, std::int64_t now);

  std::string channel_;
  std::optional<GoalStamp> goal_;
  std::deque<Sender> senders_;        // that had the floor; the one that last had a new goal comes last
  std::deque<Sender> ignored_;        // that had not: apart, so that no crowd of them makes us forget the others
  std::int64_t holder_ = 0;           // session that has the floor
  std::int64_t holder_since_ = 0;     // us, of now
  std::int64_t holder_heard_at_ = 0;  // us, of now
  bool holder_is_first_ = false;      // nobody had the floor before it
  bool contested_ = false;
  std::optional<Second> second_;
  std::optional<Second> in_vain_;  // who last repeated what was ignored
};

}  // namespace markservo::motion
