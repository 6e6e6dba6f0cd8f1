#include "engine/cases.h"

#include <array>

#include "engine/bindings.h"

// Only this file speaks to NumPy, with what all its versions from 1.24 on understand.
#define NPY_NO_DEPRECATED_API NPY_1_24_API_VERSION
#define NPY_TARGET_VERSION NPY_1_24_API_VERSION
#include <numpy/arrayobject.h>

namespace nb = nanobind;

namespace poinsot::python {
namespace {

PyArrayObject* as_array(nb::handle object) { return reinterpret_cast<PyArrayObject*>(object.ptr()); }

bool is_of_doubles(nb::handle object) {
  return PyArray_Check(object.ptr()) && PyArray_TYPE(as_array(object)) == NPY_DOUBLE &&
         PyArray_ISCARRAY_RO(as_array(object));
}

}  // namespace

void load_numpy() {
  if (_import_array() < 0) throw nb::python_error();
}

CaseArray::CaseArray(nb::handle array) : array_(nb::borrow(array)) {
  if (!is_of_doubles(array)) {
    array_ = nb::steal(PyArray_FROM_OTF(array.ptr(), NPY_DOUBLE, NPY_ARRAY_CARRAY_RO));
    if (!array_.is_valid()) throw nb::python_error();
  }
  ndim_ = static_cast<std::size_t>(PyArray_NDIM(as_array(array_)));
  shape_ = PyArray_DIMS(as_array(array_));
  data_ = static_cast<const double*>(PyArray_DATA(as_array(array_)));
}

CaseShape case_shape(CaseInputs inputs) {
  CaseShape cases;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const CaseArray& array = inputs[i].array;
    const int rows = inputs[i].rows;
    const auto refuse = [&](const std::string& why) {
      throw nb::value_error((std::string(inputs[i].name) + " " + why).c_str());
    };
    if (array.ndim() != 1 && array.ndim() != 2)
      refuse("is an array of " + std::to_string(array.ndim()) +
             " dimensions: expected one number for each coordinate, "
             "or a row for each with a column for each case");
    if (array.shape(0) != static_cast<std::size_t>(rows))
      refuse("has " + std::to_string(array.shape(0)) + " rows, the model needs " + std::to_string(rows));
    const bool single = array.ndim() == 1;
    const std::size_t count = single ? 1 : array.shape(1);
    if (i > 0 && (single != cases.single || count != cases.count))
      refuse("is of " + std::to_string(count) + " cases, " + inputs[0].name + " of " + std::to_string(cases.count));
    cases = {count, single};
  }
  return cases;
}

ResultArray new_result(const std::vector<std::size_t>& shape, const CaseShape& cases) {
  std::array<npy_intp, 4> sizes{};
  std::size_t count = 0;
  for (const std::size_t size : shape) sizes.at(count++) = static_cast<npy_intp>(size);
  if (!cases.single) sizes.at(count++) = static_cast<npy_intp>(cases.count);
  ResultArray result{{nb::steal(PyArray_SimpleNew(static_cast<int>(count), sizes.data(), NPY_DOUBLE))}, nullptr};
  if (!result.array.object.is_valid()) throw nb::python_error();
  result.data = static_cast<double*>(PyArray_DATA(as_array(result.array.object)));
  return result;
}

CaseTile::CaseTile(const EngineModel& model, CaseInputs inputs, std::size_t cases, std::size_t results)
    : inputs_(inputs), cases_(cases), case_(model.packs) {
  for (const CaseInput& input : inputs) rows_ += static_cast<std::size_t>(input.rows);
  // Bytes: a quarter of what a core has for itself, as the numbers on the way from a case to its result need some, too.
  constexpr std::size_t memory = std::size_t{1} << 18;
  // An odd number: rows that lie a power of two apart would share few places of the nearest memory.
  packs_ = (std::clamp<std::size_t>(memory / (sizeof(CasePack) * (rows_ + results)), 1, 64) - 1) | 1;
  in_.resize(rows_ * width());
  out_.resize(results * width());
  case_.found.resize(results);
}

void CaseTile::read(std::size_t first_pack, std::size_t last_pack) {
  first_ = first_pack * pack_width;
  held_ = (last_pack - first_pack) * pack_width;
  const std::size_t there = std::min(held_, cases_ - first_);
  double* to = in_.data();
  for (const CaseInput& input : inputs_)
    for (int row = 0; row < input.rows; ++row, to += width()) {
      const double* const from = input.array.data() + static_cast<std::size_t>(row) * cases_ + first_;
      std::copy_n(from, there, to);
      std::fill(to + there, to + held_, from[there - 1]);
    }
}

void CaseTile::write(double* out) const {
  const std::size_t there = std::min(held_, cases_ - first_);
  for (std::size_t row = 0; row < case_.found.size(); ++row)
    std::copy_n(out_.data() + row * width(), there, out + row * cases_ + first_);
}

}  // namespace poinsot::python
