#pragma once

#include <CLI/CLI.hpp>
#include <functional>

/// Adds `report` and `gallery` to the program. The one that was asked for puts itself into `chosen`, to be
/// called for its exit code.
void add_report_commands(CLI::App& app, std::function<int()>& chosen);
