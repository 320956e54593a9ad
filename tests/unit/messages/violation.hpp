#pragma once

#include <string>

#include "common/messages/message_rules.hpp"

namespace markservo::messages {

template <class M>
std::string violation(const M& message) {
  return MessageRules<M>::violation(message);
}

}  // namespace markservo::messages
