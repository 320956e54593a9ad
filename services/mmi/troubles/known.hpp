#pragma once

// What is remembered by a name that comes from the bus: bounded, whoever invents names.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>

namespace markservo::mmi {

inline constexpr std::size_t kMostKnown = 100;  // of each kind; a robot has some twenty
inline constexpr double kForgotten = 10.0;      // s without a word, after which one gives way to a newcomer

// The one of `key`, known or new; null where there is no room. A Value has `heard`, s of `now`'s clock.
template <class Key, class Value>
Value* known_or_new(std::map<Key, Value>& all, const Key& key, double now) {
  const auto known = all.find(key);
  if (known != all.end()) return &known->second;
  if (all.size() >= kMostKnown) {
    const auto oldest = std::min_element(all.begin(), all.end(),
                                         [](const auto& a, const auto& b) { return a.second.heard < b.second.heard; });
    if (now - oldest->second.heard <= kForgotten) return nullptr;
    all.erase(oldest);
  }
  return &all[key];
}

// Since when something is so.
struct Since {
  double now = 0.0;        // s of the watch's clock
  std::int64_t utime = 0;  // us of the source's
};

}  // namespace markservo::mmi
