// I9 to I11: what is told, kept and printed.

#include <algorithm>
#include <cctype>

#include "common/time/seconds_between.hpp"
#include "tests/experiments/task_words.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/motion.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

bool done_well(const TaskState& task) {
  return task.state == TaskState::DONE || task.state == TaskState::HOLD_LIFTED;
}

bool given_up(const TaskState& task) {
  return task.state == TaskState::REFUSED || task.state == TaskState::FAILED || task.state == TaskState::STOPPED;
}

bool in_a_name(const std::string& text, std::size_t at) {
  return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
}

// Whether `word` stands in `reason` by itself: STOP is not named by STOP_STATE.
bool names(const std::string& reason, const std::string& word) {
  if (word.empty()) return false;
  for (std::size_t at = reason.find(word); at != std::string::npos; at = reason.find(word, at + 1)) {
    if ((at == 0 || !in_a_name(reason, at - 1)) && !in_a_name(reason, at + word.size())) return true;
  }
  return false;
}

bool names_one(const std::string& reason, const Timeline& timeline) {
  for (const Fault& fault : timeline.faults) {
    for (const std::string& word : fault.words) {
      if (names(reason, word)) return true;
    }
  }
  return false;
}

// s, world: since when nothing of the arm, the base and the task's state has changed.
double stands_since(const Timeline& timeline, const Bars& bars) {
  double since = 0.0;
  int state = -1;
  for (const auto& heard : timeline.task_states) {
    if (heard.foreign || !timeline.is("task-manager", heard.message.session) || heard.message.state == state) continue;
    state = heard.message.state;
    since = heard.world;
  }
  const SimTruth* arm = nullptr;
  for (const auto& truth : timeline.truth) {
    if (arm != nullptr && same_world(*arm, truth.message) &&
        farthest_joint(arm->shaft, truth.message.shaft) <= bars.task_moves)
      continue;
    arm = &truth.message;
    since = std::max(since, truth.world);
  }
  const SimBaseTruth* base = nullptr;
  for (const auto& truth : timeline.base_truth) {
    if (base != nullptr && base->session == truth.message.session &&
        way_between(*base, truth.message) <= bars.task_moves && turn_between(*base, truth.message) <= bars.task_moves)
      continue;
    base = &truth.message;
    since = std::max(since, truth.world);
  }
  return since;
}

// A task that is under way long after the faults, or of which nothing goes on, does not end.
void judge_endless(const Timeline& timeline, const Heard<TaskState>& last, const Bars& bars, Verdict& verdict) {
  const double since = std::max(stands_since(timeline, bars), timeline.clock.at(timeline.faults_gone()));
  const double stood = timeline.clock.at(timeline.ended_at) - since;
  if (stood > bars.task_stands) {
    note(verdict, last.t,
         text("the task stands in state %s, and nothing has changed for %.1f s (world)",
              experiments::task_state_name(last.message.state), stood));
  } else if (timeline.clock.at(timeline.ended_at) - timeline.clock.at(timeline.faults_gone()) > bars.task_patience) {
    note(verdict, last.t,
         text("the task is in state %s %.1f s (world) after the fault",
              experiments::task_state_name(last.message.state), bars.task_patience));
  }
}

// What the stack says of the task from `t` on.
const Heard<TaskState>* last_state_after(const Timeline& timeline, std::int64_t t) {
  const Heard<TaskState>* last = nullptr;
  for (const auto& heard : timeline.task_states) {
    if (!heard.foreign && timeline.is("task-manager", heard.message.session) && heard.t > t) last = &heard;
  }
  return last;
}

// Whether the stack's task had come to its end before `t`.
bool ended_before(const Timeline& timeline, std::int64_t t) {
  const int state = timeline.task_state_at(t);
  return state == TaskState::DONE || state == TaskState::HOLD_LIFTED;
}

// s of [from, to] (us) that the manifest does not tell as missed.
double untold(const nlohmann::json& gaps, std::int64_t from, std::int64_t to) {
  double told = 0.0;
  for (const auto& gap : gaps) {
    const std::int64_t begin = std::max(from, gap.at(0).get<std::int64_t>());
    const auto until = gap.at(1).get<std::int64_t>();
    const std::int64_t end = until > 0 ? std::min(to, until) : to;  // 0: to the recording's end
    if (end > begin) told += seconds_between(begin, end);
  }
  return seconds_between(from, to) - told;
}

// A gap is told from what was written last, at most a second before the logger died.
bool is_true(const nlohmann::json& gap, const std::vector<std::int64_t>& moments, const Bars& bars) {
  const std::int64_t from = gap.at(0).get<std::int64_t>() + static_cast<std::int64_t>(bars.told_to * 1e6);
  const std::int64_t to = gap.at(1).get<std::int64_t>() - static_cast<std::int64_t>(bars.told_to * 1e6);
  return std::none_of(moments.begin(), moments.end(), [&](std::int64_t t) { return t > from && t < to; });
}

