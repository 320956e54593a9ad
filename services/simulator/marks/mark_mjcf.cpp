#include "services/simulator/marks/mark_mjcf.hpp"

#include "services/simulator/contacts/contact_classes.hpp"
#include "services/simulator/model/mjcf_writer.hpp"

namespace markservo::simulator {
namespace {

constexpr double kPi = 3.141592653589793;

// The print's box is drawn with its local z towards the cameras: MuJoCo draws 2D textures true on that side only.
const Eigen::Matrix3d kPrintTurn = Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitX()).toRotationMatrix();

}  // namespace

std::string print_name(const std::string& mark) {
  return "print:" + mark;
}

std::string print_geom(const robot::MarkDescription& mark, const Eigen::Isometry3d& X) {
  Eigen::Isometry3d turned = X * Eigen::Translation3d(0.0, 0.5 * kPrintThickness, 0.0);
  turned.rotate(kPrintTurn);
  return "<geom " + named(print_name(mark.name)) + " " + placed(turned) + " " +
         box({mark.size, mark.size, kPrintThickness}) + " material=\"" + print_name(mark.name) + "\" " + kNoContact +
         "/>\n";
}

}  // namespace markservo::simulator
