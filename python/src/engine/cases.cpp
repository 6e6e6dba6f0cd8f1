#include "engine/cases.h"

#include <array>
#include <cmath>

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

void refuse_stretching(const EngineModel& model, const CaseInput& q, const CaseShape& cases) {
  // Of the square of the length: numbers of single precision, and those of many small steps, are nearer.
  constexpr double one_to = 1e-6;
  for (const int row : model.quaternions) {
    const double* const numbers = q.array.data() + static_cast<std::size_t>(row) * cases.count;
    const auto square = [&](std::size_t k) {
      double sum = 0;
      for (std::size_t i = 0; i < 4; ++i) sum += numbers[i * cases.count + k] * numbers[i * cases.count + k];
      return sum;
    };
    double worst = 0;
    for (std::size_t k = 0; k < cases.count; ++k) worst = std::max(worst, std::fabs(square(k) - 1));
    if (!(worst > one_to)) continue;
    std::size_t at = 0;
    while (!(std::fabs(square(at) - 1) > one_to)) ++at;
    const std::span<const Body<double>> bodies = model.numbers.bodies();
    const auto body = std::ranges::find_if(bodies, [&](const Body<double>& one) {
      return one.q == row && (one.joint == JointType::ball || one.joint == JointType::free);
    });
    const std::string& name = model.numbers.names()[static_cast<std::size_t>(body - bodies.begin())];
    throw nb::value_error(("the quaternion of '" + name + "', q[" + std::to_string(row) + "] to q[" +
                           std::to_string(row + 3) + "], has the length " + std::to_string(std::sqrt(square(at))) +
                           (cases.single ? "" : " in case " + std::to_string(at)) +
                           " and not 1: divide it by this, or take positions from neutral() and integrate()")
                              .c_str());
  }
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
    : model_(model), inputs_(inputs), cases_(cases), memory_(model.take_memory()) {
  std::size_t rows = results;
  for (const CaseInput& input : inputs) rows += static_cast<std::size_t>(input.rows);
  // Bytes: a quarter of what a core has for itself, as the numbers on the way from a case to its result need some, too.
  constexpr std::size_t memory = std::size_t{1} << 18;
  packs_ = std::clamp<std::size_t>(memory / (sizeof(CasePack) * rows), 1, 64);
  packs_ = std::min(packs_, (cases + pack_width - 1) / pack_width);
  while (memory_->packs.size() < packs_) memory_->packs.emplace_back(model.packs);
  for (std::size_t k = 0; k < packs_; ++k) memory_->packs[k].found.assign(results, CasePack(0));
}

void CaseTile::read(std::size_t first_pack, std::size_t last_pack) {
  first_ = first_pack;
  held_ = last_pack - first_pack;
  // The last pack may be filled in part.
  const std::size_t whole = std::min(held_, cases_ / pack_width - std::min(cases_ / pack_width, first_));
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    for (std::size_t row = 0; row < static_cast<std::size_t>(inputs_[i].rows); ++row) {
      const double* const all = inputs_[i].array.data() + row * cases_;
      const double* const from = all + first_ * pack_width;
      const auto number = [&](std::size_t k) -> CasePack& { return memory_->packs[k].input(static_cast<int>(i))[row]; };
      for (std::size_t k = 0; k < whole; ++k)
        number(k) = CasePack(CasePack::Lanes(from + k * pack_width, std::experimental::element_aligned));
      for (std::size_t k = whole; k < held_; ++k)
        number(k) = CasePack::from_lanes([&](int lane) {
          return all[std::min((first_ + k) * pack_width + static_cast<std::size_t>(lane), cases_ - 1)];
        });
    }
}

void CaseTile::write(double* out) const {
  const std::size_t results = memory_->packs.front().found.size();
  for (std::size_t row = 0; row < results; ++row)
    for (std::size_t k = 0; k < held_; ++k) {
      const CasePack& number = memory_->packs[k].found[row];
      const std::size_t at = (first_ + k) * pack_width;
      double* const to = out + row * cases_ + at;
      if (at + pack_width <= cases_)
        number.lanes().copy_to(to, std::experimental::element_aligned);
      else
        for (std::size_t lane = 0; at + lane < cases_; ++lane) to[lane] = number.lane(static_cast<int>(lane));
    }
}

}  // namespace poinsot::python
