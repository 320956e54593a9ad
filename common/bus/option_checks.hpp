#pragma once

// What CLI11 should also ask of an option's value. With all of CLI11: options.hpp is for who only adds options.

#include <CLI/CLI.hpp>
#include <cmath>
#include <sstream>
#include <string>

#include "common/text/text.hpp"

namespace markservo::bus {

// That a number is one, and from `min` to `max`. (CLI::Range takes "nan", which is neither below nor above.)
class Within : public CLI::Validator {
 public:
  Within(double min, double max) {
    const std::string range = text(min) + " to " + text(max);
    description("FLOAT in [" + text(min) + " - " + text(max) + "]");
    func_ = [min, max, range](std::string& input) {
      double value = 0.0;
      const bool number = CLI::detail::lexical_cast(input, value) && std::isfinite(value);
      return number && value >= min && value <= max ? std::string() : "'" + input + "'; allowed: " + range;
    };
  }

 private:
  static std::string text(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
  }
};

// That a whole number is written as people do: CLI11 reads 0640 as 416.
class Decimal : public CLI::Validator {
 public:
  Decimal() {
    func_ = [](std::string& input) {
      const bool good = text::is_decimal(input);
      return good ? std::string() : "'" + input + "'; allowed: a whole number, without zeros before it";
    };
  }
};

// Asks that of all options of `app` that are whole numbers, given on the command line or in a file; to be called when
// they are all there.
inline void require_decimal_numbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    if (type.rfind("INT", 0) == 0 || type.rfind("UINT", 0) == 0) option->check(Decimal());
  }
}

}  // namespace markservo::bus
