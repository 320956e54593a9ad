#pragma once

#include <map>
#include <optional>
#include <string>

#include "services/mmi/troubles/finding.hpp"
#include "services/mmi/troubles/known.hpp"
#include "services/mmi/troubles/remedies.hpp"
#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

struct MarkTroubleParameters {
  double task = 2.0;   // s for which a TASK_STATE counts, of one a picture
  double marks = 1.0;  // s for which a TARGET_POSE counts, likewise: without pictures nothing is known of marks
};

// mark_unseen and hand_unseen: a mark is not located while the task needs it. The target's: where it looks, servoes,
// and measures both marks before and after the small lift. The hand's: from when it has been brought before the target
// on; at the look it rightly is out of view.
class MarkTroubles {
 public:
  explicit MarkTroubles(MarkTroubleParameters parameters = {}) : parameters_(parameters) {}

  void observe(const TaskWord& word, double now);
  void observe(const ServoWord& word, double now);
  void observe(const MarksWord& word, double now);

  void find(const Remedies& remedies, double now, Findings& found) const;

 private:
  struct Mark {
    bool is_hand = false;
    MarkStatus status = MarkStatus::kLocated;
    Since since;  // not located
    double heard = 0.0;
  };

  bool needs_target() const;
  bool needs_hand() const;
  std::optional<Finding> target_unseen(double now) const;
  std::optional<Finding> hand_unseen(double now) const;
  std::optional<Finding> servo_lost() const;

  MarkTroubleParameters parameters_;
  std::optional<TaskWord> task_;
  Since phase_;
  double task_heard_ = 0.0;
  std::optional<ServoWord> servo_;
  Since servo_lost_;
  Since settled_;
  std::map<std::string, Mark> marks_;
  std::optional<Since> marks_heard_;  // the newest TARGET_POSE
};

}  // namespace markservo::mmi
