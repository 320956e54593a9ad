#include "services/mmi/control/desk.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/reflection/message_json.hpp"
#include "services/mmi/server/secret.hpp"

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<const char*, task::Action> kWishes[] = {{"start", task::Action::kStart},
                                                            {"home", task::Action::kHome},
                                                            {"drive", task::Action::kDrive},
                                                            {"reset", task::Action::kReset},
                                                            {"abort", task::Action::kAbort}};

std::set<std::string> targets_of(const robot::RobotDescription& robot) {
  std::set<std::string> targets;
  for (const robot::MarkDescription& mark : robot.marks) {
    if (mark.role == robot::MarkRole::kTarget) targets.insert(mark.name);
  }
  return targets;
}

bool moves(const Command& command) {
  return command.action != task::Action::kAbort && command.action != task::Action::kReset;
}

const char* state_of(const task::Ending& ending) {
  if (ending.exit_code == task::kExitReached) return "done";
  return ending.exit_code == task::kExitNoAnswer ? "unanswered" : "failed";
}

std::string text_of(const Json& json) {
  std::string text = reflection::json_text(json, -1);
  text.pop_back();  // the end of the line
  return text;
}

}  // namespace

Desk::Desk(const robot::RobotDescription& robot, std::string token, std::function<std::int64_t()> number_reset,
           DeskParameters parameters)
    : token_(std::move(token)),
      number_reset_(std::move(number_reset)),
      parameters_(parameters),
      stop_devices_(robot.stop_devices),
      targets_(targets_of(robot)),
      robot_(robot.stop_devices, robot.base.has_value()) {}

void Desk::arrive(std::int64_t session) {
  clients_.try_emplace(session, session);
}

// Its command goes on: a task does not end because a page is closed.
void Desk::leave(std::int64_t session) {
  clients_.erase(session);
  lease_.give_up(session);
}

bool Desk::admits(std::string_view token) const {
  return is_secret(token, token_);
}

void Desk::hear_token(std::int64_t session, std::string_view token) {
  const auto client = clients_.find(session);
  if (client != clients_.end()) client->second.may = admits(token);
}

void Desk::lease(std::int64_t session, bool on, bool take, double now) {
  const auto client = clients_.find(session);
  if (client == clients_.end() || !client->second.may) return;  // view() says that it may not
  if (on) {
    lease_.hold(session, take, now);
  } else {
    lease_.give_up(session);
  }
}

bool Desk::waits_for(const Command& command, const Errand& errand) {
  if (errand.dialogue.followed()) return false;
  return errand.command.action == command.action || (moves(command) && moves(errand.command));
}

CommandRules::Verdict Desk::judge(const Client& client, const CommandStamp& stamp, const Command& command,
                                  double now) const {
  if (!client.may)
    return {false, Refusal::kNoToken, "no token of commands: open the address that scripts/page printed"};
  if (lease_.holder(now) != stamp.session)
    return {false, Refusal::kNoLease, "another operates, or nobody: take control first"};
  if (command.action == task::Action::kStart && targets_.count(command.target) == 0) {
    return {false, Refusal::kUnknownTarget, "'" + command.target + "' is no target of the robot's description"};
  }
  const auto is_before = [&command](const Errand& errand) { return waits_for(command, errand); };
  if (std::any_of(errands_.begin(), errands_.end(), is_before)) {
    return {false, Refusal::kBusy, "the command before it has not been answered yet"};
  }
  const std::string why = robot_.why_not(command.action, now);
  if (!why.empty()) return {false, Refusal::kCannot, why};
  return {};
}

void Desk::command(std::int64_t session, const CommandStamp& stamp, const Command& command, double now,
                   std::int64_t now_utime) {
  const auto found = clients_.find(session);
  if (found == clients_.end()) return;
  Client& client = found->second;
  CommandRules::Verdict verdict = client.rules.judge(stamp, now_utime);
  if (verdict.good) verdict = judge(client, stamp, command, now);
  if (!verdict.good) return refuse(client, stamp.seq, verdict);

  task::Parameters dialogue;
  dialogue.patience = parameters_.patience;
  Errand errand{session, stamp.seq, 0, command, task::Dialogue(command.action, stop_devices_, dialogue)};
  errand.id = errand.is_reset() ? number_reset_() : ++commands_;
  robot_.tell(errand.dialogue, now);
  errands_.push_back(std::move(errand));
}

