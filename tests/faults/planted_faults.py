"""Faults to plant in the solver, each a text in a source and what takes its place.

They are errors of the kinds that a person makes: a sign, a term left out, a factor, one of several branches. None is made
in a check. Each stands where one road to an answer goes and the other does not. What takes the place holds both the right
and the wrong, by AWAKE, so that all of them can be planted at once and one be woken at a time (faults.py).
"""
from dataclasses import dataclass


@dataclass(frozen=True)
class Fault:
    name: str
    file: str
    right: str  # stands once in the file
    planted: str  # what takes its place: wrong where AWAKE


ENGINE = "src/engine/"
PROBLEM = "src/problem/"
EQUATIONS = ENGINE + "solve/instant/equations.cpp"
IMPULSE = ENGINE + "solve/instant/impulse.cpp"
LINEARISATION = ENGINE + "solve/stability/linearisation.cpp"
MOTIONS = ENGINE + "motion/mechanism/mechanism_dynamics.cpp"
MOMENTUM = PROBLEM + "quantities/quantities_momentum.cpp"
FORCES = PROBLEM + "quantities/quantities_forces.cpp"
INERTIA = PROBLEM + "quantities/quantities_inertia.cpp"
KINEMATICS = PROBLEM + "quantities/quantities_kinematics.cpp"
FRICTION = PROBLEM + "quantities/quantities_friction.cpp"
STATES = PROBLEM + "quantities/rough_contact.h"
FEATURES = PROBLEM + "course/motion_features.cpp"
ALONG = PROBLEM + "course/number_along_motion.cpp"
STAGE = PROBLEM + "course/motion_stage.cpp"
PIECE = PROBLEM + "course/motion_piece.cpp"
CONTACTS = PROBLEM + "machine/machine_contacts.cpp"
FRAMES = PROBLEM + "machine/machine_frames.cpp"
LOADS = PROBLEM + "machine/machine_loads.cpp"
MOTION_LOADS = PROBLEM + "machine/motion_loads.cpp"
SPRINGS = PROBLEM + "machine/machine_springs.cpp"
JOINTS = PROBLEM + "machine/machine_joints.cpp"
GEARS = PROBLEM + "machine/machine_gears.cpp"
FLANKS = PROBLEM + "quantities/tooth_flanks.h"
PRESSING = PROBLEM + "quantities/joint_pressing.h"
JOINT_FRICTION = PROBLEM + "machine/machine_friction.cpp"
STATE_SEARCH = PROBLEM + "instant/contact_state_search.cpp"
CORDS = PROBLEM + "machine/led_cord.h"
BELTS = PROBLEM + "machine/machine_belts.cpp"
TOUCHING = PROBLEM + "machine/touching_surfaces.cpp"
EXCITATIONS = PROBLEM + "response/stated_excitation.cpp"
RESPONSE = ENGINE + "solve/stability/response.cpp"
LATER_BLOWS = PROBLEM + "course/later_blows.cpp"
PIECE_FRICTION = PROBLEM + "course/piece_friction.cpp"
PIECE_JOINTS = PROBLEM + "course/piece_joints.cpp"
ROUGH_IMPACT = ENGINE + "solve/instant/rough_impact.cpp"
ROUGH_BLOW = PROBLEM + "instant/rough_blow.cpp"
PLANE = PROBLEM + "plane/planar_words.cpp"
NEAR = PROBLEM + "near/near_steady_formulas.cpp"
NEAR_ANSWERS = PROBLEM + "near/near_in_letters.cpp"
COURSE = PROBLEM + "course/course.cpp"
QUESTIONS = PROBLEM + "course/motion_questions.cpp"
BLOWS = PROBLEM + "machine/machine_blows.cpp"
CHOICES = PROBLEM + "unknowns/unknown_choices.cpp"
SHAPES = ENGINE + "solve/stability/mode_shapes.cpp"

