#include "problem/machine/touching_surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "poinsot/engine/dynamics/kinematics.h"
#include "poinsot/engine/model/state.h"
#include "poinsot/engine/solve/instant/contact_curvature.h"
#include "problem/language/diagnostic.h"
#include "problem/language/exact_numbers.h"
#include "problem/machine/body_surfaces.h"
#include "problem/machine/round_surface.h"
#include "problem/machine/shape_arguments.h"
#include "problem/machine/shape_row.h"

namespace poinsot::problem {
namespace {

using Vector = Vector3<double>;

// A sine, and of the size of a surface: places are given with the six digits of a figure.
constexpr double drawn_digits = 1e-6;
// Sine between axes that are parallel but for rounding.
constexpr double parallel_sine = 1e-9;

template <class Scalar>
bool is_edge(const ContactSurface<Scalar>& s) {
  return s.kind == SurfaceKind::torus && plain(s.tube) == 0;
}
template <class Scalar>
bool is_straight(const ContactSurface<Scalar>& s) {
  return s.kind == SurfaceKind::cylinder || s.kind == SurfaceKind::cone;
}

// How far a place is from a surface, and the outward normal there; of an edge the part of `out` across it.
std::pair<double, Vector> seen_from(const ContactSurface<double>& s, const Vector& C, const Vector& out) {
  const Vector r = C - s.center;
  const double z = dot(r, s.axis);
  const Vector across = r - z * s.axis;
  switch (s.kind) {
    case SurfaceKind::plane:
      return {z, s.axis};
    case SurfaceKind::sphere:
      return {norm(r) - s.radius, normalized(r)};
    case SurfaceKind::cylinder:
      return {norm(across) - s.radius, normalized(across)};
    case SurfaceKind::cone:
      return {norm(across) * s.cosine - z * s.sine, s.cosine * normalized(across) - s.sine * s.axis};
    case SurfaceKind::torus: {
      const Vector beside = across - s.radius * normalized(across) + z * s.axis;
      if (s.tube > 0) return {norm(beside) - s.tube, normalized(beside)};
      const Vector along = cross(s.axis, normalized(across));
      return {norm(beside), normalized(Vector(out - dot(out, along) * along))};
    }
    case SurfaceKind::ellipsoid: {
      double square = 0;
      Vector slope = Vector::zero();
      for (const Vector& a : s.semi_axes) {
        const double part = dot(a, r) / norm_squared(a);
        square += part * part;
        slope += part / norm_squared(a) * a;
      }
      return {(square - 1) / (2 * norm(slope)), normalized(slope)};
    }
  }
  return {};
}

// What a body has at a place of contact.
template <class Scalar>
struct Touched {
  std::optional<ContactSurface<Scalar>> surface;
  std::optional<ContactLimit::End> end;
  bool askew = false;   // whether the place is on a surface, but the normal does not stand on it
  bool hollow = false;  // whether the normal stands on the inside
};

template <class Scalar>
void look_at(const std::vector<Candidate<Scalar>>& list, const Vector& C, const Vector& out, Touched<Scalar>& touched) {
  for (const Candidate<Scalar>& candidate : list) {
    // The edge of what lies flat is the rim of a flat side.
    if (is_edge(candidate.surface) && norm(cross(plain(candidate.surface.axis), out)) <= drawn_digits) continue;
    const auto [gap, normal] = seen_from(detail::plain_surface(candidate.surface), C, out);
    if (!(std::abs(gap) <= drawn_digits * candidate.size)) continue;
    if (candidate.end) {
      const double along = dot(C - candidate.end->point, candidate.end->axis);
      if (along < -drawn_digits * candidate.size || along > candidate.end->extent + drawn_digits * candidate.size)
        continue;
    }
    if (!(norm(cross(normal, out)) <= drawn_digits)) {
      touched.askew = true;
      continue;
    }
    // A smooth surface goes before an edge.
    if (touched.surface && (is_edge(candidate.surface) || !is_edge(*touched.surface))) continue;
    touched.surface = candidate.surface;
    touched.end = candidate.end;
    touched.hollow = dot(normal, out) < 0;
  }
}

// out: the direction out of the body at the place, towards what it touches.
template <class Scalar>
Touched<Scalar> touched_surface(const Body& body, DataScope<Scalar>& data, const Vector3<Scalar>& C,
                                const Vector3<Scalar>& out) {
  Touched<Scalar> touched;
  const Vector place = plain(C), away = plain(out);
  for (const auto* list : {&body.parts, &body.added})
    for (const Part& part : *list) {
      const ShapeRow<Scalar>& row = shape_row<Scalar>(part.shape.kind);
      const ShapeArguments<Scalar> arguments(part.shape, data, part.name, false);
      if (part.shape.kind == "rod") {
        const auto ends = arguments.places("points", 2);
        const Vector3<Scalar> e = normalized(ends[1] - ends[0]);
        const double along = plain(dot(C - ends[0], e)), length = norm(plain(ends[1] - ends[0]));
        if (along > drawn_digits * length && along < (1 - drawn_digits) * length &&
            norm(plain(C - ends[0]) - along * plain(e)) <= drawn_digits * length &&
            std::abs(plain(dot(e, out))) <= drawn_digits) {
          touched.surface = cylinder_about(ends[0], e, Scalar(0));
          touched.end = ContactLimit::End{plain(ends[0]), plain(e), length};
        }
      }
      if (!row.round) continue;
      std::vector<Candidate<Scalar>> found =
          std::visit([](const auto& round) { return candidates(round); }, row.round(arguments));
      if (arguments.has("inner_radius")) {
        const Scalar inner = arguments.length("inner_radius");
        if (part.shape.kind == "tube") {
          const auto [A, B] = arguments.ends();
          for (auto& one : candidates(FrustumSurface<Scalar>{A, inner, B, inner})) found.push_back(std::move(one));
        } else {
          for (auto& one :
               candidates(CircleSurface<Scalar>{arguments.place("center"), arguments.direction("normal"), inner}))
            found.push_back(std::move(one));
        }
      }
      look_at(found, place, away, touched);
      // The flat sides of disks, cylinders and half spheres: their edge turned flat.
      for (const Candidate<Scalar>& one : found) {
        if (touched.surface || !is_edge(one.surface)) continue;
        const ContactSurface<double> edge = detail::plain_surface(one.surface);
        const Vector r = place - edge.center;
        const double along = dot(r, edge.axis);
        if (std::abs(along) <= drawn_digits * one.size &&
            norm(r - along * edge.axis) <= (1 + drawn_digits) * edge.radius &&
            norm(cross(edge.axis, away)) <= drawn_digits)
          touched.surface = plane_at(C, out);
      }
    }
  if (touched.surface) return touched;
  const auto straight = straight_directions(body, data, place, away);
  if (straight.size() == 2) touched.surface = plane_at(C, out);
  if (straight.empty()) {
    const std::optional<double> gap = gap_to_sides(body, data, place);
    const double size = norm(place) + norm(away);
    if (gap && *gap <= drawn_digits * size) touched.surface = sphere_at(C, Scalar(0));
  }
  return touched;
}

// Whether two bodies turn relative to each other about an axis only, wherever they go.
template <class Scalar>
bool turn_about_only(const Model<Scalar>& tree, int on, int from, const Vector& axis) {
  Workspace<Scalar> w(tree);
  update_poses<Scalar>(tree, w, neutral_state(tree).q);
  std::vector<Vector> turns(static_cast<std::size_t>(tree.velocity_size()), Vector::zero());
  for (const auto& [body, sign] : {std::pair{on, 1.0}, std::pair{from, -1.0}})
    for_each_coordinate_motion(tree, w, body, Vector3<Scalar>::zero(),
                               [&, s = sign](int k, const SpatialMotion<Scalar>& S) {
                                 turns[static_cast<std::size_t>(k)] += s * plain(S.angular);
                               });
  return std::ranges::all_of(turns, [&](const Vector& turn) { return norm(cross(turn, axis)) <= parallel_sine; });
}

// The circle of a disk, or of a cylinder through a place.
template <class Scalar>
ContactSurface<Scalar> circle_of(const ContactSurface<Scalar>& s, const Vector3<Scalar>& C) {
  if (is_edge(s)) return s;
  ContactSurface<Scalar> circle =
      torus_about(s.center + dot(C - s.center, s.axis) * s.axis, s.axis, s.radius, Scalar(0));
  circle.inside = s.inside;
  return circle;
}

template <class Scalar>
class PairReader {
 public:
  PairReader(MachineDraft<Scalar>& draft, const Contact& contact, const Vector3<Scalar>& C, const Vector3<Scalar>& S,
             const Vector3<Scalar>& n)
      : draft_(draft), contact_(contact), C_(C), S_(S), n_(n) {}

