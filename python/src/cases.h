// Many states of one model at once: arrays of NumPy whose rows are coordinates and whose columns are cases (structures
// of arrays), read and written in place. Cases go through the algorithms in packs, and packs over threads; the numbers
// of a case are the same bits whatever the number of threads.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/workspace.h"
#include "poinsot/engine/math/algebra/pack.h"
#include "poinsot/engine/model/model.h"
#include "poinsot/engine/model/state.h"

namespace poinsot::python {

inline constexpr int pack_width = 4;
using CasePack = Pack<pack_width>;

// A model with what its algorithms need over numbers and over packs.
struct EngineModel {
  explicit EngineModel(Model<double> one) : numbers(std::move(one)), packs(convert<CasePack>(numbers)) {}

  Model<double> numbers;
  Model<CasePack> packs;

  template <class Scalar>
  const Model<Scalar>& over() const {
    if constexpr (std::is_same_v<Scalar, double>) {
      return numbers;
    } else {
      return packs;
    }
  }
};

// What comes in: one state (one dimension), or a column for each case (two).
using CaseArray = nanobind::ndarray<const double, nanobind::c_contig, nanobind::device::cpu>;
using ResultArray = nanobind::ndarray<nanobind::numpy, double>;

struct CaseInput {
  const char* name;
  const CaseArray& array;
  int rows;
};

// The memory for one case or pack: its state, a further input by coordinates, and what is found.
template <class Scalar>
struct Case {
  explicit Case(const Model<Scalar>& model, std::size_t results)
      : workspace(model), state(neutral_state(model)), given(model.velocity_size()), found(results) {}

  Workspace<Scalar> workspace;
  State<Scalar> state;
  std::vector<Scalar> given;
  std::vector<Scalar> found;

  std::vector<Scalar>& input(int which) { return which == 0 ? state.q : which == 1 ? state.v : given; }
};

// The number of cases, 1 for a single state; checks that the inputs agree and fit the model.
struct CaseShape {
  std::size_t count = 1;
  bool single = true;
};
CaseShape case_shape(const std::vector<CaseInput>& inputs);

// A new array: `shape` for a single state, with a last dimension of the cases for several.
ResultArray new_result(std::vector<std::size_t> shape, const CaseShape& cases);

// Runs work(model, case) for every case, with its inputs in place, in the order q, v, given; and writes what is found.
template <class Work>
ResultArray for_cases(const EngineModel& model, const std::vector<CaseInput>& inputs, std::vector<std::size_t> shape,
                      int threads, const Work& work) {
  const CaseShape cases = case_shape(inputs);
  std::size_t results = 1;
  for (const std::size_t size : shape) results *= size;
  ResultArray result = new_result(std::move(shape), cases);
  double* const out = result.data();
  const nanobind::gil_scoped_release released;

  if (cases.single) {
    Case<double> one(model.numbers, results);
    for (std::size_t i = 0; i < inputs.size(); ++i)
      std::copy_n(inputs[i].array.data(), inputs[i].rows, one.input(static_cast<int>(i)).begin());
    work(model.numbers, one);
    std::ranges::copy(one.found, out);
    return result;
  }

  // One thread's cases: whole packs, whose last one repeats the last case.
  const auto run = [&](std::size_t first_pack, std::size_t last_pack) {
    Case<CasePack> one(model.packs, results);
    for (std::size_t pack = first_pack; pack < last_pack; ++pack) {
      const std::size_t start = pack * pack_width;
      const auto column = [&](int lane) { return std::min(start + static_cast<std::size_t>(lane), cases.count - 1); };
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        std::vector<CasePack>& to = one.input(static_cast<int>(i));
        for (std::size_t row = 0; row < to.size(); ++row) {
          const double* const from = inputs[i].array.data() + row * cases.count;
          to[row] = CasePack::from_lanes([&](int lane) { return from[column(lane)]; });
        }
      }
      work(model.packs, one);
      const std::size_t lanes = std::min<std::size_t>(pack_width, cases.count - start);
      for (std::size_t row = 0; row < results; ++row)
        for (std::size_t lane = 0; lane < lanes; ++lane)
          out[row * cases.count + start + lane] = one.found[row].lane(static_cast<int>(lane));
    }
  };
  const std::size_t packs = (cases.count + pack_width - 1) / pack_width;
  const std::size_t workers =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)), 1, std::max<std::size_t>(packs, 1));
  if (workers == 1) {
    run(0, packs);
    return result;
  }
  std::vector<std::exception_ptr> failures(workers);
  {
    std::vector<std::jthread> pool;
    for (std::size_t k = 0; k < workers; ++k)
      pool.emplace_back([&, k] {
        try {
          run(packs * k / workers, packs * (k + 1) / workers);
        } catch (...) {
          failures[k] = std::current_exception();
        }
      });
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return result;
}

}  // namespace poinsot::python
