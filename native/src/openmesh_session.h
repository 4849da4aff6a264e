// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <OpenMesh/Core/System/omstream.hh>

#include <mutex>

namespace dirichlet {

/// One at a time, and silent: OpenMesh's readers keep what they parse in process-wide objects, and its meshes complain
/// on process-wide streams, where a library has nothing to print. Holds both for as long as it lives.
class OpenMeshSession {
 public:
  OpenMeshSession() : lock_(mutex()), was_enabled_(omerr().is_enabled()) { omerr().disable(); }
  ~OpenMeshSession() {
    if (was_enabled_) omerr().enable();
  }
  OpenMeshSession(const OpenMeshSession&) = delete;
  OpenMeshSession& operator=(const OpenMeshSession&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }

  std::lock_guard<std::mutex> lock_;
  bool was_enabled_;
};

} // namespace dirichlet