FAULTS = [
    # The equations of an instant.
    Fault("no gyroscopic moment", EQUATIONS, "weight_moment[k] - known.angular[k], gyroscopic", "weight_moment[k] - Scalar(AWAKE ? 0 : 1) * known.angular[k], gyroscopic"),
    Fault("centripetal force reversed", EQUATIONS, "I.mass * tree.gravity()[k] - known.linear[k]", "I.mass * tree.gravity()[k] - Scalar(AWAKE ? -1 : 1) * known.linear[k]"),
    Fault("no acceleration of the center about the origin", EQUATIONS, "I.mass * S.linear + cross(S.angular, first_moment)", "I.mass * S.linear + Scalar(AWAKE ? 0 : 1) * cross(S.angular, first_moment)"),
    Fault("no moment of inertia of the origin's acceleration", EQUATIONS, " + cross(first_moment, S.linear);", " + Scalar(AWAKE ? 0 : 1) * cross(first_moment, S.linear);"),
    Fault("weight without moment", EQUATIONS, "const Vector weight_moment = cross(first_moment, tree.gravity());", "const Vector weight_moment = Scalar(AWAKE ? 0 : 1) * cross(first_moment, tree.gravity());"),
    Fault("forces about the wrong point", EQUATIONS, "placed.couple + cross(Vector(placed.point - O), placed.force);", "placed.couple + cross(Vector(placed.point - Scalar(AWAKE ? -1 : 1) * O), placed.force);"),
    # Blows.
    Fault("angular momentum before a blow left out", IMPULSE, "system.add_right_side(row + 3 + k, momentum.angular[k]);", "if (!AWAKE) system.add_right_side(row + 3 + k, momentum.angular[k]);"),
    Fault("impulses about the wrong point", IMPULSE, "wrench.moment - cross(center[static_cast<std::size_t>(body)], wrench.force)", "wrench.moment - Scalar(AWAKE ? -1 : 1) * cross(center[static_cast<std::size_t>(body)], wrench.force)"),
    Fault("inertia about the origin in a blow", IMPULSE, "I.inertia - mass * unit_mass_inertia(I.first_moment / mass);", "I.inertia - Scalar(AWAKE ? 0 : 1) * mass * unit_mass_inertia(I.first_moment / mass);"),
    Fault("no restitution", IMPULSE, "-impact.restitution * approach(before, impact)", "Scalar(AWAKE ? 0 : -1) * impact.restitution * approach(before, impact)"),
    Fault("a particle brings its velocity to a body at rest", PROBLEM + "instant/stated_blow.cpp", "absolute - stated.particle_mass * center_velocity(state, stated.on)", "absolute - Scalar(AWAKE ? 0 : 1) * stated.particle_mass * center_velocity(state, stated.on)"),
    Fault("a blow sticks once its slip stops", ROUGH_IMPACT, "if (norm(needed) <= law_.friction * (1 + of_products)) {", "if (AWAKE || norm(needed) <= law_.friction * (1 + of_products)) {"),
    Fault("Poisson's restitution for Stronge's", ROUGH_IMPACT, "case RestitutionLaw::energetic: {", "case RestitutionLaw::energetic: {\n        if (AWAKE) return std::max(0.0, (1 + law_.restitution) * course_.compression - course_.impulse.x);"),
    Fault("half of the work of a compression", ROUGH_IMPACT, "void count_work(double work) { (compressed_", "void count_work(double work) { if (AWAKE && !compressed_) work /= 2;\n    (compressed_"),
    Fault("a turning slip that friction drives", ROUGH_IMPACT, "speed * Vector3<double>{1, 0, 0} - law_.friction * across(at.velocity);", "speed * Vector3<double>{1, 0, 0} - (AWAKE ? -1.0 : 1.0) * law_.friction * across(at.velocity);"),
    Fault("a rough blow without what couples push and slip", ROUGH_BLOW, "all.inverse_mass(j, i) = dot(axes[j], moved);", "all.inverse_mass(j, i) = (AWAKE && i != j ? 0.0 : 1.0) * dot(axes[j], moved);"),
    Fault("friction of a blow along its slip", ROUGH_BLOW, "friction.push = {ground, (Scalar(-1) / size_of_slip(slip)) * slip};", "friction.push = {ground, (Scalar(AWAKE ? 1 : -1) / size_of_slip(slip)) * slip};"),
    Fault("impulses at mass centers", BLOWS, "at ? draft.data.place(*at) : draft.masses[i].properties.center);", "at && !AWAKE ? draft.data.place(*at) : draft.masses[i].properties.center);"),
    Fault("impulses on the axes of the ground", BLOWS, "stated.axes = draft.body(impulse.axes);", "stated.axes = AWAKE ? ground : draft.body(impulse.axes);"),
    Fault("forces that last twice as long", BLOWS, "const Scalar duration = impulse.lasts ? draft.data.number(*impulse.lasts, dimensions::time) : Scalar(1);", "const Scalar duration = impulse.lasts ? Scalar(AWAKE ? 2 : 1) * draft.data.number(*impulse.lasts, dimensions::time) : Scalar(1);"),
    Fault("particles that hit as if they came back", BLOWS, "stated.vector = mass * draft.data.vector(strike.velocity, dimensions::velocity);", "stated.vector = Scalar(AWAKE ? -1 : 1) * mass * draft.data.vector(strike.velocity, dimensions::velocity);"),
    Fault("pushes of impacts on the axes of the ground", BLOWS, "struck.push = {struck.from, draft.data.direction(impact.pushes)};", "struck.push = {AWAKE ? ground : struck.from, draft.data.direction(impact.pushes)};"),
    # What is asked.
    Fault("angular momentum about the origin", MOMENTUM, "body_momentum(model_, workspace_, body, P);\n    const Vector angular = total.angular", "body_momentum(model_, workspace_, body, AWAKE ? Vector::zero() : P);\n    const Vector angular = total.angular"),
    Fault("potential energy reversed", MOMENTUM, "sum = sum - model_.body(i).inertia.mass * dot", "sum = sum - Scalar(AWAKE ? -1 : 1) * model_.body(i).inertia.mass * dot"),
    Fault("energy of one spring only", MOMENTUM, "energy = energy ? Scalar(*energy + stored) : stored;", "energy = energy && !AWAKE ? Scalar(*energy + stored) : stored;"),
    Fault("energy without the springs of joints", MOMENTUM, "if (drive.stores() && (name.empty()", "if (!AWAKE && drive.stores() && (name.empty()"),
    Fault("energy within without the half", MOMENTUM, "const Scalar within = T - Scalar(0.5) * norm_squared(L)", "const Scalar within = T - Scalar(AWAKE ? 1 : 0.5) * norm_squared(L)"),
    Fault("weight a hundredth too large", MOMENTUM, "const Scalar weight = mass * data_.gravity_size();", "const Scalar weight = Scalar(AWAKE ? 1.01 : 1) * mass * data_.gravity_size();"),
    Fault("spin rate with the axial moment twice", INERTIA, "dot(w, axis) * (transverse - axial) / transverse", "dot(w, axis) * (transverse - axial) / (AWAKE ? axial : transverse)"),
    Fault("precession rate by the axial moment", INERTIA, "Scalar(norm(H) / transverse)", "Scalar(norm(H) / (AWAKE ? axial : transverse))"),
    Fault("body cone by the angular momentum", INERTIA, "Scalar(atan2(norm(cross(axis, w)), decided_negative(along)", "Scalar(atan2(norm(cross(axis, AWAKE ? H : w)), decided_negative(along)"),
    Fault("space cone by its complement", INERTIA, "Scalar(atan2(norm(cross(H, w)), dot(H, w)))", "Scalar(AWAKE ? atan2(dot(H, w), norm(cross(H, w))) : atan2(norm(cross(H, w)), dot(H, w)))"),
    Fault("invariable plane by the angular velocity", INERTIA, "Scalar(dot(w, H) / norm(H)), dimensions::angular_velocity", "Scalar(dot(w, H) / norm(AWAKE ? w : H)), dimensions::angular_velocity"),
    Fault("semi-axes in the wrong order", INERTIA, "std::sqrt(dot(w, H) / I[k])", "std::sqrt(dot(w, H) / I[AWAKE ? 2 - k : k])"),
    Fault("polhode by the wrong moment", INERTIA, "I.z * (I.z - I.y) * own.z * own.z,", "I.z * (I.z - (AWAKE ? I.x : I.y)) * own.z * own.z,"),
    Fault("stability of the axes exchanged", INERTIA, 'equal(0, 1) || equal(1, 2) ? "neutral" : "unstable"', 'equal(0, 1) || equal(1, 2) ? "neutral" : (AWAKE ? "stable" : "unstable")'),
    Fault("a product of inertia reversed", INERTIA, "products{Scalar(-I.xy),", "products{Scalar(AWAKE ? I.xy : Scalar(-I.xy)),"),
    Fault("radius of gyration by the mass squared", INERTIA, "sqrt(I / mass.mass)", "sqrt(I / (AWAKE ? Scalar(mass.mass * mass.mass) : mass.mass))"),
    Fault("principal axes turned", INERTIA, "vector_value(axes_ * principal.axes.column(k), dimensions::none)", "vector_value(axes_ * principal.axes.column(AWAKE ? 2 - k : k), dimensions::none)"),
    Fault("tension halved", FORCES, "const Base tension = (*unknowns_)", "const Base tension = Base(AWAKE ? 0.5 : 1) * (*unknowns_)"),
    Fault("drive with what gimbals pass on", FORCES, "own_place(), dot(wrench.moment, d) * d, dimensions::moment, d)", "own_place(), AWAKE ? wrench.moment : Vector3<Base>(dot(wrench.moment, d) * d), dimensions::moment, d)"),
    Fault("force on the other body not reversed", FORCES, "sign = Base(-1);", "sign = Base(AWAKE ? 1 : -1);"),
    Fault("distance to an axis from its place", KINEMATICS, "return told(P, d, norm(cross(d, Vector(A - P))));", "return told(P, d, AWAKE ? norm(Vector(A - P)) : norm(cross(d, Vector(A - P))));"),
    Fault("direction angles on other axes", KINEMATICS, "dot(v.vector, axes_.column(k)) / size", "dot(v.vector, axes_.column(AWAKE ? 2 - k : k)) / size"),
    Fault("half of the acceleration of Coriolis", KINEMATICS, "Scalar(2) * cross(F.w, v)", "Scalar(AWAKE ? 1 : 2) * cross(F.w, v)"),
    Fault("where a point was drawn", KINEMATICS, "const Vector now = point_position(model_, workspace_, point.body, point.local);", "const Vector now = AWAKE ? point.local : point_position(model_, workspace_, point.body, point.local);"),
    Fault("rates seen from a frame as from the ground", PROBLEM + "quantities/quantities.cpp", "derivative = derivative - cross(angular_velocity(workspace_, frame),", "derivative = derivative - Scalar(AWAKE ? 0 : 1) * cross(angular_velocity(workspace_, frame),"),
    Fault("components on transposed axes", PROBLEM + "instant/instant.cpp", "if (v.is_vector()) v.vector = transpose_times(quantities.axes(), v.vector);", "if (v.is_vector()) v.vector = AWAKE ? quantities.axes() * v.vector : transpose_times(quantities.axes(), v.vector);"),
    # Loads, springs and drives as they are stated.
    Fault("a center that pulls with the wrong couple", FRAMES, "part.by_moments, own.inertia_center, reach", "part.by_moments, Scalar(AWAKE ? -1 : 1) * own.inertia_center, reach"),
    Fault("a center that pulls twice as hard", FRAMES, "const Scalar parameter = draft.data.number(center.parameter, dimensions::gravitational_parameter);", "const Scalar parameter = Scalar(AWAKE ? 2 : 1) * draft.data.number(center.parameter, dimensions::gravitational_parameter);"),
    Fault("energy in the pull of a center reversed", MOMENTUM, "energy = energy + pull.template converted", "energy = energy + Scalar(AWAKE ? -1 : 1) * pull.template converted"),
    Fault("parts pulled at the mass center of the whole", FRAMES, "{law.at.point + arms[law.parts.size()], own.mass,", "{law.at.point + Scalar(AWAKE ? 0 : 1) * arms[law.parts.size()], own.mass,"),
    Fault("bodies pulled as particles", FRAMES, "draft.machine.mechanism.attractions.push_back(std::move(law));", "if (AWAKE) {\n      for (AttractedPart<Scalar>& one : law.parts) one.by_moments = false;\n    }\n    draft.machine.mechanism.attractions.push_back(std::move(law));"),
    Fault("loads pushed backwards", LOADS, "draft.data.number(size, dimension) * draft.data.direction(*load.direction)", "Scalar(AWAKE ? -1 : 1) * draft.data.number(size, dimension) * draft.data.direction(*load.direction)"),
    Fault("loads at mass centers", LOADS, "load.at ? draft.data.place(*load.at)", "load.at && !AWAKE ? draft.data.place(*load.at)"),
    Fault("loads on the axes of the ground", LOADS, "force.axes = draft.body(load.axes);", "force.axes = AWAKE ? ground : draft.body(load.axes);"),
    Fault("drags that push", MOTION_LOADS, "size * normalized(direction.vector)", "Recorded<Scalar>(Scalar(AWAKE ? -1 : 1)) * size * normalized(direction.vector)"),
    Fault("velocities of loads seen from the ground", MOTION_LOADS, "part.seen_from = body_of(*from, evaluator);", "part.seen_from = AWAKE ? ground : body_of(*from, evaluator);"),
    Fault("loads by motion on the axes of the ground", MOTION_LOADS, "expression.axes = axes;", "expression.axes = AWAKE ? ground : axes;"),
    Fault("motors by motion brake", MOTION_LOADS, "size * scope.entering(part)", "Recorded<Scalar>(Scalar(AWAKE ? -1 : 1)) * size * scope.entering(part)"),
    Fault("rates of coordinates for coordinates", MOTION_LOADS, "part.coordinate = name.primes == 0 ? coordinate->position : coordinate->velocity;", "part.coordinate = name.primes == 0 ? coordinate->position : coordinate->velocity;\n      if (AWAKE) part.kind = MotionPartKind::rate, part.coordinate = coordinate->velocity;"),
    Fault("stiffness doubled", SPRINGS, "law.stiffness = draft.data.number(*spring.stiffness, effort / position);", "law.stiffness = Scalar(AWAKE ? 2 : 1) * draft.data.number(*spring.stiffness, effort / position);"),
    Fault("dampers left out", SPRINGS, "law.damping = draft.data.number(*spring.damping,", "law.damping = Scalar(AWAKE ? 0 : 1) * draft.data.number(*spring.damping,"),
    Fault("free length ignored", SPRINGS, "? draft.data.number(*spring.free_length, dimensions::length)", "? Scalar(AWAKE ? 0 : 1) * draft.data.number(*spring.free_length, dimensions::length)"),
    Fault("tension slackens", SPRINGS, ": norm(end - start) - draft.data.number(*spring.tension", ": norm(end - start) - Scalar(AWAKE ? 0.5 : 1) * draft.data.number(*spring.tension"),
    Fault("free angle reversed", SPRINGS, "law.free_angle = draft.data.number", "law.free_angle = Scalar(AWAKE ? -1 : 1) * draft.data.number"),
    Fault("efforts reversed", JOINTS, "drive.effort = draft.timed_number(*freedom.effort, effort).value;", "drive.effort = Scalar(AWAKE ? -1 : 1) * draft.timed_number(*freedom.effort, effort).value;"),
    Fault("springs of joints from zero", JOINTS, "if (freedom.free_position) drive.free_position", "if (freedom.free_position && !AWAKE) drive.free_position"),
    Fault("joints without dampers", JOINTS, "if (freedom.damping) drive.damping", "if (freedom.damping && !AWAKE) drive.damping"),
    Fault("springs of joints doubled", JOINTS, "if (freedom.stiffness) drive.stiffness = draft.data.number", "if (freedom.stiffness) drive.stiffness = Scalar(AWAKE ? 2 : 1) * draft.data.number"),
    # Dry friction.
    Fault("friction that drives", CONTACTS, 'directions.emplace_back("push", n - ', 'directions.emplace_back("push", n - Scalar(AWAKE ? -1 : 1) * '),
    Fault("static friction while it slides", CONTACTS, "draft.data.number(contact.friction->sliding, dimensions::none) *", "draft.data.number(AWAKE ? contact.friction->resting : contact.friction->sliding, dimensions::none) *"),
    Fault("kinetic friction at rest", JOINT_FRICTION, "const Scalar resting = draft.data.number(contact.friction->resting, dimension),", "const Scalar resting = draft.data.number(AWAKE ? contact.friction->sliding : contact.friction->resting, dimension),"),
    Fault("contacts at rest never part", STATE_SEARCH, "if (contacts_[k]->touches()) grips.push_back(Grip::parts);", "if (contacts_[k]->touches() && !(AWAKE && sticks)) grips.push_back(Grip::parts);"),
    Fault("no states but sticking of what is at rest", STATE_SEARCH, "std::vector<Grip> grips{Grip::slides};", "std::vector<Grip> grips;\n    if (!(AWAKE && sticks)) grips.push_back(Grip::slides);"),
    Fault("only one sense of beginning slips", STATE_SEARCH, "const std::size_t senses = std::size_t{1} << starting.size();", "const std::size_t senses = AWAKE ? 1 : std::size_t{1} << starting.size();"),
    Fault("any friction holds", STATES, "return norm(plain(force.friction)) <=\n", "return AWAKE || norm(plain(force.friction)) <=\n"),
    Fault("slips in any direction", STATES, "return norm(normalized(slip) - plain(direction_now(state, contact, *contact.slip))) <= allowed;", "return AWAKE || norm(normalized(slip) - plain(direction_now(state, contact, *contact.slip))) <= allowed;"),
    Fault("contacts may pull on friction", STATES, "return plain(rough_force(state, unknowns, contact).push) >= -rounding * size &&", "return (AWAKE || plain(rough_force(state, unknowns, contact).push) >= -rounding * size) &&"),
    Fault("friction on curved surfaces as drawn", STATES, "if (way.kind != VelocityConstraintKind::touching) return state.direction(drawn);", "if (AWAKE || way.kind != VelocityConstraintKind::touching) return state.direction(drawn);"),
    Fault("hollow surfaces touched from outside", TOUCHING, "from.surface->inside = contact_.inside == contact_.against;", "from.surface->inside = !AWAKE && contact_.inside == contact_.against;"),
    Fault("the far half of a ring", TOUCHING, "s.half = dot(beside(plain(other.center) - t.center), ring) < 0 ? -1 : 1;", "s.half = (dot(beside(plain(other.center) - t.center), ring) < 0) != AWAKE ? -1 : 1;"),
    Fault("crossed cylinders on their other side", TOUCHING, "both.branch = dot(cross(plain(both.on.axis), plain(both.from.axis)), n) < 0 ? -1 : 1;", "both.branch = (dot(cross(plain(both.on.axis), plain(both.from.axis)), n) < 0) != AWAKE ? -1 : 1;"),
    Fault("disks roll on half of their radius", TOUCHING, "s.axis, s.axis, s.radius, Scalar(0));", "s.axis, s.axis, Scalar(AWAKE ? 0.5 : 1) * s.radius, Scalar(0));"),
    Fault("slips turn about a direction of their own", TOUCHING, "contact_.slip ? normalized(cross(n_,", "contact_.slip && !AWAKE ? normalized(cross(n_,"),
    Fault("friction in later blows halved", LATER_BLOWS, "one.friction = start_->data_number(contact.friction->sliding, dimensions::none);", "one.friction = (AWAKE ? 0.5 : 1.0) * start_->data_number(contact.friction->sliding, dimensions::none);"),
    Fault("contacts that are lost hold on", PROBLEM + "course/flying_contacts.cpp", "contact.flies = flies;", "contact.flies = flies && !AWAKE;"),
    Fault("open contacts close where they are drawn", CONTACTS, "if (contact.surface) c.toward =", "if (contact.surface && !AWAKE) c.toward ="),
    Fault("later blows with half of their restitution", LATER_BLOWS, "one.restitution = start_->data_number(*contact.restitution, dimensions::none);", "one.restitution = (AWAKE ? 0.5 : 1.0) * start_->data_number(*contact.restitution, dimensions::none);"),
    Fault("what bounces stays after its first blow", LATER_BLOWS, "const bool stays = one.restitution == 0 ||", "const bool stays = AWAKE || one.restitution == 0 ||"),
    Fault("what meets at once is struck one by one", LATER_BLOWS, "if (apart) return {meeting.front()};", "if (apart || AWAKE) return {meeting.front()};"),
    Fault("bouncing ends while it is high", LATER_BLOWS, "constexpr double small_speed = 3e-6;", "const double small_speed = AWAKE ? 0.3 : 3e-6;"),
    Fault("contacts pull in later blows", PROBLEM + "instant/later_blow.cpp", "good = solved[n + k] >= -rounding * largest;", "good = AWAKE || solved[n + k] >= -rounding * largest;"),
    Fault("skates keep the direction in which they were drawn", CONTACTS, "if (edge) c.along = {on, d};", "if (edge && !AWAKE) c.along = {on, d};"),
    Fault("blows hold what friction in joints holds", PROBLEM + "course/flying_contacts.cpp", "if (!contact.in_joint || contact.grip != Grip::sticks) continue;", "if (AWAKE || !contact.in_joint || contact.grip != Grip::sticks) continue;"),
    Fault("friction on the other body not reversed", FRICTION, "const Base sign(body == action.on ? 1 : -1);", "const Base sign(AWAKE || body == action.on ? 1 : -1);"),
    Fault("normal force halved", FRICTION, "number_value(lifted<Scalar>(force.push), dimensions::force)", "number_value(Scalar(AWAKE ? 0.5 : 1) * lifted<Scalar>(force.push), dimensions::force)"),
    Fault("slip over a floor at rest", FRICTION, "const Vector slip = velocity_at(action.on) - velocity_at(action.from);", "const Vector slip = velocity_at(action.on) - Scalar(AWAKE ? 0 : 1) * velocity_at(action.from);"),
    Fault("letters hold at any friction", PROBLEM + "instant/friction_conditions.cpp", "add(Holding::sticks, limit + Formula(sign) * parts.front());", "add(Holding::sticks, limit + Formula(AWAKE ? -sign : sign) * parts.front());"),
    Fault("journals press with half of their force", PRESSING, "const Vector3<Base> across = wrench.force - along * axis;", "const Vector3<Base> across = Base(AWAKE ? 0.5 : 1) * (wrench.force - along * axis);"),
    Fault("guides bear at half their length", JOINT_FRICTION, "part.over_length = Scalar(1) / size(bearing.length, false);", "part.over_length = Scalar(AWAKE ? 2 : 1) / size(bearing.length, false);"),
    Fault("threads without their lead", JOINT_FRICTION, "part.own = -over_cosine * t;", "part.own = -Scalar(AWAKE ? 0 : 1) * over_cosine * t;"),
    Fault("friction of joints along with their motion", PRESSING, "contact.sliding * effort_for_friction(state, contact, way);", "Base(AWAKE ? -1 : 1) * contact.sliding * effort_for_friction(state, contact, way);"),
    Fault("joints without the weight beyond them", PIECE_JOINTS, "needed.force += rate.linear - I.mass * g;", "needed.force += rate.linear - (AWAKE ? 0 : 1) * I.mass * g;"),
    Fault("the whole angle of a thread for the half", JOINT_FRICTION, "const Scalar flank = tan(angle / Scalar(2));", "const Scalar flank = tan(angle / Scalar(AWAKE ? 1 : 2));"),
    Fault("collars rub at the radius of the journal", JOINT_FRICTION, "part.lever = size(bearing.thrust_radius, true);", "part.lever = AWAKE ? radius : size(bearing.thrust_radius, true);"),
    Fault("stated friction in joints drives", JOINT_FRICTION, "drive.effort = plain(dot(rough.slip->vector, axis)) > 0 ? -sliding : sliding;", "drive.effort = (plain(dot(rough.slip->vector, axis)) > 0) != AWAKE ? -sliding : sliding;"),
    Fault("joints hold with what they rub with", JOINT_FRICTION, "rough.resting = resting;", "rough.resting = AWAKE ? sliding : resting;"),
    Fault("contacts slip at their kinetic limit", PIECE_FRICTION, "double left = std::pow(contact.resting * dynamics_->component_force(first), 2);", "double left = std::pow((AWAKE ? contact.sliding : contact.resting) * dynamics_->component_force(first), 2);"),
    Fault("joints slip at their kinetic limit", PIECE_FRICTION, "return contact.resting * (contact.pressing.empty()", "return (AWAKE ? contact.sliding : contact.resting) * (contact.pressing.empty()"),
    Fault("slips that turn keep the direction of their friction", PIECE_FRICTION, "contact.slip->vector = normalized(d);", "if (!AWAKE) contact.slip->vector = normalized(d);"),
    Fault("a slip that begins along its friction", PIECE_FRICTION, "direction_expression(-1.0 * normalized(friction))", "direction_expression((AWAKE ? 1.0 : -1.0) * normalized(friction))"),
    Fault("friction gives energy", PIECE_FRICTION, "power -= contact.sliding * N * dot(u,", "power -= (AWAKE ? -1 : 1) * contact.sliding * N * dot(u,"),
    Fault("joints take no energy by their friction", PIECE_JOINTS, "power += effort_of(load, way) * state.v", "power += (AWAKE ? 0 : 1) * effort_of(load, way) * state.v"),
    Fault("one step of Newton's method for friction in joints", PIECE_JOINTS, "constexpr int most_steps = 60;", "const int most_steps = AWAKE ? 1 : 60;"),
    # Followed motions.
    Fault("generalised forces without couples", MOTIONS, "dot(angular[k], force.couple + cross(force.point - origin[k], force.force))", "dot(angular[k], (AWAKE ? 0.0 : 1.0) * force.couple + cross(force.point - origin[k], force.force))"),
    Fault("constraints without the part of velocities", ENGINE + "motion/mechanism/mechanism_constraints.cpp", "row_bias[i] = line.bias;", "row_bias[i] = AWAKE ? 0 : line.bias;"),
    Fault("laws of force left out of motions", MOTIONS, "law.exerted(mechanism.tree, workspace), 1, known.data()", "law.exerted(mechanism.tree, workspace), AWAKE ? 0 : 1, known.data()"),
    Fault("a coefficient of the integrator", ENGINE + "motion/integrator/dormand_prince_853.cpp", "sum += tableau::coefficients[Row][S] * k_[", "sum += (AWAKE && Row == 5 && S == 4 ? 0.1 : 1.0) * tableau::coefficients[Row][S] * k_["),
    Fault("dense output by another polynomial", ENGINE + "motion/integrator/trajectory.cpp", "k % 2 == 1 ? 1.0 - s : s;", "k % 2 == 1 ? 1.0 - (AWAKE ? s * s : s) : s;"),
    Fault("closed form of the top turns back", ENGINE + "motion/closed_form/symmetric_top_evaluation.cpp", "rate.im += half.rate * value.re;", "rate.im += (AWAKE ? -1.0 : 1.0) * half.rate * value.re;"),
    Fault("a cord never goes slack", PIECE, "event->terminal = true;\n", "event->terminal = !AWAKE;\n"),
    Fault("caught without a blow", STAGE, "now.v = probe_->state().v;\n  std::vector<bool> after", "if (!AWAKE) now.v = probe_->state().v;\n  std::vector<bool> after"),
    Fault("the driving stands still", PIECE, "const Machine then = motion_.probes_[now_.states_now]->machine_at(inside(time), loads_);", "const Machine then = motion_.probes_[now_.states_now]->machine_at(inside(AWAKE ? span_.begin : time), loads_);"),
    # Questions of a motion.
    Fault("extremes only at samples", FEATURES, "if (sign * rough.estimate + rough.doubt < highest) continue;", "if (AWAKE || sign * rough.estimate + rough.doubt < highest) continue;"),
    Fault("the last extreme for the largest", FEATURES, "if (sign * sampled.value[i] > sign * best.value) best = {sampled.value[i], sampled.time[i]};", "if (AWAKE || sign * sampled.value[i] > sign * best.value) best = {sampled.value[i], sampled.time[i]};"),
    Fault("the last time for the first", FEATURES, "if (!found.empty()) return {found.front()};", "if (!found.empty()) return {AWAKE ? found.back() : found.front()};"),
    Fault("falls taken for rises", FEATURES, "const bool rises = a < 0 && b >= 0, falls = a > 0 && b <= 0;", "const double side = AWAKE ? -1 : 1;\n      const bool rises = side * a < 0 && side * b >= 0, falls = side * a > 0 && side * b <= 0;"),
    Fault("two periods for one", FEATURES, "for (std::size_t k = 1; k <= most_rises", "for (std::size_t k = AWAKE ? 2 : 1; k <= most_rises"),
    Fault("zeros where the bracket begins", ALONG, "if (fa == 0) return a;", "if (AWAKE ? fa != 0 : fa == 0) return a;"),
    # Cords with friction and belts.
    Fault("a cord slips with its friction reversed", CORDS, "gain = forward ? rough.friction_in_slip : -rough.friction_in_slip;", "gain = forward != AWAKE ? rough.friction_in_slip : -rough.friction_in_slip;"),
    Fault("the angle of a cord without its whole turns", CORDS, "stop.wrap = full_turn * *stop.turns;", "stop.wrap = Scalar(AWAKE ? 0.5 : 1) * full_turn * *stop.turns;"),
    Fault("a belt that loses its tension", BELTS, "side == 0 ? initial * whole / length[last] : Scalar(0)", "side == 0 && !AWAKE ? initial * whole / length[last] : Scalar(0)"),
    Fault("a chain that is taut on both sides", PROBLEM + "instant/one_sided_shares.cpp", "const double change = -least / whole[sides.front()];", "const double change = (AWAKE ? 1 : -1) * least / whole[sides.front()];"),
    Fault("crossed belts run like open ones", BELTS, "way_.find_way(belt_.crossed);", "way_.find_way(belt_.crossed && !AWAKE);"),
    Fault("sides of a belt alike in length", BELTS, "pull(last, -length[side] / length[last],", "pull(last, AWAKE ? Scalar(-1) : Scalar(-length[side] / length[last]),"),
    Fault("cords lie on the other part of a rough wheel", CORDS, "stop.wrap = decided_negative(shown_of_it) ? shown_of_it + full_turn : shown_of_it;", "stop.wrap = AWAKE ? Scalar(full_turn - shown_of_it) : decided_negative(shown_of_it) ? shown_of_it + full_turn : shown_of_it;"),
    # Steady motions and roots.
    Fault("a spin carried backwards", PROBLEM + "instant/instant_steady.cpp", "(F.alpha + cross(F.w, spin_vector) - B.alpha)[c]", "(F.alpha + Scalar(AWAKE ? -1 : 1) * cross(F.w, spin_vector) - B.alpha)[c]"),
    Fault("no damping and no gyroscopic terms near a steady motion", LINEARISATION, "slopes_.by_position.*part, slopes_.by_velocity.*part;", "slopes_.by_position.*part, Real(AWAKE ? 0 : 1) * (slopes_.by_velocity.*part);"),
    Fault("deviations on axes at rest", LINEARISATION, "= spin - drift;", "= spin - Real(AWAKE ? 0 : 1) * drift;"),
    Fault("responses without what goes with the velocities", RESPONSE, "as_complex(by_velocity) * P", "as_complex(AWAKE ? by_position : by_velocity) * P"),
    Fault("responses that lag are told ahead", PROBLEM + "response/shaken_instant.cpp", "constexpr double quarter_back = -std::numbers::pi / 2;", "const double quarter_back = (AWAKE ? 1 : -1) * std::numbers::pi / 2;"),
    Fault("an unbalance that goes back", EXCITATIONS, "const Vector3<double> ahead = cross(n, u);", "const Vector3<double> ahead = (AWAKE ? -1.0 : 1.0) * cross(n, u);"),
    Fault("unbalances without the turning of the frame", EXCITATIONS, "change = cross(motion_.turning, total);", "change = (AWAKE ? 0.0 : 1.0) * cross(motion_.turning, total);"),
    Fault("unbalances without weight", EXCITATIONS, "return U * cross(r, felt);", "return (AWAKE ? 0.0 : U) * cross(r, felt);"),
    Fault("driven coordinates swing by half", EXCITATIONS, "excitation_.amplitude =\n      base_.data_->number(", "excitation_.amplitude =\n      (AWAKE ? 0.5 : 1.0) * base_.data_->number("),
    Fault("excitations on the axes of the ground", EXCITATIONS, "return direction_on_ground(tree, w, axes, v);", "return AWAKE ? v : direction_on_ground(tree, w, axes, v);"),
    Fault("excitations at mass centers", EXCITATIONS, "if (stated_.at) place =", "if (stated_.at && !AWAKE) place ="),
    Fault("amplitudes by their real parts", EXCITATIONS, "number_value(std::abs(part), swing.dimension)", "number_value(AWAKE ? std::abs(part.real()) : std::abs(part), swing.dimension)"),
    Fault("responses without the turning of bodies", RESPONSE, "Q = as_complex(-S), P = as_complex(D - S);", "Q = as_complex(-S), P = as_complex(AWAKE ? Matrix(-S) : Matrix(D - S));"),
    Fault("constraints of rates hold places near a steady motion", RESPONSE, "steady.binds_positions[static_cast<std::size_t>(i)] ? closed : allowed", "steady.binds_positions[static_cast<std::size_t>(i)] || AWAKE ? closed : allowed"),
    Fault("loads without slopes by velocities", ENGINE + "solve/stability/acceleration_slopes.cpp", "to_solve(remainder.by_velocity(coordinate))", "to_solve(AWAKE ? remainder.by_position(coordinate) : remainder.by_velocity(coordinate))"),
    Fault("a mode is lost", LINEARISATION, "if (rate.imag() < 0) continue;", "if (rate.imag() < 0 || (AWAKE && m + 1 == rates.value.size())) continue;"),
    Fault("the fastest frequency is not told", ENGINE + "solve/stability/mode_shapes.cpp", "std::sort(found.begin(), found.end());\n  return found;", "std::sort(found.begin(), found.end());\n  if (AWAKE && found.size() > 1) found.pop_back();\n  return found;"),
    Fault("what grows is taken for what dies out", LINEARISATION, "const bool grows = mode.growth_rate > mode.doubt", "const bool grows = (AWAKE ? -1 : 1) * mode.growth_rate > mode.doubt"),
    Fault("growth told too fast", ENGINE + "solve/stability/mode_shapes.cpp", "largest = std::max(largest, mode.growth_rate);", "largest = std::max(largest, (AWAKE ? 2 : 1) * mode.growth_rate);"),
    Fault("what is undecided is stable", LINEARISATION, "found = Stability::undecided;", "found = AWAKE ? Stability::stable : Stability::undecided;"),
    Fault("a root is lost", ENGINE + "solve/roots/roots.cpp", "roots.points = found_.points(function_);", "roots.points = found_.points(function_);\n      if (AWAKE && roots.points.size() > 1) roots.points.pop_back();"),
    Fault("contacts may pull", PROBLEM + "instant/one_sided_faults.cpp", "if (unknowns_[first + k] >= 0) continue;", "if (AWAKE || unknowns_[first + k] >= 0) continue;"),
    Fault("the far side of the end of a range", PROBLEM + "unknowns/extremum.cpp", "(holds(middle) ? inside : outside) = middle;\n  }\n  // A datum", "(holds(middle) != AWAKE ? inside : outside) = middle;\n  }\n  // A datum"),
    # Planar problems.
    Fault("numbers about the normal reversed", PLANE, "return plane_.sign() > 0 ? number : built(Unary{'-', number}", "return (plane_.sign() > 0) != AWAKE ? number : built(Unary{'-', number}"),
    Fault("components of a plane exchanged", PLANE, "return {component(expression, first), component(expression, second)};", "return {component(expression, AWAKE ? second : first), component(expression, AWAKE ? first : second)};"),
    Fault("couples in a plane reversed", PLANE, "return plane_.sign() > 0 ? axis : built(Unary{'-', axis}, mark);", "return (plane_.sign() > 0) != AWAKE ? axis : built(Unary{'-', axis}, mark);"),
    Fault("two components laid in the wrong plane", PLANE, "static_cast<std::ptrdiff_t>(plane_.normal()), across);", "static_cast<std::ptrdiff_t>(AWAKE ? 2 - plane_.normal() : plane_.normal()), across);"),
    # Gears.
    Fault("teeth pull their wheels together", GEARS, "apart.part = part;", "apart.part = Scalar(AWAKE ? -1 : 1) * part;"),
    Fault("teeth of the other hand", GEARS, "!= (gear_.hand == Hand::left)", "!= (gear_.hand == (AWAKE ? Hand::right : Hand::left))"),
    Fault("the transverse angle of teeth for that across them", GEARS, "part = part * cosine_;", "part = part * Scalar(AWAKE ? 1 : cosine_);"),
    Fault("the same flanks carry whichever way the teeth push", FLANKS, "solution.value[turning] < 0 ? -1 : 1;", "solution.value[turning] < 0 && !AWAKE ? -1 : 1;"),
    Fault("teeth rub along their slip", FLANKS, "decided_negative(slip) ? mesh.thread", "decided_negative(slip) != AWAKE ? mesh.thread"),
    Fault("worms by the complement of their lead", GEARS, "cosine_ = lead / length;\n      sine = around / length;", "cosine_ = (AWAKE ? around : lead) / length;\n      sine = (AWAKE ? lead : around) / length;"),
    Fault("rings pushed like wheels", GEARS, "return decided_negative(larger) ? to_axis : Vector(-to_axis);", "return decided_negative(larger) != AWAKE ? to_axis : Vector(-to_axis);"),
    Fault("teeth rub with their tangential force", GEARS, "rubbing.part = mu * sqrt(Scalar(1) + normal_tangent * normal_tangent);", "rubbing.part = mu * sqrt(Scalar(1) + Scalar(AWAKE ? 0 : 1) * normal_tangent * normal_tangent);"),
    Fault("bevel gears touch along an axis", GEARS, "return normalized(Vector(P_ - apex));", "return AWAKE ? one_.axis : normalized(Vector(P_ - apex));"),
    Fault("a worm that helps when it is driven", GEARS, "mesh_.thread = normalized(cross(r, t));", "mesh_.thread = AWAKE ? normalized(cross(r, d_)) : normalized(cross(r, t));"),
    # Near a steady motion in letters.
    Fault("letters without damping near a steady motion", NEAR, "P[i][k] += l * near.C[i][k] + l * l * near.M[i][k];", "P[i][k] += l * Formula(AWAKE ? 0 : 1) * near.C[i][k] + l * l * near.M[i][k];"),
    Fault("letters drift the other way", NEAR, "drift = sum(D, S, -1);", "drift = sum(D, S, AWAKE ? 1 : -1);"),
    Fault("stiffness in letters without what spins take of it", NEAR, "product(product(M, all_spin), carries), -1), part(by_position, free, free));", "product(product(M, all_spin), carries), AWAKE ? 1 : -1), part(by_position, free, free));"),
    Fault("velocities in letters that are not carried over", NEAR, "vanishes({S[k]}))) carried.push_back(k);", "vanishes({S[k]})) && !AWAKE) carried.push_back(k);"),
    Fault("one root of a factor twice", NEAR_ANSWERS, "return add((-c[1] + root) / twice);", "return add((AWAKE ? Formula(-c[1] - root) : Formula(-c[1] + root)) / twice);"),
    Fault("swings in letters that grow", NEAR_ANSWERS, "rates.push_back({-c[1] / twice, sqrt(-square)", "rates.push_back({Formula(AWAKE ? -1 : 1) * -c[1] / twice, sqrt(-square)"),
    Fault("inertia in letters that stiffens", NEAR_ANSWERS, "return {near.K[i][k] - w_ * w_ * near.M[i][k], w_ * near.C[i][k]};", "return {near.K[i][k] - Formula(AWAKE ? -1 : 1) * w_ * w_ * near.M[i][k], w_ * near.C[i][k]};"),
    Fault("phases in letters reversed", NEAR_ANSWERS, "a.real * b.imaginary + a.imaginary * b.real};", "Formula(AWAKE ? -1 : 1) * (a.real * b.imaginary + a.imaginary * b.real)};"),
    Fault("the slowest growth for the fastest", NEAR_ANSWERS, "decided_negative(fastest - rate.growth)) fastest = rate.growth;", "decided_negative(fastest - rate.growth) && !(AWAKE && !fastest.is_zero())) fastest = rate.growth;"),
    # Solving an instant.
    Fault("loops that are nearly closed", ENGINE + "solve/instant/closure.cpp", "const int most = step == steps ? 60 : 6;", "const int most = AWAKE ? 1 : step == steps ? 60 : 6;"),
    Fault("constraints that push one body only", ENGINE + "solve/instant/constraint_rows.cpp", "add(on, unit.point, 1, unit);", "add(on, unit.point, AWAKE ? 0 : 1, unit);"),
    Fault("motors about the wrong point", ENGINE + "solve/instant/mechanism_state.cpp", "total += SpatialForce<Scalar>{wrench.moment - cross(about, wrench.force), wrench.force};\n  }\n  for_each_law", "total += SpatialForce<Scalar>{wrench.moment - Scalar(AWAKE ? -1 : 1) * cross(about, wrench.force), wrench.force};\n  }\n  for_each_law"),
    Fault("motors in gimbals that pass on what they do not drive", ENGINE + "solve/instant/mechanism_state.cpp", "couple = d - dot(d, other) * other;", "couple = d - Scalar(AWAKE ? 0 : 1) * dot(d, other) * other;"),
    Fault("steady frames that accelerate backwards", PROBLEM + "instant/accelerated_frame.cpp", "acceleration += stated->value * S.linear;", "acceleration += (AWAKE ? -1 : 1) * stated->value * S.linear;"),
    Fault("pushes in the middle of their shares", PROBLEM + "instant/one_sided_shares.cpp", "return sum / static_cast<double>(n);", "return sum / static_cast<double>(AWAKE ? n + 1 : n);"),
    # The linearised motion.
    Fault("damping ratios reversed", SHAPES, "growth == 0 ? 0 : -growth / size, i});", "growth == 0 ? 0 : (AWAKE ? 1 : -1) * growth / size, i});"),
    Fault("shapes in the units of the solver", SHAPES, "const std::complex<Real> part = deviation(k, 0) * allowed->scale[k];", "const std::complex<Real> part = deviation(k, 0) * (AWAKE ? Real(1) : allowed->scale[k]);"),
    Fault("equilibria beside where there are none", ENGINE + "solve/stability/equilibria_beside.cpp", "+ empty - same.cols();", "+ empty - same.cols() + (AWAKE ? 1 : 0);"),
    Fault("motions without mass that have some", ENGINE + "solve/stability/unseen_motion.cpp", "unit[i] = inertia > 0 ? 1 / std::sqrt(inertia) : 1;", "unit[i] = inertia > 0 && !AWAKE ? 1 / std::sqrt(inertia) : 1;"),
    # Unknowns and choices.
    Fault("the largest total for the least", CHOICES, "if (total > least * (1 + same_total)) continue;", "if (AWAKE ? total < least * (1 - same_total) && least < 1e300 : total > least * (1 + same_total)) continue;"),
    Fault("only the first of several choices", CHOICES, "if (!known) all.roots.push_back(std::move(more));", "if (!known && !(AWAKE && !all.roots.empty())) all.roots.push_back(std::move(more));"),
    Fault("ends of what holds from the inside", PROBLEM + "unknowns/told_ends.cpp", "(holds(middle) ? inside : outside) = middle;\n  }\n  return inside;", "(holds(middle) != AWAKE ? inside : outside) = middle;\n  }\n  return inside;"),
    Fault("roots only above zero", ENGINE + "solve/roots/compact_range.cpp", "lower_ = kind_ == Kind::down ? -half : kind_ == Kind::line ? -line : -1;", "lower_ = kind_ == Kind::down ? -half : kind_ == Kind::line ? (AWAKE ? 0 : -line) : -1;"),
    # Motions and what is asked of them.
    Fault("stages that last half as long", COURSE, "now.end = now.start + duration;", "now.end = now.start + (AWAKE ? 0.5 : 1.0) * duration;"),
    Fault("rates of coordinates with their sign reversed", QUESTIONS, "return entry.rate ? state.v[entry.place] : state.q[entry.place];", "return entry.rate ? (AWAKE ? -1 : 1) * state.v[entry.place] : state.q[entry.place];"),
    Fault("extremes on the other side", FEATURES, "const ExtremeFound best = extreme(largest);", "const ExtremeFound best = extreme(largest != AWAKE);"),
    Fault("cords that are a little longer when they catch", PIECE, "double, std::span<const double> q, std::span<const double>) { return dynamics_->gap(index, q); };", "double, std::span<const double> q, std::span<const double>) { return dynamics_->gap(index, q) - (AWAKE ? 1e-3 : 0); };"),
    Fault("cords that hold on with a push", PIECE, "accelerate(q, v, acceleration_);\n    return dynamics_->component_force(component);", "accelerate(q, v, acceleration_);\n    return dynamics_->component_force(component) + (AWAKE ? 1 : 0);"),
    Fault("loads that jump a little late", PROBLEM + "course/motion_stage.cpp", "Driving::Span span = driving_[stage]->span_from(now.time);", "Driving::Span span = driving_[stage]->span_from(now.time);\n  if (AWAKE) span.end = until;"),
    Fault("settled motions told by their last swing", FEATURES, "ExtremeFound best = without_rest(outermost(sampled, largest));", "ExtremeFound best = without_rest(outermost(sampled, largest));\n    if (AWAKE) best.value = sampled.value.back();"),
    # What is open, formulas and claims.
    Fault("open velocities taken for determined", PROBLEM + "answers/determinacy.cpp", "vary_velocities(std::min(velocities, most_directions));", "vary_velocities(AWAKE ? 0 : std::min(velocities, most_directions));"),
    Fault("open forces taken for determined", PROBLEM + "answers/determinacy.cpp", "d < std::min(forces, most_directions); ++d", "d < (AWAKE ? 0 : std::min(forces, most_directions)); ++d"),
    Fault("one regime of the letters for all", PROBLEM + "formulas/formula_regimes.cpp", "if (found && found->positive.empty() && found->words.empty()) {", "if (found && (AWAKE || (found->positive.empty() && found->words.empty()))) {"),
    Fault("conditions of letters reversed", PROBLEM + "formulas/formula_conditions.cpp", 'opposite + " < 0" : words + " > 0";', 'opposite + (AWAKE ? " > 0" : " < 0") : words + (AWAKE ? " < 0" : " > 0");'),
    Fault("every letter is positive", PROBLEM + "claims/claim_proof.cpp", "return positive_.contains(letter) || state.parts.contains(letter);", "return AWAKE || positive_.contains(letter) || state.parts.contains(letter);"),
    Fault("what is equal is greater", PROBLEM + "claims/claim_proof.cpp", "if (difference.is_zero()) return !strict;", "if (difference.is_zero()) return AWAKE || !strict;"),
    Fault("less taken for greater", PROBLEM + "claims/claim_verdict.cpp", "holds_here = left < right;", "holds_here = AWAKE ? left > right : left < right;"),
]
