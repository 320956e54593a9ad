#pragma once

#include "common/bus/options.hpp"

namespace markservo::bus {

// Adds options that are numbers in a range, their values as they stand the defaults:
//
//   const NumberOptions number(app);
//   number("--speed", parameters.speed, "m/s", 0.05, 10.0);
class NumberOptions {
 public:
  // `app` must outlive this.
  explicit NumberOptions(CLI::App& app) : add_(app) {}

  void operator()(const char* name, double& value, const char* what, double min, double max) const {
    add_.option(name, value, what).within(min, max).show_default();
  }

 private:
  Options add_;
};

}  // namespace markservo::bus
