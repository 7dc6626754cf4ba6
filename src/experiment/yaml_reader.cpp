#include "experiment/yaml_reader.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "core/error.hpp"

namespace facet {
namespace {

/// Builds the tree from parser events: unlike YAML::Node they show every key and every mark.
class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(std::string source, ConfigErrors& errors) : source_(std::move(source)), errors_(errors) {}

  ConfigValue take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    check_anchor(mark, anchor);
    ConfigValue value = make(ConfigValue::Kind::null, mark);
    // The mark of an absent value lies on the token that follows; its key is where the reader should look.
    if (!open_.empty() && open_.back().has_key) value.origin = open_.back().key_origin;
    place(std::move(value));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    errors_.add(at(mark), "aliases are not supported; use extends");
    place(make(ConfigValue::Kind::null, mark));
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& text) override {
    check_anchor(mark, anchor);
    check_tag(mark, tag);
    ConfigValue value = make(ConfigValue::Kind::scalar, mark);
    value.scalar = text;
    value.quoted = tag == "!";
    place(std::move(value));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(ConfigValue::Kind::list, mark, tag, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(ConfigValue::Kind::map, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    ConfigValue value;
    bool has_key = false;
    std::string key;
    Origin key_origin;
  };

  Origin at(const YAML::Mark& mark) const { return {source_, mark.line + 1, mark.column + 1}; }
  ConfigValue make(ConfigValue::Kind kind, const YAML::Mark& mark) const {
    ConfigValue value;
    value.kind = kind;
    value.origin = at(mark);
    return value;
  }
  void check_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor != 0) errors_.add(at(mark), "anchors are not supported; use extends");
  }
  void check_tag(const YAML::Mark& mark, const std::string& tag) {
    if (!tag.empty() && tag != "?" && tag != "!") errors_.add(at(mark), "tags are not supported: " + tag);
  }
  void open(ConfigValue::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    check_anchor(mark, anchor);
    check_tag(mark, tag);
    open_.push_back({make(kind, mark), false, {}, {}});
  }
  void close() {
    ConfigValue value = std::move(open_.back().value);
    open_.pop_back();
    place(std::move(value));
  }
  void place(ConfigValue value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (open_.back().value.is_list()) {
      open_.back().value.items.push_back(std::move(value));
    } else if (!open_.back().has_key) {
      take_key(value);
    } else {
      add_entry(std::move(value));
    }
  }
  void take_key(const ConfigValue& value) {
    if (!value.is_scalar()) errors_.add(value.origin, "a key must be plain text, got " + value.describe());
    open_.back().has_key = true;
    open_.back().key = value.scalar;
    open_.back().key_origin = value.origin;
  }
  void add_entry(ConfigValue value) {
    Open& map = open_.back();
    map.has_key = false;
    if (map.key == "<<") {
      errors_.add(map.key_origin, "merge keys (<<) are not supported; use extends");
    } else if (const ConfigEntry* first = map.value.find(map.key)) {
      errors_.add(map.key_origin, fmt::format("duplicate key \"{}\", first given at line {}", map.key,
                                              first->key_origin.line));
    } else {
      map.value.entries.push_back({map.key, map.key_origin, std::move(value)});
    }
  }

  std::string source_;
  ConfigErrors& errors_;
  std::vector<Open> open_;
  ConfigValue root_;
};

ConfigValue parse(std::istream& input, const std::string& source, ConfigErrors& errors) {
  try {
    YAML::Parser parser(input);
    TreeBuilder builder(source, errors);
    parser.HandleNextDocument(builder);
    ConfigValue root = builder.take_root();
    TreeBuilder rest(source, errors);
    if (parser.HandleNextDocument(rest))
      errors.add(rest.take_root().origin, "only one YAML document per file");
    if (root.origin.source.empty()) root.origin = {source, 1, 1};
    return root;
  } catch (const YAML::Exception& e) {
    throw Error(ErrorKind::config, fmt::format("{}:{}:{}: not valid YAML: {}", source, e.mark.line + 1,
                                               e.mark.column + 1, e.msg));
  }
}

}  // namespace

ConfigValue read_yaml_file(const std::filesystem::path& file, ConfigErrors& errors) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    throw Error(ErrorKind::config, file.string() + ": no such file");
  std::ifstream input(file, std::ios::binary);
  if (!input) throw Error(ErrorKind::config, file.string() + ": cannot be read");
  return parse(input, file.string(), errors);
}

ConfigValue read_yaml_text(const std::string& text, const std::string& source, ConfigErrors& errors) {
  std::istringstream input(text);
  ConfigValue value = parse(input, source, errors);
  return value;
}

}  // namespace facet
