#pragma once

// Where operators' commands come in: who may command, what is sent, what became of it. No bus, no clock: `now` is s of
// any steady clock, `now_utime` us of the one by which commands expire.

#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "common/task/dialogue.hpp"
#include "services/mmi/control/command.hpp"
#include "services/mmi/control/command_rules.hpp"
#include "services/mmi/control/lease.hpp"
#include "services/mmi/control/robot_answers.hpp"

namespace markservo::mmi {

struct DeskParameters {
  double patience = 2.0;          // s that an unanswered command is repeated: nothing is done late
  std::size_t answers_max = 200;  // waiting for one client
};

// A command to be sent now: RESET as STOP, all others as TASK_COMMAND.
struct CommandToSend {
  std::int64_t id = 0;  // of the STOP or TASK_COMMAND, under the bus's session
  Command command;
};

class Desk {
 public:
  // `token`: of commands, not empty. `number_reset` gives each RESET its request_id.
  Desk(const robot::RobotDescription& robot, std::string token, std::function<std::int64_t()> number_reset,
       DeskParameters parameters = {});

  // A conversation begins, and ends. `session`: random, above 0 and of no other conversation.
  void arrive(std::int64_t session);
  void leave(std::int64_t session);
  bool admits(std::string_view token) const;
  // What it said as its token.
  void hear_token(std::int64_t session, std::string_view token);

  void lease(std::int64_t session, bool on, bool take, double now);
  void command(std::int64_t session, const CommandStamp& stamp, const Command& command, double now,
               std::int64_t now_utime);

  // `desk` of an update, JSON.
  std::string view(std::int64_t session, double now, std::int64_t now_utime) const;
  // `answers` of an update, JSON: what it has not been told; empty when there is nothing.
  std::string take_answers(std::int64_t session);
  // Whether answers were lost to it because it took none.
  bool is_behind(std::int64_t session) const;
  // How many commands were refused, by name.
  const std::map<std::string, std::int64_t>& refused() const { return refused_; }

  // `ours`: the request of ours that a device, or task-manager, has obeyed last; 0: none.
  void observe(task::StopReport report, std::int64_t ours, bool asked, double now);
  void observe(task::TaskReport report, std::int64_t ours, double now);
  // Two write TASK_STATE, in words.
  void observe_conflict(const std::string& words, double now);

  // To be called every 0.1 s or oftener.
  std::vector<CommandToSend> step(double now);

 private:
  struct Client {
    explicit Client(std::int64_t session) : rules(session) {}
    CommandRules rules;
    bool may = false;
    std::deque<std::string> answers;
    bool behind = false;
  };
  // A command under way.
  struct Errand {
    std::int64_t session = 0;
    std::int64_t seq = 0;
    std::int64_t id = 0;
    Command command;
    task::Dialogue dialogue;
    bool sent = false;

    bool is_reset() const { return command.action == task::Action::kReset; }
  };

  // Whether the command must wait until `errand` is answered.
  static bool waits_for(const Command& command, const Errand& errand);
  CommandRules::Verdict judge(const Client& client, const CommandStamp& stamp, const Command& command,
                              double now) const;
  void refuse(Client& client, std::int64_t seq, const CommandRules::Verdict& why);
  void tell(std::int64_t session, std::int64_t seq, const char* state, const std::string& text);
  void answer(Client& client, std::string json) const;

  std::string token_;
  std::function<std::int64_t()> number_reset_;
  DeskParameters parameters_;
  std::vector<std::string> stop_devices_;
  std::set<std::string> targets_;
  RobotAnswers robot_;
  Lease lease_;
  std::map<std::int64_t, Client> clients_;
  std::list<Errand> errands_;
  std::map<std::string, std::int64_t> refused_;
  std::int64_t commands_ = 0;  // sent as TASK_COMMAND so far
};

}  // namespace markservo::mmi
