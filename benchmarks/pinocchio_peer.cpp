// Pinocchio on the benchmark's models. Of its two conventions (local and world axes) the quicker one for the model
// counts.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/config.hpp>
#if __has_include(<pinocchio/multibody.hpp>)  // version 4
#include <pinocchio/multibody.hpp>
#include <pinocchio/multibody/joint.hpp>
#else
#include <pinocchio/multibody/data.hpp>
#include <pinocchio/multibody/model.hpp>
#endif

#include "peer.h"

namespace poinsot::bench {
namespace {

Eigen::Vector3d eigen(const Vector3<double>& a) { return {a.x, a.y, a.z}; }
Eigen::Matrix3d eigen(const Matrix3<double>& a) {
  Eigen::Matrix3d b;
  b << a.row0.x, a.row0.y, a.row0.z, a.row1.x, a.row1.y, a.row1.z, a.row2.x, a.row2.y, a.row2.z;
  return b;
}

struct PinocchioSample {
  Eigen::VectorXd q;
  Eigen::VectorXd v;
  Eigen::VectorXd given;
};

struct Peer {
  pinocchio::Model model;
  std::unique_ptr<pinocchio::Data> data;
  std::vector<JointType> joints;
  std::vector<PinocchioSample> samples;
  pinocchio::Convention aba_convention = pinocchio::Convention::LOCAL;
  pinocchio::Convention crba_convention = pinocchio::Convention::LOCAL;

