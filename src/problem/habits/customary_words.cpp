#include "problem/habits/customary_words.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace poinsot::problem {
namespace {

struct Custom {
  std::string_view elsewhere;  // in lower case
  std::string_view here;
};

// One word may stand several times: which is meant is told by what is known where it stands.
constexpr std::array customs{
    // joints
    Custom{"hinge", "revolute"},
    Custom{"pin", "revolute"},
    Custom{"pivot", "revolute"},
    Custom{"bearing", "revolute"},
    Custom{"rotational", "revolute"},
    Custom{"slider", "prismatic"},
    Custom{"slide", "prismatic"},
    Custom{"guide", "prismatic"},
    Custom{"translational", "prismatic"},
    Custom{"spherical", "ball"},
    Custom{"socket", "ball"},
    Custom{"ball_and_socket", "ball"},
    Custom{"fixed", "weld"},
    Custom{"rigid", "weld"},
    Custom{"clamp", "weld"},
    Custom{"hooke", "universal"},
    Custom{"cardan", "universal"},
    Custom{"omega", "rate"},
    Custom{"angular_velocity", "rate"},
    Custom{"velocity", "rate"},
    Custom{"speed", "rate"},
    Custom{"alpha", "accel"},
    Custom{"acceleration", "accel"},
    Custom{"angular_acceleration", "accel"},
    Custom{"torque", "couple"},
    Custom{"moment", "couple"},
    Custom{"body", "to"},
    Custom{"child", "to"},
    Custom{"of", "to"},
    Custom{"parent", "from"},
    Custom{"base", "from"},
    Custom{"point", "at"},
    Custom{"location", "at"},
    Custom{"origin", "at"},
    Custom{"stiffness", "spring"},
    // belts, gears and centers that pull
    Custom{"wheels", "over"},
    Custom{"pulleys", "over"},
    Custom{"sheaves", "over"},
    Custom{"around", "over"},
    Custom{"pretension", "tension"},
    Custom{"initial_tension", "tension"},
    Custom{"phi", "pressure_angle"},
    Custom{"helix", "helix_angle"},
    Custom{"mu", "parameter"},
    Custom{"gm", "parameter"},
    Custom{"gravitational_parameter", "parameter"},
    Custom{"to", "toward"},
    // what shakes
    Custom{"harmonic", "excitations"},
    Custom{"forcing", "excitations"},
    // bodies and their shapes
    Custom{"slender_rod", "rod"},
    Custom{"bar", "rod"},
    Custom{"slender_bar", "rod"},
    Custom{"point_mass", "particle"},
    Custom{"hoop", "ring"},
    Custom{"circle", "ring"},
    Custom{"plate", "rectangle"},
    Custom{"square", "rectangle"},
    Custom{"circular_plate", "disk"},
    Custom{"wheel", "disk"},
    Custom{"block", "box"},
    Custom{"brick", "box"},
    Custom{"cuboid", "box"},
    Custom{"ball", "sphere"},
    Custom{"hollow_cylinder", "tube"},
    Custom{"semicylinder", "half_cylinder"},
    Custom{"wedge", "prism"},
    Custom{"pipe", "tube"},
    Custom{"diameter", "radius"},
    Custom{"height", "length"},
    Custom{"inertia_tensor", "inertia_matrix"},
    Custom{"tensor", "inertia_matrix"},
    Custom{"moments_of_inertia", "inertia"},
    Custom{"radius_of_gyration", "radii_of_gyration"},
    Custom{"ixx", "x"},
    Custom{"iyy", "y"},
    Custom{"izz", "z"},
    Custom{"ix", "x"},
    Custom{"iy", "y"},
    Custom{"iz", "z"},
    Custom{"xx", "x"},
    Custom{"yy", "y"},
    Custom{"zz", "z"},
    Custom{"ixy", "xy"},
    Custom{"iyz", "yz"},
    Custom{"izx", "zx"},
    Custom{"ixz", "zx"},
    Custom{"mass_center", "center"},
    Custom{"center_of_mass", "center"},
    Custom{"centroid", "center"},
    Custom{"cg", "center"},
    Custom{"com", "center"},
    // springs, contacts and blows
    Custom{"k", "stiffness"},
    Custom{"spring_constant", "stiffness"},
    Custom{"c", "damping"},
    Custom{"damper", "damping"},
    Custom{"damping_coefficient", "damping"},
    Custom{"rest_length", "free_length"},
    Custom{"natural_length", "free_length"},
    Custom{"unstretched_length", "free_length"},
    Custom{"length", "free_length"},
    Custom{"rolling", "no_slip"},
    Custom{"rolls", "no_slip"},
    Custom{"rough", "no_slip"},
    Custom{"mu", "friction"},
    Custom{"coefficient_of_friction", "friction"},
    Custom{"friction_coefficient", "friction"},
    Custom{"e", "restitution"},
    Custom{"coefficient_of_restitution", "restitution"},
    Custom{"dynamic", "kinetic"},
    Custom{"mu_k", "kinetic"},
    Custom{"mu_s", "static"},
    Custom{"massless", "mass"},
    // loads and asks
    Custom{"on", "body"},
    Custom{"on", "against"},
    Custom{"with", "against"},
    Custom{"direction", "along"},
    Custom{"minimum", "smallest"},
    Custom{"min", "smallest"},
    Custom{"least", "smallest"},
    Custom{"minimize", "smallest"},
    Custom{"maximum", "largest"},
    Custom{"max", "largest"},
    Custom{"most", "largest"},
    Custom{"maximize", "largest"},
    Custom{"when", "first_time"},
    Custom{"time", "first_time"},
    Custom{"until", "while"},
    Custom{"condition", "while"},
    Custom{"expression", "of"},
    Custom{"quantity", "of"},
    Custom{"frame", "axes"},
    Custom{"in", "axes"},
    // sections
    Custom{"data", "given"},
    Custom{"parameters", "given"},
    Custom{"constants", "given"},
    Custom{"known", "given"},
    Custom{"symbols", "letters"},
    Custom{"variables", "letters"},
    Custom{"unknowns", "find"},
    Custom{"solve", "find"},
    Custom{"questions", "ask"},
    Custom{"outputs", "ask"},
    Custom{"connections", "joints"},
    Custom{"forces", "loads"},
    Custom{"body", "bodies"},
    Custom{"torques", "loads"},
    Custom{"moments", "loads"},
    Custom{"couples", "loads"},
    Custom{"unknown", "find"},
    Custom{"question", "ask"},
    Custom{"output", "ask"},
    Custom{"results", "ask"},
    Custom{"bearings", "joints"},
    Custom{"constraints", "joints"},
    Custom{"initial", "instants"},
    Custom{"initially", "instants"},
    Custom{"start", "instants"},
    Custom{"impulse", "value"},
    Custom{"initial_conditions", "instants"},
    Custom{"name", "title"},
    Custom{"calculate", "ask"},
    Custom{"compute", "ask"},
    Custom{"objects", "bodies"},
    Custom{"links", "joints"},
    Custom{"coordinates", "points"},
    Custom{"definitions", "define"},
    Custom{"prove", "claim"},
    Custom{"claims", "claim"},
    // quantities and functions
    Custom{"speed", "norm(velocity(A of plate))"},
    Custom{"magnitude", "norm(v)"},
    Custom{"mag", "norm(v)"},
    Custom{"length", "norm(v)"},
    Custom{"power", "dot(force(J on plate) with velocity(A of plate))"},
    Custom{"ke", "kinetic_energy(plate)"},
    Custom{"pe", "potential_energy(plate)"},
    Custom{"energy", "kinetic_energy(plate) + potential_energy(plate)"},
    Custom{"linear_momentum", "momentum(plate)"},
    Custom{"omega", "angular_velocity(plate)"},
    Custom{"alpha", "angular_acceleration(plate)"},
    Custom{"inertia", "moment_of_inertia(plate about x at A)"},
    Custom{"inertia_tensor", "inertia_matrix(plate about A)"},
    Custom{"product_of_inertia", "products_of_inertia(plate about A)"},
    Custom{"moment", "couple(J on plate about P)"},
    Custom{"torque", "couple(J on plate about P)"},
    Custom{"reaction_force", "reaction(J)"},
    Custom{"reaction_moment", "reaction_couple(J)"},
    Custom{"mass_center", "center(plate)"},
    Custom{"center_of_mass", "center(plate)"},
    Custom{"centroid", "center(plate)"},
    Custom{"frequency", "frequencies(plate)"},
    Custom{"natural_frequency", "frequencies(plate)"},
    Custom{"precession", "precession_rate(plate)"},
    Custom{"spin", "spin_rate(plate)"},
    Custom{"stick", "sticking(floor)"},
    Custom{"sticks", "sticking(floor)"},
    Custom{"slide", "sliding(floor)"},
    Custom{"slides", "sliding(floor)"},
    Custom{"slip", "sliding(floor)"},
    Custom{"slips", "sliding(floor)"},
    Custom{"slipping", "sliding(floor)"},
    Custom{"touch", "touching(floor)"},
    Custom{"touches", "touching(floor)"},
    Custom{"contact", "touching(floor)"},
    Custom{"sine", "sin(theta)"},
    Custom{"cosine", "cos(theta)"},
    Custom{"tangent", "tan(theta)"},
    Custom{"cot", "tan(theta)^-1"},
    Custom{"cotangent", "tan(theta)^-1"},
    Custom{"sec", "cos(theta)^-1"},
    Custom{"secant", "cos(theta)^-1"},
    Custom{"csc", "sin(theta)^-1"},
    Custom{"cosecant", "sin(theta)^-1"},
    Custom{"arcsin", "asin(x)"},
    Custom{"arcsine", "asin(x)"},
    Custom{"arccos", "acos(x)"},
    Custom{"arccosine", "acos(x)"},
    Custom{"arctan", "atan(x)"},
    Custom{"arctangent", "atan(x)"},
    Custom{"root", "sqrt(x)"},
    Custom{"squareroot", "sqrt(x)"},
    Custom{"square_root", "sqrt(x)"},
    Custom{"absolute", "abs(x)"},
    Custom{"fabs", "abs(x)"},
    Custom{"exponential", "exp(x)"},
    Custom{"logarithm", "ln(x)"},
    Custom{"log10", "ln(x)/ln(10)"},
    Custom{"log2", "ln(x)/ln(2)"},
    Custom{"arctan2", "atan2(y to x)"},
    Custom{"log", "ln(x)"},
    Custom{"maximum", "max(X)"},
    Custom{"minimum", "min(X)"},
};

std::string customary(std::string_view word, const std::vector<std::string>& known, bool call) {
  std::string lower(word);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Custom& custom : customs) {
    const std::size_t name = custom.here.find('(');
    if (custom.elsewhere == lower && (name != std::string_view::npos) == call &&
        std::ranges::find(known, custom.here.substr(0, name)) != known.end())
      return std::string(custom.here);
  }
  return "";
}

}  // namespace

