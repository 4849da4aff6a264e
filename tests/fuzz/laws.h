// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "problem.h"

namespace dirichlet::fuzz {

// What has to hold whatever comes in. A law that is broken says which, and ends the run like a crash does.

/// Runs the body, which may refuse what it was given: by a DirichletError of one printable sentence, nothing else.
void expect_result_or_refusal(const std::function<void()>& body);

/// Painted values bit for bit; NaN on pieces without paint, and nowhere else; without a source in the painted range of
/// every piece, or no farther outside than the report says where the operator does not promise it.
void expect_lawful_field(const Mesh& mesh, const Problem& problem, const Field& field);

} // namespace dirichlet::fuzz
