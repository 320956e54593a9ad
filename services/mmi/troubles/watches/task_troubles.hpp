#pragma once

#include <optional>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

// target_refused: the newest task was refused. Ends with the next command that is executed.
class TaskTroubles {
 public:
  void observe(const TaskWord& word, double now) {
    const bool same = task_ && task_->phase == word.phase && task_->target == word.target;
    if (!same) since_ = {now, word.at};
    task_ = word;
  }

  void find(const Remedies& remedies, Findings& found) const {
    if (!task_ || task_->phase != TaskPhase::kRefused) return;
    const std::string subject = task_->target.empty() ? "task" : task_->target;
    found.push_back(
        {{TroubleCode::kTargetRefused, subject, since_.utime,
          subject + " was refused, and nothing has moved: " + task_->reason, remedies.target_refused(task_->target)},
         since_.now});
  }

 private:
  std::optional<TaskWord> task_;
  Since since_;  // in its phase
};

}  // namespace markservo::mmi
