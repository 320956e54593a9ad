#pragma once

// Who has fallen silent: a service that hangs is alive for the kernel and for its supervisor, but says nothing on the
// bus any more. No bus, no clock, no process: the caller tells what was heard, sent and found, and when, in us of a
// clock that nobody sets; times never go back.

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace markservo::stack_watch {

struct SilenceParameters {
  // Five words are missed then, of one a second, and a machine under load delays one by 1 to 2 s.
  std::int64_t silence_us = 5'000'000;
  // For the first word: a service reads its files before, which takes a loaded machine several seconds.
  std::int64_t start_us = 15'000'000;
  // Twice as long for the next one of its name, so often: a kill would only have it begin the same work again.
  int start_doubled = 4;
  // So many processes of a name in a row are told that say no word, where none of that name ever did: it may speak on
  // another bus.
  int mute_in_a_row = 3;
  // Longer between two ticks, and the watch itself was held up: it knows nothing of that time.
  std::int64_t leap_us = 1'000'000;
  // Own words that do not come back one after another before the bus counts as gone. One a second.
  int beacons_missed = 3;
  // What they have on top of silence_us to join the bus again.
  std::int64_t return_us = 5'000'000;
  // Where messages are lost, silence may be chance: the limit grows until that is less likely than this.
  double chance = 1e-6;
};

// A process that the supervisor runs.
struct RunningProcess {
  std::string name;
  int pid = 0;
  // By its command line it is the service itself, on this bus: it must speak. What makes it wait before it begins is
  // not.
  bool must_speak = false;
};

// One that spoke and does not any more, or that never began.
struct SilentService {
  std::string name;
  int pid = 0;
  std::int64_t silent_us = 0;
  bool spoke = false;
};

class SilenceWatch {
 public:
  explicit SilenceWatch(SilenceParameters parameters = {}) : parameters_(parameters) {}

  // A service's own word: its SERVICE_STATUS, from this host.
  void observe_word(const std::string& name, int pid, std::int64_t session, std::int64_t now_us);
  // Any other message of that session.
  void observe_session(std::int64_t session, std::int64_t now_us);
  // The watch sends a word of its own once a second, which comes back while there is a bus.
  void send_beacon();
  void observe_beacon(std::int64_t now_us);

  // To be called at least four times a second: those silent for too long, of the processes that run now. Each is told
  // once, and then counted anew. One that is not in `processes` is never told, nor listened to.
  std::vector<SilentService> step(const std::vector<RunningProcess>& processes, std::int64_t now_us);

  // Own words do not come back: nobody can be judged.
  bool bus_is_gone() const { return beacons_in_a_row_missed_ >= parameters_.beacons_missed; }
  // How long a service may be silent now, us.
  std::int64_t limit_us() const;
  // Since its last sign of life, us; -1 for one that never spoke.
  std::int64_t silent_for_us(const std::string& name, int pid, std::int64_t now_us) const;

 private:
  using Key = std::pair<std::string, int>;  // name and pid
  struct Speaker {
    bool spoke = false;
    std::int64_t session = 0;
    std::int64_t heard_us = 0;    // the last sign of life, or since when it must speak
    std::int64_t counted_us = 0;  // silence counts from here
  };

  void renew(const Key& key, std::int64_t now_us);
  void follow(const std::vector<RunningProcess>& processes, std::int64_t now_us);
  bool is_silent(const Key& key, const Speaker& speaker, std::int64_t now_us);
  void count_anew(std::int64_t from_us);

  static constexpr std::size_t kBeaconsKept = 20;

  SilenceParameters parameters_;
  std::map<Key, Speaker> speakers_;         // the processes of the last step
  std::map<std::int64_t, Key> speaker_of_;  // by session
  std::set<std::string> have_spoken_;       // names, of a process of the stack
  std::map<std::string, int> mute_;         // how many processes of a name in a row were told that said no word
  std::deque<bool> beacons_;                // the last ones, the newest at the end: whether it came back
  int beacons_in_a_row_missed_ = 0;
  bool heard_no_beacon_ = true;  // until the first comes back
  std::int64_t stepped_us_ = -1;
};

}  // namespace markservo::stack_watch
