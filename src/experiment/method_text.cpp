#include "experiment/method_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/typed_value.hpp"
#include "method/method_fields.hpp"
#include "method/registry.hpp"

namespace facet {
namespace {

std::string yields_text(const MethodKind& kind, const MethodSpec& spec) {
  const auto yields = kind.yields(spec);
  if (!yields) return "what they contain";
  std::vector<std::string> parts;
  if (yields->regions) parts.emplace_back("regions");
  if (yields->edges) parts.emplace_back("edges");
  if (yields->poses) parts.emplace_back("poses");
  if (yields->grasps) parts.emplace_back("grasps");
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Lines of a card, the names of its rows in a column of their own.
class Card {
 public:
  void row(std::string_view name, const std::string& text) {
    if (!text.empty()) text_ += fmt::format("  {:<12} {}\n", name, text);
  }
  template <class T>
  void parameter(std::string_view key, const T& value, const FieldInfo& info) {
    const std::string given = fmt::format("{} = {}", key, spell(value));
    row(first_ ? "parameters" : "", fmt::format("{:<26} {}; {}", given, expectation<T>(info), info.doc));
    first_ = false;
  }
  std::string text_;

 private:
  bool first_ = true;
};

void add_parameters(const MethodSpec& spec, Card& card) {
  if (spec.kind != "pipeline")
    return visit_method_fields(spec, [&](std::string_view key, const auto& value, const FieldInfo& info) {
      card.parameter(key, value, info);
    });
  int count = 0;
  visit_fields(spec.params, [&count](std::string_view, const auto&, const FieldInfo&) { ++count; });
  card.row("parameters", fmt::format("{}, listed in configs/default.yaml", count));
}

}  // namespace

std::string describe_methods() {
  std::string text;
  for (const MethodKind& kind : method_kinds()) {
    MethodSpec spec;
    spec.kind = kind.name;
    Card card;
    card.text_ = fmt::format("{}{}: {}\n", text.empty() ? "" : "\n", kind.name, kind.doc);
    card.row("yields", yields_text(kind, spec));
    card.row("folder", std::string(kind.folder));
    add_parameters(spec, card);
    card.row("source", std::string(kind.source));
    card.row("licence", std::string(kind.licence));
    card.row("absent", std::string(kind.absent));
    text += card.text_;
  }
  return text;
}

}  // namespace facet
