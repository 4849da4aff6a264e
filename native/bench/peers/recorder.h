// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace peers {

/// Seconds on the wall, and of the processor in all threads of this process.
struct Times {
  double wall = 0;
  double user = 0;

  static Times now();
  Times operator-(const Times& other) const { return {wall - other.wall, user - other.user}; }
};

/// Says what was measured, a line of JSON each, as soon as it is known: a peer that dies later has said the rest.
/// (dirichlet_bench/recorder.py is the same for Python.)
class Recorder {
 public:
  Recorder(int runs, double seconds) : runs_(runs), seconds_(seconds) {}

  /// Calls measure(i) for i = 0, 1, … up to the number of runs, or until this stage has used up its seconds.
  template <class F>
  void repeat(const F& measure) const {
    const Times start = Times::now();
    for (int i = 0; i < runs_ && (i == 0 || (Times::now() - start).wall < seconds_); ++i) measure(i);
  }

  /// What the work took, which is recorded as a run of that stage.
  template <class F>
  Times time(const char* stage, const F& work) const {
    const Times start = Times::now();
    work();
    const Times spent = Times::now() - start;
    record(stage, spent);
    return spent;
  }

  static void record(const char* stage, const Times& spent);
  static void state(const char* fact, double value);
  static void state(const char* fact, const std::string& value);

  /// The highest memory of the process over what it is now, in MB: forget(), work, peak(). Linux.
  class Memory {
   public:
    Memory();
    [[nodiscard]] double peak() const;

   private:
    double before_;
  };

 private:
  int runs_;
  double seconds_;
};

} // namespace peers
