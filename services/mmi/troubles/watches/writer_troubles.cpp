#include "services/mmi/troubles/watches/writer_troubles.hpp"

namespace markservo::mmi {

void WriterTroubles::observe(const AnyWord& word, double now) {
  if (!word.one_writes) return;
  Output* output = known_or_new(outputs_, {word.channel, word.writer_of}, now);
  if (output == nullptr) return;
  if (output->other != 0 && now - output->other_heard > parameters_.alone) {
    output->other = 0;
    output->turns = 0;
  }
  if (output->session != 0 && output->session != word.session) {
    const bool again = word.session == output->other;
    if (again && output->turns == 0) output->since = {now, word.at};
    output->turns = again ? output->turns + 1 : output->turns;
    output->other = output->session;
    output->other_heard = output->heard;
  }
  output->session = word.session;
  output->heard = now;
}

void WriterTroubles::observe(const ServiceWord& word, double now) {
  for (const ReceivedWord& channel : word.channels) {
    if (!channel.second_writer) {
      const auto told = told_.find(channel.channel);
      if (told != told_.end() && told->second.reader == word.name) told_.erase(told);
      continue;
    }
    Told* told = known_or_new(told_, channel.channel, now);
    if (told == nullptr) continue;
    if (told->reader.empty() || now - told->heard > parameters_.word) *told = {word.name, {now, word.at}, now};
    if (told->reader == word.name) told->heard = now;
  }
}

bool WriterTroubles::two_write(const Output& output, double now) const {
  return output.turns >= parameters_.turns && now - output.heard <= parameters_.alone &&
         now - output.other_heard <= parameters_.alone;
}

void WriterTroubles::find(const SessionNames& names, const Remedies& remedies, double now, Findings& found) const {
  for (const auto& [place, output] : outputs_) {
    if (!two_write(output, now)) continue;
    const auto& [channel, writer_of] = place;
    const std::string what = writer_of.empty() ? "write " + channel : "claim to be the " + writer_of;
    found.push_back({{TroubleCode::kSecondWriter, writer_of.empty() ? channel : writer_of, output.since.utime,
                      "two " + what + ": " + names.words(output.session) + " and " + names.words(output.other),
                      remedies.second_writer()},
                     output.since.now});
  }
  for (const auto& [channel, told] : told_) {
    const bool heard_here = outputs_.count({channel, ""}) > 0;
    if (heard_here || now - told.heard > parameters_.word) continue;
    found.push_back({{TroubleCode::kSecondWriter, channel, told.since.utime,
                      told.reader + " hears two that write " + channel, remedies.second_writer()},
                     told.since.now});
  }
}

}  // namespace markservo::mmi
