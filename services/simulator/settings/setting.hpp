#pragma once

// How a part of the simulator declares its settings: a struct of numbers with their defaults and, beside it, a line for
// each number with its name, range and meaning. settings.hpp puts all parts together.

#include <string>

namespace markservo::simulator {

// When a changed setting shows.
enum class TakesEffect { kAtOnce, kAtReset };

// One number of the struct `Part`.
template <class Part>
struct Setting {
  const char* name;  // "part.name", as --set and SIM_CONTROL have it
  double Part::*value;
  double min;
  double max;
  TakesEffect takes_effect;
  const char* what;    // meaning with unit
  bool whole = false;  // only whole numbers
};

// `value` as people read and write it.
std::string setting_text(double value);

// Throws ConfigurationError: which setting has which value, and what is allowed.
[[noreturn]] void refuse_setting(const std::string& name, const std::string& value, const std::string& allowed);

}  // namespace markservo::simulator
