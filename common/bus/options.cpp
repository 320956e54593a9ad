#include "common/bus/options.hpp"

#include "common/bus/option_checks.hpp"

namespace markservo::bus {

Option Option::show_default() const {
  return Option(option_->capture_default_str());
}

Option Option::within(double min, double max) const {
  return Option(option_->check(Within(min, max)));
}

Option Option::in_range(int min, int max) const {
  return Option(option_->check(CLI::Range(min, max)));
}

Option Option::not_negative() const {
  return Option(option_->check(CLI::NonNegativeNumber));
}

Option Option::one_of(const std::vector<std::string>& allowed) const {
  return Option(option_->check(CLI::IsMember(allowed)));
}

Option Option::check(const std::function<std::string(const std::string& value)>& objection,
                     const std::string& allowed) const {
  return Option(option_->check(CLI::Validator(objection, allowed)));
}

Option Option::required() const {
  return Option(option_->required());
}

Option Option::needs(const Option& other) const {
  return Option(option_->needs(other.option_));
}

Option Option::excludes(const Option& other) const {
  return Option(option_->excludes(other.option_));
}

Option Option::delimiter(char delimiter) const {
  return Option(option_->delimiter(delimiter));
}

Option Option::expected(int count) const {
  return Option(option_->expected(count));
}

Option Option::one_at_a_time() const {
  return Option(option_->allow_extra_args(false));
}

Option Option::take_all() const {
  return Option(option_->take_all());
}

Option Option::environment(const std::string& variable) const {
  return Option(option_->envname(variable));
}

Option Option::not_in_config() const {
  return Option(option_->configurable(false));
}

Option Option::group(const std::string& heading) const {
  return Option(option_->group(heading));
}

Option Options::option(const std::string& name, std::string& value, const std::string& what) const {
  return Option(app_->add_option(name, value, what));
}

Option Options::option(const std::string& name, double& value, const std::string& what) const {
  return Option(app_->add_option(name, value, what));
}

Option Options::option(const std::string& name, int& value, const std::string& what) const {
  return Option(app_->add_option(name, value, what));
}

Option Options::option(const std::string& name, std::int64_t& value, const std::string& what) const {
  return Option(app_->add_option(name, value, what));
}

Option Options::option(const std::string& name, std::size_t& value, const std::string& what) const {
  return Option(app_->add_option(name, value, what));
}

Option Options::option(const std::string& name, bool& value, const std::string& what) const {
  return Option(app_->add_option(name, value, what));
}

Option Options::option(const std::string& name, std::optional<double>& value, const std::string& what) const {
  return Option(app_->add_option(name, value, what));
}

Option Options::option(const std::string& name, std::optional<std::string>& value, const std::string& what) const {
  return Option(app_->add_option(name, value, what));
}

Option Options::option(const std::string& name, std::vector<std::string>& values, const std::string& what) const {
  return Option(app_->add_option(name, values, what));
}

Option Options::option(const std::string& name, std::vector<double>& values, const std::string& what) const {
  return Option(app_->add_option(name, values, what));
}

Option Options::option(const std::string& name, std::vector<int>& values, const std::string& what) const {
  return Option(app_->add_option(name, values, what));
}

Option Options::option(const std::string& name, std::vector<std::int64_t>& values, const std::string& what) const {
  return Option(app_->add_option(name, values, what));
}

Option Options::flag(const std::string& name, bool& value, const std::string& what) const {
  return Option(app_->add_flag(name, value, what));
}

void Options::footer(const std::string& text) const {
  app_->footer(text);
}

}  // namespace markservo::bus
