// Arrays of NumPy that own their numbers.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <utility>
#include <vector>

namespace poinsot::python {

// One row of `components` for each number of them; one dimension for 0 components.
template <class Number>
nanobind::ndarray<nanobind::numpy, Number> owned_array(std::vector<Number> numbers, std::size_t components = 0) {
  auto* const kept = new std::vector<Number>(std::move(numbers));
  const nanobind::capsule owner(kept,
                                [](void* pointer) noexcept { delete static_cast<std::vector<Number>*>(pointer); });
  const std::size_t shape[2] = {components == 0 ? kept->size() : kept->size() / components, components};
  return nanobind::ndarray<nanobind::numpy, Number>(kept->data(), components == 0 ? 1 : 2, shape, owner);
}

}  // namespace poinsot::python
