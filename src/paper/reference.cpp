#include "paper/reference.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

void compare_tables(const std::string& target, const ReportTable& expected, const ReportTable& found,
                    std::vector<std::string>& differences) {
  if (expected.header != found.header || expected.rows.size() != found.rows.size())
    return differences.push_back(
        fmt::format("{}: {}: other rows or columns than the reference", target, expected.caption));
  for (std::size_t r = 0; r < expected.rows.size(); ++r)
    for (std::size_t c = 0; c < expected.rows[r].size(); ++c)
      if (c >= found.rows[r].size() || expected.rows[r][c] != found.rows[r][c])
        differences.push_back(fmt::format("{}: {}: {}, {}: {} where the reference has {}", target,
                                          expected.caption, expected.rows[r][0], expected.header[c],
                                          c < found.rows[r].size() ? found.rows[r][c] : "nothing",
                                          expected.rows[r][c]));
}

}  // namespace

std::string to_json(const ReferenceTables& tables) {
  Json json{{"schema_version", 1}, {"targets", Json::object()}};
  for (const auto& [target, list] : tables) {
    json["targets"][target] = Json::array();
    for (const ReportTable& table : list)
      json["targets"][target].push_back(
          {{"caption", table.caption}, {"header", table.header}, {"rows", table.rows}});
  }
  return json.dump(1) + '\n';
}

ReferenceTables read_reference(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw Error(ErrorKind::not_measured, printable(file) + ": there is no reference to compare with");
  ReferenceTables tables;
  try {
    const auto bytes = read_file_bytes(file);
    const Json json = Json::parse(bytes.begin(), bytes.end());
    for (const auto& [target, list] : json.at("targets").items())
      for (const Json& entry : list) {
        ReportTable& table = tables[target].emplace_back();
        entry.at("caption").get_to(table.caption);
        entry.at("header").get_to(table.header);
        entry.at("rows").get_to(table.rows);
      }
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, printable(file) + ": no reference: " + e.what());
  }
  return tables;
}

std::vector<std::string> differences_from(const ReferenceTables& reference, const ReferenceTables& tables) {
  std::vector<std::string> differences;
  for (const auto& [target, list] : tables) {
    const auto found = reference.find(target);
    if (found == reference.end() || found->second.size() != list.size()) {
      differences.push_back(target + ": the reference does not have its tables");
      continue;
    }
    for (std::size_t i = 0; i < list.size(); ++i)
      compare_tables(target, found->second[i], list[i], differences);
  }
  return differences;
}

}  // namespace facet
