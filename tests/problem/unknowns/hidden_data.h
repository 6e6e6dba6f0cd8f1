// Data of a random problem hidden behind names, to be found again from what follows from them.
#pragma once

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "problem/entries/random_problems.h"

namespace poinsot::problem::testing {

// One number of a problem as it stands in the text.
struct Datum {
  std::string kind;  // in words, for messages
  double value = 0;  // SI
  NamedUnit unit;
  bool sided = false;   // it cannot be negative
  bool linear = false;  // accelerations and forces are linear in it
  bool length = false;  // one that may have either sign: a coordinate
};

// The numbers of a problem that its text holds once (or, a place of a joint, twice as the same place).
inline std::vector<Datum> data_of(const ProblemData& problem, const UnitSystem& units) {
  std::vector<Datum> list;
  const auto add = [&](const std::string& kind, double value, const NamedUnit& unit) -> Datum& {
    list.push_back({kind, value, unit});
    return list.back();
  };
  const auto add_vector = [&](const std::string& kind, const Vector& a, const NamedUnit& unit, bool linear) {
    for (std::size_t k = 0; k < 3; ++k) {
      Datum& datum = add(kind, a[k], unit);
      datum.linear = linear;
      datum.length = unit.name == units.length.name;
    }
  };
  for (const BodyData& body : problem.bodies)
    for (const PartData& part : body.parts) {
      add("mass", part.mass, units.mass).sided = true;
      add_vector("coordinate of a shape", part.a, units.length, false);
      using enum PartData::Shape;
      if (part.shape == disk || part.shape == sphere || part.shape == cylinder)
        add("radius", part.radius, units.length).sided = true;
      if (part.shape == cylinder) add("length", part.length, units.length).sided = true;
    }
  for (const JointData& joint : problem.joints) {
    if (joint.kind != "free") add_vector("coordinate of a point", joint.at, units.length, false);
    for (const FreedomData& f : joint.freedoms) {
      Datum& position = add(f.turning ? "angle" : "displacement", f.position, f.turning ? units.angle : units.length);
      position.length = !f.turning;
      if (f.rate) add("rate", *f.rate, f.turning ? units.rate() : units.velocity());
      if (f.accel)
        add("acceleration", *f.accel, f.turning ? units.angular_acceleration() : units.acceleration()).linear = true;
      if (f.effort) add("effort", *f.effort, f.turning ? units.moment() : units.force).linear = true;
      if (f.stiffness != 0) {
        const NamedUnit unit = f.turning ? units.turning_stiffness() : units.stiffness();
        add("stiffness of a joint", f.stiffness, unit).linear = true;
        Datum& free = add("free position", f.free_position, f.turning ? units.angle : units.length);
        free.linear = true;
        free.length = !f.turning;
      }
      if (f.damping != 0)
        add("damping", f.damping, f.turning ? units.turning_damping() : units.damping()).linear = true;
    }
    if (joint.kind == "ball" || joint.kind == "free") add_vector("angular velocity", joint.w, units.rate(), false);
    if (joint.kind == "free") add_vector("velocity", joint.v, units.velocity(), false);
  }
  for (const LoadData& load : problem.loads) {
    add_vector(load.couple ? "couple" : "force", load.vector, load.couple ? units.moment() : units.force, true);
    if (!load.couple) add_vector("place of a force", load.at, units.length, true);
  }
  for (const SpringData& spring : problem.springs) {
    add("stiffness", spring.stiffness, units.stiffness()).linear = true;
    Datum& free = add("free length", spring.free_length, units.length);
    free.sided = free.linear = true;
    add_vector("end of a spring", spring.end, units.length, false);
  }
  add_vector("gravity", problem.gravity, units.acceleration(), true);
  // What is nearly zero is no number to find to a relative tolerance.
  std::erase_if(list, [](const Datum& datum) { return std::abs(datum.value) < 1e-2; });
  return list;
}

// A component of a quantity, or all three, and what the data make of it.
struct StatedFact {
  std::string quantity;  // with .x if it is a component
  Value<double> value;   // SI

  std::string line() const {
    const std::string unit = " " + base_units(value.dimension);
    const auto number = [&](double x) { return fmt::format("{:.17g}", x) + (unit == " 1" ? "" : unit); };
    if (value.is_number()) return "'" + quantity + "': " + number(value.number);
    return "'" + quantity + "': [" + number(value.vector.x) + ", " + number(value.vector.y) + ", " +
           number(value.vector.z) + "]";
  }
  std::vector<double> numbers() const {
    if (value.is_number()) return {value.number};
    return {value.vector.x, value.vector.y, value.vector.z};
  }
};

// A problem with some of its data as names.
class HiddenProblem {
 public:
  HiddenProblem(ProblemData problem, const UnitSystem& units, std::vector<Datum> hidden)
      : problem_(std::move(problem)), hidden_(std::move(hidden)) {
    style_.units = units;
  }

  const std::vector<Datum>& hidden() const { return hidden_; }
  static std::string name(std::size_t k) { return fmt::format("u{}", k); }

  // The answers to some questions with given values of the hidden data (SI).
  std::vector<Value<double>> forward(const std::vector<std::string>& asks, const std::vector<double>& values) const {
    std::string given = "given: {";
    for (std::size_t k = 0; k < hidden_.size(); ++k)
      given += (k == 0 ? "" : ", ") + name(k) + ": " + style_.number(values[k], hidden_[k].unit);
    const Solution solution = solved(text(asks) + given + "}\n");
    std::vector<Value<double>> answers;
    for (const SolvedAsk& ask : solution.asks) {
      if (ask.state != AskState::found) throw std::logic_error("no answer: " + ask.reason);
      answers.push_back(ask.value);
    }
    return answers;
  }

  // The problem of finding them again; `ranges` says where, if it is not empty.
  std::string backward(const std::vector<std::string>& asks, const std::vector<StatedFact>& facts,
                       const std::vector<std::pair<double, double>>& ranges) const {
    std::string all = text(asks), find, where, now;
    for (std::size_t k = 0; k < hidden_.size(); ++k) {
      const NamedUnit& unit = hidden_[k].unit;
      find += (k == 0 ? "" : ", ") + name(k) + ": " + unit.name;
      if (!ranges.empty())
        where += (k == 0 ? "" : ", ") + style_.number(ranges[k].first, unit) + " < " + name(k) + " < " +
                 style_.number(ranges[k].second, unit);
    }
    for (const StatedFact& fact : facts) now += "    " + fact.line() + "\n";
    const std::string head = "instants:\n  now:\n";
    if (const std::size_t at = all.find(head); at != std::string::npos)
      all.insert(at + head.size(), now);
    else
      all += head + now;
    all += "find: {" + find + "}\n";
    if (!where.empty()) all += "where: [" + where + "]\n";
    return all;
  }

 private:
  std::string text(const std::vector<std::string>& asks) const {
    ProblemData problem = problem_;
    problem.asks = asks;
    std::string all = problem.text(style_);
    for (std::size_t k = 0; k < hidden_.size(); ++k) {
      const std::string literal = style_.number(hidden_[k].value, hidden_[k].unit);
      bool met = false;
      for (std::size_t at; (at = all.find(literal)) != std::string::npos; met = true)
        all.replace(at, literal.size(), name(k));
      if (!met) throw std::logic_error("'" + literal + "' does not stand in the text");
    }
    return all;
  }

  ProblemData problem_;
  Style style_;
  std::vector<Datum> hidden_;
};

}  // namespace poinsot::problem::testing
