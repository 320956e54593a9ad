// The rules of what is said about learning a mark's colour.

#include <cstdint>
#include <markservo/LearnRequest.hpp>
#include <markservo/LearnResult.hpp>

#include "common/messages/rule_words.hpp"

namespace markservo::messages {
namespace {

constexpr std::int32_t kMaxBoxSide = 16384;  // px, as an image's

template <class Result, class Visit>
void each_text_of_result(Result& result, Visit& visit) {
  visit("mark", result.mark);
  visit("reason", result.reason);
  for (auto& warning : result.warnings) {
    visit("a warning's overlaps", warning.overlaps);
    visit("a warning's text", warning.text);
  }
}

std::string share_violation(const std::string& field, double value) {
  return value >= 0.0 && value <= 1.0 ? "" : wrong(field, value, "0 to 1");
}

std::string colour_violation(const LearnResult& result) {
  for (const double hue : {result.hue_min_deg, result.hue_max_deg}) {
    if (!(hue >= 0.0 && hue <= 360.0)) return wrong("a hue", hue, "0 to 360 degrees");
  }
  for (const double limit : {result.saturation_min, result.saturation_max, result.value_min, result.value_max}) {
    if (auto why = share_violation("a saturation or value", limit); !why.empty()) return why;
  }
  return share_violation("covered", result.covered);
}

std::string mask_violation(const LearnResult& result) {
  for (const std::int32_t side : {result.mask_width, result.mask_height}) {
    if (side < 0 || side > kMaxBoxSide) return wrong("the mask's width or height", side, "0 to 16384 px");
  }
  if (result.mask_size == result.mask_height * ((result.mask_width + 7) / 8)) return {};
  return wrong("mask_size", result.mask_size, "mask_height * ((mask_width + 7) / 8) bytes");
}

}  // namespace

// Who asks and for which mark: box and frame are judged by mark-detector, which says what is wrong with them in its
// answer.
std::string MessageRules<LearnRequest>::violation(const LearnRequest& request) {
  if (auto why = text::violation("mark", request.mark); !why.empty()) return why;
  if (request.session < 1) return wrong("session", request.session, "1 or more");
  if (request.request_id < 1) return wrong("request_id", request.request_id, "1 or more");
  return {};
}

void MessageRules<LearnRequest>::clean_texts(LearnRequest& request) {
  text::clean(request.mark);
}

std::string MessageRules<LearnResult>::violation(const LearnResult& result) {
  TextCheck texts;
  each_text_of_result(result, texts);
  if (!texts.why().empty()) return texts.why();
  if (auto why = count_violation("request_session", result.request_session); !why.empty()) return why;
  if (auto why = count_violation("request_id", result.request_id); !why.empty()) return why;
  if (auto why = colour_violation(result); !why.empty()) return why;
  return mask_violation(result);
}

void MessageRules<LearnResult>::clean_texts(LearnResult& result) {
  TextCleaner cleaner;
  each_text_of_result(result, cleaner);
}

}  // namespace markservo::messages
