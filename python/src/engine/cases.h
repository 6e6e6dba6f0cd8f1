// Many states of one model at once: arrays of NumPy whose rows are coordinates and whose columns are cases (structures
// of arrays), read and written in place. Cases go through the algorithms in packs, and packs over threads; the numbers
// of a case are the same bits whatever the number of threads.
#pragma once

#include <nanobind/nanobind.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/dynamics_derivatives.h"
#include "poinsot/engine/dynamics/packed_bodies.h"
#include "poinsot/engine/dynamics/workspace.h"
#include "poinsot/engine/math/algebra/pack.h"
#include "poinsot/engine/model/model.h"
#include "poinsot/engine/model/state.h"

namespace poinsot::python {

// As many as a register of the largest kind holds.
#ifdef __AVX512F__
inline constexpr int pack_width = 8;
#else
inline constexpr int pack_width = 4;
#endif
using CasePack = Pack<pack_width>;

// The numbers of one case or pack: its state, a further input by coordinates, and what is found.
template <class Scalar>
struct CaseNumbers {
  explicit CaseNumbers(const Model<Scalar>& model) : state(neutral_state(model)), given(model.velocity_size()) {}

  State<Scalar> state;
  std::vector<Scalar> given;
  std::vector<Scalar> found;

  std::vector<Scalar>& input(int which) { return which == 0 ? state.q : which == 1 ? state.v : given; }
  void swap(CaseNumbers& other) {
    state.q.swap(other.state.q);
    state.v.swap(other.state.v);
    given.swap(other.given);
    found.swap(other.found);
  }
};

// With the memory in which they are worked on.
template <class Scalar>
struct Case : CaseNumbers<Scalar> {
  explicit Case(const Model<Scalar>& model) : CaseNumbers<Scalar>(model), workspace(model), bodies(model, workspace) {}
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  Workspace<Scalar> workspace;
  PackedBodies<Scalar> bodies;
  std::vector<Scalar> between;  // for what is found on the way, made by who needs it first
  std::optional<DerivativesWorkspace<Scalar>> derivatives;

  // Made by who asks for it first.
  DerivativesWorkspace<Scalar>& for_derivatives(const Model<Scalar>& model) {
    if (!derivatives) derivatives.emplace(model);
    return *derivatives;
  }
};

// The memory of one thread that goes through cases in packs.
struct CaseMemory {
  explicit CaseMemory(const Model<CasePack>& model) : one(model) {}

  Case<CasePack> one;
  std::vector<CaseNumbers<CasePack>> packs;
};

// A model with what its algorithms need over numbers and over packs.
struct EngineModel {
  explicit EngineModel(Model<double> own_numbers)
      : numbers(std::move(own_numbers)), packs(convert<CasePack>(numbers)), single(numbers) {
    for (const Body<double>& body : numbers.bodies())
      if (body.joint == JointType::ball || body.joint == JointType::free) quaternions.push_back(body.q);
  }

  Model<double> numbers;
  Model<CasePack> packs;
  std::vector<int> quaternions;  // the row of q at which each begins
  // The memory for single states, which hold the interpreter's lock: to make it takes longer than most calls.
  mutable Case<double> single;

  // That for packs, of which a call takes some and gives them back: to make it takes as long as a thousand states.
  std::unique_ptr<CaseMemory> take_memory() const {
    {
      const std::scoped_lock lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<CaseMemory> memory = std::move(idle_.back());
        idle_.pop_back();
        return memory;
      }
    }
    return std::make_unique<CaseMemory>(packs);
  }
  void give_back(std::unique_ptr<CaseMemory> memory) const {
    const std::scoped_lock lock(mutex_);
    if (idle_.size() < std::max(std::thread::hardware_concurrency(), 1U)) idle_.push_back(std::move(memory));
  }

 private:
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<CaseMemory>> idle_;
};

// An array of NumPy on its way back to Python.
struct NumpyArray {
  nanobind::object object;
};

// What comes in: one state (one dimension), or a column for each case (two), as the memory of an array of NumPy. What
// is no array of doubles in that order becomes one. Errors: what NumPy raises if it cannot.
class CaseArray {
 public:
  explicit CaseArray(nanobind::handle array);

  std::size_t ndim() const { return ndim_; }
  std::size_t shape(std::size_t i) const { return static_cast<std::size_t>(shape_[i]); }
  const double* data() const { return data_; }

 private:
  nanobind::object array_;
  std::size_t ndim_ = 0;
  const Py_ssize_t* shape_ = nullptr;
  const double* data_ = nullptr;
};

