#pragma once

// Options of a program, without CLI11's header: a file that includes it takes the compiler 6 s longer.
//
//   const Options add(app);
//   add.option("--method", method_, "Whose pose it is").one_of({"filter", "paper"}).show_default();
//   add.option("--rate", rate_, "Hz").within(0.1, 1000.0).show_default();
//   add.flag("--once", once_, "End after one");
//
// What only CLI11 can is asked of the CLI::App itself, in a file that includes <CLI/CLI.hpp>.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace markservo::bus {

// An option that was added. Each function asks something more of it, as CLI11's does, and returns it again.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  // Its value as it stands is its default, which --help and --print-config show.
  Option show_default() const;
  // A finite number from `min` to `max`.
  Option within(double min, double max) const;
  // A whole number from `min` to `max`.
  Option in_range(int min, int max) const;
  Option not_negative() const;
  Option one_of(const std::vector<std::string>& allowed) const;

  // `objection` says why a value is refused, or nothing; `allowed` is for --help.
  Option check(const std::function<std::string(const std::string& value)>& objection, const std::string& allowed) const;

  Option required() const;
  Option needs(const Option& other) const;
  Option excludes(const Option& other) const;
  // Of a list: separated by `delimiter`; so many; one only, each time that it is given; all, however often it is given.
  Option delimiter(char delimiter) const;
  Option expected(int count) const;
  Option one_at_a_time() const;
  Option take_all() const;

  // The environment variable that stands in for it.
  Option environment(const std::string& variable) const;
  // Neither read from --config nor shown by --print-config.
  Option not_in_config() const;
  // The heading in --help that it stands under.
  Option group(const std::string& heading) const;

 private:
  CLI::Option* option_;
};

// Adds options to `app`, which must outlive this. A name without dashes is a positional argument's; `what` is for
// --help. A value that is a std::optional is left empty by an option that is not given.
class Options {
 public:
  explicit Options(CLI::App& app) : app_(&app) {}

  Option option(const std::string& name, std::string& value, const std::string& what = {}) const;
  Option option(const std::string& name, double& value, const std::string& what = {}) const;
  Option option(const std::string& name, int& value, const std::string& what = {}) const;
  Option option(const std::string& name, std::int64_t& value, const std::string& what = {}) const;
  Option option(const std::string& name, std::size_t& value, const std::string& what = {}) const;
  Option option(const std::string& name, bool& value, const std::string& what = {}) const;
  Option option(const std::string& name, std::optional<double>& value, const std::string& what = {}) const;
  Option option(const std::string& name, std::optional<std::string>& value, const std::string& what = {}) const;
  Option option(const std::string& name, std::vector<std::string>& values, const std::string& what = {}) const;
  Option option(const std::string& name, std::vector<double>& values, const std::string& what = {}) const;
  Option option(const std::string& name, std::vector<int>& values, const std::string& what = {}) const;
  Option option(const std::string& name, std::vector<std::int64_t>& values, const std::string& what = {}) const;

  // True when it is given.
  Option flag(const std::string& name, bool& value, const std::string& what = {}) const;

  // Text at the end of --help.
  void footer(const std::string& text) const;

 private:
  CLI::App* app_;
};

}  // namespace markservo::bus
