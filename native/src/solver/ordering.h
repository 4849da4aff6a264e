// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <thread>
#include <vector>

#include "dirichlet/array.h"
#include "dirichlet/cancel.h"

namespace dirichlet {

/// An elimination order of a symmetric graph that keeps the Cholesky factor of its matrices small: nested dissection
/// (George 1973; Karypis & Kumar 1998), made for surface meshes but correct for any graph.
///
/// `offsets` (n + 1,) and `neighbours` are the rows of the matrix's pattern, which must be symmetric; entries of the
/// diagonal are skipped, and rows need not be sorted. order[k] is the vertex eliminated k-th. The result depends on the
/// graph alone, not on the number of threads, of which there are at most about `threads`.
///
/// Cost: for meshes O(n) time but for what is near to divisions, about three times the memory of the graph.
std::vector<Index> fill_reducing_order(std::span<const Index> offsets, std::span<const Index> neighbours,
                                       unsigned threads = std::thread::hardware_concurrency(),
                                       const CancelToken& cancel = {});

/// The same by approximate minimum degree (Amestoy, Davis & Duff 1996): quicker, and as good on most small surfaces;
/// but regular ones may take three times the operations, and more if they are renumbered. On one thread; cost, for
/// meshes: about O(n log n).
std::vector<Index> minimum_degree_order(std::span<const Index> offsets, std::span<const Index> neighbours);

} // namespace dirichlet
