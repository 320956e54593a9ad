#include "services/task-manager/task_log.hpp"

#include "common/time/seconds_between.hpp"

namespace markservo::task_manager {

std::optional<double> TaskLog::news(const Output& output, std::int64_t utime) {
  const bool changed = !told_ || told_->phase != output.phase || told_->reason != output.reason ||
                       told_->command_id != output.command_id || told_->command_session != output.command_session;
  if (!changed) return std::nullopt;
  const bool begins = under_way(output.phase) && (!told_ || !under_way(told_->phase));
  if (begins) task_began_ = utime;
  told_ = output;
  return task_began_ == 0 ? 0.0 : seconds_between(task_began_, utime);
}

}  // namespace markservo::task_manager
