"""Faults to plant in the solver, each a text in a source and what takes its place.

They are errors of the kinds that a person makes: a sign, a term left out, a factor, one of several branches. None is made
in a check. Each stands where one road to an answer goes and the other does not.
"""
from dataclasses import dataclass


@dataclass(frozen=True)
class Fault:
    name: str
    file: str
    right: str  # stands once in the file
    wrong: str


ENGINE = "src/engine/"
PROBLEM = "src/problem/"
EQUATIONS = ENGINE + "solve/instant/equations.cpp"
IMPULSE = ENGINE + "solve/instant/impulse.cpp"
MOMENTUM = PROBLEM + "quantities/quantities_momentum.cpp"
FORCES = PROBLEM + "quantities/quantities_forces.cpp"
FEATURES = PROBLEM + "course/motion_features.cpp"
ALONG = PROBLEM + "course/number_along_motion.cpp"
STAGE = PROBLEM + "course/motion_stage.cpp"
PIECE = PROBLEM + "course/motion_piece.cpp"

FAULTS = [
    # The equations of an instant.
    Fault("no gyroscopic moment", EQUATIONS, "weight_moment[k] - known.angular[k], gyroscopic", "weight_moment[k], gyroscopic"),
    Fault("centripetal force reversed", EQUATIONS, "I.mass * tree.gravity()[k] - known.linear[k]", "I.mass * tree.gravity()[k] + known.linear[k]"),
    Fault("no acceleration of the center about the origin", EQUATIONS, "I.mass * S.linear + cross(S.angular, first_moment)", "I.mass * S.linear"),
    Fault("no moment of inertia of the origin's acceleration", EQUATIONS, " + cross(first_moment, S.linear);", ";"),
    Fault("weight without moment", EQUATIONS, "const Vector weight_moment = cross(first_moment, tree.gravity());", "const Vector weight_moment = Scalar(0) * cross(first_moment, tree.gravity());"),
    Fault("forces about the wrong point", EQUATIONS, "wrench.moment - cross(O, wrench.force);", "wrench.moment + cross(O, wrench.force);"),
    # Blows.
    Fault("angular momentum before a blow left out", IMPULSE, "system.add_right_side(row + 3 + k, momentum.angular[k]);", "(void)momentum.angular[k];"),
    Fault("impulses about the wrong point", IMPULSE, "wrench.moment - cross(center[static_cast<std::size_t>(body)], wrench.force)", "wrench.moment + cross(center[static_cast<std::size_t>(body)], wrench.force)"),
    Fault("inertia about the origin in a blow", IMPULSE, "I.inertia - mass * unit_mass_inertia(I.first_moment / mass);", "I.inertia;"),
    # What is asked.
    Fault("angular momentum about the origin", MOMENTUM, "body_momentum(model_, workspace_, body, P);\n    const Vector angular = total.angular", "body_momentum(model_, workspace_, body, Vector::zero());\n    const Vector angular = total.angular"),
    Fault("potential energy reversed", MOMENTUM, "sum = sum - model_.body(i).inertia.mass * dot", "sum = sum + model_.body(i).inertia.mass * dot"),
    Fault("force on the other body not reversed", FORCES, "sign = Base(-1);", "sign = Base(1);"),
    # Followed motions.
    Fault("generalised forces without couples", ENGINE + "motion/mechanism/mechanism_dynamics.cpp", "dot(angular[k], force.couple + cross(force.point - origin[k], force.force))", "dot(angular[k], cross(force.point - origin[k], force.force))"),
    Fault("constraints without the part of velocities", ENGINE + "motion/mechanism/mechanism_constraints.cpp", "row_bias[i] = line.bias;", "row_bias[i] = 0;"),
    Fault("laws of force left out of motions", ENGINE + "motion/mechanism/mechanism_dynamics.cpp", "law.exerted(mechanism.tree, workspace), 1, known.data()", "law.exerted(mechanism.tree, workspace), 0, known.data()"),
    Fault("a coefficient of the integrator", ENGINE + "motion/integrator/dormand_prince_853_tableau.h", "6.02165389804559606850219397283e-2", "6.02165389804559606850219397283e-3"),
    Fault("dense output by another polynomial", ENGINE + "motion/integrator/trajectory.cpp", "k % 2 == 1 ? 1.0 - s : s;", "k % 2 == 1 ? 1.0 - s * s : s;"),
    Fault("closed form of the top turns back", ENGINE + "motion/closed_form/symmetric_top_evaluation.cpp", "rate.im += half.rate * value.re;", "rate.im -= half.rate * value.re;"),
    Fault("a cord never goes slack", PIECE, "event->terminal = true;\n", "event->terminal = false;\n"),
    Fault("caught without a blow", STAGE, "if (acting[action]) now.v = probe_->caught(acting);", ""),
    Fault("the driving stands still", PIECE, "const Machine then = motion_.start_->machine_at(inside(time), loads_);", "const Machine then = motion_.start_->machine_at(inside(span_.begin), loads_);"),
    # Questions of a motion.
    Fault("extremes only at samples", FEATURES, "if (sign * rough.estimate + rough.doubt < highest) continue;", "continue;"),
    Fault("the last extreme for the largest", FEATURES, "if (sign * sampled.value[i] > sign * best.value) best = {sampled.value[i], sampled.time[i]};", "best = {sampled.value[i], sampled.time[i]};"),
    Fault("the last time for the first", FEATURES, "if (!found.empty()) return {found.front()};", "if (!found.empty()) return {found.back()};"),
    Fault("falls taken for rises", FEATURES, "const bool rises = a < 0 && b >= 0, falls = a > 0 && b <= 0;", "const bool falls = a < 0 && b >= 0, rises = a > 0 && b <= 0;"),
    Fault("two periods for one", FEATURES, "for (std::size_t k = 1; k <= most_rises", "for (std::size_t k = 2; k <= most_rises"),
    Fault("zeros where the bracket begins", ALONG, "if (fa == 0) return a;", "if (fa != 0) return a;"),
    # Steady motions and roots.
    Fault("no damping and no gyroscopic terms near a steady motion", ENGINE + "solve/stability/linearisation.cpp", "slopes_.by_position.*part, slopes_.by_velocity.*part;", "slopes_.by_position.*part, Real(0) * (slopes_.by_velocity.*part);"),
    Fault("a root is lost", ENGINE + "solve/roots/roots.cpp", "roots.points = found_.points(function_);", "roots.points = found_.points(function_);\n      if (roots.points.size() > 1) roots.points.pop_back();"),
    Fault("contacts may pull", PROBLEM + "instant/instant_forces.cpp", "if (unknowns_[first + k] >= 0) continue;", "if (std::abs(unknowns_[first + k]) >= 0) continue;"),
]
