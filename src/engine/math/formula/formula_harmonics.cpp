// Polynomials in sines and cosines as sums of waves: cos(a) cos(b) + sin(a) sin(b) is cos(a - b).
#include <algorithm>
#include <map>
#include <optional>

#include "engine/math/formula/formula_form.h"

namespace poinsot::symbolic {
namespace {

using Exponents = std::vector<int>;

// A polynomial as a sum of (real + i imaginary) exp(i k.angles), by the multiples k of the angles.
struct Amplitude {
  Polynomial real;
  Polynomial imaginary;
};
using Amplitudes = std::map<Exponents, Amplitude>;

// One term as a sum of exponentials with numbers for amplitudes, times 2 for each sine and cosine in it.
using TermAmplitudes = std::map<Exponents, std::pair<Integer, Integer>>;  // real and imaginary

// 2 cos = e + 1/e, 2 sin = -i e + i/e, with e of angle k.
TermAmplitudes times_wave(const TermAmplitudes& sum, std::size_t k, bool sine) {
  TermAmplitudes result;
  for (const auto& [wave, value] : sum) {
    for (const int step : {-1, 1}) {
      Exponents turned = wave;
      turned[k] += step;
      auto& [real, imaginary] = result[turned];
      if (!sine) {
        fmpz_add(real.get(), real.get(), value.first.get());
        fmpz_add(imaginary.get(), imaginary.get(), value.second.get());
      } else if (step > 0) {
        fmpz_add(real.get(), real.get(), value.second.get());
        fmpz_sub(imaginary.get(), imaginary.get(), value.first.get());
      } else {
        fmpz_sub(real.get(), real.get(), value.second.get());
        fmpz_add(imaginary.get(), imaginary.get(), value.first.get());
      }
    }
  }
  return result;
}

// The amplitudes of 2^twos p.
Amplitudes amplitudes_of(const Polynomial& p, const Angles& angles, int twos) {
  const std::size_t n = angles.variables();
  Amplitudes amplitudes;
  for (std::size_t i = 0; i < p.length(); ++i) {
    Exponents exponents = p.exponents(i);
    int own_twos = 0;
    TermAmplitudes sum;
    sum[Exponents(angles.tangents.size(), 0)] = {p.coefficient(i), Integer(0)};
    for (std::size_t k = 0; k < angles.tangents.size(); ++k) {
      const int sines = std::exchange(exponents[angles.sine(k)], 0);
      const int cosines = std::exchange(exponents[angles.cosine(k)], 0);
      own_twos += sines + cosines;
      for (int factor = 0; factor < sines + cosines; ++factor) sum = times_wave(sum, k, factor < sines);
    }
    for (const auto& [wave, value] : sum) {
      Amplitude& amplitude = amplitudes.try_emplace(wave, Amplitude{Polynomial(n), Polynomial(n)}).first->second;
      Integer real;
      Integer imaginary;
      fmpz_mul_2exp(real.get(), value.first.get(), static_cast<ulong>(twos - own_twos));
      fmpz_mul_2exp(imaginary.get(), value.second.get(), static_cast<ulong>(twos - own_twos));
      amplitude.real.push(real, exponents);
      amplitude.imaginary.push(imaginary, exponents);
    }
  }
  for (auto& [wave, amplitude] : amplitudes) {
    amplitude.real.tidy();
    amplitude.imaginary.tidy();
  }
  return amplitudes;
}

// cosine * cos(angle) + sine * sin(angle)
struct Wave {
  Form angle;
  std::optional<Form> half_angle;  // if it is no longer than the angle
  Polynomial cosine;
  Polynomial sine;
};

struct Waves {
  Polynomial constant;
  std::vector<Wave> waves;
};

// Each exponential with its opposite. Where angles cancel, as twice a and that of a letter that is 2 a, it is constant.
Waves waves_of(const Amplitudes& amplitudes, const Generators& generators, const Angles& angles) {
  Waves found{Polynomial(angles.variables()), {}};
  const auto still = amplitudes.find(Exponents(angles.tangents.size(), 0));
  if (still != amplitudes.end()) found.constant = still->second.real;
  for (const auto& [wave, amplitude] : amplitudes) {
    const auto first = std::find_if(wave.begin(), wave.end(), [](int k) { return k != 0; });
    if (first == wave.end() || *first < 0 || (amplitude.real.is_zero() && amplitude.imaginary.is_zero())) continue;
    Formula angle;
    for (std::size_t k = 0; k < wave.size(); ++k) {
      const Generator& g = *generators[angles.tangents[k]];
      angle += Formula(wave[k]) * ratio_formula(g.multiple) * g.argument;
    }
    if (angle.is_zero()) {
      found.constant = found.constant + scaled(amplitude.real, Integer(2));
      continue;
    }
    const bool negative = angle.fraction()->numerator.leading_sign() < 0;
    if (negative) angle = -angle;
    const Formula half = angle / 2;
    std::optional<Form> half_angle;
    if (half.fraction()->denominator.is_one()) half_angle = form_of(half);
    const Polynomial sine = scaled(amplitude.imaginary, Integer(2));
    found.waves.push_back({form_of(angle), half_angle, scaled(amplitude.real, Integer(2)), negative ? sine : -sine});
  }
  return found;
}

// How cosines of twice an angle are written.
enum class Doubled { cosine, sine_square, cosine_square };

}  // namespace

std::vector<TrigonometricSum> harmonic_sums(const Generators& generators, const Polynomial& p, const Angles& angles,
                                            int twos, const std::vector<Form>& variables) {
  const std::size_t n = angles.variables();
  const auto [constant, waves] = waves_of(amplitudes_of(p, angles, twos), generators, angles);
  const std::size_t all = n + 2 * waves.size();
  std::vector<int> places(n);
  for (std::size_t i = 0; i < n; ++i) places[i] = static_cast<int>(i);

  const bool any_half =
      std::any_of(waves.begin(), waves.end(), [](const Wave& wave) { return wave.half_angle.has_value(); });
  std::vector<TrigonometricSum> sums;
  for (const Doubled doubled : {Doubled::cosine, Doubled::sine_square, Doubled::cosine_square}) {
    if (doubled != Doubled::cosine && !any_half) continue;
    TrigonometricSum sum{constant.moved(places, all), variables, 2 * twos};
    for (const Wave& wave : waves) {
      const std::size_t place = sum.variables.size();
      Polynomial cosine = Polynomial::variable(all, place);
      if (doubled != Doubled::cosine && wave.half_angle) {  // cos 2x = 1 - 2 sin^2 x = 2 cos^2 x - 1
        const int sign = doubled == Doubled::sine_square ? -1 : 1;
        cosine = scaled(cosine * cosine, Integer(2 * sign)) - Polynomial(all, Integer(sign));
        sum.variables.push_back(call_form(sign < 0 ? "sin" : "cos", *wave.half_angle));
      } else {
        sum.variables.push_back(call_form("cos", wave.angle));
      }
      sum.variables.push_back(call_form("sin", wave.angle));
      sum.polynomial = sum.polynomial + wave.cosine.moved(places, all) * cosine +
                       wave.sine.moved(places, all) * Polynomial::variable(all, place + 1);
    }
    sums.push_back(std::move(sum));
  }
  return sums;
}

}  // namespace poinsot::symbolic
