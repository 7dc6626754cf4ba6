#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace facet {

/// Collects everything that is wrong with a YAML file, each with file:line:col, and throws it at once.
class SpecProblems {
 public:
  explicit SpecProblems(std::filesystem::path file) : file_(std::move(file)) {}
  /// `at` gives the place; one without a place (a missing key) is reported at line 1.
  void add(const YAML::Node& at, const std::string& path, const std::string& rule);
  /// Throws Error{config} with all problems, one per line, where there are any.
  void throw_if_any() const;

 private:
  std::filesystem::path file_;
  std::vector<std::string> lines_;
};

/// Reads the keys of one YAML map into variables; whatever has no reader is an unknown key.
class MapReader {
 public:
  MapReader(YAML::Node map, std::string path, SpecProblems& problems);

  void number(const char* key, double low, double high, const std::function<void(double)>& set);
  void integer(const char* key, double low, double high, const std::function<void(long long)>& set);
  void flag(const char* key, const std::function<void(bool)>& set);
  void text(const char* key, const std::function<void(const std::string&)>& set);
  /// One of the names; the others are listed in the problem.
  void choice(const char* key, const std::vector<std::string>& names,
              const std::function<void(std::size_t)>& set);
  void numbers(const char* key, double low, double high,
               const std::function<void(const std::vector<double>&)>& set);
  void map(const char* key, const std::function<void(MapReader&)>& read);
  void maps(const char* key, const std::function<void(MapReader&)>& read);
  void required(const char* key);
  /// Reports unknown and repeated keys; call it last.
  void finish();
  void problem(const char* key, const std::string& rule);

 private:
  YAML::Node find(const char* key);
  bool read_number(const YAML::Node& node, const std::string& key, double low, double high, double& out);

  YAML::Node map_;
  std::string path_;
  SpecProblems& problems_;
  std::vector<std::string> known_;
};

}  // namespace facet