  std::optional<TouchingSurfaces<Scalar>> read() {
    const Body* against = body_named(contact_.against);
    if (contact_.inside.empty() &&
        !(against && has_part(*against, [](const ShapeRow<Scalar>& row) { return row.round != nullptr; })) &&
        !has_part(*body_named(contact_.of), [](const ShapeRow<Scalar>& row) {
          return row.round != nullptr && row.other == OtherSurface::curved;
        }))
      return std::nullopt;
    Touched<Scalar> on;
    if (contact_.corner)
      on.surface = sphere_at(C_, Scalar(0));
    else
      on = touched_surface(*body_named(contact_.of), draft_.data, C_, Vector3<Scalar>(-n_));
    Touched<Scalar> from;
    if (against)
      from = touched_surface(*against, draft_.data, S_, n_);
    else
      from.surface = plane_at(S_, n_);
    if (!contact_.inside.empty() && contact_.inside != contact_.of && !against)
      refuse(contact_.inside_mark, "'" + contact_.inside + "' has no inside",
             "weld a body with the shape to it, with mass: 0 kg if it has none, and state the contact against that");
    check_side(on, contact_.of);
    check_side(from, contact_.against);
    if (!on.surface || !from.surface || !is_curved(*on.surface, *from.surface)) {
      if (!contact_.inside.empty()) unknown_inside();
      return std::nullopt;
    }
    if constexpr (std::is_same_v<Scalar, Formula>)
      if (contact_.friction) throw NoFormula("friction between curved surfaces is solved for numbers");
    on.surface->inside = contact_.inside == contact_.of;
    from.surface->inside = contact_.inside == contact_.against;
    TouchingSurfaces<Scalar> found{
        {*on.surface, *from.surface, *on.surface, *from.surface, 1, n_, {}}, on.end, from.end};
    // A slip stays on its line where the surfaces turn about what lies across it.
    found.surfaces.tangent =
        contact_.slip ? normalized(cross(n_, draft_.data.direction(*contact_.slip))) : across(n_).second;
    found.along_line = settle_parallel(found.surfaces);
    settle_sides(found.surfaces);
    if (std::is_same_v<Scalar, Formula> && !has_closed_form(found.surfaces.on, found.surfaces.from))
      return std::nullopt;
    if (contact_.open) {
      check_open(found);
    } else {
      check_curvature(found.surfaces);
      check_nearest(found.surfaces);
    }
    place(found);
    return found;
  }

