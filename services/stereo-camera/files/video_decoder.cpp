#include "services/stereo-camera/files/video_decoder.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/imgutils.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "services/stereo-camera/files/orientation.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kMaxRate_hz = 1000.0;  // files without a time base state nonsense such as 90000
constexpr int kRowPixels = 32;          // swscale writes whole vectors, beyond the width where that is no multiple
constexpr AVRational kMicroseconds{1, 1'000'000};

struct Free {
  void operator()(AVFormatContext* format) const { avformat_close_input(&format); }
  void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
template <class Type>
using Owned = std::unique_ptr<Type, Free>;

std::string error_text(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

void require(int result) {
  if (result < 0) throw std::runtime_error(error_text(result));
}

Owned<AVFormatContext> open_file(const std::string& path) {
  AVDictionary* options = nullptr;
  // A playlist may name what lies elsewhere.
  av_dict_set(&options, "protocol_whitelist", "file", 0);
  AVFormatContext* format = nullptr;
  const int result = avformat_open_input(&format, ("file:" + path).c_str(), nullptr, &options);
  av_dict_free(&options);
  require(result);
  return Owned<AVFormatContext>(format);
}

Orientation stated_orientation(const AVStream& stream) {
  std::array<std::int32_t, 9> matrix{};
  std::size_t bytes = 0;
  const std::uint8_t* data = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &bytes);
  if (data == nullptr || bytes < sizeof matrix) return {};
  std::copy_n(data, sizeof matrix, reinterpret_cast<std::uint8_t*>(matrix.data()));
  return orientation_of(matrix);
}

double number(AVRational ratio) {
  return ratio.den == 0 ? 0.0 : av_q2d(ratio);
}

}  // namespace

struct VideoDecoder::State {
  Owned<AVFormatContext> format;
  Owned<AVCodecContext> codec;
  Owned<AVPacket> packet{av_packet_alloc()};
  Owned<AVFrame> frame{av_frame_alloc()};
  Owned<SwsContext> scaler;
  AVStream* stream = nullptr;
  std::int64_t origin = 0;  // where the time line begins, in units of the stream
  Orientation orientation;
  bool drained = false;  // no packet is left to be sent

  void open_codec(const AVCodec& decoder) {
    codec.reset(avcodec_alloc_context3(&decoder));
    if (!codec) throw std::runtime_error("out of memory");
    require(avcodec_parameters_to_context(codec.get(), stream->codecpar));
    codec->pkt_timebase = stream->time_base;
    codec->thread_count = 0;  // as many as there are cores
    require(avcodec_open2(codec.get(), &decoder, nullptr));
  }

  // Gives the codec its next packet; at the end, once, the sign that there is none.
  void send() {
    while (av_read_frame(format.get(), packet.get()) >= 0) {
      const bool ours = packet->stream_index == stream->index;
      // A damaged packet costs its picture.
      if (ours) avcodec_send_packet(codec.get(), packet.get());
      av_packet_unref(packet.get());
      if (ours) return;
    }
    avcodec_send_packet(codec.get(), nullptr);
    drained = true;
  }

  cv::Mat image() {
    const AVFrame& decoded = *frame;
    scaler.reset(sws_getCachedContext(scaler.release(), decoded.width, decoded.height,
                                      static_cast<AVPixelFormat>(decoded.format), decoded.width, decoded.height,
                                      AV_PIX_FMT_BGR24, SWS_BICUBIC, nullptr, nullptr, nullptr));
    if (!scaler) return {};
    const int padded_width = (decoded.width + kRowPixels - 1) / kRowPixels * kRowPixels;
    cv::Mat padded(decoded.height, padded_width, CV_8UC3);
    std::uint8_t* const planes[] = {padded.data, nullptr, nullptr, nullptr};
    const int strides[] = {static_cast<int>(padded.step), 0, 0, 0};
    sws_scale(scaler.get(), decoded.data, decoded.linesize, 0, decoded.height, planes, strides);
    const cv::Mat view = padded.colRange(0, decoded.width);
    return make_upright(view, orientation);
  }

  std::optional<std::int64_t> time_us() const {
    const std::int64_t stated = frame->best_effort_timestamp;
    if (stated == AV_NOPTS_VALUE) return std::nullopt;
    return av_rescale_q(stated - origin, stream->time_base, kMicroseconds);
  }
};

VideoDecoder::VideoDecoder(const std::string& path) : state_(std::make_unique<State>()) {
  av_log_set_level(AV_LOG_QUIET);  // what goes wrong is told by us
  State& state = *state_;
  if (!state.packet || !state.frame) throw std::runtime_error("out of memory");
  state.format = open_file(path);
  require(avformat_find_stream_info(state.format.get(), nullptr));
  const AVCodec* decoder = nullptr;
  const int index = av_find_best_stream(state.format.get(), AVMEDIA_TYPE_VIDEO, -1, -1, &decoder, 0);
  require(index);
  state.stream = state.format->streams[index];
  // A broadcast's clock has begun anywhere; other files count from the beginning of the recording.
  const bool any_origin = (state.format->iformat->flags & AVFMT_TS_DISCONT) != 0;
  if (any_origin && state.stream->start_time != AV_NOPTS_VALUE) state.origin = state.stream->start_time;
  state.orientation = stated_orientation(*state.stream);
  state.open_codec(*decoder);
}

VideoDecoder::~VideoDecoder() = default;

std::optional<VideoPicture> VideoDecoder::next() {
  State& state = *state_;
  for (;;) {
    const int result = avcodec_receive_frame(state.codec.get(), state.frame.get());
    if (result >= 0) {
      VideoPicture picture{state.image(), state.time_us()};
      av_frame_unref(state.frame.get());
      if (picture.image.empty()) continue;
      return picture;
    }
    if (result == AVERROR_EOF || state.drained) return std::nullopt;
    state.send();
  }
}

double VideoDecoder::rate() const {
  for (const AVRational& ratio : {state_->stream->avg_frame_rate, state_->stream->r_frame_rate}) {
    const double rate = number(ratio);
    if (std::isfinite(rate) && rate > 0.0 && rate <= kMaxRate_hz) return rate;
  }
  return 0.0;
}

}  // namespace markservo::stereo_camera
