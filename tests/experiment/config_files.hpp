#pragma once

#include <fstream>
#include <string>

#include "core/error.hpp"
#include "experiment/experiment_reader.hpp"
#include "support/temporary_folder.hpp"

namespace facet {

/// Configuration files that a test writes.
class ConfigFiles {
 public:
  std::string write(const std::string& name, const std::string& text) const {
    const auto file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
  }
  /// The message of the error that reading gives, empty where it gives none.
  std::string errors_of(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    try {
      load_experiment(write("exp.yaml", text), overrides);
      return {};
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::config);
      return e.what();
    }
  }
  std::string at(const std::string& name, const std::string& rest) const {
    return (folder_.path() / name).string() + ':' + rest;
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

}  // namespace facet
