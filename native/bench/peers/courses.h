// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "direct_peer.h"
#include "recorder.h"

namespace peers {

using MakePeer = std::function<std::unique_ptr<DirectPeer>(const SparseMatrix& lower)>; ///< the matrix to come

/// Every task of the benchmark that a sparse Cholesky takes part in, on the scene of that folder; the field of the
/// first painting goes into the file `field`.
void run_direct_course(const MakePeer& make, const std::filesystem::path& scene, const std::filesystem::path& field,
                       const Recorder& recorder);

/// That field, by refinement with residuals in extended precision: what the others' errors are measured against.
void run_reference_course(const MakePeer& make, const std::filesystem::path& scene, const std::filesystem::path& field);

/// OpenMesh: half-edges from arrays, face by face.
void run_openmesh_course(const std::filesystem::path& scene, const Recorder& recorder);

} // namespace peers
