#include "services/camera-check/marks/mark_sightings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace markservo::camera_check {
namespace {

// The reason that most pairs have.
MarkStatus usual_reason(const MarkSighting& mark) {
  const auto more = [](const auto& one, const auto& other) { return one.second < other.second; };
  const auto most = std::max_element(mark.reasons.begin(), mark.reasons.end(), more);
  return most == mark.reasons.end() ? MarkStatus::kUnseen : most->first;
}

// A mark that both pictures show whole, and that is not located all the same.
bool is_trouble(MarkStatus status) {
  return status == MarkStatus::kTooFewMatches || status == MarkStatus::kInconsistent;
}

const char* cure_of(MarkStatus status) {
  return status == MarkStatus::kTooFewMatches
             ? "show its whole outline, as robot.yaml states it, or print a texture (scripts/print-mark); bring it "
               "nearer and sharp"
             : "look for another thing of the mark's colour, and for what is said of the cameras above";
}

Finding finding_of(const MarkSighting& mark) {
  const std::string where = fmt::format("left in {}, right in {} of {} pairs", mark.left, mark.right, mark.pairs);
  if (mark.located > 0) {
    const double distance_m = mark.p_C.norm();
    return {true,
            fmt::format("{}: located in {} of {} pairs, {}, {:.3f} m from the left lens", mark.name, mark.located,
                        mark.pairs, told_cue(mark), distance_m),
            ""};
  }
  const MarkStatus reason = usual_reason(mark);
  const bool trouble = is_trouble(reason);
  return {!trouble, fmt::format("{}: {} (seen {})", mark.name, name_of(reason), where), trouble ? cure_of(reason) : ""};
}

}  // namespace

MarkSighting& MarkSightings::named(const std::string& name) {
  const auto found =
      std::find_if(marks_.begin(), marks_.end(), [&name](const MarkSighting& mark) { return mark.name == name; });
  if (found != marks_.end()) return *found;
  marks_.emplace_back();
  marks_.back().name = name;
  return marks_.back();
}

void MarkSightings::add(const SeenMark& seen) {
  MarkSighting& mark = named(seen.name);
  ++mark.pairs;
  mark.left += seen.left ? 1 : 0;
  mark.right += seen.right ? 1 : 0;
}

void MarkSightings::add(const PlacedMark& placed) {
  MarkSighting& mark = named(placed.name);
  if (placed.status != MarkStatus::kLocated) {
    ++mark.reasons[placed.status];
    return;
  }
  ++mark.located;
  mark.cue = placed.cue;
  mark.num_points = placed.num_points;
  mark.p_C = placed.p_C;
}

std::string told_cue(const MarkSighting& mark) {
  const bool by_points = mark.cue == MarkCue::kTexture || mark.cue == MarkCue::kOutline;
  return by_points ? fmt::format("{} ({} points)", name_of(mark.cue), mark.num_points) : name_of(mark.cue);
}

std::vector<Finding> findings_of(const std::vector<MarkSighting>& marks) {
  std::vector<Finding> findings;
  const bool nothing = std::all_of(marks.begin(), marks.end(), [](const auto& mark) { return mark.located == 0; });
  for (const MarkSighting& mark : marks) findings.push_back(finding_of(mark));
  const bool told = std::any_of(findings.begin(), findings.end(), [](const Finding& each) { return !each.ok; });
  if (nothing && !told) {
    findings.push_back({false, "no mark is located",
                        "hold a mark where both cameras see it whole; mark-detector --learn measures its colour"});
  }
  return findings;
}

}  // namespace markservo::camera_check
