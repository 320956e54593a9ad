#pragma once

#include <CLI/CLI.hpp>

namespace markservo::bus {

// Adds options that are numbers in a range, their values as they stand the defaults:
//
//   const NumberOptions number(app);
//   number("--speed", parameters.speed, "m/s", 0.05, 10.0);
class NumberOptions {
 public:
  // `app` must outlive this.
  explicit NumberOptions(CLI::App& app) : app_(&app) {}

  void operator()(const char* name, double& value, const char* what, double min, double max) const {
    app_->add_option(name, value, what)->check(CLI::Range(min, max))->capture_default_str();
  }

 private:
  CLI::App* app_;
};

}  // namespace markservo::bus
