#pragma once

// Where a person is in the view: the table with one channel selected, or one channel's fields.

#include <string>
#include <vector>

namespace markservo::bus_top {

enum class Key { kUp, kDown, kPageUp, kPageDown, kHome, kEnd, kOpen, kBack, kQuit };

class Navigation {
 public:
  // Begins with the fields of `opened`, or with the table when that is empty.
  explicit Navigation(std::string opened = {}) : selected_(opened), opened_(std::move(opened)) {}

  // `channels` are those of the table, in its order; the page has `lines` lines, of which the terminal shows `rows`.
  void press(Key key, const std::vector<std::string>& channels, int lines, int rows);

  bool quit() const { return quit_; }
  bool in_fields() const { return !opened_.empty(); }
  const std::string& opened() const { return opened_; }

  // The selected channel's place; it stays with its channel when others appear. -1 without channels.
  int selected(const std::vector<std::string>& channels) const;
  // The first of `lines` lines to show of which `rows` fit: in the table, so that the selected one is seen.
  int first_line(const std::vector<std::string>& channels, int lines, int rows) const;

 private:
  std::string selected_;  // empty: the first
  std::string opened_;
  int scroll_ = 0;  // in the fields, lines
  bool quit_ = false;
};

}  // namespace markservo::bus_top
