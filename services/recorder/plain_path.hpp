#pragma once

#include <filesystem>
#include <string>

namespace markservo::recorder {

// The path, absolute, without "." and "..", and without a slash at its end. Links stay as they are.
inline std::string plain_path(const std::string& path) {
  std::string plain = std::filesystem::absolute(path).lexically_normal().string();
  while (plain.size() > 1 && plain.back() == '/') plain.pop_back();
  return plain;
}

}  // namespace markservo::recorder
