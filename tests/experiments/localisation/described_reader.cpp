#include "tests/experiments/localisation/described_reader.hpp"

namespace markservo::experiments {

ReaderModel described_reader(const robot::RfidDescription& rfid, const robot::TagField& field) {
  ReaderModel reader;
  reader.p_RF = rfid.p_RF;
  reader.reading_radius = rfid.reading_radius;
  reader.edge_softness = rfid.edge_softness;
  reader.read_probability = rfid.read_probability;
  reader.round_time = rfid.round_time;
  for (const auto& tag : field.tags) reader.tags.push_back(tag.p_W);
  return reader;
}

}  // namespace markservo::experiments
