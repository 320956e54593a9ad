#pragma once

// Whether the estimate may be believed: followed round by round, so that a robot that was carried away says so.

#include <string>

namespace markservo::rfid_localizer {

enum class Placement { kSearching, kLocalised, kLost };

struct TrustParameters {
  double lost = 5.0;            // of doubt, which each contradicting round raises by 1: half a second at 10 Hz
  double suspect = 3.0;         // of doubt; more is no place to drive by
  double usual_surprise = 1.2;  // standard deviations; a round with reads and less lowers the doubt; nine in ten have
  double surprise_scale = 2.0;  // standard deviations beyond the usual raise the doubt by 1, which is the most
  double unlikely = 0.01;       // a silent round of this probability raises the doubt by 1, which is the most
  double usual_silence = 0.2;   // a silent round of more probability says nothing
  double explained = 0.05;      // a read whose tag was inside the footprint with less probability is no confirmation
  int confirmations = 3;        // agreeing rounds with reads until a new place is believed
  double largest_sigma = 0.15;  // m, of the position: more is no place to drive by
  double silence = 2.0;         // s without any round: the reader is gone
};

// How a round looks to the estimate.
enum class Agreement {
  kAgrees,       // reads that the antenna can have reached
  kContradicts,  // only reads from elsewhere
};

class Trust {
 public:
  explicit Trust(const TrustParameters& parameters) : parameters_(parameters) {}

  // A round of an estimate whose position is known to `sigma` (m, the larger axis). `surprise` in standard deviations
  // (surprise.hpp) counts where the round agrees: reads that the antenna can have reached may still be the wrong ones,
  // as those of a robot that slipped aside. True when the estimate has lost all trust and
  // must be given up.
  bool follow(Agreement agreement, double surprise, double sigma);
  // A round without any read, which the estimate lets expect with `probability`. True as follow().
  bool follow_silence(double probability);
  // The estimate is given up; `why` stays the reason until another place finds agreement.
  void lose(const std::string& why);

  // At a time `since_round` (s) after the last round, with the position known to `sigma` (m) now.
  Placement placement(double sigma, double since_round) const;
  std::string reason(double sigma, double since_round) const;

 private:
  TrustParameters parameters_;
  bool placed_once_ = false;
  int agreements_ = 0;
  double doubt_ = 0.0;
  std::string why_lost_;
};

}  // namespace markservo::rfid_localizer
