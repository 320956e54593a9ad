#include "services/mmi/troubles/remedies.hpp"

#include <algorithm>
#include <string_view>

namespace markservo::mmi {

std::string typable(const std::string& name, const std::string& instead) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./";
  const bool plain = !name.empty() && name.front() != '-' && std::all_of(name.begin(), name.end(), [&](char letter) {
    return letter == '-' || kPlain.find(letter) != std::string_view::npos;
  });
  return plain ? name : instead;
}

std::string Remedies::stop_device_silent() const {
  return "if it moves, take its power away; then start its driver: " + typed_.of("stack") + " start";
}

std::string Remedies::second_writer() const {
  return "end one of the two (" + typed_.of("doctor") + " names them), then " + typed_.of("task") + " reset";
}

std::string Remedies::process_dead(const std::string& process, bool comes_back) const {
  const std::string name = typable(process, "NAME");
  const std::string why = typed_.of("stack") + " logs " + name + " says why";
  if (comes_back) return "it is started again by itself; " + why;
  return why + "; then " + typed_.of("stack") + " restart " + name;
}

std::string Remedies::process_hung(const std::string& process, bool is_killed) const {
  const std::string restart = typed_.of("stack") + " restart " + typable(process, "NAME");
  return is_killed ? "it is killed and started again by itself; if not: " + restart : restart;
}

std::string Remedies::watch_silent() const {
  return typed_.of("stack") + " status says what runs; " + typed_.of("stack") + " start brings the stack back";
}

std::string Remedies::clock_ahead() const {
  return "stop the robot, then on that host: chronyc makestep; " + typed_.of("doctor") + " compares the clocks";
}

std::string Remedies::messages_lost() const {
  return typed_.of("doctor") + " says what the network and the host lack; a cable loses less than radio";
}

std::string Remedies::camera_silent(const std::string& writer) const {
  std::string look = typed_.of("doctor") + " --cameras says what the cameras lack";
  if (writer.empty()) return look;
  return look + "; then " + typed_.of("stack") + " restart " + typable(writer, "NAME");
}

std::string Remedies::stop_latched() const {
  return "when nobody is in reach of the robot: " + typed_.of("task") + " reset, and then a new start";
}

std::string Remedies::mark_unseen() const {
  return "uncover the mark, light it, or bring the robot before it; " + typed_.of("doctor") +
         " --cameras says what is seen";
}

std::string Remedies::hand_unseen() const {
  return "clear the view of the hand, or wipe its mark; " + typed_.of("doctor") + " --cameras says what is seen";
}

std::string Remedies::pose_lost() const {
  return "push the robot slowly over the floor's tags until it is found again; if not: " + typed_.of("stack") +
         " restart rfid-localizer";
}

std::string Remedies::base_blocked() const {
  return "clear the way: it goes on by itself; " + typed_.of("task") + " abort gives the drive up";
}

std::string Remedies::recording_ended() const {
  return "mend what it says, such as a full disk; " + typed_.of("record") + " begins another";
}

std::string Remedies::recorder_silent(const std::string& folder) const {
  return typed_.of("record") + " begins another; " + typed_.of("record") + " --finish " + typable(folder, "FOLDER") +
         " completes this one";
}

std::string Remedies::target_refused(const std::string& target) const {
  return "change what the reason says, then " + typed_.of("task") + " start --target " + typable(target, "NAME");
}

}  // namespace markservo::mmi
