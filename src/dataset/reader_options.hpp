#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// What a reader's option holds; in YAML a scalar, or for `numbers` a list.
enum class OptionType { text, number, flag, numbers };

/// One option of a reader.
struct OptionInfo {
  std::string_view name;
  OptionType type;
  std::string_view doc;  ///< one line: meaning, unit, what holds without it
};

/// Options as text, by name: a scalar as it stands in YAML, the items of a list joined by commas
/// ("525,525,319.5").
using ReaderOptions = std::map<std::string, std::string, std::less<>>;

/// Throws Error{config} where an option is unknown or its text is not of its type. `context` opens the
/// message.
void check_options(const ReaderOptions& options, std::span<const OptionInfo> known,
                   const std::string& context);

/// The value of an option, nothing where it is absent. Throw Error{config} where the text is of another type.
std::optional<std::string> text_option(const ReaderOptions& options, std::string_view name);
std::optional<double> number_option(const ReaderOptions& options, std::string_view name);
/// The number of the option `seed`, a whole one.
std::optional<std::uint64_t> seed_option(const ReaderOptions& options);
std::optional<bool> flag_option(const ReaderOptions& options, std::string_view name);
std::optional<std::vector<double>> numbers_option(const ReaderOptions& options, std::string_view name);

}  // namespace facet