 private:
  const Body* body_named(const std::string& name) const {
    const auto found = std::ranges::find(draft_.situation.bodies, name, &Body::name);
    return found == draft_.situation.bodies.end() ? nullptr : &*found;
  }
  template <class Which>
  static bool has_part(const Body& body, Which which) {
    for (const auto* list : {&body.parts, &body.added})
      for (const Part& part : *list)
        if (which(shape_row<Scalar>(part.shape.kind))) return true;
    return false;
  }
  [[noreturn]] void refuse(const Mark& mark, const std::string& message, const std::string& hint) const {
    fail(draft_.situation.file, mark, message, hint);
  }
  [[noreturn]] void unknown_inside() const {
    refuse(contact_.inside_mark,
           "contact '" + contact_.name + "' is not inside '" + contact_.inside +
               "': the point under at: is on no hollow surface of it, or what touches there is not known",
           "give the bodies shapes that touch there: the inside of a sphere, ellipsoid, cylinder, cone or torus, a "
           "half sphere, a ring or a tube");
  }

  void check_side(const Touched<Scalar>& touched, const std::string& name) const {
    if (!touched.surface) {
      if (touched.askew && contact_.inside == name)
        refuse(contact_.normal.mark(),
               "the normal of contact '" + contact_.name + "' does not stand on the surface of '" + name +
                   "' at that point",
               "correct it, or the point under at:");
      return;
    }
    const bool stated = contact_.inside == name;
    const SurfaceKind kind = touched.surface->kind;
    if (kind == SurfaceKind::plane || (kind == SurfaceKind::sphere && plain(touched.surface->radius) == 0)) return;
    if (touched.hollow && !stated)
      refuse(contact_.normal.mark(), "by its normal contact '" + contact_.name + "' is on the inside of '" + name + "'",
             "write inside: " + name + " if its hollow side touches; else turn the normal round, it points into '" +
                 contact_.of + "'");
    if (!touched.hollow && stated && !is_edge(*touched.surface))
      refuse(contact_.inside_mark, "by its normal contact '" + contact_.name + "' is on the outside of '" + name + "'",
             "leave inside: out, or turn the normal round: it points into '" + contact_.of + "'");
  }

