#pragma once

#include <cstddef>
#include <memory>
#include <spdlog/logger.h>
#include <string>

#include "experiment/run_observer.hpp"

/// Reports how a run goes on to stderr: a bar on a terminal, plain lines elsewhere.
class Progress final : public facet::RunObserver {
 public:
  Progress(std::shared_ptr<spdlog::logger> log, bool enabled);
  ~Progress() override;
  void on_note(const std::string& text) override;
  void on_frame(const facet::FrameRow& row, std::size_t done, std::size_t planned) override;
  void on_step(const std::string& what, std::size_t done, std::size_t planned) override;
  void on_written(std::size_t done, std::size_t planned);  ///< frames of a synthetic benchmark
  void clear_bar();

 private:
  void show(const std::string& what, std::size_t done, std::size_t planned);

  std::shared_ptr<spdlog::logger> log_;
  bool enabled_;
  bool bar_;
  bool drawn_ = false;
  std::size_t lines_of_ten_ = 0;  ///< plain lines written for the present step, one per tenth of it
  std::string step_;
};
