#include "services/stack-watch/supervisor/supervisor_words.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo::stack_watch {
namespace {

std::string member(const std::string& name, const std::string& value) {
  return "<member>\n<name>" + name + "</name>\n<value>" + value + "</value>\n</member>\n";
}

// As supervisord 4.2.5 answers.
std::string answer_of(const std::string& structs) {
  return "HTTP/1.0 200 OK\r\nContent-Type: text/xml\r\n\r\n<?xml version='1.0'?>\n<methodResponse>\n<params>\n<param>\n"
         "<value><array><data>\n" +
         structs + "</data></array></value>\n</param>\n</params>\n</methodResponse>\n";
}

std::string process(const std::string& name, const std::string& state, int pid) {
  return "<value><struct>\n" + member("name", "<string>" + name + "</string>") + member("group", "<string>x</string>") +
         member("statename", "<string>" + state + "</string>") + member("spawnerr", "<string></string>") +
         member("pid", "<int>" + std::to_string(pid) + "</int>") + "</struct></value>\n";
}

TEST(SupervisorWords, AreReadFromItsAnswer) {
  const auto processes =
      processes_in(answer_of(process("simulator", "RUNNING", 12) + process("visual-servo", "FATAL", 0)));
  ASSERT_EQ(processes.size(), 2U);
  EXPECT_EQ(processes[0].name, "simulator");
  EXPECT_EQ(processes[0].state, "RUNNING");
  EXPECT_EQ(processes[0].pid, 12);
  EXPECT_EQ(processes[1].name, "visual-servo");
  EXPECT_EQ(processes[1].state, "FATAL");
  EXPECT_EQ(processes[1].pid, 0);
}

TEST(SupervisorWords, TellSinceWhenAProcessRunsAndHowTheLastOneEnded) {
  const auto processes = processes_in(answer_of(
      "<value><struct>\n" + member("name", "<string>arm</string>") + member("start", "<int>1700000000</int>") +
      member("statename", "<string>FATAL</string>") + member("exitstatus", "<int>-1</int>") +
      member("spawnerr", "<string>no &lt;such&gt; &amp;lt; command</string>") + "</struct></value>\n"));
  ASSERT_EQ(processes.size(), 1U);
  EXPECT_EQ(processes[0].start_utime, 1'700'000'000'000'000);
  EXPECT_EQ(processes[0].exit_code, -1);
  EXPECT_EQ(processes[0].spawn_error, "no <such> &lt; command");
}

TEST(SupervisorWords, OfNoProcessAreNone) {
  EXPECT_TRUE(processes_in(answer_of("")).empty());
}

TEST(SupervisorWords, ThatEndTooSoonAreRefused) {
  const std::string whole = answer_of(process("simulator", "RUNNING", 12));
  for (const std::size_t size : {std::size_t{0}, whole.find("<pid"), whole.find("RUNNING"), whole.find("</struct>")}) {
    EXPECT_THROW(processes_in(whole.substr(0, std::min(size, whole.size() / 2))), std::invalid_argument) << size;
  }
}

TEST(SupervisorWords, OfAFaultAreRefused) {
  EXPECT_THROW(processes_in("<methodResponse><fault><value></value></fault></methodResponse>"), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::stack_watch
