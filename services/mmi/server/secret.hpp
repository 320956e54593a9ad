#pragma once

#include <cstddef>
#include <string_view>

namespace markservo::mmi {

// Whether `given` is the secret, in a time that does not tell how much of it is right.
inline bool is_secret(std::string_view given, std::string_view secret) {
  unsigned difference = given.size() == secret.size() ? 0U : 1U;
  for (std::size_t i = 0; i < secret.size(); ++i) {
    const char other = i < given.size() ? given[i] : '\0';
    difference |= static_cast<unsigned>(static_cast<unsigned char>(secret[i] ^ other));
  }
  return difference == 0;
}

}  // namespace markservo::mmi
