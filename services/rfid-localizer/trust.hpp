#pragma once

// Whether the estimate may be believed: followed round by round, so that a robot that was carried away says so.

#include <cstdint>
#include <string>

namespace markservo::rfid_localizer {

enum class Placement { kSearching, kLocalised, kLost };

struct TrustParameters {
  int contradictions = 5;       // rounds, less the agreeing ones between them: half a second at 10 Hz
  double unlikely = 0.01;       // an empty round with less probability contradicts
  double explained = 0.05;      // a read whose tag was inside the footprint with less probability is no confirmation
  int confirmations = 3;        // agreeing rounds with reads until a new place is believed
  double largest_sigma = 0.15;  // m, of the position: more is no place to drive by
  double silence = 2.0;         // s without any round: the reader is gone
};

// How a round looks to the estimate.
enum class Agreement {
  kAgrees,       // reads that the antenna can have reached
  kNothing,      // nothing read where that is no wonder
  kContradicts,  // only reads from elsewhere, or nothing where tags must answer
};

class Trust {
 public:
  explicit Trust(const TrustParameters& parameters) : parameters_(parameters) {}

  // A round of an estimate whose position is known to `sigma` (m, the larger axis). True when the estimate has just
  // lost all trust and must begin anew.
  bool follow(Agreement agreement, double sigma);
  // The estimate began anew.
  void begin() { agreements_ = contradictions_ = 0; }

  // At a time `since_round` (s) after the last round, with the position known to `sigma` (m) now.
  Placement placement(double sigma, double since_round) const;
  std::string reason(double sigma, double since_round) const;

 private:
  TrustParameters parameters_;
  bool placed_once_ = false;
  int agreements_ = 0;
  int contradictions_ = 0;
};

}  // namespace markservo::rfid_localizer
