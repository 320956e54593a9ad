#pragma once

namespace markservo::bus {

// From now on SIGINT and SIGTERM, and SIGHUP where `hangup` says so (the terminal went away), are noted and end nothing
// by themselves.
void note_end_signals(bool hangup = false);

// Whether one of them has come.
bool told_to_end();

}  // namespace markservo::bus
