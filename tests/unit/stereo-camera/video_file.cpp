#include "video_file.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace markservo::stereo_camera {
namespace {

constexpr AVRational kMilliseconds{1, 1000};

struct Free {
  void operator()(AVFormatContext* format) const {
    if (format->pb != nullptr) avio_closep(&format->pb);
    avformat_free_context(format);
  }
  void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
  void operator()(AVPacket* packet) const { av_packet_free(&packet); }
  void operator()(AVFrame* frame) const { av_frame_free(&frame); }
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
template <class Type>
using Owned = std::unique_ptr<Type, Free>;

int require(int result, const char* what) {
  if (result < 0) throw std::runtime_error(std::string("write_video: ") + what + " failed");
  return result;
}

bool ends_with(const std::string& path, const std::string& end) {
  return path.size() >= end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
}

class Writer {
 public:
  Writer(const std::string& path, cv::Size size, const VideoFormat& format) {
    av_log_set_level(AV_LOG_QUIET);
    AVFormatContext* made = nullptr;
    require(avformat_alloc_output_context2(&made, nullptr, nullptr, path.c_str()), "a container");
    format_.reset(made);
    format_->flags |= AVFMT_FLAG_BITEXACT;
    open_codec(size, format, ends_with(path, ".mp4") || ends_with(path, ".ts"));
    stream_ = avformat_new_stream(format_.get(), nullptr);
    stream_->time_base = codec_->time_base;
    stream_->avg_frame_rate = codec_->framerate;
    require(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), "the stream");
    const bool turned = std::any_of(format.display_matrix.begin(), format.display_matrix.end(),
                                    [](std::int32_t entry) { return entry != 0; });
    if (turned) {
      std::uint8_t* data = av_stream_new_side_data(stream_, AV_PKT_DATA_DISPLAYMATRIX, sizeof format.display_matrix);
      std::copy_n(reinterpret_cast<const std::uint8_t*>(format.display_matrix.data()), sizeof format.display_matrix,
                  data);
    }
    require(avio_open(&format_->pb, path.c_str(), AVIO_FLAG_WRITE), "opening the file");
    require(avformat_write_header(format_.get(), nullptr), "the header");
    convert_.reset(sws_getContext(size.width, size.height, AV_PIX_FMT_BGR24, size.width, size.height, codec_->pix_fmt,
                                  SWS_BICUBIC, nullptr, nullptr, nullptr));
  }

  void add(const TimedImage& timed) {
    const Owned<AVFrame> frame(av_frame_alloc());
    frame->format = codec_->pix_fmt;
    frame->width = codec_->width;
    frame->height = codec_->height;
    require(av_frame_get_buffer(frame.get(), 0), "a frame");
    const std::uint8_t* const planes[] = {timed.image.data, nullptr, nullptr, nullptr};
    const int strides[] = {static_cast<int>(timed.image.step), 0, 0, 0};
    sws_scale(convert_.get(), planes, strides, 0, frame->height, frame->data, frame->linesize);
    frame->pts = av_rescale_q(timed.time_ms, kMilliseconds, codec_->time_base);
    require(avcodec_send_frame(codec_.get(), frame.get()), "encoding");
    write_packets();
  }

  void finish() {
    require(avcodec_send_frame(codec_.get(), nullptr), "encoding");
    write_packets();
    require(av_write_trailer(format_.get()), "the end");
  }

 private:
  void open_codec(cv::Size size, const VideoFormat& format, bool small) {
    const AVCodec* encoder = avcodec_find_encoder(small ? AV_CODEC_ID_MPEG4 : AV_CODEC_ID_FFV1);
    codec_.reset(avcodec_alloc_context3(encoder));
    codec_->width = size.width;
    codec_->height = size.height;
    codec_->pix_fmt = small ? AV_PIX_FMT_YUV420P : AV_PIX_FMT_BGR0;
    codec_->framerate = av_d2q(format.rate_hz, 100000);
    // Times in ms, but where the container counts pictures.
    const bool counts = std::string(format_->oformat->name) == "avi";
    codec_->time_base = counts ? av_inv_q(codec_->framerate) : kMilliseconds;
    codec_->flags |= AV_CODEC_FLAG_BITEXACT | AV_CODEC_FLAG_QSCALE;
    codec_->global_quality = FF_QP2LAMBDA;  // the best
    if ((format_->oformat->flags & AVFMT_GLOBALHEADER) != 0) codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    require(avcodec_open2(codec_.get(), encoder, nullptr), "the codec");
  }

  void write_packets() {
    const Owned<AVPacket> packet(av_packet_alloc());
    while (avcodec_receive_packet(codec_.get(), packet.get()) >= 0) {
      av_packet_rescale_ts(packet.get(), codec_->time_base, stream_->time_base);
      packet->stream_index = stream_->index;
      require(av_interleaved_write_frame(format_.get(), packet.get()), "writing");
    }
  }

  Owned<AVFormatContext> format_;
  Owned<AVCodecContext> codec_;
  Owned<SwsContext> convert_;
  AVStream* stream_ = nullptr;
};

}  // namespace

void write_video(const std::string& path, const std::vector<TimedImage>& images, const VideoFormat& format) {
  Writer writer(path, images.front().image.size(), format);
  for (const TimedImage& image : images) writer.add(image);
  writer.finish();
}

}  // namespace markservo::stereo_camera