// Whether the manifest tells what a recording misses, truly.
void judge_manifest(const Timeline& timeline, const nlohmann::json& recording, const std::vector<std::int64_t>& moments,
                    const Bars& bars, Verdict& verdict) {
  if (!recording.contains("manifest")) return;
  const nlohmann::json& manifest = recording.at("manifest");
  ++verdict.judged;
  if (manifest.contains("error")) {
    note(verdict, timeline.ended_at, "the manifest: " + manifest.at("error").get<std::string>());
    return;
  }
  const std::string ended_by = manifest.value("ended_by", std::string());
  if (ended_by != "told to") {
    note(verdict, timeline.ended_at, text("the recording ended by itself: \"%.200s\"", ended_by.c_str()));
  }
  for (const auto& gap : manifest.at("gaps")) {
    if (is_true(gap, moments, bars)) continue;
    note(verdict, gap.at(0), "the manifest tells as missed what was recorded");
  }
}

}  // namespace

Verdict tasks_end_with_the_reason(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  if (timeline.task_starts.empty()) return verdict;
  const std::int64_t strike = timeline.first_strike();
  const Heard<TaskState>* last = last_state_after(timeline, strike);
  // A task that had ended well may stay so; what stops it afterwards is to be named all the same.
  if (ended_before(timeline, strike) && (last == nullptr || !given_up(last->message))) return verdict;
  ++verdict.judged;
  if (last == nullptr) {
    note(verdict, timeline.ended_at, "the stack says nothing of its task any more");
    return verdict;
  }
  const TaskState& task = last->message;
  if (done_well(task)) return verdict;
  // A task-manager that began anew has no task; it must say so.
  if (given_up(task) || (task.state == TaskState::IDLE && !task.reason.empty())) {
    if (!names_one(task.reason, timeline)) {
      note(verdict, last->t,
           text("the task ended as %s: \"%.300s\", which names no fault", experiments::task_state_name(task.state),
                task.reason.c_str()));
    }
    return verdict;
  }
  if (task.state == TaskState::IDLE) {
    note(verdict, last->t, "the task is gone, without a reason");
  } else {
    judge_endless(timeline, *last, bars, verdict);
  }
  return verdict;
}

Verdict recording_goes_on(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  const auto bar_us = [](double seconds) { return static_cast<std::int64_t>(seconds * 1e6); };
  for (const auto& recording : timeline.recordings) {
    ++verdict.judged;
    if (!recording.value("error", std::string()).empty()) {
      note(verdict, timeline.ended_at, "the recording: " + recording.at("error").get<std::string>());
    }
    std::int64_t last = recording.value("began", std::int64_t{0});
    std::vector<std::int64_t> moments;  // us, one a tenth of a second in which something was recorded
    for (const auto& moment : recording.at("moments")) moments.push_back(moment.get<std::int64_t>());
    const std::int64_t until = recording.value("ended", timeline.ended_at);
    judge_manifest(timeline, recording, moments, bars, verdict);
    const bool manifest = recording.contains("manifest") && recording.at("manifest").contains("gaps");
    moments.push_back(until);
    for (const std::int64_t moment : moments) {
      if (moment > until) break;
      // Nothing is missing where nothing was said.
      std::int64_t said = 0;
      for (const auto& truth : timeline.base_truth)
        said += truth.t > last + bar_us(0.5) && truth.t < moment - bar_us(0.5) ? 1 : 0;
      const bool before_fault = moment <= timeline.first_strike();
      const double allowed = before_fault ? bars.recording_up_to : bars.recording_gap;
      if (said > 10 && seconds_between(last, moment) > allowed) {
        note(verdict, moment,
             text("nothing recorded for %.1f s, from %.1f s after the first strike", seconds_between(last, moment),
                  seconds_between(timeline.first_strike(), last)));
      }
      if (said > 10 && manifest && untold(recording.at("manifest").at("gaps"), last, moment) > bars.told_to) {
        note(verdict, moment,
             text("the manifest does not tell that nothing was recorded for %.1f s, from %.1f s after the first strike",
                  seconds_between(last, moment), seconds_between(timeline.first_strike(), last)));
      }
      last = std::max(last, moment);
    }
  }
  return verdict;
}

Verdict words_are_clean(const Timeline& timeline, const Bars&) {
  Verdict verdict;
  for (const auto& [name, printed] : timeline.printed) {
    ++verdict.judged;
    if (const std::string what = unclean(printed); !what.empty()) note(verdict, timeline.ended_at, name + ": " + what);
    if (printed.find("\nFORGED") != std::string::npos) {
      note(verdict, timeline.ended_at, name + ": a line that a message's text made up");
    }
  }
  return verdict;
}

}  // namespace markservo::campaign