  static bool is_curved(const ContactSurface<Scalar>& on, const ContactSurface<Scalar>& from) {
    const bool smooth = from.kind != SurfaceKind::plane &&
                        !(from.kind == SurfaceKind::sphere && plain(from.radius) == 0) &&
                        !(from.kind == SurfaceKind::cylinder && plain(from.radius) == 0);
    return smooth || on.kind == SurfaceKind::ellipsoid || (on.kind == SurfaceKind::torus && plain(on.tube) > 0);
  }

  // Disks and cylinders with parallel axes touch along a line. Where they keep them parallel a sphere moves as the one
  // does in the other, else the circle through the place touches. Returns whether that is so.
  bool settle_parallel(CurvedContact<Scalar>& both) const {
    ContactSurface<Scalar>&on = both.on, &from = both.from;
    const auto round = [](const ContactSurface<Scalar>& s) {
      return is_edge(s) || (s.kind == SurfaceKind::cylinder && plain(s.radius) > 0);
    };
    // A point beside an edge is known where it stays in the plane of the edge.
    const bool point = on.kind == SurfaceKind::sphere && plain(on.radius) == 0;
    if (point && is_edge(from) && turns_about(plain(from.axis))) {
      const bool hollow = from.inside;
      both.shape_from = cylinder_about(from.center, from.axis, from.radius);
      both.tangent = lifted<Scalar>(plain(from.axis));
      if constexpr (std::is_same_v<Scalar, Formula>) both.tangent = from.axis;
      from = sphere_at(from.center, from.radius);
      from.inside = both.shape_from.inside = hollow;
      return false;
    }
    const bool beside_flat = on.kind == SurfaceKind::plane && round(from);
    if (!beside_flat && !(round(on) && round(from) && norm(cross(plain(on.axis), plain(from.axis))) <= parallel_sine)) {
      if (is_edge(on) && is_edge(from)) refuse_edges();
      return false;
    }
    both.shape_from = from;
    if (beside_flat) {
      from = both.shape_from = circle_of(from, S_);
    } else {
      if (from.kind != SurfaceKind::cylinder && on.kind != SurfaceKind::cylinder && !turns_about(plain(on.axis)))
        refuse_edges();
      if (is_edge(from) && on.kind == SurfaceKind::cylinder) {
        both.shape_from = from;
      } else {
        on = both.shape_on = circle_of(on, C_);
        const bool hollow = from.inside;
        from = both.shape_from = cylinder_about(from.center, from.axis, from.radius);
        from.inside = both.shape_from.inside = hollow;
      }
    }
    const Vector axis = plain(from.axis);
    both.tangent = lifted<Scalar>(axis);
    if constexpr (std::is_same_v<Scalar, Formula>) both.tangent = from.axis;
    if (!turns_about(axis)) return true;
    ContactSurface<Scalar>& edge = is_edge(on) ? on : from;
    const bool hollow = edge.inside;
    edge = sphere_at(edge.center, edge.radius);
    edge.inside = hollow;
    return false;
  }
  bool turns_about(const Vector& axis) const {
    // What moves in a plane turns about its normal only.
    if (const auto& plane = draft_.situation.plane;
        plane && norm(cross(Vector::unit(plane->normal()), axis)) <= parallel_sine)
      return true;
    return turn_about_only(draft_.machine.mechanism.tree, draft_.body(contact_.of), draft_.body(contact_.against),
                           axis);
  }
  [[noreturn]] void refuse_edges() const {
    refuse(
        contact_.mark,
        "contact '" + contact_.name + "' is between two edges, and it is not known how they cross as the bodies move",
        "let joints keep both in one plane (planar: of the normal), or give one of them a thickness: cylinder:");
  }

