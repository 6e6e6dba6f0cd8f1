// The bodies of a mechanism near a steady motion by the place and the turn of each, with what joins them told by
// geometry: joints as points and axes that coincide, contacts as gaps between shapes, cords as distances.
//
// In the frame of the steady motion, whose axes are those of the ground at the instant, each body is displaced by a
// shift d of its mass center and a turn exp(t); a spin about an axis of symmetry shows in neither.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/solve/instant/true_surfaces.h"
#include "engine/solve/stability/doubted_rates.h"
#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/solve/stability/linearisation.h"

namespace poinsot::solve {

using Place3 = Eigen::Matrix<Real, 3, 1>;
using Turn3 = Eigen::Matrix<Real, 3, 3>;

Turn3 crossing(const Place3& a);      // a x
Turn3 turned_by(const Place3& turn);  // exp(a x)

struct Displaced {
  Turn3 turn = Turn3::Identity();
  Place3 shift = Place3::Zero();
};
// One for each body of the tree, then one for the ground.
using Displacements = std::vector<Displaced>;
// How fast the mass center moves and the body turns relative to the frame.
struct DisplacedRate {
  Place3 shift = Place3::Zero(), turn = Place3::Zero();
};
using DisplacedRates = std::vector<DisplacedRate>;

// A body at the instant, on ground axes.
struct SteadyBody {
  bool moves = false;  // else its motion is given, and it is not displaced
  Real mass = 0;
  Turn3 inertia;                     // about the mass center
  Place3 center, angular, velocity;  // of the mass center, or the origin of a body without mass
};

class RedundantBodies {
 public:
  // The motion must outlive it. Nothing where this road does not lead: screws, dampers on bodies that spin, bodies
  // that lie flat on their circle.
  static std::unique_ptr<RedundantBodies> find(const SteadyMotion& motion);

  const std::vector<SteadyBody>& bodies() const { return bodies_; }
  Place3 axis_point() const { return axis_point_; }  // of the axis of the frame
  Place3 turning() const { return turning_; }
  Place3 spin(std::size_t body) const { return bodies_[body].angular - turning_; }

  // What must stay zero by positions, and V, the energy of weights, springs and constant efforts.
  std::vector<Real> gaps(const Displacements& at) const;
  // Which of these is the angle or displacement of a held coordinate, in a joint of one freedom.
  std::optional<std::size_t> gap_of(int coordinate) const;
  Real energy(const Displacements& at) const;
  // Lengths and angles that dampers act on, each with its coefficient.
  std::vector<std::pair<Real, Real>> damped(const Displacements& at) const;

  // What may not slip: the material points of two bodies at a place, along a direction.
  struct Touch {
    int on = ground, from = ground;
    Place3 place, direction;
  };
  std::vector<Touch> touches(const Displacements& at) const;
  // Forces that are no energy's: on a body at a place, with a couple.
  struct Push {
    int on = ground, from = ground;
    Place3 place, force, couple;
  };
  std::vector<Push> pushes(const Displacements& at, const DisplacedRates& rates) const;
  // The velocity of the material point of a body at a place, as its mass center moves with `rate` and it turns with
  // `turn` relative to the frame.
  Place3 velocity(int body, const Displacements& at, const Place3& place, const Place3& rate, const Place3& turn) const;

  Place3 center(int body, const Displacements& at) const;
  // A place of a body before anything is displaced.
  Place3 drawn_place(const Place<double>& place) const { return drawn(place); }

 private:
  explicit RedundantBodies(const SteadyMotion& motion);
  bool read();
  bool read_joint(int body);
  bool read_held(int body);
  bool read_constraints();

  std::size_t index(int body) const { return body == ground ? bodies_.size() : static_cast<std::size_t>(body); }
  Place3 drawn(const Place<double>& place) const;
  Place3 drawn(const Direction<double>& direction) const;
  Place3 moved(int body, const Displacements& at, const Place3& drawn) const;
  Place3 turned(int body, const Displacements& at, const Place3& drawn) const { return at[index(body)].turn * drawn; }
  Turn3 read_axes(int body) const;  // of its joint
  Real energy_of_pull(const AttractionLaw<double>& pull, const Displacements& at) const;
  Place3 angular_velocity_of(int body, const Displacements& at, const DisplacedRates& rates) const;
  Place3 velocity_of(int body, const Displacements& at, const DisplacedRates& rates, const Place3& place) const;
  Real coordinate(int coordinate, bool rate, const Displacements& at, const DisplacedRates& rates) const;
  Place3 part_of_motion(const MotionPart<double>& part, const Displacements& at, const DisplacedRates& rates) const;
  Place3 size_by_motion(const MotionExpression<double>& load, const Displacements& at,
                        const DisplacedRates& rates) const;
  // Where a straight part of a cord begins and ends, and the axis of its wheels.
  struct Straight {
    Place3 start, end, axis;
  };
  Straight straight(const CordSpan<double>& span, const Displacements& at) const;
  Real led_length(const VelocityConstraint<double>& c, const Displacements& at, const Displacements& from) const;
  std::optional<drawn::NearestPlace> touching(const VelocityConstraint<double>& c, const Displacements& at) const;
  Real turned_about(int on, int from, const Displacements& at, const Place3& axis) const;

  const SteadyMotion& motion_;
  const Mechanism<double>& mechanism_;
  Workspace<double> w_;
  std::vector<SteadyBody> bodies_;
  Place3 turning_, axis_point_, drift_;
  std::vector<std::function<Real(const Displacements&)>> gaps_;
  std::vector<std::pair<int, std::size_t>> held_gaps_;  // coordinates and their places among these
};

}  // namespace poinsot::solve
