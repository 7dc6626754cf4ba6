#include "dataset/reader_options.hpp"

#include <cmath>

#include "core/error.hpp"
#include "dataset/text_table.hpp"

namespace facet {
namespace {

[[noreturn]] void fail(std::string_view name, const std::string& expected, const std::string& text) {
  throw Error(ErrorKind::config,
              "option " + std::string(name) + ": expected " + expected + ", got '" + text + "'");
}

std::optional<double> parse_number(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return finite_number(text);
}

void check_type(const ReaderOptions& options, const OptionInfo& option) {
  switch (option.type) {
    case OptionType::text:
      return;
    case OptionType::number:
      static_cast<void>(number_option(options, option.name));
      return;
    case OptionType::flag:
      static_cast<void>(flag_option(options, option.name));
      return;
    case OptionType::numbers:
      static_cast<void>(numbers_option(options, option.name));
      return;
  }
}

}  // namespace

void check_options(const ReaderOptions& options, std::span<const OptionInfo> known,
                   const std::string& context) {
  for (const auto& [name, text] : options) {
    const OptionInfo* found = nullptr;
    std::string names;
    for (const OptionInfo& option : known) {
      if (option.name == name) found = &option;
      names += (names.empty() ? "" : ", ") + std::string(option.name);
    }
    if (!found) throw Error(ErrorKind::config, context + ": unknown option '" + name + "'; known: " + names);
    try {
      check_type(options, *found);
    } catch (const Error& e) {
      throw Error(e.kind(), context + ": " + e.what());
    }
  }
}

std::optional<std::string> text_option(const ReaderOptions& options, std::string_view name) {
  const auto found = options.find(name);
  return found == options.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> number_option(const ReaderOptions& options, std::string_view name) {
  const auto text = text_option(options, name);
  if (!text) return std::nullopt;
  const auto value = parse_number(*text);
  if (!value) fail(name, "a number", *text);
  return value;
}

std::optional<std::uint64_t> seed_option(const ReaderOptions& options) {
  constexpr double largest = 9007199254740992.0;  // 2^53: every integer up to here is a double
  const auto seed = number_option(options, "seed");
  if (!seed) return std::nullopt;
  if (*seed < 0 || *seed > largest || *seed != std::floor(*seed))
    throw Error(ErrorKind::config, "option seed: expected a whole number from 0 to 2^53");
  return static_cast<std::uint64_t>(*seed);
}

std::optional<bool> flag_option(const ReaderOptions& options, std::string_view name) {
  const auto text = text_option(options, name);
  if (!text) return std::nullopt;
  if (*text != "true" && *text != "false") fail(name, "true or false", *text);
  return *text == "true";
}

std::optional<std::vector<double>> numbers_option(const ReaderOptions& options, std::string_view name) {
  const auto text = text_option(options, name);
  if (!text) return std::nullopt;
  std::vector<double> values;
  if (text->empty()) return values;
  for (std::size_t begin = 0; begin <= text->size();) {
    const std::size_t end = std::min(text->find(',', begin), text->size());
    const auto value = parse_number(std::string_view(*text).substr(begin, end - begin));
    if (!value) fail(name, "a list of numbers", *text);
    values.push_back(*value);
    begin = end + 1;
  }
  return values;
}

}  // namespace facet
