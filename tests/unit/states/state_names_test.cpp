// Each state has one word, and no two share it.

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>

#include "common/states/base_state.hpp"
#include "common/states/localisation_state.hpp"
#include "common/states/mark_status.hpp"
#include "common/states/servo_state.hpp"
#include "common/states/task_phase.hpp"

namespace markservo {
namespace {

template <class State>
std::set<std::string> words_up_to(State last) {
  std::set<std::string> words;
  for (int code = 0; code <= static_cast<int>(last); ++code) words.insert(name_of(static_cast<State>(code)));
  EXPECT_EQ(words.size(), static_cast<std::size_t>(last) + 1);
  EXPECT_EQ(words.count("unknown"), 0U);
  EXPECT_EQ(words.count(""), 0U);
  return words;
}

TEST(StateNames, AreOneForEachState) {
  words_up_to(ServoState::kStopped);
  words_up_to(BaseState::kStopped);
  words_up_to(LocalisationState::kLost);
  words_up_to(MarkStatus::kInconsistent);
  words_up_to(TaskPhase::kDrive);
}

TEST(StateNames, AreTheSameForTheSameStateOfArmAndBase) {
  EXPECT_STREQ(name_of(ServoState::kStale), name_of(BaseState::kStale));
  EXPECT_STREQ(name_of(ServoState::kStopped), name_of(BaseState::kStopped));
  EXPECT_STREQ(name_of(ServoState::kHold), name_of(BaseState::kHold));
}

}  // namespace
}  // namespace markservo