  // Which of the places with a common normal is meant.
  void settle_sides(CurvedContact<Scalar>& both) const {
    const auto settle = [&](ContactSurface<Scalar>& s, const ContactSurface<Scalar>& other, const Vector& out) {
      if (s.kind != SurfaceKind::torus) return;
      const ContactSurface<double> t = detail::plain_surface(s);
      const auto beside = [&](const Vector& a) { return a - dot(a, t.axis) * t.axis; };
      const Vector ring = beside(plain(C_) - t.center);
      const Vector outward = s.inside ? Vector(-out) : out;
      s.side = dot(beside(outward), ring) < 0 ? -1 : 1;
      s.half = dot(beside(plain(other.center) - t.center), ring) < 0 ? -1 : 1;
      if (norm(beside(outward)) < drawn_digits && other.kind != SurfaceKind::sphere)
        refuse(contact_.mark,
               "'" + (&s == &both.on ? contact_.of : contact_.against) + "' lies flat at contact '" + contact_.name +
                   "': it touches all around",
               "state contacts at points of it that are fixed");
      if (s.side < 0 && other.kind != SurfaceKind::sphere && other.kind != SurfaceKind::plane)
        refuse(contact_.mark,
               "contact '" + contact_.name + "' is on the inner side of a ring, which is solved for spheres only",
               "give what touches there a spherical shape");
    };
    const Vector n = plain(n_);
    settle(both.on, both.from, Vector(-n));
    settle(both.from, both.on, n);
    both.shape_on.side = both.on.side;
    if (is_straight(both.on) && is_straight(both.from)) {
      if (norm(cross(plain(both.on.axis), plain(both.from.axis))) <= parallel_sine) touch_along_line();
      both.branch = dot(cross(plain(both.on.axis), plain(both.from.axis)), n) < 0 ? -1 : 1;
    }
  }
  [[noreturn]] void touch_along_line() const {
    refuse(contact_.mark,
           "the surfaces of '" + contact_.of + "' and '" + contact_.against + "' touch along a line at contact '" +
               contact_.name + "'",
           "state it where they touch at one point: a sphere in place of one of them, or cylinders with parallel axes");
  }

  void check_curvature(const CurvedContact<Scalar>& both) const {
    const ContactSurface<double> on = detail::plain_surface(both.shape_on),
                                 from = detail::plain_surface(both.shape_from);
    const std::optional<double> least = solve::least_relative_curvature(on, from, plain(C_), plain(n_));
    if (!least) refuse_edges();
    const double size = std::max({largest_size(on), largest_size(from), norm(plain(C_) - from.center)});
    if (std::isinf(*least) || *least * size > drawn_digits) return;
    if (*least * size > -drawn_digits) touch_along_line();
    refuse(contact_.mark,
           "the surfaces of '" + contact_.of + "' and '" + contact_.against + "' cut into each other beside contact '" +
               contact_.name + "'",
           contact_.inside.empty() ? "one of them is hollow there: correct the point, or the sizes"
                                   : "what touches inside is less curved than what it is in: a ball that is larger "
                                     "than its bowl touches at its rim");
  }
  static double largest_size(const ContactSurface<double>& s) {
    double size = std::max(s.radius, s.tube);
    for (const Vector& a : s.semi_axes) size = std::max(size, norm(a));
    return size;
  }

