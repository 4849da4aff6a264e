// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace dirichlet {

/// The one family of errors this library throws. Every message is one sentence that names what is wrong and where
/// (vertex, face, file line …), and how many more there are. The same classes exist in Python under the same names.
class DirichletError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An argument or a file is not what it has to be: wrong length, index out of range, number that is not finite.
class InputError : public DirichletError {
 public:
  using DirichletError::DirichletError;
};

/// The pieces are valid but cannot form what was asked for: a face that names a vertex twice, a polygon that cannot be
/// triangulated.
class TopologyError : public DirichletError {
 public:
  using DirichletError::DirichletError;
};

/// The linear system could not be solved to the promised residual.
class SolverError : public DirichletError {
 public:
  using DirichletError::DirichletError;
};

/// Somebody asked for the work to stop: see CancelToken.
class CancelledError : public SolverError {
 public:
  using SolverError::SolverError;
};

} // namespace dirichlet
