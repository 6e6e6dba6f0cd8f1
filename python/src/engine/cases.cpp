#include "engine/cases.h"

#include <cstring>

namespace nb = nanobind;

namespace poinsot::python {
namespace {

// A function of NumPy. It is never let go: it would outlive the interpreter.
nb::handle numpy_function(const char* name) { return nb::object(nb::module_::import_("numpy").attr(name)).release(); }

}  // namespace

CaseArray::CaseArray(nb::handle array) {
  if (read(array)) return;
  static const nb::handle ascontiguousarray = numpy_function("ascontiguousarray");
  const nb::object doubles = ascontiguousarray(array, nb::str("f8"));
  if (!read(doubles)) throw nb::type_error("expected an array of numbers");
}

// Whether it is an array of doubles in C's order; then the view holds it.
bool CaseArray::read(nb::handle array) {
  if (PyObject_GetBuffer(array.ptr(), &view_, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT) != 0) {
    PyErr_Clear();
    view_.obj = nullptr;
    return false;
  }
  if (view_.format != nullptr && std::strcmp(view_.format, "d") == 0) return true;
  PyBuffer_Release(&view_);
  return false;
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
  static const nb::handle empty = numpy_function("empty");
  nb::list sizes;
  for (const std::size_t size : shape) sizes.append(size);
  if (!cases.single) sizes.append(cases.count);
  ResultArray result{{nb::object(empty(nb::tuple(sizes)))}, nullptr};
  Py_buffer view;
  if (PyObject_GetBuffer(result.array.object.ptr(), &view, PyBUF_WRITABLE | PyBUF_C_CONTIGUOUS) != 0)
    throw nb::python_error();
  // The array holds its memory as long as it lives, whoever looks at it.
  result.data = static_cast<double*>(view.buf);
  PyBuffer_Release(&view);
  return result;
}

CaseTile::CaseTile(const EngineModel& model, CaseInputs inputs, std::size_t cases, std::size_t results)
    : inputs_(inputs), cases_(cases), case_(model.packs) {
  for (const CaseInput& input : inputs) rows_ += static_cast<std::size_t>(input.rows);
  constexpr std::size_t memory = std::size_t{1} << 20;  // bytes, about what a core has for itself
  packs_ = std::clamp<std::size_t>(memory / (sizeof(CasePack) * (rows_ + results)), 1, 64);
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