std::string customary_key(std::string_view word, const std::vector<std::string>& known) {
  return customary(word, known, false);
}
std::string customary_call(std::string_view word, const std::vector<std::string>& known) {
  return customary(word, known, true);
}

std::string customary_joining(std::string_view word) {
  constexpr std::array joining{
      Custom{"and", "'to' or 'with'"}, Custom{"through", "'at'"},      Custom{"around", "'about'"},
      Custom{"round", "'about'"},      Custom{"for", "'of'"},          Custom{"in", "'of' or 'along'"},
      Custom{"onto", "'along'"},       Custom{"toward", "'along'"},    Custom{"towards", "'along'"},
      Custom{"between", "'to'"},       Custom{"wrt", "'relative to'"}, Custom{"against", "'on'"},
      Custom{"upon", "'on'"}};
  const auto found = std::ranges::find(joining, word, &Custom::elsewhere);
  return found == joining.end() ? "" : std::string(found->here);
}

std::string customary_unit_of(std::string_view quantity) {
  constexpr std::array units{Custom{"mass", "kg"},   Custom{"length", "m"},     Custom{"distance", "m"},
                             Custom{"time", "s"},    Custom{"force", "N"},      Custom{"angle", "rad"},
                             Custom{"speed", "m/s"}, Custom{"velocity", "m/s"}, Custom{"acceleration", "m/s^2"},
                             Custom{"number", "1"},  Custom{"none", "1"},       Custom{"dimensionless", "1"},
                             Custom{"-", "1"}};
  const auto found = std::ranges::find(units, quantity, &Custom::elsewhere);
  return found == units.end() ? "" : std::string(found->here);
}

}  // namespace poinsot::problem
