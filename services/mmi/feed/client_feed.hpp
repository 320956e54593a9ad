#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "services/mmi/control/desk.hpp"
#include "services/mmi/feed/shown.hpp"
#include "services/mmi/pictures/picture_maker.hpp"
#include "services/mmi/server/web_site.hpp"

namespace markservo::mmi {

// What a conversation asks of the program.
class FeedHost {
 public:
  virtual ~FeedHost() = default;
  // The hello, but for its events, without the last brace.
  virtual const std::string& hello() const = 0;
  virtual bool admits(const std::string& token) const = 0;
  virtual std::string stop(const std::string& reason) = 0;  // why it cannot be; empty when it goes out
  virtual const VersionedText& stop_state() const = 0;
  virtual PictureMaker& pictures() = 0;
  // Where commands come in; null: nowhere.
  virtual Desk* desk() { return nullptr; }
  // Random, for one more conversation.
  virtual std::int64_t new_session() = 0;
  virtual double now() const = 0;  // s of a steady clock
};

// s: who hears nothing for longer knows that there is nobody, or nobody at work.
inline constexpr double kUpdateAtLeastEvery = 0.25;

struct FeedParameters {
  double update_every = 0.05;         // s: 20 a second, which an eye takes as motion
  double picture_every = 1.0 / 15.0;  // s
  int updates_under_way = 8;          // 0.4 s: what a client that reads again is behind at most
  int pictures_under_way = 2;         // one is drawn while the next is on its way
};

// A client of the page's protocol: newest of what is measured, each change of state.
class ClientFeed final : public Conversation {
 public:
  ClientFeed(FeedHost& host, std::unique_ptr<Shown> shown, const FeedParameters& parameters = {});
  ~ClientFeed() override;
  ClientFeed(const ClientFeed&) = delete;
  ClientFeed& operator=(const ClientFeed&) = delete;

  std::string hear(std::string_view text) override;
  bool greeted() const override { return greeted_; }
  std::optional<OutgoingMessage> next() override;
  std::string trouble() const override;

 private:
  // What it has been told.
  struct Told {
    std::uint64_t generation = 0;
    std::uint64_t slots = 0;
    std::int64_t event = 0;
    std::uint64_t arm = 0;
    std::uint64_t places = 0;
    std::uint64_t floor = 0;
    std::uint64_t troubles = 0;
    std::uint64_t figures = 0;
    std::uint64_t latency = 0;
    std::uint64_t stop = 0;
    std::uint64_t play = 0;
  };

  std::string obey(const ClientWord& message);
  std::string obey_operator(const ClientWord& message);
  std::string hello_text();
  std::string desk_parts();
  std::optional<std::string> update_text();
  std::string slot_list();
  std::optional<std::string> picture();
  bool wants(const std::string& channel) const;

  FeedHost& host_;
  std::unique_ptr<Shown> shown_;
  std::int64_t session_;  // this conversation's
  FeedParameters parameters_;
  bool greeted_ = false;
  bool told_hello_ = false;
  bool wants_pictures_ = false;
  std::set<std::string> looked_;
  Told told_;
  std::string told_desk_;
  std::int64_t update_ = 0;  // the newest sent
  std::int64_t took_ = 0;    // the newest taken
  std::int64_t picture_ = 0;
  std::int64_t seen_ = 0;
  std::optional<double> updated_at_;  // s
  double picture_due_ = 0.0;          // s
  std::weak_ptr<const Frame> shown_frame_;
};

}  // namespace markservo::mmi
