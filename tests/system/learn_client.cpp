// Asks mark-detector for a mark's colour as a display does: keeps the first STEREO_FRAME that it hears, and sends it in
// a LEARN_REQUEST, in pieces, again after 1 s without an answer, up to three times; for tests.
//   learn-client --mark NAME --box X,Y,WIDTH,HEIGHT [--save] [--requests N] [--picture FILE]
// Of each request a line of JSON: how often it was sent, and the answer. FILE gets the frame's left picture: a raw one
// as PNG, a JPEG byte by byte. Exit codes: 0 all answered; 1 not; 2 bad options; 3 no bus.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <markservo/LearnRequest.hpp>
#include <markservo/LearnResult.hpp>
#include <markservo/LearnWarning.hpp>
#include <markservo/StereoFrame.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus.hpp"
#include "common/bus/bus_unavailable.hpp"
#include "common/bus/bus_url.hpp"
#include "services/mark-detector/learning/robot_file_edit.hpp"
#include "tests/unit/mark-detector/request_pieces.hpp"

namespace markservo {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kListen(20);
constexpr milliseconds kBetweenPieces(2);
constexpr std::chrono::seconds kResend(1);
constexpr int kSendings = 4;  // once, and three times again
constexpr std::chrono::seconds kPatience(20);

struct Wish {
  std::string url = bus::kDefaultUrl;
  std::string mark;
  std::vector<int> box;
  bool save = false;
  int requests = 1;
  std::string picture;
};

bus::BusParameters parameters(const std::string& url) {
  bus::BusParameters result;
  result.urls = {url, url};
  result.service_name = "learn-client";
  result.heartbeat = false;
  return result;
}

class LearnClient {
 public:
  explicit LearnClient(const std::string& url)
      : bus_(parameters(url)), requests_(bus_.advertise(channels::kLearnRequest)) {
    bus_.on_latest(channels::kStereoFrame, [this](const StereoFrame& frame) {
      if (!frozen_) frozen_ = frame;
      newest_utime_ = frame.utime;
    });
    bus_.on_each(channels::kLearnResult, [this](const LearnResult& result) {
      if (result.request_session == requests_.session() && result.request_id == request_id_) answer_ = result;
    });
  }

  // The frame that is learned from; nothing if none came in time.
  const StereoFrame* freeze() {
    const auto end = steady_clock::now() + kPatience;
    while (!frozen_ && steady_clock::now() < end) bus_.poll(kListen);
    return frozen_ ? &*frozen_ : nullptr;
  }

  // The answer, and in `sent` how often it took; nothing if there is none.
  std::optional<LearnResult> ask(const Wish& wish, bool save, int& sent) {
    LearnRequest request{};
    request.session = requests_.session();
    request.request_id = ++request_id_;
    request.mark = wish.mark;
    request.x = wish.box[0];
    request.y = wish.box[1];
    request.width = wish.box[2];
    request.height = wish.box[3];
    request.save = save ? 1 : 0;
    request.frame = *frozen_;
    std::vector<LearnRequest> pieces = mark_detector::test::pieces_of(std::move(request));
    answer_.reset();
    for (sent = 0; !answer_ && sent < kSendings; ++sent) {
      for (LearnRequest& piece : pieces) {
        piece.utime = newest_utime_;  // anew each time: an old one is refused
        requests_.publish(piece);
        bus_.poll(kBetweenPieces);
      }
      const auto end = steady_clock::now() + kResend;
      while (!answer_ && steady_clock::now() < end) bus_.poll(kListen);
    }
    return answer_;
  }

 private:
  bus::Bus bus_;
  bus::Publisher<LearnRequest> requests_;
  std::optional<StereoFrame> frozen_;
  std::int64_t newest_utime_ = 0;
  std::int64_t request_id_ = 0;
  std::optional<LearnResult> answer_;
};

void write_left(const StereoFrame& frame, const std::string& path) {
  if (frame.encoding == StereoFrame::ENCODING_BGR8) {
    cv::imwrite(path, cv::Mat(frame.height, frame.width, CV_8UC3, const_cast<std::uint8_t*>(frame.left.data())));
    return;
  }
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(frame.left.data()), static_cast<std::streamsize>(frame.left.size()));
}

nlohmann::ordered_json json_of(const LearnResult& r) {
  nlohmann::ordered_json warnings = nlohmann::ordered_json::array();
  for (const LearnWarning& warning : r.warnings) warnings.push_back(warning.text);
  return {{"learned", r.learned != 0},
          {"interval", mark_detector::to_text({r.hue_min_deg, r.hue_max_deg, r.saturation_min, r.saturation_max,
                                               r.value_min, r.value_max})},
          {"covered", r.covered},
          {"warnings", warnings},
          {"written", r.written != 0},
          {"reason", r.reason}};
}

int run(const Wish& wish) {
  LearnClient client(wish.url);
  const StereoFrame* frame = client.freeze();
  if (frame == nullptr) {
    std::fprintf(stderr, "learn-client: no STEREO_FRAME within 20 s\n");
    return 1;
  }
  if (!wish.picture.empty()) write_left(*frame, wish.picture);
  bool all_answered = true;
  for (int i = 0; i < wish.requests; ++i) {
    int sent = 0;
    const auto begin = steady_clock::now();
    const std::optional<LearnResult> answer = client.ask(wish, wish.save && i + 1 == wish.requests, sent);
    const std::chrono::duration<double> took = steady_clock::now() - begin;
    nlohmann::ordered_json line{{"sent", sent}, {"seconds", took.count()}, {"answered", answer.has_value()}};
    if (answer) line.update(json_of(*answer));
    std::printf("%s\n", line.dump().c_str());
    all_answered = all_answered && answer;
  }
  return all_answered ? 0 : 1;
}

}  // namespace
}  // namespace markservo

int main(int argc, char** argv) {
  CLI::App app("Asks mark-detector for a mark's colour");
  markservo::Wish wish;
  app.add_option("--lcm-url", wish.url, "The bus");
  app.add_option("--mark", wish.mark, "Whose colour")->required();
  app.add_option("--box", wish.box, "Where it is in the left picture, px")->delimiter(',')->expected(4)->required();
  app.add_flag("--save", wish.save, "Write what the last request learns into the robot's file");
  app.add_option("--requests", wish.requests, "So many, one after the other");
  app.add_option("--picture", wish.picture, "Write the frame's left picture there");
  try {
    app.parse(argc, argv);
    return markservo::run(wish);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const markservo::bus::BusUnavailable& error) {
    std::fprintf(stderr, "learn-client: %s\n", error.what());
    return 3;
  }
}
