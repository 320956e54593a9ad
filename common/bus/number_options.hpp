#pragma once

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

// Adds options that are numbers in a range, their values as they stand the defaults:
//
//   const NumberOptions number(app);
//   number("--speed", parameters.speed, "m/s", 0.05, 10.0);
class NumberOptions {
 public:
  // `app` must outlive this.
  explicit NumberOptions(CLI::App& app) : app_(&app) {}

  void operator()(const char* name, double& value, const char* what, double min, double max) const {
    app_->add_option(name, value, what)->check(Within(min, max))->capture_default_str();
  }

 private:
  CLI::App* app_;
};

}  // namespace markservo::bus
