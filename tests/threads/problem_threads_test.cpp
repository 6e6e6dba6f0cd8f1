// Several threads solve different problems, and one and the same, at once: each gets the document that it gets alone.
// `./test --threads` runs this under the thread sanitizer.
#include <gtest/gtest.h>

#include <barrier>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "poinsot/problem.h"
#include "poinsot/rendering.h"

namespace poinsot {
namespace problem_threads_test {

constexpr std::size_t threads_at_once = 8;

// A tetrahedron with edges of one along the axes.
class Tetrahedron : public FileProvider {
 public:
  std::string bytes(const std::string& /*name*/) const override {
    return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  }
};

// Formulas in letters and a claim, an unknown, a motion, a mesh, tables, a blow.
std::vector<Problem> problems() {
  std::vector<Problem> all{
      Problem::from_text(
          "title: Letters\nletters: {m: kg, a: m, J: N*s}\n"
          "points: {A: [0, -a, a], B: [0, 0, a], C: [0, 0, -a], D: [0, a, -a]}\n"
          "bodies: {rod: {wire: [A, B, C, D], mass: m}}\nimpulses: {b: {body: rod, at: A, value: [J, 0, 0]}}\n"
          "instants: {before: rest}\nask: {w: angular_velocity(rod)}\n"
          "claim: {more: kinetic_energy(rod) > J^2/(2*m)}\n",
          "letters.yaml"),
      Problem::from_text(
          "title: Unknown\nfind: {r: m}\nwhere: [r > 0]\nbodies: {p: {particle: [r, 0, 0], mass: 2 kg}}\n"
          "facts: {'moment_of_inertia(p about z at [0, 0, 0])': 18 kg*m^2}\nask: {d: center(p).x}\n",
          "unknown.yaml"),
      Problem::from_text("title: Motion\npoints: {O: [0, 0, 0], P: [0, -0.9 m, 0]}\n"
                         "bodies: {bob: {particle: P, mass: 2 kg}}\n"
                         "joints: {pin: {revolute: z, at: O, to: bob, angle: theta}}\ngravity: -y\n"
                         "instants: {start: {theta: 40 deg, theta': 0}}\n"
                         "ask: {x: {table: {t: time, a: theta}, over: {time: 0 s .. 2 s by 0.5 s}, unit: {a: deg}}}\n",
                         "motion.yaml"),
      Problem::from_text(
          "title: Mesh\nbodies: {t: {mesh: {file: t.obj, unit: m, at: [1 m, 0, 0]}, density: 6 kg/m^3}}\n"
          "ask: {m: mass(t), c: center(t)}\n",
          "mesh.yaml", Tetrahedron())};
  const std::filesystem::path textbook = std::filesystem::path(POINSOT_SOURCE_DIR) / "examples/textbook";
  for (const char* name : {"18.001.yaml", "18.045.yaml", "18.089.yaml", "18.107.yaml"})
    all.push_back(Problem::from_file((textbook / name).string()));
  return all;
}

// What a thread finds of one problem: its answers and worked solutions.
std::string found_by(const Problem& problem) {
  return to_json(problem.explain()) + to_terminal(problem.solve()) + problem.title();
}

// What each of some threads, which begin together, finds of the problem that is its own.
std::vector<std::string> found_at_once(const std::vector<const Problem*>& of_thread) {
  std::vector<std::string> found(of_thread.size());
  std::barrier begin(static_cast<std::ptrdiff_t>(of_thread.size()));
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < of_thread.size(); ++i)
    threads.emplace_back([&, i] {
      begin.arrive_and_wait();
      try {
        found[i] = found_by(*of_thread[i]);
      } catch (const std::exception& error) {
        found[i] = error.what();
      }
    });
  for (std::thread& thread : threads) thread.join();
  return found;
}

// The first calls of a program, before anything is known that is found once.
TEST(Threads, read_and_solve_from_the_beginning_at_once) {
  std::vector<std::string> found(threads_at_once);
  std::vector<std::thread> threads;
  for (std::string& one : found)
    threads.emplace_back([&one] {
      for (const Problem& problem : problems()) one += found_by(problem);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(found, std::vector<std::string>(threads_at_once, found.front()));
  EXPECT_NE(found.front(), "");
}

TEST(Threads, solve_different_problems_at_once) {
  const std::vector<Problem> all = problems();
  ASSERT_EQ(all.size(), threads_at_once);
  std::vector<std::string> alone;
  std::vector<const Problem*> of_thread;
  for (const Problem& problem : all) {
    alone.push_back(found_by(problem));
    EXPECT_FALSE(problem.solve().solutions.empty()) << problem.name();
    of_thread.push_back(&problem);
  }
  EXPECT_EQ(found_at_once(of_thread), alone);
}

TEST(Threads, solve_one_problem_at_once) {
  for (const Problem& problem : problems()) {
    const std::string alone = found_by(problem);
    const std::vector<const Problem*> of_thread(threads_at_once, &problem);
    EXPECT_EQ(found_at_once(of_thread), std::vector<std::string>(threads_at_once, alone)) << problem.name();
  }
}

}  // namespace problem_threads_test
}  // namespace poinsot
