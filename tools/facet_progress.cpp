#include "facet_progress.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

Progress::Progress(std::shared_ptr<spdlog::logger> log, bool enabled)
    : log_(std::move(log)), enabled_(enabled), bar_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  clear_bar();
}

void Progress::on_note(const std::string& text) {
  clear_bar();
  log_->info("{}", text);
}

void Progress::on_frame(const facet::FrameRow& row, std::size_t done, std::size_t planned) {
  if (row.status != facet::FrameStatus::ok) {
    clear_bar();
    log_->error("{}/{} ({}): {}", row.dataset, row.frame, row.method, row.reason);
  }
  log_->debug("{}/{} ({}): {} surfaces", row.dataset, row.frame, row.method, row.surfaces);
  show("frames", done, planned);
}

void Progress::on_step(const std::string& what, std::size_t done, std::size_t planned) {
  show(what, done, planned);
}

void Progress::on_written(std::size_t done, std::size_t planned) {
  show("frames written", done, planned);
}

void Progress::show(const std::string& what, std::size_t done, std::size_t planned) {
  if (!enabled_ || planned == 0) return;
  if (step_ != what) {
    step_ = what;
    lines_of_ten_ = 0;
  }
  if (bar_) {
    constexpr std::size_t width = 30;
    const std::size_t full = width * done / planned;
    fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}/{} {}\x1b[K", "", full, "", width - full, done, planned, what);
    std::fflush(stderr);
    drawn_ = true;
  } else if (10 * done / planned > lines_of_ten_) {
    lines_of_ten_ = 10 * done / planned;
    log_->info("{}: {} of {}", what, done, planned);
  }
}

void Progress::clear_bar() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}
