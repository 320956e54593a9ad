#include "services/mmi/troubles/watches/loss_troubles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <markservo/channels.hpp>

namespace markservo::mmi {
void LossTroubles::observe(const ServiceWord& word, double now) {
  Service* service = known_or_new(services_, {word.host, word.name}, now);
  if (service == nullptr) return;
  const bool follows = service->session == word.session && now - service->heard <= parameters_.interval_max;
  if (service->session != word.session) service->inputs.clear();
  service->session = word.session;
  service->heard = now;
  for (const ReceivedWord& counts : word.channels) {
    if (channels::find(counts.channel) == nullptr) continue;  // invented ones would fill the memory
    const auto [input, is_new] = service->inputs.try_emplace(counts.channel);
    compare(counts, {now, word.at}, follows && !is_new, input->second);
  }
}

void LossTroubles::compare(const ReceivedWord& counts, Since now, bool follows, Input& input) const {
  const std::int64_t received = counts.received - input.counts.received;
  const std::int64_t lost = counts.lost - input.counts.lost;
  const bool refused = counts.refused != input.counts.refused;
  const double share =
      static_cast<double>(lost) / std::max(1.0, static_cast<double>(lost) + static_cast<double>(received));
  const bool loses =
      follows && input.was_heard && !refused && received > 0 && lost >= parameters_.least && share >= parameters_.share;
  if (loses && input.share == 0.0) input.since = now;
  input.share = loses ? share : 0.0;
  input.was_heard = follows && received > 0 && !refused;
  input.counts = counts;
}

// Of the one that has lost for longest, so that the same is told from word to word.
std::optional<LossTroubles::Loss> LossTroubles::worst(double now) const {
  std::optional<Loss> worst;
  for (const auto& [place, service] : services_) {
    if (now - service.heard > parameters_.word) continue;
    for (const auto& [channel, input] : service.inputs) {
      if (input.share == 0.0) continue;
      if (!worst || input.since.now < worst->input->since.now) worst = Loss{place.second, channel, &input};
    }
  }
  return worst;
}

void LossTroubles::find(const Remedies& remedies, double now, Findings& found) const {
  const auto loss = worst(now);
  if (!loss) return;
  const Input& input = *loss->input;
  const std::string text = fmt::format("{} does not get every {}: about {:.0f} % are lost", loss->service,
                                       loss->channel, 10.0 * std::round(10.0 * input.share));
  found.push_back({{TroubleCode::kMessagesLost, loss->channel, input.since.utime, text, remedies.messages_lost()},
                   input.since.now});
}

}  // namespace markservo::mmi
