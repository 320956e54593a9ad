// A type's fingerprint covers its fields' names, types and order. A change here orphans every log written before it:
// make it on purpose, and change the number with it.

#include <cstdint>
#include <map>
#include <string>

#include "tests/unit/lcmtypes/all_types.hpp"

namespace markservo {
namespace {

// One a line: for one entry more clang-format may set the whole table anew, several a line.
// clang-format off
const std::map<std::string, std::uint64_t> kFingerprints = {
    {"BaseCommand", 0xa30a4f2ffcca8b88},
    {"BaseGoal", 0x6f0897d19d9cc04e},
    {"BaseStatus", 0xefdc95906ae76836},
    {"ChannelStatus", 0x36a6bbfbc332a94e},
    {"Covariance3", 0xcc5f85f810cc4dbf},
    {"DetectedMark", 0x4774cfb188113052},
    {"JointCommand", 0x6d68f59efaf61455},
    {"JointState", 0xf3038144e52da378},
    {"LearnRequest", 0xcc9c85b56564d7c2},
    {"LearnResult", 0x4a7efc15bf473436},
    {"LearnWarning", 0xaa78cbca034a15e2},
    {"LocatedMark", 0x7781b3b8b35243a0},
    {"MarkDetection", 0xc5d4e8a564e68e26},
    {"MarkMatches", 0xbc1958170aed005c},
    {"MarkPatch", 0x6c1fec5028a1c864},
    {"MarkView", 0x46980fcad4cd2fd7},
    {"PaperLocalisation", 0xd965642cadc536c1},
    {"Pose2", 0x479f41e1ade43dc7},
    {"PoseCovariance2", 0xcc5f85f8a0d47dcb},
    {"ProcessStatus", 0x9c5d22b98fd61496},
    {"RecorderStatus", 0x60b09a864d5609a7},
    {"RfidTagHit", 0x15bd3582427c100b},
    {"RfidTagHits", 0x94adaf012d241710},
    {"RobotPose", 0x10ab0d9900d03876},
    {"ServiceStatus", 0xd0bd649f66aa77bc},
    {"ServoGoal", 0x0d7bf352beca6584},
    {"ServoStatus", 0x9a6b43718a5b82df},
    {"SimBaseTruth", 0x27417bf8431e8e20},
    {"SimBody", 0x6a37dc4ea8b4b70b},
    {"SimControl", 0x56f9bcb0e71f1aa2},
    {"SimMark", 0x4ba91cc7bca1aa43},
    {"SimParameter", 0xea7bbdc5e39b2f1e},
    {"SimTruth", 0x7405876fcc7267b3},
    {"SonarEcho", 0xb0cfd30ea180c61c},
    {"SonarScan", 0x750a31a1a5c5d7cb},
    {"StereoCalibration", 0x3dc8e13ef086180b},
    {"StereoFrame", 0x36e15a60ab50c56c},
    {"StereoMatches", 0x3cad37b01e4827b6},
    {"StopRequest", 0xb1ee88ba800ce4e9},
    {"StopState", 0xa8127e023e9b84c4},
    {"TargetPose", 0xb37deef36f12ae3f},
    {"TaskCommand", 0x5a8c82868f3a4421},
    {"TaskState", 0x6f22750652149849},
    {"Vector3", 0xae7e5fba5eeca11e},
    {"WheelOdometry", 0xc57eea1e3b62f8b3},
};
// clang-format on

template <class M>
class Fingerprint : public ::testing::Test {};
TYPED_TEST_SUITE(Fingerprint, AllTypes);

TYPED_TEST(Fingerprint, IsTheOneThatLogsWereWrittenWith) {
  const auto known = kFingerprints.find(TypeParam::getTypeName());
  ASSERT_NE(known, kFingerprints.end()) << "add {\"" << TypeParam::getTypeName() << "\", 0x" << std::hex
                                        << static_cast<std::uint64_t>(TypeParam::getHash()) << "} to kFingerprints";
  EXPECT_EQ(static_cast<std::uint64_t>(TypeParam::getHash()), known->second)
      << TypeParam::getTypeName() << ": 0x" << std::hex << static_cast<std::uint64_t>(TypeParam::getHash());
}

}  // namespace
}  // namespace markservo
