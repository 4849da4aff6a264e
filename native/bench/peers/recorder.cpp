// SPDX-License-Identifier: GPL-3.0-or-later
#include "recorder.h"

#include <sys/resource.h>

#include <fstream>

namespace peers {

namespace {

/// Of /proc/self/status, in MB; Linux.
double status(const std::string& key) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
    if (double kilobytes = 0; word == key && file >> kilobytes) return kilobytes / 1024;
  return 0;
}

} // namespace

Times Times::now() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration<double>(since).count(),
          static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec)};
}

void Recorder::record(const char* stage, const Times& spent) {
  std::printf("{\"stage\": \"%s\", \"wall\": %.9g, \"user\": %.9g}\n", stage, spent.wall, spent.user);
  std::fflush(stdout);
}

void Recorder::state(const char* fact, double value) {
  std::printf("{\"fact\": \"%s\", \"value\": %.9g}\n", fact, value);
  std::fflush(stdout);
}

void Recorder::state(const char* fact, const std::string& value) {
  std::printf("{\"fact\": \"%s\", \"value\": \"%s\"}\n", fact, value.c_str());
  std::fflush(stdout);
}

Recorder::Memory::Memory() : before_(status("VmRSS:")) {
  std::ofstream("/proc/self/clear_refs") << '5';
}

double Recorder::Memory::peak() const {
  return status("VmHWM:") - before_;
}

} // namespace peers
