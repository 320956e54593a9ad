#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/bus-top/navigation.hpp"

namespace markservo::bus_top {

struct ScreenLine {
  std::string text;
  bool grey = false;
  bool strong = false;
  bool selected = false;
};

// The terminal, drawn by ncurses. What it was before comes back when this ends, by an exception too.
class Screen {
 public:
  Screen();  // throws ConfigurationError where the terminal cannot be drawn on
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  // How many lines fit between head and foot.
  int rows() const;
  // `body` is cut to rows(), all lines to the terminal's width.
  void draw(const std::string& head, const std::vector<ScreenLine>& body, const std::string& foot);
  // A key that was pressed, without waiting; nothing when there is none, or none that means anything.
  std::optional<Key> read_key();
  // True once after the last key that was no Key: there may be more.
  bool more_keys() const { return more_keys_; }

 private:
  void* terminal_ = nullptr;  // ncurses' SCREEN
  bool more_keys_ = false;
};

}  // namespace markservo::bus_top
