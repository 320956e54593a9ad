#pragma once

#include "services/task-manager/parameters.hpp"

namespace CLI {
class App;
}

namespace markservo::task_manager {

// The settings a person may want to change, with what is allowed.
void add_parameter_options(CLI::App& app, Parameters& parameters);

}  // namespace markservo::task_manager
