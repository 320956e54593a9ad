// rfid-localizer: where the robot is, by the tags in the floor and the wheels' encoders.

#include "common/bus/service.hpp"
#include "services/rfid-localizer/rfid_localizer_node.hpp"

int main(int argc, char** argv) {
  markservo::rfid_localizer::RfidLocalizerNode node;
  return markservo::bus::run_service({"rfid-localizer", "RFID_TAG_HITS and WHEEL_ODOMETRY in, ROBOT_POSE out"}, node,
                                     argc, argv);
}
