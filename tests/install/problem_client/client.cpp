// Solves the text of a problem; exits with 1 if the answer is wrong.
#include <poinsot/document.h>
#include <poinsot/problem.h>
#include <poinsot/rendering.h>

#include <cmath>
#include <cstdio>
#include <variant>

int main() {
  // A particle of 2 kg at 3 m from the axis: 18 kg m^2.
  const poinsot::Problem problem = poinsot::Problem::from_text(
      "title: A particle\ngiven: {m: 1 kg, r: 3 m}\nbodies: {p: {particle: [r, 0, 0], mass: m}}\n"
      "ask: {I: 'moment_of_inertia(p about z at [0, 0, 0])'}\n",
      "particle.yaml");
  const poinsot::Document document = problem.solve({{"m", "2 kg"}});
  std::fputs(poinsot::to_terminal(document).c_str(), stdout);
  const double* inertia = std::get_if<double>(&document.solutions.at(0).answers.at(0).si.content);
  return inertia && std::abs(*inertia - 18) < 1e-12 && fully_answered(document) ? 0 : 1;
}
