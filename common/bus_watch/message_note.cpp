#include "common/bus_watch/message_note.hpp"

#include "common/reflection/message_value.hpp"

namespace markservo::bus_watch {

MessageNote note_of(const reflection::TypeCatalog& catalog, const void* data, std::size_t size) {
  MessageNote note;
  note.bytes = size;
  std::uint64_t fingerprint = 0;
  if (!reflection::read_fingerprint(data, size, &fingerprint)) {
    note.decodes = false;
    return note;
  }
  note.fingerprint = fingerprint;
  const reflection::MessageType* type = catalog.find(fingerprint);
  if (type == nullptr) return note;
  note.type = type->name;
  const reflection::DecodedMessage message = reflection::decode(catalog, data, size);
  note.decodes = message.error.empty();
  if (!note.decodes) return note;
  note.session = reflection::integer_in(message.fields, "session", 0);
  note.seq = reflection::integer_in(message.fields, "seq", -1);
  return note;
}

}  // namespace markservo::bus_watch