struct CaseInput {
  CaseInput(const char* own_name, nanobind::handle own_array, int own_rows)
      : name(own_name), array(own_array), rows(own_rows) {}

  const char* name;
  CaseArray array;
  int rows;
};
using CaseInputs = std::span<const CaseInput>;

// The number of cases, 1 for a single state; checks that the inputs agree and fit the model.
struct CaseShape {
  std::size_t count = 1;
  bool single = true;
};
CaseShape case_shape(CaseInputs inputs);

// Refuses q with quaternions that are not of length one: they would be taken for turns and stretch the bodies.
void refuse_stretching(const EngineModel& model, const CaseInput& q, const CaseShape& cases);

// A new array: `shape` for a single state, with a last dimension of the cases for several.
struct ResultArray {
  NumpyArray array;
  double* data = nullptr;
};
ResultArray new_result(const std::vector<std::size_t>& shape, const CaseShape& cases);

// Some packs of cases, as many as fit into a processor's nearer memory, with their inputs and results beside each
// other: in the whole arrays the numbers of a case lie far apart.
class CaseTile {
 public:
  CaseTile(const EngineModel& model, CaseInputs inputs, std::size_t cases, std::size_t results);
  ~CaseTile() { model_.give_back(std::move(memory_)); }
  CaseTile(const CaseTile&) = delete;
  CaseTile& operator=(const CaseTile&) = delete;

  std::size_t packs() const { return packs_; }
  // These packs of the inputs, of which the last one repeats the last case.
  void read(std::size_t first_pack, std::size_t last_pack);
  // Their results into a row of all cases for each.
  void write(double* out) const;

  template <class Work>
  void for_each_pack(const Work& work) {
    for (std::size_t k = 0; k < held_; ++k) {
      memory_->one.swap(memory_->packs[k]);
      work(memory_->one);
      memory_->one.swap(memory_->packs[k]);
    }
  }

 private:
  const EngineModel& model_;
  CaseInputs inputs_;
  // Of cases, and in packs: how many there are at most, which is the first and how many are held.
  std::size_t cases_, packs_, first_ = 0, held_ = 0;
  std::unique_ptr<CaseMemory> memory_;
};

// Runs work(model, case) for every case, with its inputs in place, in the order q, v, given; and writes what is found.
template <std::size_t N, class Work>
NumpyArray for_cases(const EngineModel& model, const CaseInput (&inputs)[N], const std::vector<std::size_t>& shape,
                     int threads, const Work& work) {
  if (threads < 1) throw nanobind::value_error("threads is a whole number, 1 or more");
  const CaseShape cases = case_shape(inputs);
  if (!model.quaternions.empty()) refuse_stretching(model, inputs[0], cases);
  std::size_t results = 1;
  for (const std::size_t size : shape) results *= size;
  const ResultArray result = new_result(shape, cases);
  double* const out = result.data;

  if (cases.single) {
    Case<double>& one = model.single;
    one.found.resize(results);
    for (std::size_t i = 0; i < N; ++i)
      std::copy_n(inputs[i].array.data(), inputs[i].rows, one.input(static_cast<int>(i)).begin());
    work(model.numbers, one);
    std::ranges::copy(one.found, out);
    return result.array;
  }

  const nanobind::gil_scoped_release released;
  const auto run = [&](std::size_t first_pack, std::size_t last_pack) {
    CaseTile tile(model, inputs, cases.count, results);
    for (std::size_t pack = first_pack; pack < last_pack; pack += tile.packs()) {
      tile.read(pack, std::min(pack + tile.packs(), last_pack));
      tile.for_each_pack([&](Case<CasePack>& one) { work(model.packs, one); });
      tile.write(out);
    }
  };
  const std::size_t packs = (cases.count + pack_width - 1) / pack_width;
  const std::size_t workers =
      std::clamp<std::size_t>(static_cast<std::size_t>(threads), 1, std::max<std::size_t>(packs, 1));
  if (workers == 1) {
    run(0, packs);
    return result.array;
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
  return result.array;
}

}  // namespace poinsot::python

template <>
struct nanobind::detail::type_caster<poinsot::python::NumpyArray> {
  static constexpr auto Name = const_name("numpy.typing.NDArray[numpy.float64]");

  static handle from_cpp(const poinsot::python::NumpyArray& array, rv_policy, cleanup_list*) {
    return handle(array.object).inc_ref();
  }
};