  // Its velocities of a free joint have the linear part first.
  Eigen::VectorXd to_peer(const std::vector<double>& v) const {
    Eigen::VectorXd w = Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
    int k = 0;
    for (const JointType joint : joints) {
      if (joint == JointType::free) {
        w.segment<3>(k).swap(w.segment<3>(k + 3));
      }
      k += velocity_size(joint);
    }
    return w;
  }
  // Our number of each of its velocity coordinates is the same map: a swap of threes.
  int index(int ours) const {
    int k = 0;
    for (const JointType joint : joints) {
      if (joint == JointType::free && ours >= k && ours < k + 6) return k + (ours - k + 3) % 6;
      k += velocity_size(joint);
    }
    return ours;
  }
};

pinocchio::JointModel joint_of(const Joint<double>& joint) {
  if (joint.type == JointType::free) return pinocchio::JointModelFreeFlyer();
  if (joint.type == JointType::ball) return pinocchio::JointModelSpherical();
  if (joint.axis.x == 1.0) return pinocchio::JointModelRX();
  if (joint.axis.y == 1.0) return pinocchio::JointModelRY();
  if (joint.axis.z == 1.0) return pinocchio::JointModelRZ();
  return pinocchio::JointModelRevoluteUnaligned(eigen(joint.axis));
}

// Its Data always holds four tensors of the third order (second derivatives of the inverse dynamics): 32 GB for 1000
// coordinates. They may take half of the machine's memory.
bool memory_suffices(std::size_t coordinates) {
  const double n = static_cast<double>(coordinates);
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  return 4.0 * 8.0 * n * n * n < 0.5 * memory;
}

template <class F>
double seconds_of(F f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::string peer_name() { return std::string("Pinocchio ") + PINOCCHIO_VERSION; }

Contestant make_peer(const StatedModel& stated, const std::vector<Sample>& samples) {
  if (!memory_suffices(samples.front().state.v.size())) return {};
  const auto peer = std::make_shared<Peer>();
  pinocchio::Model& model = peer->model;
  model.gravity.linear(Eigen::Vector3d(0.0, 0.0, -9.81));
  for (std::size_t i = 0; i < stated.bodies.size(); ++i) {
    const StatedBody& body = stated.bodies[i];
    const pinocchio::SE3 placement(eigen(body.placement.R), eigen(body.placement.p));
    const pinocchio::JointIndex joint = model.addJoint(static_cast<pinocchio::JointIndex>(body.parent + 1),
                                                       joint_of(body.joint), placement, "joint " + std::to_string(i));
    model.appendBodyToJoint(
        joint, pinocchio::Inertia(body.mass.mass, eigen(body.mass.center), eigen(as_matrix(body.mass.inertia_center))),
        pinocchio::SE3::Identity());
    peer->joints.push_back(body.joint.type);
  }
  peer->data = std::make_unique<pinocchio::Data>(model);
  for (const Sample& sample : samples) {
    PinocchioSample own;
    own.q = Eigen::Map<const Eigen::VectorXd>(sample.state.q.data(), static_cast<Eigen::Index>(sample.state.q.size()));
    int k = 0;
    for (const JointType joint : peer->joints) {
      if (joint == JointType::ball || joint == JointType::free) {
        // Its quaternions end with the scalar part, its free joints begin with the position.
        const double* q = &sample.state.q[static_cast<std::size_t>(k)];
        const Eigen::Vector4d quaternion(q[1], q[2], q[3], q[0]);
        if (joint == JointType::free) own.q.segment<3>(k) = Eigen::Vector3d(q[4], q[5], q[6]);
        own.q.segment<4>(joint == JointType::free ? k + 3 : k) = quaternion;
      }
      k += position_size(joint);
    }
    own.v = peer->to_peer(sample.state.v);
    own.given = peer->to_peer(sample.given);
    peer->samples.push_back(own);
  }

  Contestant contestant;
  contestant.inverse_dynamics = [peer](int calls) {
    for (int i = 0; i < calls; ++i) {
      const PinocchioSample& s = peer->samples[static_cast<std::size_t>(i) % peer->samples.size()];
      pinocchio::rnea(peer->model, *peer->data, s.q, s.v, s.given);
    }
  };
  contestant.forward_dynamics = [peer](int calls) {
    for (int i = 0; i < calls; ++i) {
      const PinocchioSample& s = peer->samples[static_cast<std::size_t>(i) % peer->samples.size()];
      pinocchio::aba(peer->model, *peer->data, s.q, s.v, s.given, peer->aba_convention);
    }
  };
  contestant.mass_matrix = [peer](int calls) {
    for (int i = 0; i < calls; ++i) {
      const PinocchioSample& s = peer->samples[static_cast<std::size_t>(i) % peer->samples.size()];
      pinocchio::crba(peer->model, *peer->data, s.q, peer->crba_convention);
    }
  };
  contestant.inverse_result = [peer](int i) {
    const PinocchioSample& s = peer->samples[static_cast<std::size_t>(i)];
    const Eigen::VectorXd tau = pinocchio::rnea(peer->model, *peer->data, s.q, s.v, s.given);
    std::vector<double> ours(static_cast<std::size_t>(tau.size()));
    for (int k = 0; k < tau.size(); ++k) ours[static_cast<std::size_t>(k)] = tau[peer->index(k)];
    return ours;
  };
  contestant.forward_result = [peer](int i) {
    const PinocchioSample& s = peer->samples[static_cast<std::size_t>(i)];
    const Eigen::VectorXd a = pinocchio::aba(peer->model, *peer->data, s.q, s.v, s.given, peer->aba_convention);
    std::vector<double> ours(static_cast<std::size_t>(a.size()));
    for (int k = 0; k < a.size(); ++k) ours[static_cast<std::size_t>(k)] = a[peer->index(k)];
    return ours;
  };
  contestant.mass_result = [peer](int i) {
    const PinocchioSample& s = peer->samples[static_cast<std::size_t>(i)];
    Eigen::MatrixXd M = pinocchio::crba(peer->model, *peer->data, s.q, peer->crba_convention);
    M.triangularView<Eigen::StrictlyLower>() = M.transpose().triangularView<Eigen::StrictlyLower>();
    std::vector<double> ours;
    for (int r = 0; r < M.rows(); ++r) {
      for (int c = 0; c <= r; ++c) ours.push_back(M(peer->index(r), peer->index(c)));
    }
    return ours;
  };

  // The quicker convention for this model.
  const int calls = static_cast<int>(2000 / model.nv) + 8;
  const auto quicker = [&](pinocchio::Convention& convention, const std::function<void(int)>& run) {
    double best[2] = {1e9, 1e9};
    for (int repeat = 0; repeat < 5; ++repeat) {
      for (int c = 0; c < 2; ++c) {
        convention = c == 0 ? pinocchio::Convention::LOCAL : pinocchio::Convention::WORLD;
        best[c] = std::min(best[c], seconds_of([&] { run(calls); }));
      }
    }
    convention = best[0] <= best[1] ? pinocchio::Convention::LOCAL : pinocchio::Convention::WORLD;
  };
  quicker(peer->aba_convention, contestant.forward_dynamics);
  quicker(peer->crba_convention, contestant.mass_matrix);
  return contestant;
}

}  // namespace poinsot::bench
