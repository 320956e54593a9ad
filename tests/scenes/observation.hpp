#pragma once

// What lies between images, the detector and the locator without the bus between them.

#include <opencv2/core.hpp>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/mark_detector.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::scenes {

mark_detector::ImageView view_of(const cv::Mat& image);

// A finding as the messages between the services carry it. Points into `found`, which must outlive it.
target_locator::MarkObservation observation_of(const mark_detector::Finding& found, const robot::MarkDescription& mark);

}  // namespace markservo::scenes
