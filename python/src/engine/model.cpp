// Models of the engine, built body by body.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <map>

#include "engine/bindings.h"
#include "engine/cases.h"
#include "poinsot/engine/model/builder.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace poinsot::python {
namespace {

using Three = std::array<double, 3>;
using Rows = std::array<Three, 3>;

Vector3<double> vector(const Three& a) { return {a[0], a[1], a[2]}; }
Matrix3<double> matrix(const Rows& a) { return {vector(a[0]), vector(a[1]), vector(a[2])}; }

Joint<double> joint_of(const std::string& kind, const Three& axis, double pitch) {
  if (kind == "revolute") return Joint<double>::revolute(vector(axis));
  if (kind == "prismatic") return Joint<double>::prismatic(vector(axis));
  if (kind == "screw") return Joint<double>::screw(vector(axis), pitch);
  if (kind == "ball") return Joint<double>::ball();
  if (kind == "free") return Joint<double>::free();
  if (kind == "weld") return Joint<double>::weld();
  throw nb::value_error(
      ("there is no joint '" + kind + "': expected revolute, prismatic, screw, ball, free or weld").c_str());
}

CoordinateMode mode_of(const std::string& name) {
  if (name == "free") return CoordinateMode::free;
  if (name == "prescribed") return CoordinateMode::prescribed;
  if (name == "locked") return CoordinateMode::locked;
  throw nb::value_error(("there is no mode '" + name + "': expected free, prescribed or locked").c_str());
}

// The tensor has to be symmetric, as it is taken for one.
SymmetricMatrix3<double> tensor(const std::string& body, const Rows& I) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (I[i][j] != I[j][i])
        throw nb::value_error(("body '" + body + "': its tensor of inertia is not symmetric").c_str());
  return {I[0][0], I[1][1], I[2][2], I[0][1], I[1][2], I[2][0]};
}

void add_body(ModelBuilder<double>& builder, const std::string& name, const std::string& parent,
              const std::string& joint, const Three& axis, double pitch, const Three& place, const Rows& rotation,
              double mass, const Three& center, const Rows& inertia, const std::string& mode) {
  builder.add_body(name, std::string_view(parent), joint_of(joint, axis, pitch), {matrix(rotation), vector(place)},
                   {mass, vector(center), tensor(name, inertia)}, mode_of(mode));
}

// The numbers of a body one after the other, as poinsot._core puts them down (motion.cpp).
struct BodyNumbers {
  const std::vector<double>& numbers;
  std::size_t at = 0;

  double next() { return numbers.at(at++); }
  Vector3<double> vector() {
    const double x = next(), y = next();
    return {x, y, next()};
  }
  Matrix3<double> matrix() {
    const Vector3<double> x = vector(), y = vector();
    return {x, y, vector()};
  }
  SymmetricMatrix3<double> symmetric() {
    const Vector3<double> on = vector(), off = vector();
    return {on.x, on.y, on.z, off.x, off.y, off.z};
  }
};

EngineModel* model_of_tree(const std::vector<std::string>& names, const std::vector<std::vector<double>>& stated,
                           const std::vector<bool>& prescribed, const Three& gravity) {
  std::vector<Body<double>> bodies;
  int q = 0, v = 0;
  for (const std::vector<double>& one : stated) {
    BodyNumbers numbers{one};
    Body<double>& body = bodies.emplace_back();
    body.joint = static_cast<JointType>(static_cast<int>(numbers.next()));
    body.parent = static_cast<int>(numbers.next());
    body.pitch = numbers.next();
    body.placement.R = numbers.matrix();
    body.placement.p = numbers.vector();
    body.inertia.mass = numbers.next();
    body.inertia.first_moment = numbers.vector();
    body.inertia.inertia = numbers.symmetric();
    body.second_moment = numbers.symmetric();
    body.R_WB = numbers.matrix();
    body.q = q;
    body.v = v;
    q += position_size(body.joint);
    v += velocity_size(body.joint);
  }
  std::vector<CoordinateMode> modes;
  for (const bool is : prescribed) modes.push_back(is ? CoordinateMode::prescribed : CoordinateMode::free);
  return new EngineModel(Model<double>(std::move(bodies), names, std::move(modes), vector(gravity)));
}

}  // namespace

void bind_model(nb::module_& module) {
  nb::class_<ModelBuilder<double>>(module, "ModelBuilder")
      .def(nb::init<>())
      .def("add_body", &add_body, "name"_a, "parent"_a, "joint"_a, "axis"_a, "pitch"_a, "place"_a, "rotation"_a,
           "mass"_a, "center"_a, "inertia"_a, "mode"_a)
      .def(
          "set_gravity", [](ModelBuilder<double>& builder, const Three& g) { builder.set_gravity(vector(g)); },
          "gravity"_a)
      .def(
          "build", [](const ModelBuilder<double>& builder) { return new EngineModel(builder.build()); },
          nb::rv_policy::take_ownership);
  module.def("model_of_tree", &model_of_tree, "names"_a, "bodies"_a, "prescribed"_a, "gravity"_a,
             nb::rv_policy::take_ownership);
  nb::class_<EngineModel>(module, "EngineModel")
      .def_prop_ro("names", [](const EngineModel& model) { return model.numbers.names(); })
      .def_prop_ro("parents",
                   [](const EngineModel& model) {
                     std::vector<int> parents;
                     for (const Body<double>& body : model.numbers.bodies()) parents.push_back(body.parent);
                     return parents;
                   })
      .def_prop_ro("first_position",
                   [](const EngineModel& model) {
                     std::vector<int> places;
                     for (const Body<double>& body : model.numbers.bodies()) places.push_back(body.q);
                     return places;
                   })
      .def_prop_ro("first_velocity",
                   [](const EngineModel& model) {
                     std::vector<int> places;
                     for (const Body<double>& body : model.numbers.bodies()) places.push_back(body.v);
                     return places;
                   })
      .def_prop_ro("prescribed",
                   [](const EngineModel& model) {
                     std::vector<bool> prescribed;
                     for (const CoordinateMode mode : model.numbers.modes())
                       prescribed.push_back(mode != CoordinateMode::free);
                     return prescribed;
                   })
      .def_prop_ro("nq", [](const EngineModel& model) { return model.numbers.position_size(); })
      .def_prop_ro("nv", [](const EngineModel& model) { return model.numbers.velocity_size(); })
      .def_prop_ro("gravity",
                   [](const EngineModel& model) {
                     const Vector3<double>& g = model.numbers.gravity();
                     return Three{g.x, g.y, g.z};
                   })
      .def_prop_ro("neutral", [](const EngineModel& model) { return neutral_state(model.numbers).q; });
}

}  // namespace poinsot::python
