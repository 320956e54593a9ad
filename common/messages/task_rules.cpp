// The rules of what operators, task-manager and all that can be stopped say to each other.

#include <cstdint>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>

#include "common/messages/vector_rule.hpp"

namespace markservo::messages {
namespace {

template <class Request, class Visit>
void each_text_of_request(Request& request, Visit& visit) {
  visit("source", request.source);
  visit("reason", request.reason);
}

template <class State, class Visit>
void each_text_of_stop(State& state, Visit& visit) {
  visit("device", state.device);
  visit("reason", state.reason);
}

template <class State, class Visit>
void each_text_of_task(State& state, Visit& visit) {
  visit("target", state.target);
  visit("reason", state.reason);
}

// Who asks, so that the answer can name him: 0 stands for nobody there.
std::string asker_violation(std::int64_t session, const char* id_field, std::int64_t id) {
  if (session < 1) return wrong("session", session, "1 or more");
  return count_violation(id_field, id);
}

// A time that is none is unknown.
void mend_time(std::int64_t& utime) {
  if (utime < 0 || utime > kMaxCount) utime = 0;
}

}  // namespace

std::string MessageRules<TaskCommand>::violation(const TaskCommand& command) {
  if (auto why = text::violation("target", command.target); !why.empty()) return why;
  if (auto why = asker_violation(command.session, "command_id", command.command_id); !why.empty()) return why;
  if (auto why = enum_violation("kind", command.kind, TaskCommand::DRIVE); !why.empty()) return why;
  if (auto why = near_violation("p_CT_expected", command.p_CT_expected); !why.empty()) return why;
  return pose_violation("drive_pose", command.drive_pose);
}

void MessageRules<TaskCommand>::clean_texts(TaskCommand& command) {
  text::clean(command.target);
}

bool MessageRules<TaskCommand>::must_be_obeyed(const TaskCommand& command) {
  return command.kind == TaskCommand::ABORT;
}

void MessageRules<TaskCommand>::mend(TaskCommand& command) {
  mend_time(command.utime);
  clean_texts(command);
  command.expected_known = 0;
  command.p_CT_expected = {};
  command.drive = 0;
  command.drive_pose = {};
}

std::string MessageRules<TaskState>::violation(const TaskState& state) {
  TextCheck texts;
  each_text_of_task(state, texts);
  if (!texts.why().empty()) return texts.why();
  if (auto why = enum_violation("state", state.state, TaskState::DRIVE); !why.empty()) return why;
  if (auto why = enum_violation("result", state.result, TaskState::RESULT_FAILED); !why.empty()) return why;
  return count_violation("attempt", state.attempt);
}

void MessageRules<TaskState>::clean_texts(TaskState& state) {
  TextCleaner cleaner;
  each_text_of_task(state, cleaner);
}

std::string MessageRules<StopRequest>::violation(const StopRequest& request) {
  TextCheck texts;
  each_text_of_request(request, texts);
  if (!texts.why().empty()) return texts.why();
  if (auto why = asker_violation(request.session, "request_id", request.request_id); !why.empty()) return why;
  return enum_violation("kind", request.kind, StopRequest::RESET);
}

void MessageRules<StopRequest>::clean_texts(StopRequest& request) {
  TextCleaner cleaner;
  each_text_of_request(request, cleaner);
}

bool MessageRules<StopRequest>::must_be_obeyed(const StopRequest& request) {
  return request.kind == StopRequest::STOP;
}

void MessageRules<StopRequest>::mend(StopRequest& request) {
  mend_time(request.utime);
  clean_texts(request);
}

std::string MessageRules<StopState>::violation(const StopState& state) {
  TextCheck texts;
  each_text_of_stop(state, texts);
  return texts.why();
}

void MessageRules<StopState>::clean_texts(StopState& state) {
  TextCleaner cleaner;
  each_text_of_stop(state, cleaner);
}

}  // namespace markservo::messages
