#pragma once

// LEARN_REQUEST and LEARN_RESULT, from and to what learning works with.

#include <markservo/LearnRequest.hpp>
#include <markservo/LearnResult.hpp>
#include <string>

#include "services/mark-detector/learning/mark_learning.hpp"

namespace markservo::mark_detector {

// What is wrong with the request's frame, piece or box, for a person; empty if the mark can be learned from it.
std::string objection_to(const LearnRequest& request);

// An answer that has learned nothing yet.
LearnResult answer_to(const LearnRequest& request);

// Takes over what was learned from the one picture, or why nothing was.
void fill(LearnResult& result, const MarkLearning& learned, const LearningPicture& picture);

}  // namespace markservo::mark_detector
