#include "services/mmi/troubles/watches/process_troubles.hpp"

#include "common/census/census.hpp"

namespace markservo::mmi {
namespace {

std::string sentence(const std::string& begin, const std::string& why) {
  return why.empty() ? begin : begin + ": " + why;
}

}  // namespace

ProcessTroubles::Condition ProcessTroubles::condition_of(ProcessState state) {
  switch (state) {
    case ProcessState::kWaiting:
    case ProcessState::kEnded:
    case ProcessState::kFailed:
      return Condition::kDead;
    case ProcessState::kSilent:
      return Condition::kSilent;
    case ProcessState::kStopped:
    case ProcessState::kStarting:
    case ProcessState::kRunning:
      break;
  }
  return Condition::kWell;
}

void ProcessTroubles::observe(const ProcessWord& word, double now) {
  note_watch(word.host, word.at, now);
  Process* process = known_or_new(processes_, {word.host, word.name}, now);
  if (process == nullptr) return;
  const Condition condition = condition_of(word.state);
  if (process->word.name.empty() || condition != process->condition) process->since = {now, word.at};
  process->condition = condition;
  process->word = word;
  process->heard = now;
}

void ProcessTroubles::observe(const ServiceWord& word, double now) {
  if (word.name == census::kStackWatch) return note_watch(word.host, word.at, now);
  const Place place{word.host, word.name};
  Service* service = known_or_new(services_, place, now);
  if (service == nullptr) return;
  if (service->session != word.session) {
    speakers_.erase(service->session);
    speakers_[word.session] = place;
    // Of services that were forgotten, and of two with one name.
    if (speakers_.size() > kMostKnown) speakers_ = {{word.session, place}};
  }
  *service = {word.session, word.pid, {now, word.at}, now};
}

void ProcessTroubles::observe(const AnyWord& word, double now) {
  const auto speaker = speakers_.find(word.session);
  if (speaker == speakers_.end()) return;
  const auto service = services_.find(speaker->second);
  if (service == services_.end()) return;
  service->second.last = {now, word.at};
  service->second.heard = now;
}

void ProcessTroubles::note_watch(const std::string& host, std::int64_t at, double now) {
  if (Watch* watch = known_or_new(watches_, host, now)) *watch = {{now, at}, now};
}

void ProcessTroubles::find(const Remedies& remedies, bool lossy, double now, Findings& found) const {
  const double silent = lossy ? parameters_.silent_lossy : parameters_.silent;
  for (const auto& [host, watch] : watches_) {
    if (now - watch.heard <= silent) continue;
    found.push_back(
        {{TroubleCode::kProcessHung, census::kStackWatch, watch.last.utime,
          "stack-watch on " + host + " says nothing any more: whether the stack's processes run is not known",
          remedies.watch_silent()},
         watch.last.now});
  }
  for (const auto& [place, process] : processes_) {
    const auto watch = watches_.find(place.first);
    const bool told = watch != watches_.end() && now - watch->second.heard <= silent;
    if (told) find_process(process, remedies, silent, now, found);
  }
}

void ProcessTroubles::find_process(const Process& process, const Remedies& remedies, double silent, double now,
                                   Findings& found) const {
  const ProcessWord& word = process.word;
  if (process.condition == Condition::kDead) {
    const bool comes_back = word.state == ProcessState::kWaiting;
    found.push_back({{TroubleCode::kProcessDead, word.name, process.since.utime,
                      sentence(word.name + " does not run", word.why), remedies.process_dead(word.name, comes_back)},
                     process.since.now});
    return;
  }
  const auto service = services_.find({word.host, word.name});
  const bool spoke = service != services_.end() && service->second.pid == word.pid;
  const bool silent_here = word.state == ProcessState::kRunning && spoke && now - service->second.heard > silent;
  if (process.condition != Condition::kSilent && !silent_here) return;
  const Since since = spoke ? service->second.last : process.since;
  const bool is_killed = process.condition == Condition::kSilent;
  found.push_back({{TroubleCode::kProcessHung, word.name, since.utime, word.name + " runs, but says nothing any more",
                    remedies.process_hung(word.name, is_killed)},
                   since.now});
}

}  // namespace markservo::mmi
