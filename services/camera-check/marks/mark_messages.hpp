#pragma once

#include <markservo/MarkDetection.hpp>
#include <markservo/TargetPose.hpp>

#include "services/camera-check/marks/mark_sightings.hpp"

namespace markservo::camera_check {

void add_to(MarkSightings& sightings, const MarkDetection& detection);
void add_to(MarkSightings& sightings, const TargetPose& pose);

}  // namespace markservo::camera_check
