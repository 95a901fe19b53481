#include "sim/dynamics/rod_contact.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <Eigen/Geometry>

namespace sim {
namespace {

constexpr double kReferenceLength = 3.0;  // mm that a node of the nominal stiffness stands for

}  // namespace

RodContact::RodContact(const RodMesh& mesh, const RodSettings& settings, const Wall* wall)
    : wall_(wall),
      radius_(mesh.radius),
      friction_(mesh.friction),
      onset_(settings.contact_onset),
      soft_depth_(settings.contact_soft_depth),
      hardening_(settings.contact_hardening),
      wall_curvature_(settings.wall_curvature),
      share_(mesh.node_count(), 1.0),
      end_(mesh.node_count()),
      points_(mesh.node_count()),
      samples_(mesh.node_count()) {
  for (double length : mesh.cell_length) {
    normal_stiffness_.push_back(settings.contact_stiffness * length / kReferenceLength);
    friction_stiffness_.push_back(settings.friction_stiffness * length / kReferenceLength);
  }
  // the tip is a place, not a length: what it presses into must not depend on the mesh
  normal_stiffness_[0] = settings.contact_stiffness;
  friction_stiffness_[0] = settings.friction_stiffness;
  contacts_.reserve(mesh.node_count());
}

void RodContact::evaluate(const RodState& state, const Vec3Array& start,
                          const std::vector<double>& start_twist) {
  contacts_.clear();
  if (wall_ == nullptr) return;
  const std::size_t count = std::min(end_, state.node_count);
  for (std::size_t i = 0; i < count; ++i) points_[i] = state.position[i];
  const auto began = std::chrono::steady_clock::now();
  wall_->sample({points_.data(), count}, {samples_.data(), count});
  wall_time_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();

  for (std::size_t i = 0; i < count; ++i) {
    const double depth = radius_ - samples_[i].distance;
    const double stiffness = normal_stiffness_[i] * share_[i];
    if (depth <= 0.0 || stiffness <= 0.0) continue;
    Contact& contact = contacts_.emplace_back();
    contact.node = i;
    contact.normal = samples_[i].normal;
    if (depth < onset_) {
      contact.force = stiffness * depth * depth / (2.0 * onset_);
      contact.stiffness = stiffness * depth / onset_;
    } else {
      contact.force = stiffness * (depth - 0.5 * onset_);
      contact.stiffness = stiffness;
    }
    if (depth > soft_depth_) {
      const double beyond = depth - soft_depth_;
      contact.force += 0.5 * stiffness * hardening_ * beyond * beyond;
      contact.stiffness += stiffness * hardening_ * beyond;
    }
    evaluate_friction(state, start, start_twist, contact);
  }
}

void RodContact::evaluate_friction(const RodState& state, const Vec3Array& start,
                                   const std::vector<double>& start_twist, Contact& contact) const {
  const std::size_t i = contact.node;
  const bool has_before = i > 0;
  const bool has_behind = i + 1 < state.node_count;
  const double lever = has_before && has_behind ? 0.5 * radius_ : radius_;
  contact.lever_before = has_before ? lever : 0.0;
  contact.lever_behind = has_behind ? lever : 0.0;

  Vec3 tangent = Vec3::Zero();
  if (has_before) tangent += state.tangent[i - 1];
  if (has_behind) tangent += state.tangent[i];
  const Vec3& n = contact.normal;
  const Vec3 along = tangent - tangent.dot(n) * n;
  const double norm = along.norm();
  // head-on: any direction along the wall will do, the bristle itself is kept as a vector
  contact.along = norm > 1e-9 ? Vec3(along / norm) : n.unitOrthogonal();
  contact.around = n.cross(contact.along);

  const Vec3 moved = state.position[i] - start[i] + state.bristle[i];
  double turn = 0.0;
  if (has_before) turn += contact.lever_before * (state.twist[i - 1] - start_twist[i - 1]);
  if (has_behind) turn += contact.lever_behind * (state.twist[i] - start_twist[i]);
  const double stiffness = friction_stiffness_[i] * share_[i];
  const double trial[2] = {stiffness * contact.along.dot(moved),
                           stiffness * (contact.around.dot(moved) + turn)};
  const double size = std::sqrt(trial[0] * trial[0] + trial[1] * trial[1]);
  const double limit = friction_ * contact.force;
  if (size <= limit) {
    contact.friction[0] = trial[0];
    contact.friction[1] = trial[1];
    contact.tangent[0] = contact.tangent[2] = stiffness;
    return;
  }
  const double a = trial[0] / size;
  const double b = trial[1] / size;
  contact.friction[0] = limit * a;
  contact.friction[1] = limit * b;
  const double slope = stiffness * limit / size;
  contact.tangent[0] = slope * b * b;
  contact.tangent[1] = -slope * a * b;
  contact.tangent[2] = slope * a * a;
  contact.push[0] = friction_ * contact.stiffness * a;
  contact.push[1] = friction_ * contact.stiffness * b;
}

void RodContact::add_to_residual(double* residual) const {
  for (const Contact& contact : contacts_) {
    double* rows = residual + 4 * contact.node;
    for (int a = 0; a < 3; ++a) {
      rows[a] += contact.friction[0] * contact.along[a] + contact.friction[1] * contact.around[a] -
                 contact.force * contact.normal[a];
    }
    if (contact.lever_before != 0.0) rows[-1] += contact.lever_before * contact.friction[1];
    if (contact.lever_behind != 0.0) rows[3] += contact.lever_behind * contact.friction[1];
  }
}

void RodContact::add_to_band(RodBand& band) const {
  for (const Contact& contact : contacts_) {
    const std::size_t first = 4 * contact.node;
    const Vec3& n = contact.normal;
    const Vec3& t = contact.along;
    const Vec3& b = contact.around;
    const double* k = contact.tangent;
    const double curved = contact.force * wall_curvature_ + k[2];
    // friction's slope by depth pulls along minus the normal
    const Vec3 push = contact.stiffness * n - contact.push[0] * t - contact.push[1] * b;
    for (std::size_t r = 0; r < 3; ++r) {
      const auto p = static_cast<Eigen::Index>(r);
      double* row = band.row(first + r) + RodBand::kReach - r;
      const double by_along = k[0] * t[p] + k[1] * b[p];
      const double by_around = k[1] * t[p] + curved * b[p];
      for (int c = 0; c < 3; ++c) row[c] += push[p] * n[c] + by_along * t[c] + by_around * b[c];
      const double by_turn = k[1] * t[p] + k[2] * b[p];
      if (contact.lever_before != 0.0) row[-1] += contact.lever_before * by_turn;
      if (contact.lever_behind != 0.0) row[3] += contact.lever_behind * by_turn;
    }
    const Vec3 by_move = k[1] * t + k[2] * b - contact.push[1] * n;
    const double levers[2] = {contact.lever_before, contact.lever_behind};
    const std::ptrdiff_t places[2] = {-1, 3};
    for (int e = 0; e < 2; ++e) {
      if (levers[e] == 0.0) continue;
      const auto index = static_cast<std::ptrdiff_t>(first) + places[e];
      double* row = band.row(static_cast<std::size_t>(index)) + RodBand::kReach - places[e];
      for (int c = 0; c < 3; ++c) row[c] += levers[e] * by_move[c];
      for (int g = 0; g < 2; ++g) {
        if (levers[g] != 0.0) row[places[g]] += levers[e] * levers[g] * k[2];
      }
    }
  }
}

void RodContact::store_bristles(RodState& state) const {
  std::size_t next = 0;
  for (const Contact& contact : contacts_) {
    for (; next < contact.node; ++next) state.bristle.set(next, Vec3::Zero());
    const double stiffness = friction_stiffness_[contact.node] * share_[contact.node];
    state.bristle.set(
        contact.node,
        (contact.friction[0] * contact.along + contact.friction[1] * contact.around) / stiffness);
    next = contact.node + 1;
  }
  for (; next < state.node_count; ++next) state.bristle.set(next, Vec3::Zero());
}

double RodContact::normal_load() const {
  double sum = 0.0;
  for (const Contact& contact : contacts_) sum += contact.force;
  return sum;
}

void RodContact::node_forces(std::span<Vec3> forces) const {
  std::fill(forces.begin(), forces.end(), Vec3::Zero());
  for (const Contact& contact : contacts_) {
    forces[contact.node] = contact.force * contact.normal - contact.friction[0] * contact.along -
                           contact.friction[1] * contact.around;
  }
}

}  // namespace sim
