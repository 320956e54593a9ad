#include "tests/system/fault_campaign/results.hpp"

#include <algorithm>
#include <set>

#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

bool must_never_break(const std::string& invariant) {
  static const std::set<std::string> kNever = {"I1", "I2", "I3", "I4", "I5", "I6", "I12"};
  return kNever.count(invariant) > 0;
}

}  // namespace

bool proves_what_it_should(const nlohmann::json& result) {
  return result.at("phase_reached").get<bool>() && result.at("struck").get<bool>();
}

bool breaks_what_may_never_break(const nlohmann::json& result) {
  const nlohmann::json& broken = result.at("broken");
  return std::any_of(broken.begin(), broken.end(),
                     [](const nlohmann::json& name) { return must_never_break(name.get<std::string>()); });
}

nlohmann::json result_of(nlohmann::json trial, const std::map<std::string, Verdict>& verdicts) {
  nlohmann::json broken = nlohmann::json::array();
  nlohmann::json judged = nlohmann::json::object();
  nlohmann::json breaches = nlohmann::json::object();
  for (const char* name : kInvariants) {
    const auto found = verdicts.find(name);
    if (found == verdicts.end()) continue;
    judged[name] = found->second.judged;
    if (!found->second.broken()) continue;
    broken.push_back(name);
    for (const Breach& breach : found->second.breaches) breaches[name].push_back(breach.evidence);
  }
  trial["broken"] = broken;
  trial["judged"] = judged;
  trial["breaches"] = breaches;
  return trial;
}

nlohmann::json campaign_of(const std::string& commit, const std::vector<nlohmann::json>& results) {
  nlohmann::json totals = nlohmann::json::object();
  for (const char* name : kInvariants) {
    std::int64_t judged = 0;
    int broken = 0;
    for (const auto& result : results) {
      judged += result.at("judged").value(name, std::int64_t{0});
      for (const auto& one : result.at("broken")) broken += one == name ? 1 : 0;
    }
    totals[name] = {{"judged", judged}, {"broken", broken}};
  }
  return {{"commit", commit}, {"seeds", results}, {"totals", totals}};
}

bool bars_met(const nlohmann::json& campaign, int most) {
  for (const auto& result : campaign.at("seeds")) {
    if (!proves_what_it_should(result)) return false;
  }
  for (const auto& [name, total] : campaign.at("totals").items()) {
    if (total.at("broken").get<int>() > (must_never_break(name) ? 0 : most)) return false;
  }
  return true;
}

std::string line_of(const nlohmann::json& result) {
  std::string faults;
  for (const auto& fault : result.at("faults"))
    faults += (faults.empty() ? "" : "; ") + fault.at("what").get<std::string>();
  std::string broken;
  for (const auto& name : result.at("broken")) broken += (broken.empty() ? "" : " ") + name.get<std::string>();
  const bool proves = proves_what_it_should(result);
  return text("seed %ld  %-8s  %-16s  %s", static_cast<long>(result.at("seed").get<std::int64_t>()),
              result.at("phase").get<std::string>().c_str(),
              !broken.empty() ? broken.c_str()
              : proves        ? "held"
                              : "proves nothing",
              faults.c_str());
}

std::string table_of(const nlohmann::json& campaign) {
  std::string table;
  for (const char* name : kInvariants) {
    const auto& total = campaign.at("totals").at(name);
    table +=
        text("  %-4s judged %8ld  broken in %3d seeds  %s\n", name,
             static_cast<long>(total.at("judged").get<std::int64_t>()), total.at("broken").get<int>(), words_of(name));
  }
  return table;
}

}  // namespace markservo::campaign
