// The immutable model: a tree of rigid bodies in topological order, in flat arrays. ModelBuilder (builder.h) makes it;
// State (state.h) and the workspaces of the dynamics room live outside it, so that one model serves many threads.
//
// Frames. Each body has a body frame, fixed by the caller, in which its mass properties, points and loads are given.
// The algorithms use a working frame with the same origin whose z axis lies along the axis of the body's joint;
// R_WB takes components on the body's axes to components on its working axes. Only this room and dynamics know of it.
#pragma once

#include <cmath>
#include <concepts>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "poinsot/engine/math/algebra/spatial.h"
#include "poinsot/engine/model/joint.h"

namespace poinsot {

// The parent of a body that is joined to the ground.
inline constexpr int ground = -1;

// The data of a body that the algorithms read, on its working axes.
template <class Scalar>
struct Body {
  JointType joint = JointType::weld;
  bool all_free = true;  // every velocity coordinate of its joint is free
  // Whether it is a body of revolution about the axis of its revolute joint (for numbers only).
  bool axisymmetric = false;
  int parent = ground;
  int q = 0;                             // its first position coordinate
  int v = 0;                             // its first velocity coordinate
  SpatialTransform<Scalar> placement{};  // joint frame, z along the joint's axis, in the parent's working frame
  Scalar pitch{};
  SpatialInertia<Scalar> inertia{};
  SymmetricMatrix3<Scalar> second_moment{};  // integral of r r^T dm about the origin, kg m^2
  Matrix3<Scalar> R_WB{};
};

namespace detail {

// Whether the body is a body of revolution about z, up to rounding.
template <std::floating_point Scalar>
bool is_of_revolution(const SpatialInertia<Scalar>& body) {
  const SymmetricMatrix3<Scalar>& I = body.inertia;
  const Vector3<Scalar>& h = body.first_moment;
  const Scalar rounding = Scalar(1e-14) * (I.xx + I.yy + I.zz);
  const Scalar rounding_of_moment = Scalar(1e-14) * std::sqrt(body.mass * (I.xx + I.yy + I.zz));
  const auto vanish = [](Scalar bound, auto... x) { return (... && (std::abs(x) <= bound)); };
  return rounding > 0 && vanish(rounding, I.xx - I.yy, I.xy, I.yz, I.zx) && vanish(rounding_of_moment, h.x, h.y);
}

// Removes the rounding in what should vanish, since the square of a fast spin would multiply it.
template <std::floating_point Scalar>
void make_exactly_of_revolution(Body<Scalar>& body) {
  const SymmetricMatrix3<Scalar>& I = body.inertia.inertia;
  const Scalar J = (I.xx + I.yy) / 2, axial = I.zz / 2;
  body.inertia.first_moment = {0, 0, body.inertia.first_moment.z};
  body.inertia.inertia = SymmetricMatrix3<Scalar>::diagonal(J, J, I.zz);
  body.second_moment = SymmetricMatrix3<Scalar>::diagonal(axial, axial, J - axial);
}

}  // namespace detail

template <class Scalar>
class Model {
 public:
  // For ModelBuilder and the conversions below. Bodies must be in topological order, with one name for each body and
  // one mode for each velocity coordinate.
  Model(std::vector<Body<Scalar>> bodies, std::vector<std::string> names, std::vector<CoordinateMode> modes,
        const Vector3<Scalar>& gravity)
      : bodies_(std::move(bodies)), names_(std::move(names)), modes_(std::move(modes)), gravity_(gravity) {
    for (Body<Scalar>& body : bodies_) {
      position_size_ += poinsot::position_size(body.joint);
      if (body.joint == JointType::revolute || body.joint == JointType::screw) {
        if (angles_.last == 0) angles_.first = body.q;
        angles_.last = body.q + 1;
      }
      if constexpr (std::floating_point<Scalar>) {
        body.axisymmetric = body.joint == JointType::revolute && detail::is_of_revolution(body.inertia);
        if (body.axisymmetric) detail::make_exactly_of_revolution(body);
      }
      body.all_free = true;
      for (int k = 0; k < poinsot::velocity_size(body.joint); ++k) {
        body.all_free = body.all_free && modes_[body.v + k] == CoordinateMode::free;
      }
    }
    find_ancestor_runs();
  }

  int body_count() const { return static_cast<int>(bodies_.size()); }
  int position_size() const { return position_size_; }
  int velocity_size() const { return static_cast<int>(modes_.size()); }
  const Body<Scalar>& body(int i) const { return bodies_[i]; }
  std::span<const Body<Scalar>> bodies() const { return bodies_; }
  const std::string& name(int i) const { return names_[i]; }
  const std::vector<std::string>& names() const { return names_; }
  CoordinateMode mode(int velocity_coordinate) const { return modes_[velocity_coordinate]; }
  const std::vector<CoordinateMode>& modes() const { return modes_; }
  // Acceleration of free fall on ground axes, m/s^2.
  const Vector3<Scalar>& gravity() const { return gravity_; }

  // The body of this name, if there is one.
  std::optional<int> find(std::string_view name) const {
    for (int i = 0; i < body_count(); ++i) {
      if (names_[i] == name) return i;
    }
    return std::nullopt;
  }