void Desk::refuse(Client& client, std::int64_t seq, const CommandRules::Verdict& why) {
  ++refused_[name_of(why.refusal)];
  answer(client, text_of({{"seq", seq}, {"state", "refused"}, {"code", name_of(why.refusal)}, {"text", why.text}}));
}

void Desk::tell(std::int64_t session, std::int64_t seq, const char* state, const std::string& text) {
  const auto client = clients_.find(session);
  if (client == clients_.end()) return;
  answer(client->second, text_of({{"seq", seq}, {"state", state}, {"code", ""}, {"text", text}}));
}

void Desk::answer(Client& client, std::string json) const {
  if (client.answers.size() < parameters_.answers_max) {
    client.answers.push_back(std::move(json));
  } else {
    client.behind = true;
  }
}

std::string Desk::view(std::int64_t session, double now, std::int64_t now_utime) const {
  const auto client = clients_.find(session);
  const std::int64_t holder = lease_.holder(now);
  Json why;
  for (const auto& [name, action] : kWishes) why[name] = robot_.why_not(action, now);
  const auto since = now_utime - static_cast<std::int64_t>(1e6 * (now - lease_.since()));
  // To a tenth of a second: the two clocks run apart, and nothing is told anew for that.
  constexpr std::int64_t kTold_us = 100'000;
  return text_of({{"session", std::to_string(session)},
                  {"may", client != clients_.end() && client->second.may},
                  {"holder", holder == 0         ? "none"
                             : holder == session ? "you"
                                                 : "another"},
                  {"since", holder == 0 ? "0" : std::to_string((since + kTold_us / 2) / kTold_us * kTold_us)},
                  {"targets", targets_},
                  {"why", why}});
}

std::string Desk::take_answers(std::int64_t session) {
  const auto client = clients_.find(session);
  if (client == clients_.end() || client->second.answers.empty()) return {};
  std::string list;
  for (const std::string& answer : client->second.answers) list += (list.empty() ? "[" : ",") + answer;
  client->second.answers.clear();
  return list + "]";
}

bool Desk::is_behind(std::int64_t session) const {
  const auto client = clients_.find(session);
  return client != clients_.end() && client->second.behind;
}

void Desk::observe(task::StopReport report, std::int64_t ours, bool asked, double now) {
  report.answers_us = false;
  robot_.observe(report, asked, now);
  for (Errand& errand : errands_) {
    report.answers_us = errand.is_reset() && errand.id == ours;
    errand.dialogue.observe(report);
  }
}

void Desk::observe(task::TaskReport report, std::int64_t ours, double now) {
  if (ours != 0) report.answers = task::Answers::kAnother;
  robot_.observe(report, now);
  const task::Answers others = report.answers;
  for (Errand& errand : errands_) {
    report.answers = !errand.is_reset() && errand.id == ours ? task::Answers::kUs : others;
    errand.dialogue.observe(report, now);
  }
}

void Desk::observe_conflict(const std::string& words, double now) {
  robot_.observe_conflict(words, now);
  for (Errand& errand : errands_) errand.dialogue.observe_conflict(words);
}

std::vector<CommandToSend> Desk::step(double now) {
  std::vector<CommandToSend> to_send;
  for (auto errand = errands_.begin(); errand != errands_.end();) {
    const task::Step step = errand->dialogue.step(now);
    if (step.send) {
      to_send.push_back({errand->id, errand->command});
      if (!std::exchange(errand->sent, true)) tell(errand->session, errand->seq, "sent", "");
    }
    for (const std::string& line : step.lines) tell(errand->session, errand->seq, "under_way", line);
    if (step.ending) tell(errand->session, errand->seq, state_of(*step.ending), step.ending->line);
    errand = step.ending ? errands_.erase(errand) : std::next(errand);
  }
  return to_send;
}

}  // namespace markservo::mmi
