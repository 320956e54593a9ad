// Every text of every message is checked on receipt and made fit where it is composed.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <markservo/BaseStatus.hpp>
#include <markservo/LearnRequest.hpp>
#include <markservo/LearnResult.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RecorderStatus.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <string>

#include "common/text/text.hpp"
#include "tests/unit/messages/violation.hpp"

namespace markservo::messages {
namespace {

int texts_tried = 0;

// `text_of` gives one text of a message that keeps its rules.
template <class M>
void expect_checked(const std::string& field, const M& valid, const std::function<std::string&(M&)>& text_of) {
  ++texts_tried;
  for (const std::string& harmful : {std::string("\x1b[2J"), std::string("a\nb"), std::string(201, 'x')}) {
    M message = valid;
    text_of(message) = harmful;
    const std::string why = violation(message);
    const bool of_its_text = why.find("at most 200") != std::string::npos || why.find("UTF-8") != std::string::npos;
    EXPECT_TRUE(of_its_text) << M::getTypeName() << "." << field << ": '" << why << "'";
    EXPECT_EQ(text::violation("refusal", why.substr(0, 200)), "") << "the refusal itself is harmless";
    clean_texts(message);
    EXPECT_EQ(text::violation(field, text_of(message)), "") << M::getTypeName() << "." << field;
  }
}

template <class M>
M with_one(std::vector<typename std::decay_t<decltype(M::marks)>::value_type> marks = {{}}) {
  M message{};
  message.marks = std::move(marks);
  return message;
}

// The texts that the .lcm files declare.
int declared_texts() {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(MARKSERVO_SOURCE_DIR "/lcmtypes")) {
    if (file.path().extension() != ".lcm") continue;
    std::ifstream lines(file.path());
    for (std::string line; std::getline(lines, line);) {
      const std::size_t word = line.find_first_not_of(' ');
      if (word != std::string::npos && line.compare(word, 7, "string ") == 0) ++count;
    }
  }
  return count;
}

TEST(TextRules, HoldForEveryTextThatATypeDeclares) {
  texts_tried = 0;
  expect_checked<BaseStatus>(
      "reason", {}, [](auto& m) -> auto& { return m.reason; });
  LearnRequest learn{};
  learn.session = learn.request_id = 1;
  expect_checked<LearnRequest>(
      "mark", learn, [](auto& m) -> auto& { return m.mark; });
  LearnResult learned{};
  learned.warnings.resize(1);
  expect_checked<LearnResult>(
      "mark", learned, [](auto& m) -> auto& { return m.mark; });
  expect_checked<LearnResult>(
      "reason", learned, [](auto& m) -> auto& { return m.reason; });
  expect_checked<LearnResult>(
      "warnings.overlaps", learned, [](auto& m) -> auto& { return m.warnings[0].overlaps; });
  expect_checked<LearnResult>(
      "warnings.text", learned, [](auto& m) -> auto& { return m.warnings[0].text; });
  MarkDetection detection = with_one<MarkDetection>();
  expect_checked<MarkDetection>(
      "marks.name", detection, [](auto& m) -> auto& { return m.marks[0].name; });
  expect_checked<MarkDetection>(
      "marks.reason", detection, [](auto& m) -> auto& { return m.marks[0].reason; });
  expect_checked<TargetPose>(
      "marks.name", with_one<TargetPose>(), [](auto& m) -> auto& { return m.marks[0].name; });
  expect_checked<StereoMatches>(
      "marks.name", with_one<StereoMatches>(), [](auto& m) -> auto& { return m.marks[0].name; });
  RfidTagHits hits{};
  hits.hits.resize(1);
  expect_checked<RfidTagHits>(
      "hits.uid", hits, [](auto& m) -> auto& { return m.hits[0].uid; });
  expect_checked<ProcessStatus>(
      "name", {}, [](auto& m) -> auto& { return m.name; });
  expect_checked<ProcessStatus>(
      "host", {}, [](auto& m) -> auto& { return m.host; });
  expect_checked<ProcessStatus>(
      "why", {}, [](auto& m) -> auto& { return m.why; });
  expect_checked<RecorderStatus>(
      "folder", {}, [](auto& m) -> auto& { return m.folder; });
  expect_checked<RecorderStatus>(
      "host", {}, [](auto& m) -> auto& { return m.host; });
  expect_checked<RecorderStatus>(
      "why", {}, [](auto& m) -> auto& { return m.why; });
  expect_checked<RobotPose>(
      "reason", {}, [](auto& m) -> auto& { return m.reason; });
  ServiceStatus status{};
  status.channels.resize(1);
  expect_checked<ServiceStatus>(
      "name", status, [](auto& m) -> auto& { return m.name; });
  expect_checked<ServiceStatus>(
      "host", status, [](auto& m) -> auto& { return m.host; });
  expect_checked<ServiceStatus>(
      "version", status, [](auto& m) -> auto& { return m.version; });
  expect_checked<ServiceStatus>(
      "state", status, [](auto& m) -> auto& { return m.state; });
  expect_checked<ServiceStatus>(
      "reason", status, [](auto& m) -> auto& { return m.reason; });
  expect_checked<ServiceStatus>(
      "channels.channel", status, [](auto& m) -> auto& { return m.channels[0].channel; });
  expect_checked<ServoGoal>(
      "target", {}, [](auto& m) -> auto& { return m.target; });
  expect_checked<ServoStatus>(
      "reason", {}, [](auto& m) -> auto& { return m.reason; });
  SimControl control{};
  control.parameters.resize(1);
  expect_checked<SimControl>(
      "parameters.name", control, [](auto& m) -> auto& { return m.parameters[0].name; });
  SimTruth truth = with_one<SimTruth>();
  truth.bodies.resize(1);
  expect_checked<SimTruth>(
      "control_error", truth, [](auto& m) -> auto& { return m.control_error; });
  expect_checked<SimTruth>(
      "touched", truth, [](auto& m) -> auto& { return m.touched; });
  expect_checked<SimTruth>(
      "bodies.name", truth, [](auto& m) -> auto& { return m.bodies[0].name; });
  expect_checked<SimTruth>(
      "marks.name", truth, [](auto& m) -> auto& { return m.marks[0].name; });
  StopRequest reset{};
  reset.session = 1;
  reset.kind = StopRequest::RESET;
  expect_checked<StopRequest>(
      "source", reset, [](auto& m) -> auto& { return m.source; });
  expect_checked<StopRequest>(
      "reason", reset, [](auto& m) -> auto& { return m.reason; });
  expect_checked<StopState>(
      "device", {}, [](auto& m) -> auto& { return m.device; });
  expect_checked<StopState>(
      "reason", {}, [](auto& m) -> auto& { return m.reason; });
  TaskCommand start{};
  start.session = 1;
  expect_checked<TaskCommand>(
      "target", start, [](auto& m) -> auto& { return m.target; });
  expect_checked<TaskState>(
      "target", {}, [](auto& m) -> auto& { return m.target; });
  expect_checked<TaskState>(
      "reason", {}, [](auto& m) -> auto& { return m.reason; });
  EXPECT_EQ(texts_tried, declared_texts()) << "a text was added: its type's rules must check it, and this test too";
}

}  // namespace
}  // namespace markservo::messages