  struct Run {
    int first;
    int last;
  };
  // The shortest run [first, last) of position coordinates that contains all angles of revolute and screw joints.
  const Run& angles() const { return angles_; }
  // The velocity coordinates that move a body, as runs [first, last) in ascending order.
  std::span<const Run> moving_coordinates(int body) const {
    return std::span<const Run>(runs_).subspan(run_start_[body], run_start_[body + 1] - run_start_[body]);
  }

 private:
  // The runs of a body are those of its parent, then its own coordinates.
  void find_ancestor_runs() {
    run_start_.reserve(bodies_.size() + 1);
    run_start_.assign(1, 0);
    for (const Body<Scalar>& body : bodies_) {
      const std::size_t start = runs_.size();
      if (body.parent != ground) {
        for (int k = run_start_[body.parent]; k < run_start_[body.parent + 1]; ++k) runs_.push_back(Run(runs_[k]));
      }
      const int last = body.v + poinsot::velocity_size(body.joint);
      if (runs_.size() > start && runs_.back().last == body.v) {
        runs_.back().last = last;
      } else if (last > body.v) {
        runs_.push_back({body.v, last});
      }
      run_start_.push_back(static_cast<int>(runs_.size()));
    }
  }

  std::vector<Body<Scalar>> bodies_;
  std::vector<std::string> names_;
  std::vector<CoordinateMode> modes_;
  Vector3<Scalar> gravity_;
  int position_size_ = 0;
  Run angles_{0, 0};
  std::vector<Run> runs_;
  std::vector<int> run_start_;
};

namespace detail {

template <class Target, class Source, class Convert>
Vector3<Target> converted(const Vector3<Source>& a, Convert convert) {
  return {convert(a.x), convert(a.y), convert(a.z)};
}
template <class Target, class Source, class Convert>
SymmetricMatrix3<Target> converted(const SymmetricMatrix3<Source>& a, Convert convert) {
  return {convert(a.xx), convert(a.yy), convert(a.zz), convert(a.xy), convert(a.yz), convert(a.zx)};
}
template <class Target, class Source, class Convert>
Matrix3<Target> converted(const Matrix3<Source>& a, Convert convert) {
  return {converted<Target>(a.row0, convert), converted<Target>(a.row1, convert), converted<Target>(a.row2, convert)};
}
template <class Target, class Source, class Convert>
Body<Target> converted(const Body<Source>& b, Convert convert) {
  return {b.joint,
          b.all_free,
          b.axisymmetric,
          b.parent,
          b.q,
          b.v,
          {converted<Target>(b.placement.R, convert), converted<Target>(b.placement.p, convert)},
          convert(b.pitch),
          {convert(b.inertia.mass), converted<Target>(b.inertia.first_moment, convert),
           converted<Target>(b.inertia.inertia, convert)},
          converted<Target>(b.second_moment, convert),
          converted<Target>(b.R_WB, convert)};
}

}  // namespace detail

// The same model over another scalar. Its numbers become constants there.
template <class Target, class Source>
Model<Target> convert(const Model<Source>& model) {
  const auto constant = [](const Source& x) { return Target(x); };
  std::vector<Body<Target>> bodies;
  for (const Body<Source>& body : model.bodies()) bodies.push_back(detail::converted<Target>(body, constant));
  return Model<Target>(std::move(bodies), model.names(), model.modes(),
                       detail::converted<Target>(model.gravity(), constant));
}

// One model per lane of a pack: the same tree, joints and modes, other numbers. Errors: std::invalid_argument if the
// count is not the pack's width or the trees differ.
template <class Pack>
Model<Pack> pack_models(std::span<const Model<double>> models) {
  if (static_cast<int>(models.size()) != Pack::width) {
    throw std::invalid_argument("pack_models: got " + std::to_string(models.size()) + " models, expected " +
                                std::to_string(Pack::width) + ", one per lane");
  }
  const Model<double>& first = models.front();
  for (const Model<double>& model : models) {
    bool same = model.body_count() == first.body_count() && model.modes() == first.modes();
    for (int i = 0; same && i < first.body_count(); ++i) {
      same = model.body(i).joint == first.body(i).joint && model.body(i).parent == first.body(i).parent;
    }
    if (!same) throw std::invalid_argument("pack_models: the models differ in their tree, joints or modes");
  }
  // The numbers of every lane are read in the same order, so that the k-th number of each lane goes into one pack.
  std::vector<std::vector<double>> numbers(models.size());
  for (std::size_t lane = 0; lane < models.size(); ++lane) {
    const auto record = [&numbers, lane](double x) {
      numbers[lane].push_back(x);
      return x;
    };
    for (const Body<double>& body : models[lane].bodies()) detail::converted<double>(body, record);
    detail::converted<double>(models[lane].gravity(), record);
  }
  std::size_t next = 0;
  const auto gather = [&numbers, &next](double) {
    const std::size_t k = next++;
    return Pack::from_lanes([&numbers, k](int lane) { return numbers[lane][k]; });
  };
  std::vector<Body<Pack>> bodies;
  for (int i = 0; i < first.body_count(); ++i) {
    bodies.push_back(detail::converted<Pack>(first.body(i), gather));
    for (const Model<double>& model : models) bodies.back().axisymmetric &= model.body(i).axisymmetric;
  }
  return Model<Pack>(std::move(bodies), first.names(), first.modes(), detail::converted<Pack>(first.gravity(), gather));
}

}  // namespace poinsot
