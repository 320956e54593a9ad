#include "services/mmi/feed/client_feed.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <markservo/channels.hpp>
#include <stdexcept>

namespace markservo::mmi {
namespace {

// Small ones of the table: what the views are made of.
bool is_always_told(const std::string& channel) {
  const auto& all = channels::kAll;
  const auto found = std::find_if(std::begin(all), std::end(all), [&](const auto& one) { return channel == one.name; });
  return found != std::end(all) && !found->large;
}

template <class Version>
void add_part(std::string& parts, const char* name, const VersionedText& text, Version& told) {
  if (text.version == told) return;
  told = text.version;
  parts += fmt::format(",\"{}\":", name) + text.text;
}

}  // namespace

ClientFeed::ClientFeed(FeedHost& host, std::unique_ptr<Shown> shown, const FeedParameters& parameters)
    : host_(host), shown_(std::move(shown)), session_(host.new_session()), parameters_(parameters) {
  if (Desk* desk = host_.desk()) desk->arrive(session_);
}

ClientFeed::~ClientFeed() {
  if (Desk* desk = host_.desk()) desk->leave(session_);
}

std::string ClientFeed::hear(std::string_view text) {
  try {
    return obey(parse_client_word(text));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

std::string ClientFeed::obey(const ClientWord& message) {
  if (const auto* stop = std::get_if<ClientStop>(&message)) return host_.stop(stop->reason);
  if (const auto* hello = std::get_if<ClientHello>(&message)) {
    if (!host_.admits(hello->token)) return "another token than this program's: open the address that it printed";
    greeted_ = true;
    if (Desk* desk = host_.desk()) desk->hear_token(session_, hello->token);
    return {};
  }
  if (!greeted_) return "no hello; allowed: hello first";
  if (const auto* pictures = std::get_if<ClientPictures>(&message)) {
    wants_pictures_ = pictures->on;
  } else if (const auto* seen = std::get_if<ClientSeen>(&message)) {
    seen_ = std::clamp(seen->picture, seen_, picture_);
  } else if (const auto* took = std::get_if<ClientTook>(&message)) {
    took_ = std::clamp(took->update, took_, update_);
  } else if (const auto* look = std::get_if<ClientLook>(&message)) {
    looked_ = {look->channels.begin(), look->channels.end()};
    told_.slots = 0;  // what stands there already is told too
  } else if (std::holds_alternative<ClientLease>(message) || std::holds_alternative<ClientCommand>(message)) {
    return obey_operator(message);
  } else {
    return shown_->control(message);
  }
  return {};
}

std::string ClientFeed::obey_operator(const ClientWord& message) {
  Desk* desk = host_.desk();
  if (desk == nullptr) return "a command; allowed: where mmi was started with --enable-commands";
  if (const auto* lease = std::get_if<ClientLease>(&message)) {
    desk->lease(session_, lease->on, lease->take, host_.now());
  } else if (const auto* wish = std::get_if<ClientCommand>(&message)) {
    desk->command(session_, wish->stamp, wish->command, host_.now(), shown_->utime());
  }
  return {};
}

std::string ClientFeed::trouble() const {
  if (!told_hello_) return {};
  const Desk* desk = host_.desk();
  if (desk != nullptr && desk->is_behind(session_)) return "too slow: answers to commands would be left out";
  if (shown_->events().has_all_after(told_.event)) return {};
  return "too slow: events would be left out";
}

bool ClientFeed::wants(const std::string& channel) const {
  return is_always_told(channel) || looked_.count(channel) != 0;
}

std::optional<OutgoingMessage> ClientFeed::next() {
  if (!greeted_) return std::nullopt;
  const auto text = [](std::string content, bool binary) {
    return OutgoingMessage{std::make_shared<const std::string>(std::move(content)), binary};
  };
  if (!told_hello_) {
    told_hello_ = true;
    return text(hello_text(), false);
  }
  shown_->advance(host_.now());
  if (auto update = update_text()) return text(std::move(*update), false);
  if (auto sent = picture()) return text(std::move(*sent), true);
  return std::nullopt;
}

std::string ClientFeed::hello_text() {
  const EventLog& events = shown_->events();
  told_.event = events.newest();
  return host_.hello() + ",\"events\":" + events.list_after(0) + "}";
}

std::string ClientFeed::slot_list() {
  std::string list;
  const MessageSlots& slots = shown_->world().slots();
  for (const MessageSlots::Slot* slot : slots.since(told_.slots)) {
    if (!wants(slot->channel)) continue;
    list += (list.empty() ? "" : ",") + slot->json();
  }
  told_.slots = slots.version();
  return list;
}

std::string ClientFeed::desk_parts() {
  Desk* desk = host_.desk();
  if (desk == nullptr) return {};
  std::string parts;
  std::string view = desk->view(session_, host_.now(), shown_->utime());
  if (view != told_desk_) {
    parts += ",\"desk\":" + view;
    told_desk_ = std::move(view);
  }
  if (const std::string answers = desk->take_answers(session_); !answers.empty()) parts += ",\"answers\":" + answers;
  return parts;
}

std::optional<std::string> ClientFeed::update_text() {
  const double now = host_.now();
  if (updated_at_ && now - *updated_at_ < parameters_.update_every) return std::nullopt;
  if (update_ - took_ >= parameters_.updates_under_way) return std::nullopt;

  WorldReader& world = shown_->world();
  std::string parts;
  if (told_.generation != shown_->generation()) {
    const std::int64_t event = told_.event;
    const std::uint64_t stop = told_.stop;
    told_ = {};
    told_.generation = shown_->generation();
    told_.event = event;
    told_.stop = stop;
    parts += ",\"anew\":true";
  }
  const std::string slots = slot_list();
  if (!slots.empty()) parts += ",\"slots\":[" + slots + "]";
  const EventLog& events = shown_->events();
  if (events.newest() > told_.event) {
    parts += ",\"events\":" + events.list_after(told_.event);
    told_.event = events.newest();
  }
  add_part(parts, "arm", world.arm(), told_.arm);
  add_part(parts, "places", world.places(), told_.places);
  add_part(parts, "floor", world.floor(), told_.floor);
  add_part(parts, "troubles", world.trouble_list(), told_.troubles);
  add_part(parts, "figures", world.figures(), told_.figures);
  add_part(parts, "latency", world.latency(), told_.latency);
  add_part(parts, "stop", host_.stop_state(), told_.stop);
  add_part(parts, "play", shown_->play(), told_.play);
  parts += desk_parts();
  const bool is_due = !updated_at_ || now - *updated_at_ >= kUpdateAtLeastEvery;
  if (parts.empty() && !is_due) return std::nullopt;
  updated_at_ = now;
  return fmt::format("{{\"type\":\"update\",\"number\":{},\"now\":\"{}\"", ++update_, shown_->utime()) + parts + "}";
}

std::optional<std::string> ClientFeed::picture() {
  const double now = host_.now();
  if (!wants_pictures_ || picture_ - seen_ >= parameters_.pictures_under_way || now < picture_due_) return std::nullopt;
  const std::shared_ptr<const Frame> frame = shown_->picture();
  if (!frame || frame == shown_frame_.lock()) return std::nullopt;
  shown_frame_ = frame;
  const auto made = host_.pictures().made(frame);
  if (!made) return std::nullopt;
  // So that frames at 30 Hz are shown at 15, not at what the clock's unevenness leaves of it.
  picture_due_ = std::max(picture_due_ + parameters_.picture_every, now - parameters_.picture_every / 2.0);
  return picture_message(*made, ++picture_);
}

}  // namespace markservo::mmi
