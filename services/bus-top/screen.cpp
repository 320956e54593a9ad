#include "services/bus-top/screen.hpp"

#include <ncurses.h>

#include <algorithm>
#include <cstdlib>

#include "common/robot/configuration_error.hpp"

namespace markservo::bus_top {
namespace {

constexpr int kEscape = 27;
constexpr int kDelete = 127;
constexpr int kControlL = 12;

void put(int row, const std::string& text, attr_t attributes) {
  const auto width = static_cast<std::size_t>(std::max(0, COLS));
  std::string line = text.substr(0, width);
  line.resize(width, ' ');  // a selected line is marked to its end
  attrset(static_cast<int>(attributes));
  mvaddnstr(row, 0, line.c_str(), static_cast<int>(width));
}

attr_t attributes_of(const ScreenLine& line) {
  attr_t attributes = A_NORMAL;
  if (line.grey) attributes |= A_DIM;
  if (line.strong) attributes |= A_BOLD;
  if (line.selected) attributes |= A_REVERSE;
  return attributes;
}

}  // namespace

Screen::Screen() {
  terminal_ = newterm(nullptr, stdout, stdin);
  if (terminal_ == nullptr) {
    const char* term = std::getenv("TERM");
    throw ConfigurationError(std::string("this terminal cannot be drawn on: TERM is '") +
                             (term == nullptr ? "" : term) +
                             "'; allowed: one that terminfo knows, or --once for plain text");
  }
  cbreak();
  noecho();
  nonl();
  intrflush(stdscr, FALSE);
  keypad(stdscr, TRUE);
  nodelay(stdscr, TRUE);
  set_escdelay(25);  // ms; Escape alone goes back
  curs_set(0);
}

Screen::~Screen() {
  endwin();
  delscreen(static_cast<SCREEN*>(terminal_));
}

int Screen::rows() const {
  return std::max(1, LINES - 2);
}

void Screen::draw(const std::string& head, const std::vector<ScreenLine>& body, const std::string& foot) {
  erase();
  put(0, head, A_BOLD);
  const int shown = std::min(static_cast<int>(body.size()), rows());
  for (int i = 0; i < shown; ++i) {
    const ScreenLine& line = body[static_cast<std::size_t>(i)];
    put(i + 1, line.text, attributes_of(line));
  }
  put(LINES - 1, foot, A_DIM);
  refresh();
}

std::optional<Key> Screen::read_key() {
  const int code = getch();
  more_keys_ = code != ERR;
  switch (code) {
    case KEY_UP:
      return Key::kUp;
    case KEY_DOWN:
      return Key::kDown;
    case KEY_PPAGE:
      return Key::kPageUp;
    case KEY_NPAGE:
      return Key::kPageDown;
    case KEY_HOME:
      return Key::kHome;
    case KEY_END:
      return Key::kEnd;
    case KEY_ENTER:
    case KEY_RIGHT:
    case '\r':
    case '\n':
      return Key::kOpen;
    case KEY_BACKSPACE:
    case KEY_LEFT:
    case kDelete:
    case kEscape:
      return Key::kBack;
    case 'q':
      return Key::kQuit;
    case kControlL:
      clearok(stdscr, TRUE);
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

}  // namespace markservo::bus_top
