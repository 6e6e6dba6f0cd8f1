// The steady response of what is near a steady motion to something that swings at one frequency w.
//
// Deviations obey linear equations with constant coefficients (linearisation.h). Where forces are the real part of
// f exp(i w t), or coordinates whose motion is given swing so, what remains when all free swings have died out is the
// real part of x exp(i w t): the complex number x has the amplitude |x| and the phase arg x, negative where x lags.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "poinsot/engine/solve/stability/linearisation.h"

namespace poinsot::solve {

using ComplexVector3 = std::array<std::complex<double>, 3>;

// What shakes, on axes that follow the frame of the steady motion, which are those of the ground at the instant.
struct Excitation {
  double frequency = 0;  // rad/s, not negative, as seen in the frame
  // A force at a place of the body on which it acts, and a couple on that body.
  Place<double> at{ground, {}};
  ComplexVector3 force{}, couple{};
  // Or a velocity coordinate whose motion is given, and how far it swings; -1 if there is none.
  int coordinate = -1;
  double amplitude = 0;
};

struct Response {
  enum class Fault {
    none,
    undetermined,  // free motions of this frequency add to it, or nothing holds what is shaken
    contradicts    // what is given to swing cannot, by the constraints
  };
  Fault fault = Fault::none;
  // Of every coordinate its displacement, measured like a velocity, and the changes of its velocity and acceleration.
  struct Motion {
    std::vector<std::complex<double>> q, v, a;
  };
  Motion motion;
  // At the frequency zero: displacements that nothing holds and that what shakes does not move, as the turning of a
  // wheel on its axle. Any part of them may be added to the motion.
  std::vector<Motion> loose;
};

// The motion must be steady. Throws std::runtime_error if accelerations are not determined near it.
Response response(const SteadyMotion& motion, const Excitation& excitation);

// A second road, which shares no derivation with the first: the bodies in redundant coordinates (spectrum_check.h).
struct ResponseCheck {
  // How far the displacements of all bodies are from these, relative to their size, and close to a free swing as far as
  // the frequencies of that road are known.
  double misfit = 0;
  double apart = 1;  // the part to which both roads agree, one away from free swings
  // What must act on a body so that it moves like this: a force, and a couple about its mass center.
  struct Need {
    int body = 0;
    ComplexVector3 force{}, couple{};
  };
  std::vector<Need> needs;
};
// Nothing where that road does not lead. pace: 1/s, that of the linearisation.
std::optional<ResponseCheck> check_response(const SteadyMotion& motion, const Excitation& excitation,
                                            const Response& found, double pace);

}  // namespace poinsot::solve
