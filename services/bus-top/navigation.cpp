#include "services/bus-top/navigation.hpp"

#include <algorithm>
#include <limits>

namespace markservo::bus_top {
namespace {

constexpr int kFarAway = std::numeric_limits<int>::max() / 4;  // farther than any list is long

int step_of(Key key, int rows) {
  switch (key) {
    case Key::kUp:
      return -1;
    case Key::kDown:
      return 1;
    case Key::kPageUp:
      return -std::max(1, rows);
    case Key::kPageDown:
      return std::max(1, rows);
    case Key::kHome:
      return -kFarAway;
    case Key::kEnd:
      return kFarAway;
    default:
      return 0;
  }
}

}  // namespace

int Navigation::selected(const std::vector<std::string>& channels) const {
  if (channels.empty()) return -1;
  const auto found = std::find(channels.begin(), channels.end(), selected_);
  return found == channels.end() ? 0 : static_cast<int>(found - channels.begin());
}

int Navigation::first_line(const std::vector<std::string>& channels, int lines, int rows) const {
  const int last_first = std::max(0, lines - rows);
  if (in_fields()) return std::min(scroll_, last_first);
  return std::clamp(selected(channels) - rows + 1, 0, last_first);
}

void Navigation::press(Key key, const std::vector<std::string>& channels, int lines, int rows) {
  const int step = step_of(key, rows);
  if (key == Key::kQuit) {
    quit_ = true;
  } else if (key == Key::kBack) {
    opened_.clear();
  } else if (in_fields()) {
    scroll_ = std::clamp(first_line(channels, lines, rows) + step, 0, std::max(0, lines - rows));
  } else if (const int now = selected(channels); now >= 0) {
    selected_ = channels[static_cast<std::size_t>(std::clamp(now + step, 0, static_cast<int>(channels.size()) - 1))];
    if (key == Key::kOpen) {
      opened_ = selected_;
      scroll_ = 0;
    }
  }
}

}  // namespace markservo::bus_top
