#include "paper/claim_table.hpp"

#include <array>
#include <fmt/format.h>

namespace facet {

void ClaimTable::add(const Claim& claim) {
  constexpr std::array<const char*, 3> words{"holds", "does not", "not measured"};
  std::vector<std::string> row{claim.claim, claim.paper, claim.ours,
                               words[static_cast<std::size_t>(claim.verdict)], claim.definition};
  if (!claim.is_time) exact_.rows.push_back(row);
  table_.rows.push_back(std::move(row));
}

void ClaimTable::add_missing(const std::string& claim, const std::string& paper, const std::string& reason,
                             const std::string& definition) {
  add({claim, paper, "n/a: " + reason, Verdict::not_measured, definition});
  measured_ = false;
}

Reproduced ClaimTable::take(bool full) {
  table_.notes = {
      "The default method on built-in data. A claim holds or does not by the definition beside it; the "
      "paper's data "
      "are not ours, and its column decides nothing but what the verdict is held against."};
  if (!full)
    table_.notes.push_back("Few scenes per level: intervals of invariances are wide. --full runs them all.");
  Reproduced result;
  result.section.title = "Claims";
  result.section.tables = {std::move(table_)};
  result.exact = {std::move(exact_)};
  result.is_measured = measured_;
  return result;
}

std::string percent_with_interval(double share, double lo, double hi) {
  return fmt::format("{:.1f} % [{:.1f}, {:.1f}]", 100 * share, 100 * lo, 100 * hi);
}

}  // namespace facet
