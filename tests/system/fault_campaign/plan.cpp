#include "tests/system/fault_campaign/plan.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/system/fault_campaign/fault_kinds.hpp"
#include "tests/system/fault_campaign/random.hpp"

namespace markservo::campaign {
namespace {

using Names = std::vector<std::string>;

FaultPlan drawn(Random& random, const KindOfFault& kind) {
  FaultPlan fault;
  fault.kind = kind.kind;
  fault.offset = random.between(0.0, 0.8);
  kind.draw(random, fault);
  return fault;
}

const KindOfFault& draw_kind(Random& random) {
  double total = 0.0;
  for (const KindOfFault& kind : kinds_of_fault()) total += kind.weight;
  double at = random.uniform() * total;
  for (const KindOfFault& kind : kinds_of_fault()) {
    at -= kind.weight;
    if (at < 0.0) return kind;
  }
  return kinds_of_fault().back();
}

// Two faults that need the same thing of their own (a service's way to the bus, one packet filter) exclude each other.
std::string exclusive(const FaultPlan& fault) {
  if (fault.kind == "relay" || (fault.kind == "clock-step" && fault.variant == "stamps")) return "relay";
  if (fault.kind == "clock-step" || fault.kind == "clock-drift") return "wall clock";
  if (fault.kind == "disk-full" || fault.kind == "read-only") return "disk";
  if (fault.kind == "route-gone" || fault.kind == "interface-gone") return "route";
  return fault.kind;
}

std::uint64_t seed_for(std::int64_t seed, int draw) {
  Random mix(static_cast<std::uint64_t>(seed) * 0x2545f4914f6cdd1dULL + static_cast<std::uint64_t>(draw));
  return mix.next();
}

// "a:b" into a and b; one word at least.
Names split(const std::string& text) {
  Names words{""};
  for (const char character : text) {
    if (character == ':') {
      words.emplace_back();
    } else {
      words.back() += character;
    }
  }
  return words;
}

// Whether channel, service, variant and session are those of the words after the kind.
bool has_all(const FaultPlan& fault, const Names& words) {
  return std::all_of(words.begin() + 1, words.end(), [&](const std::string& word) {
    return word == fault.channel || word == fault.service || word == fault.variant ||
           word == (fault.same_session ? "same" : "other");
  });
}

}  // namespace

const std::vector<std::string>& phases() {
  static const Names all = {"idle", "drive", "approach", "servo", "grip", "lifted", "carry"};
  return all;
}

const std::vector<std::string>& fault_kinds() {
  static const Names all = [] {
    Names names;
    for (const KindOfFault& kind : kinds_of_fault()) names.emplace_back(kind.kind);
    return names;
  }();
  return all;
}

Plan plan_of(std::int64_t seed, int draw) {
  Random random(seed_for(seed, draw));
  Plan plan;
  plan.seed = seed;
  plan.draw = draw;
  plan.phase = random.one_of(phases());
  plan.phase_delay = random.between(0.0, 0.3);
  // Most trials have one fault: what breaks then has one cause.
  const double dice = random.uniform();
  const std::size_t count = dice < 0.6 ? 1 : dice < 0.9 ? 2 : 3;
  Names taken;
  while (plan.faults.size() < count) {
    const FaultPlan fault = drawn(random, draw_kind(random));
    const std::string needs = exclusive(fault);
    if (std::find(taken.begin(), taken.end(), needs) != taken.end()) continue;
    taken.push_back(needs);
    plan.faults.push_back(fault);
  }
  return plan;
}

Plan plan_with(std::int64_t seed, const std::string& wanted, const std::string& phase) {
  if (std::find(phases().begin(), phases().end(), phase) == phases().end()) {
    throw std::invalid_argument("phase '" + phase + "' is none");
  }
  const Names words = split(wanted);
  const auto found = std::find_if(kinds_of_fault().begin(), kinds_of_fault().end(),
                                  [&](const KindOfFault& one) { return words[0] == one.kind; });
  if (found == kinds_of_fault().end()) throw std::invalid_argument("fault '" + words[0] + "' is none");
  Random random(seed_for(seed, 0));
  Plan plan;
  plan.seed = seed;
  plan.phase = phase;
  plan.phase_delay = random.between(0.0, 0.3);
  constexpr int kTries = 10000;
  for (int tries = 0; tries < kTries; ++tries) {
    const FaultPlan fault = drawn(random, *found);
    if (!has_all(fault, words)) continue;
    plan.faults.push_back(fault);
    return plan;
  }
  throw std::invalid_argument("fault '" + wanted + "' is never drawn");
}

nlohmann::json json_of(const FaultPlan& fault) {
  nlohmann::json json{{"kind", fault.kind}, {"offset_s", fault.offset}, {"duration_s", fault.duration}};
  if (!fault.channel.empty()) json["channel"] = fault.channel;
  if (!fault.service.empty()) json["service"] = fault.service;
  if (!fault.variant.empty()) json["variant"] = fault.variant;
  if (fault.rate > 0.0) json["rate_hz"] = fault.rate;
  if (fault.percent > 0.0) json["percent"] = fault.percent;
  if (fault.delay > 0.0) json["delay_s"] = fault.delay;
  if (fault.amount != 0.0) json["amount"] = fault.amount;
  if (fault.same_session) json["same_session"] = true;
  return json;
}

}  // namespace markservo::campaign
