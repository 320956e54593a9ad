#include "services/log-tool/log_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "common/reflection/value_text.hpp"
#include "services/log-tool/message_key.hpp"

namespace markservo::log_tool {
namespace {

using reflection::Bytes;
using reflection::Leaf;

bool names_the_writer(const reflection::MessageType& type, const std::string& field) {
  return type.package == reflection::kOurPackage && (field == "session" || field == "seq");
}

std::vector<Leaf> compared_leaves(const reflection::Fields& fields) {
  std::vector<Leaf> leaves = reflection::leaves(fields);
  leaves.erase(std::remove_if(leaves.begin(), leaves.end(),
                              [&fields](const Leaf& leaf) { return names_the_writer(*fields.type, leaf.path); }),
               leaves.end());
  return leaves;
}

std::string excerpt(const Leaf* leaf) {
  return leaf == nullptr ? "nothing" : reflection::text_of(leaf->value);
}

// How far two values are apart: 0 equal; infinite where they are no numbers, or where one is none.
double distance(const Leaf& a, const Leaf& b) {
  if (const auto* bytes = std::get_if<Bytes>(&a.value.content)) {
    const auto* other = std::get_if<Bytes>(&b.value.content);
    const bool same = other != nullptr && bytes->size == other->size &&
                      (bytes->size == 0 || std::memcmp(bytes->data, other->data, bytes->size) == 0);
    return same ? 0.0 : INFINITY;
  }
  const auto* x = std::get_if<double>(&a.value.content);
  const auto* y = std::get_if<double>(&b.value.content);
  if (x == nullptr || y == nullptr)
    return reflection::text_of(a.value) == reflection::text_of(b.value) ? 0.0 : INFINITY;
  if (*x == *y || (std::isnan(*x) && std::isnan(*y))) return 0.0;
  return std::isfinite(*x) && std::isfinite(*y) ? std::abs(*x - *y) : INFINITY;
}

double magnitude(const Leaf& leaf) {
  const auto* number = std::get_if<double>(&leaf.value.content);
  return number == nullptr || !std::isfinite(*number) ? 0.0 : std::abs(*number);
}

class Comparer {
 public:
  Comparer(const reflection::TypeCatalog& catalog, const ComparisonParameters& parameters)
      : catalog_(catalog), parameters_(parameters) {}

  LogComparison run(const std::vector<logs::LogEvent>& recorded, const std::vector<logs::LogEvent>& replayed) {
    std::map<std::string, std::int64_t> begins;  // utime of each channel's first replayed message
    for (const logs::LogEvent& event : replayed)
      begins.try_emplace(std::string(event.channel), message_utime(event, catalog_));
    std::map<std::string, std::int64_t> recorded_begins;
    std::map<MessageKey, const logs::LogEvent*> counterparts;
    MessageKeys recorded_keys(catalog_);
    for (const logs::LogEvent& event : recorded) {
      const auto begin = begins.find(std::string(event.channel));
      if (begin == begins.end()) continue;
      const std::int64_t utime = message_utime(event, catalog_);
      const std::int64_t recorded_begin = recorded_begins.try_emplace(begin->first, utime).first->second;
      if (utime < begin->second && logs::seconds_apart(recorded_begin, utime) <= parameters_.start_up) {
        ++result_.channels[begin->first].outside;
      } else {
        counterparts.emplace(recorded_keys.next(event), &event);
      }
    }
    MessageKeys replayed_keys(catalog_);
    for (const logs::LogEvent& event : replayed) {
      const auto counterpart = counterparts.find(replayed_keys.next(event));
      ChannelComparison& channel = result_.channels[std::string(event.channel)];
      if (counterpart == counterparts.end()) {
        ++channel.extra;
        continue;
      }
      compare(*counterpart->second, event, channel);
      counterparts.erase(counterpart);
    }
    for (const auto& [key, event] : counterparts) {
      ++result_.channels[std::get<0>(key)].missing;
      note_first({std::get<0>(key), std::get<1>(key), "", "a message", "no message"});
    }
    return std::move(result_);
  }

 private:
  void compare(const logs::LogEvent& recorded, const logs::LogEvent& replayed, ChannelComparison& channel) {
    const auto old_message = reflection::decode(catalog_, recorded.data.data, recorded.data.size);
    const auto new_message = reflection::decode(catalog_, replayed.data.data, replayed.data.size);
    if (!old_message.error.empty() || !new_message.error.empty()) {
      const bool same = recorded.data.text() == replayed.data.text();
      ++(same ? channel.equal : channel.different);
      if (!same) note_first(difference(replayed, "payload", old_message.error, new_message.error));
      return;
    }
    const std::vector<Leaf> before = compared_leaves(old_message.fields);
    const std::vector<Leaf> now = compared_leaves(new_message.fields);
    double largest = 0.0;
    bool beyond = false;
    for (std::size_t i = 0; i < std::max(before.size(), now.size()); ++i) {
      const Leaf* a = i < before.size() ? &before[i] : nullptr;
      const Leaf* b = i < now.size() ? &now[i] : nullptr;
      const bool same_field = a != nullptr && b != nullptr && a->path == b->path;
      const double apart = same_field ? distance(*a, *b) : INFINITY;
      if (apart > largest) largest = apart;
      if (apart > channel.largest) {
        channel.largest = apart;
        channel.largest_field = (a != nullptr ? a : b)->path;
      }
      const double allowed =
          same_field ? parameters_.tolerance * std::max(1.0, std::max(magnitude(*a), magnitude(*b))) : 0.0;
      if (apart <= allowed) continue;
      if (!beyond) note_first(difference(replayed, (a != nullptr ? a : b)->path, excerpt(a), excerpt(b)));
      beyond = true;
    }
    ++(beyond ? channel.different : largest > 0.0 ? channel.within : channel.equal);
  }

  FieldDifference difference(const logs::LogEvent& event, const std::string& field, const std::string& recorded,
                             const std::string& replayed) const {
    return {std::string(event.channel), message_utime(event, catalog_), field, recorded, replayed};
  }

  void note_first(FieldDifference difference) {
    if (!result_.first) result_.first = std::move(difference);
  }

  const reflection::TypeCatalog& catalog_;
  ComparisonParameters parameters_;
  LogComparison result_;
};

}  // namespace

bool LogComparison::as_recorded() const {
  return !channels.empty() &&
         std::all_of(channels.begin(), channels.end(), [](const auto& entry) { return entry.second.as_recorded(); });
}

bool LogComparison::complete() const {
  return !channels.empty() &&
         std::all_of(channels.begin(), channels.end(), [](const auto& entry) { return entry.second.complete(); });
}

LogComparison compare(const std::vector<logs::LogEvent>& recorded, const std::vector<logs::LogEvent>& replayed,
                      const reflection::TypeCatalog& catalog, const ComparisonParameters& parameters) {
  return Comparer(catalog, parameters).run(recorded, replayed);
}

}  // namespace markservo::log_tool
