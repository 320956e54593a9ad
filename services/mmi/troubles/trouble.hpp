#pragma once

#include <cstdint>
#include <string>
#include <utility>

namespace markservo::mmi {

// What can be wrong, the worst first: as kTroubleOrder has it.
enum class TroubleCode {
  kMmiLost,
  kStopDeviceSilent,
  kSecondWriter,
  kProcessDead,
  kProcessHung,
  kClockAhead,
  kMessagesLost,
  kCameraSilent,
  kStopLatched,
  kMarkUnseen,
  kHandUnseen,
  kPoseLost,
  kBaseBlocked,
  kRecordingEnded,
  kTargetRefused,
};

struct TroubleRank {
  TroubleCode code;
  const char* name;  // as /state.json has it
  const char* why;   // it stands before those below
};

// The order of all troubles, the worst first: what may hurt somebody, then what causes others of the list, then what
// keeps the robot from its work, then what harms nothing.
inline constexpr TroubleRank kTroubleOrder[] = {
    {TroubleCode::kMmiLost, "mmi_lost", "the page is cut off: all that it shows is old (the page finds it itself)"},
    {TroubleCode::kStopDeviceSilent, "stop_device_silent", "only its power switch is known to stop it"},
    {TroubleCode::kSecondWriter, "second_writer", "two command one robot, or two claim to be one thing"},
    {TroubleCode::kProcessDead, "process_dead", "what it did is not done, and others wait for it"},
    {TroubleCode::kProcessHung, "process_hung", "likewise, but it is started again by itself in seconds"},
    {TroubleCode::kClockAhead, "clock_ahead", "what its host says is refused, as if it were silent"},
    {TroubleCode::kMessagesLost, "messages_lost", "pictures, which take many packets, get lost first"},
    {TroubleCode::kCameraSilent, "camera_silent", "the robot is blind; whether its marks are seen is not known"},
    {TroubleCode::kStopLatched, "stop_latched", "somebody wanted it: nothing moves, whatever is below"},
    {TroubleCode::kMarkUnseen, "mark_unseen", "the task waits, and gives up soon"},
    {TroubleCode::kHandUnseen, "hand_unseen", "likewise; without the target's mark the hand's is of no use"},
    {TroubleCode::kPoseLost, "pose_lost", "the base must not drive; the arm may work all the same"},
    {TroubleCode::kBaseBlocked, "base_blocked", "goes on by itself when the way is free"},
    {TroubleCode::kRecordingEnded, "recording_ended", "the robot works on, but what happens now is not kept"},
    {TroubleCode::kTargetRefused, "target_refused", "an answer, no fault: nothing has moved"},
};

// "process_dead", ...
constexpr const char* name_of(TroubleCode code) {
  for (const TroubleRank& rank : kTroubleOrder) {
    if (rank.code == code) return rank.name;
  }
  return "";
}

struct Trouble {
  TroubleCode code = TroubleCode::kMmiLost;
  std::string subject;           // a process, device, channel, mark, folder: what to look at
  std::int64_t since_utime = 0;  // us of the source's clock: when the first message was heard that tells it, or, of
                                 // silence, the last one
  std::string text;              // what is wrong, a sentence without its full stop
  std::string remedy;            // what a person does, likewise, with the command to type where there is one
};

// What is one trouble as long as it lasts. A stop is one whatever has latched so far: device after device hears of it.
inline std::pair<TroubleCode, std::string> identity_of(const Trouble& trouble) {
  return {trouble.code, trouble.code == TroubleCode::kStopLatched ? "" : trouble.subject};
}

inline bool operator==(const Trouble& a, const Trouble& b) {
  return a.code == b.code && a.subject == b.subject && a.since_utime == b.since_utime && a.text == b.text &&
         a.remedy == b.remedy;
}

}  // namespace markservo::mmi
