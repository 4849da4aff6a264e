// SPDX-License-Identifier: GPL-3.0-or-later
// NumPy arrays in and out. Types and layouts are exact here: the Python side converts and checks before it calls.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "dirichlet/array.h"

namespace dirichlet::bindings {

namespace py = pybind11;

template <class T>
using Array = py::array_t<T, py::array::c_style>;

template <class T>
std::span<const T> view(const Array<T>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Uses the array in place and keeps it alive; its owner may be dropped by any thread.
template <class T>
SharedArray<T> share(const Array<T>& array) {
  const auto release = [](py::object* object) {
    const py::gil_scoped_acquire gil;
    delete object;
  };
  return {view(array), std::shared_ptr<py::object>(new py::object(array), release)};
}

/// A new NumPy array of this shape that takes over the vector: no copy.
template <class T, class Allocator>
py::array to_numpy(std::vector<T, Allocator>&& values, std::vector<py::ssize_t> shape) {
  using Vector = std::vector<T, Allocator>;
  auto owner = std::make_unique<Vector>(std::move(values));
  const T* data = owner->data();
  const py::capsule capsule(owner.get(), [](void* pointer) { delete static_cast<Vector*>(pointer); });
  owner.release();
  return py::array(py::dtype::of<T>(), std::move(shape), data, capsule);
}

template <class T, class Allocator>
py::array to_numpy(std::vector<T, Allocator>&& values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return to_numpy(std::move(values), {size});
}

/// A read-only view of this shape into memory that `owner` keeps alive.
template <class T>
py::array view_of(std::span<const T> values, std::vector<py::ssize_t> shape, const py::handle& owner) {
  py::array array(py::dtype::of<T>(), std::move(shape), values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

} // namespace dirichlet::bindings
