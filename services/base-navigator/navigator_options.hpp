#pragma once

namespace CLI {
class App;
}

namespace markservo::base_navigator {

struct NavigatorParameters;

// The settings a person may want to change, with what is allowed.
void add_navigator_options(CLI::App& app, NavigatorParameters& parameters);

// Throws ConfigurationError where values contradict each other.
void require_consistent(const NavigatorParameters& parameters);

}  // namespace markservo::base_navigator
