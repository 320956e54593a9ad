#pragma once

// What a campaign found: one result a seed, and the totals.

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/system/fault_campaign/invariants.hpp"

namespace markservo::campaign {

// `trial` as fault-trial leaves it, with what its history shows: "broken", "judged" and "breaches" by invariant.
nlohmann::json result_of(nlohmann::json trial, const std::map<std::string, Verdict>& verdicts);

// Whether the phase was reached and each fault struck something.
bool proves_what_it_should(const nlohmann::json& result);
// Whether one of I1 to I6 and I12 broke: such a seed is not drawn again, whatever its faults did.
bool breaks_what_may_never_break(const nlohmann::json& result);

// {"commit", "seeds": [...], "totals": {"I1": {"judged", "broken"}, ...}}: how often each invariant was judged and in
// how many seeds it broke.
nlohmann::json campaign_of(const std::string& commit, const std::vector<nlohmann::json>& results);

// Whether the bars are met: I1 to I6 and I12 broken in no seed, I7 to I11 each in at most `most`. A seed whose phase
// was never reached or whose fault never struck proves nothing and misses them. A breach of I1 to I6 or I12 in a draw
// that proved nothing counts all the same.
bool bars_met(const nlohmann::json& campaign, int most);

std::string table_of(const nlohmann::json& campaign);
std::string line_of(const nlohmann::json& result);

}  // namespace markservo::campaign
