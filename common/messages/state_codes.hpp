#pragma once

// States between the messages' numbers and the services' enums. state_codes.cpp asserts that each value of each enum is
// numbered as its .lcm file numbers it, so that both ways are a plain cast.

#include <cstdint>

namespace markservo::messages {

template <class State>
constexpr std::int8_t code_of(State state) {
  return static_cast<std::int8_t>(state);
}

// Of a message that keeps its rules: they refuse numbers that are none (message_rules.hpp).
template <class State>
constexpr State state_of(std::int8_t code) {
  return static_cast<State>(code);
}

}  // namespace markservo::messages