  void check_nearest(const CurvedContact<Scalar>& both) const {
    const auto now = nearest_points(detail::plain_surface(both.on), detail::plain_surface(both.from), both.branch);
    const double size =
        norm(plain(C_)) + largest_size(detail::plain_surface(both.on)) + largest_size(detail::plain_surface(both.from));
    const double apart = dot(now.normal, now.on - now.from);
    // Of the sizes: more is no rounding of given numbers, and the motion would begin with surfaces that do not touch.
    constexpr double closed = 1e-9;
    const double off = std::max(norm(now.on - plain(C_)), norm(now.from - plain(C_)));
    constexpr double magnified = 100;  // of the digits of a figure, by flat surfaces
    if (off <= magnified * drawn_digits * size && norm(now.normal - plain(n_)) <= magnified * drawn_digits) {
      if (std::abs(apart) <= closed * size) return;
      refuse(contact_.at.mark(),
             fmt::format("at contact '{}' the surfaces of '{}' and '{}' {} by {:.3g} m", contact_.name, contact_.of,
                         contact_.against, apart > 0 ? "are apart" : "overlap", std::abs(apart)),
             "write the places and sizes so that they touch: as expressions of each other, or with more digits");
    }
    refuse(contact_.at.mark(),
           fmt::format("at contact '{}' the surfaces of '{}' and '{}' do not come nearest to each other", contact_.name,
                       contact_.of, contact_.against),
           "they overlap, or touch elsewhere: correct the point, the normal or the sizes");
  }

  // What does not touch yet may come from anywhere, so that a surface must have no end, and nearest places that are
  // sure.
  void check_open(const TouchingSurfaces<Scalar>& found) const {
    // In a plane the edge of a disk has no end: it is the cylinder across the plane.
    const auto whole = [this](const ContactSurface<Scalar>& s) {
      return s.kind == SurfaceKind::sphere || s.kind == SurfaceKind::ellipsoid || s.kind == SurfaceKind::plane ||
             (s.kind == SurfaceKind::cylinder && draft_.situation.plane && turns_about(plain(s.axis)));
    };
    if (!found.end_on && !found.end_from && whole(found.surfaces.on) && whole(found.surfaces.from)) return;
    refuse(contact_.mark,
           "contact '" + contact_.name + "' is open between curved surfaces, of which one has an end or a ring",
           "what meets later is followed for spheres, ellipsoids, planes, and disks that joints or plane: keep in one "
           "plane");
  }

  // From the axes of the drawing to those of the bodies.
  void place(TouchingSurfaces<Scalar>& found) const {
    const auto placed = [&](int body, const ContactSurface<Scalar>& s) {
      return converted_surface<Scalar>(
          s, [&](const Vector3<Scalar>& p) { return draft_.machine.place(body, p).point; },
          [](const Vector3<Scalar>& d) { return d; }, [](const Scalar& x) { return x; });
    };
    const int on = draft_.body(contact_.of), from = draft_.body(contact_.against);
    CurvedContact<Scalar>& both = found.surfaces;
    both.on = placed(on, both.on);
    both.shape_on = placed(on, both.shape_on);
    both.from = placed(from, both.from);
    both.shape_from = placed(from, both.shape_from);
    if (found.end_on) found.end_on->point -= plain(draft_.machine.drawn_origin.at(on));
    if (found.end_from) {
      found.end_from->point -= plain(draft_.machine.drawn_origin.at(from));
      found.end_from->of_against = true;
    }
  }

  MachineDraft<Scalar>& draft_;
  const Contact& contact_;
  const Vector3<Scalar>&C_, &S_, &n_;
};

}  // namespace

template <class Scalar>
std::optional<TouchingSurfaces<Scalar>> touching_surfaces(MachineDraft<Scalar>& draft, const Contact& contact,
                                                          const Vector3<Scalar>& C, const Vector3<Scalar>& S,
                                                          const Vector3<Scalar>& n) {
  return PairReader<Scalar>(draft, contact, C, S, n).read();
}

template std::optional<TouchingSurfaces<double>> touching_surfaces(MachineDraft<double>&, const Contact&,
                                                                   const Vector3<double>&, const Vector3<double>&,
                                                                   const Vector3<double>&);
template std::optional<TouchingSurfaces<Dual<1>>> touching_surfaces(MachineDraft<Dual<1>>&, const Contact&,
                                                                    const Vector3<Dual<1>>&, const Vector3<Dual<1>>&,
                                                                    const Vector3<Dual<1>>&);
template std::optional<TouchingSurfaces<Formula>> touching_surfaces(MachineDraft<Formula>&, const Contact&,
                                                                    const Vector3<Formula>&, const Vector3<Formula>&,
                                                                    const Vector3<Formula>&);

}  // namespace poinsot::problem
