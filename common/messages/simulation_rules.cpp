// The rules of what the simulator and those who score it say.

#include <cmath>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>

#include "common/messages/vector_rule.hpp"

namespace markservo::messages {
namespace {

template <class Control, class Visit>
void each_text_of_control(Control& control, Visit& visit) {
  for (auto& parameter : control.parameters) visit("a parameter's name", parameter.name);
}

template <class Truth, class Visit>
void each_text_of_truth(Truth& truth, Visit& visit) {
  visit("control_error", truth.control_error);
  visit("touched", truth.touched);
  for (auto& body : truth.bodies) visit("a body's name", body.name);
  for (auto& mark : truth.marks) visit("a mark's name", mark.name);
}

}  // namespace

std::string MessageRules<SimControl>::violation(const SimControl& control) {
  TextCheck texts;
  each_text_of_control(control, texts);
  if (!texts.why().empty()) return texts.why();
  if (auto why = enum_violation("kind", control.kind, SimControl::STEP); !why.empty()) return why;
  for (const auto& parameter : control.parameters) {
    if (!std::isfinite(parameter.value)) return not_finite("parameter " + parameter.name);
  }
  return {};
}

void MessageRules<SimControl>::clean_texts(SimControl& control) {
  TextCleaner cleaner;
  each_text_of_control(control, cleaner);
}

std::string MessageRules<SimTruth>::violation(const SimTruth& truth) {
  TextCheck texts;
  each_text_of_truth(truth, texts);
  if (!texts.why().empty()) return texts.why();
  if (!all_finite(truth.shaft)) return not_finite("shaft");
  if (!finite(truth.p_CG) || !std::isfinite(truth.gripper_opening)) return not_finite("p_CG or gripper_opening");
  for (const auto& body : truth.bodies) {
    if (!finite(body.p_CB) || !all_finite({body.q_CB_w, body.q_CB_x, body.q_CB_y, body.q_CB_z, body.height_gain})) {
      return not_finite("body " + body.name);
    }
  }
  for (const auto& mark : truth.marks) {
    if (!finite(mark.p_C) || !finite(mark.normal_C)) return not_finite("mark " + mark.name);
  }
  return {};
}

void MessageRules<SimTruth>::clean_texts(SimTruth& truth) {
  TextCleaner cleaner;
  each_text_of_truth(truth, cleaner);
}

std::string MessageRules<SimBaseTruth>::violation(const SimBaseTruth& truth) {
  if (auto why = pose_violation("pose", truth.pose); !why.empty()) return why;
  return all_finite({truth.speed, truth.turn_rate, truth.nearest}) ? "" : not_finite("speed, turn_rate or nearest");
}

}  // namespace markservo::messages
