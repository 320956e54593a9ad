// What a forged history knows of processes, faults, the recording and what was printed.

#include "tests/unit/fault_campaign/forged_history.hpp"

namespace markservo::campaign {

ForgedHistory& ForgedHistory::process(double from, double to, const std::string& service, char state, double rss_mb) {
  for (double t = from; t < to; t += 0.5) {
    history_.facts.push_back({{"t", at(t)},
                              {"kind", "process"},
                              {"service", service},
                              {"pid", forged_stack().at(service).first},
                              {"state", std::string(1, state)},
                              {"rss_mb", rss_mb}});
  }
  return *this;
}

ForgedHistory& ForgedHistory::fault(double struck, double ended, std::set<std::string> words) {
  history_.facts.push_back({{"t", at(0.0)},
                            {"kind", "fault"},
                            {"what", "planned"},
                            {"index", faults_},
                            {"describe", "forged"},
                            {"words", words}});
  history_.facts.push_back({{"t", at(struck)}, {"kind", "fault"}, {"what", "strike"}, {"index", faults_}});
  history_.facts.push_back({{"t", at(ended)}, {"kind", "fault"}, {"what", "end"}, {"index", faults_}});
  ++faults_;
  return *this;
}

ForgedHistory& ForgedHistory::ended(double t) {
  history_.facts.push_back({{"t", at(t)}, {"kind", "end"}});
  return *this;
}

ForgedHistory& ForgedHistory::start(double t) {
  history_.facts.push_back({{"t", at(t)}, {"kind", "start"}, {"target", "red_book"}});
  return *this;
}

ForgedHistory& ForgedHistory::recorded(const std::vector<std::pair<double, double>>& spans, double until,
                                       const std::vector<std::pair<double, double>>& gaps,
                                       const std::string& ended_by) {
  std::vector<std::int64_t> moments;
  for (const auto& [from, to] : spans) {
    for (double t = from; t < to; t += 0.1) moments.push_back(at(t));
  }
  nlohmann::json told = nlohmann::json::array();
  for (const auto& [from, to] : gaps) told.push_back({at(from), at(to)});
  history_.facts.push_back({{"t", at(until)},
                            {"kind", "recording"},
                            {"began", at(0.0)},
                            {"ended", at(until)},
                            {"moments", moments},
                            {"manifest", {{"gaps", told}, {"ended_by", ended_by}}}});
  return *this;
}

ForgedHistory& ForgedHistory::printed(const std::string& name, const std::string& text) {
  history_.printed[name] = text;
  return *this;
}

}  // namespace markservo::campaign
