#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

// Whether it is still the arm that was told what it does.
class ArmSession {
 public:
  // True at the first report after the arm restarted: what it was told in its former life is not its state any more.
  bool restarts(const std::optional<ArmReport>& arm) {
    if (!arm) return false;
    const std::int64_t before = std::exchange(session_, arm->session);
    return before != 0 && before != session_;
  }

 private:
  std::int64_t session_ = 0;
};

}  // namespace markservo::task_manager
