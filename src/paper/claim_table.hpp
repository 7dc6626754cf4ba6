#pragma once

#include <string>

#include "paper/reproduction.hpp"

namespace facet {

enum class Verdict { holds, does_not, not_measured };

/// One numeric claim of the paper beside what we measured.
struct Claim {
  std::string claim, paper, ours;
  Verdict verdict = Verdict::not_measured;
  std::string definition;
  bool is_time = false;  ///< differs from machine to machine
};

/// The claims of the abstract and of sections 5 and 6.
class ClaimTable {
 public:
  void add(const Claim& claim);
  void add_missing(const std::string& claim, const std::string& paper, const std::string& reason,
                   const std::string& definition);
  Reproduced take(bool full);

 private:
  ReportTable table_{"Numeric claims of the paper",
                     {"claim", "paper, other data", "ours [95 % interval]", "verdict", "definition"},
                     {},
                     {},
                     {}};
  ReportTable exact_ = table_;
  bool measured_ = true;
};

/// "92.4 % [90.1, 94.0]" of shares.
std::string percent_with_interval(double share, double lo, double hi);

}  // namespace facet
