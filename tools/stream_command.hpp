#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

/// Adds `stream` to the program; where it was asked for it puts itself into `chosen`. `command` is the
/// command line as it was typed.
void add_stream_command(CLI::App& app, std::function<int()>& chosen, const std::vector<std::string>& command);
