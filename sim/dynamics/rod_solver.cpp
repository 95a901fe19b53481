#include "sim/dynamics/rod_solver.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

#include "sim/base/require.h"

namespace sim {
namespace {

constexpr double kTorqueWeight = 0.45;    // 1/mm: how a torque counts against the tolerance
constexpr double kSlowConvergence = 0.7;  // less progress than this twice: damp
constexpr double kMaxTurn = 1.0;          // rad of any edge in one iteration

}  // namespace

RodSolver::RodSolver(const RodMesh& mesh, const RodSettings& settings, const Wall* wall)
    : mesh_(mesh),
      settings_(settings),
      elasticity_(mesh, settings.axial_stiffness),
      contact_(mesh, settings, wall),
      band_(mesh.node_count()),
      state_(mesh.node_count()),
      start_(mesh.node_count()),
      guide_(mesh.node_count(), 0.0),
      held_(4 * mesh.node_count(), 0),
      motion_(4 * mesh.node_count(), 0.0),
      residual_(4 * mesh.node_count() + RodBand::kReach, 0.0),
      change_(4 * mesh.node_count() + RodBand::kReach, 0.0) {
  base::require(settings.time_step > 0.0, "the time step must be positive");
  base::require(mesh.node_count() >= 3, "a rod needs at least three nodes");
  const double dt = settings.time_step;
  for (double length : mesh.cell_length) {
    mass_.push_back(settings.line_density * length / (dt * dt));
    drag_.push_back(settings.drag * length / dt);
    twist_drag_.push_back(settings.twist_drag * length / dt);
  }
  load_.resize(mesh.node_count());
}

void RodSolver::place(std::span<const Vec3> nodes, const Vec3& up) {
  base::require(nodes.size() >= 3 && nodes.size() <= capacity(), "too few or too many nodes");
  const std::size_t count = nodes.size();
  state_ = RodState(capacity());
  state_.node_count = count;
  for (std::size_t i = 0; i < count; ++i) state_.position.set(i, nodes[i]);
  Vec3 direction = up;
  for (std::size_t i = count - 1; i-- > 0;) {
    const Vec3 tangent = (nodes[i + 1] - nodes[i]).normalized();
    if (i + 2 == count) {
      direction = (up - up.dot(tangent) * tangent).normalized();
    } else {
      const Vec3 last = state_.tangent[i + 1];
      direction -= direction.dot(tangent) / (1.0 + last.dot(tangent)) * (last + tangent);
    }
    state_.tangent.set(i, tangent);
    state_.reference.set(i, direction);
  }
  std::fill(state_.reference_cosine.begin(), state_.reference_cosine.end(), 1.0);
  start_ = state_;
  evaluate();
}

void RodSolver::hold(std::size_t node, bool held) {
  for (int axis = 0; axis < 3; ++axis) hold_along(node, axis, held);
}

void RodSolver::hold_along(std::size_t node, int axis, bool held) {
  held_[4 * node + static_cast<std::size_t>(axis)] = held ? 1 : 0;
}

void RodSolver::hold_twist(std::size_t edge, bool held) { held_[4 * edge + 3] = held ? 1 : 0; }

void RodSolver::set_guide(const Vec3& point, const Vec3& axis) {
  guide_point_ = point;
  guide_axis_ = axis.normalized();
}

void RodSolver::move(std::size_t node, const Vec3& displacement) {
  for (std::size_t a = 0; a < 3; ++a) {
    motion_[4 * node + a] += displacement[static_cast<Eigen::Index>(a)];
  }
}

void RodSolver::turn(std::size_t edge, double angle) { motion_[4 * edge + 3] += angle; }

RodStatus RodSolver::step() {
  assert(state_.node_count >= 3);
  begin_step();
  predict();
  evaluate();
  residual_norm_ = measure();
  iterations_ = 0;
  double damping = 1.0;
  double before = 0.0;
  int slow = 0;
  while (iterations_ < settings_.max_iterations && std::isfinite(residual_norm_)) {
    if (iterations_ > 0 && residual_norm_ < settings_.tolerance) break;
    slow = iterations_ > 0 && residual_norm_ > kSlowConvergence * before ? slow + 1 : 0;
    if (slow >= 2) damping = std::max(0.25, 0.6 * damping);
    if (iterations_ == settings_.restart_iteration) {
      restart();
      evaluate();
      damping = 1.0;
      slow = 0;
      residual_norm_ = measure();
    }
    before = residual_norm_;
    assemble();
    band_.solve(4 * state_.node_count - 1, change_.data());
    apply(damping);
    evaluate();
    residual_norm_ = measure();
    ++iterations_;
  }
  if (!std::isfinite(residual_norm_)) return RodStatus::diverged;
  finish_step();
  return std::isfinite(residual_norm_) ? RodStatus::ok : RodStatus::diverged;
}

void RodSolver::begin_step() {
  const std::size_t count = state_.node_count;
  start_.node_count = count;
  const auto keep = [count](const std::vector<double>& from, std::vector<double>& to) {
    std::copy_n(from.begin(), count, to.begin());
  };
  const auto keep_vectors = [&keep](const Vec3Array& from, Vec3Array& to) {
    keep(from.x, to.x);
    keep(from.y, to.y);
    keep(from.z, to.z);
  };
  keep_vectors(state_.position, start_.position);
  keep_vectors(state_.velocity, start_.velocity);
  keep_vectors(state_.tangent, start_.tangent);
  keep_vectors(state_.reference, start_.reference);
  keep(state_.twist, start_.twist);
  keep(state_.twist_rate, start_.twist_rate);
  keep(state_.reference_twist, start_.reference_twist);
  keep(state_.reference_cosine, start_.reference_cosine);
  keep(state_.reference_sine, start_.reference_sine);
}

void RodSolver::predict() {
  const double dt = settings_.time_step;
  const std::size_t count = state_.node_count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* held = held_.data() + 4 * i;
    double* motion = motion_.data() + 4 * i;
    state_.position.x[i] += held[0] != 0 ? motion[0] : dt * state_.velocity.x[i];
    state_.position.y[i] += held[1] != 0 ? motion[1] : dt * state_.velocity.y[i];
    state_.position.z[i] += held[2] != 0 ? motion[2] : dt * state_.velocity.z[i];
    state_.twist[i] += held[3] != 0 ? motion[3] : dt * state_.twist_rate[i];
  }
}

// Drops the prediction: back to the beginning of the step, but for what is held.
void RodSolver::restart() {
  const std::size_t count = state_.node_count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* held = held_.data() + 4 * i;
    if (held[0] == 0) state_.position.x[i] = start_.position.x[i];
    if (held[1] == 0) state_.position.y[i] = start_.position.y[i];
    if (held[2] == 0) state_.position.z[i] = start_.position.z[i];
    if (held[3] == 0) state_.twist[i] = start_.twist[i];
    state_.tangent.set(i, start_.tangent[i]);
    state_.reference.set(i, start_.reference[i]);
    state_.reference_twist[i] = start_.reference_twist[i];
    state_.reference_cosine[i] = start_.reference_cosine[i];
    state_.reference_sine[i] = start_.reference_sine[i];
  }
}

void RodSolver::evaluate() {
  elasticity_.evaluate(state_);
  contact_.evaluate(state_, start_.position, start_.twist);
  add_rows();
  contact_.add_to_residual(residual_.data());
}

void RodSolver::add_rows() {
  const double dt = settings_.time_step;
  const std::size_t count = state_.node_count;
  const Vec3Array& force = elasticity_.edge_forces();
  double fx = 0.0;  // of the edge before
  double fy = 0.0;
  double fz = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const double dx = state_.position.x[i] - start_.position.x[i];
    const double dy = state_.position.y[i] - start_.position.y[i];
    const double dz = state_.position.z[i] - start_.position.z[i];
    const double both = mass_[i] + drag_[i];
    const double kick = mass_[i] * dt;
    double* rows = residual_.data() + 4 * i;
    rows[0] = fx + both * dx - kick * start_.velocity.x[i] - load_.x[i];
    rows[1] = fy + both * dy - kick * start_.velocity.y[i] - load_.y[i];
    rows[2] = fz + both * dz - kick * start_.velocity.z[i] - load_.z[i];
    rows[3] = 0.0;
    if (!last) {
      fx = force.x[i];
      fy = force.y[i];
      fz = force.z[i];
      rows[0] -= fx;
      rows[1] -= fy;
      rows[2] -= fz;
      rows[3] = elasticity_.twist_force(i) + twist_drag_[i] * (state_.twist[i] - start_.twist[i]);
    }
    if (guide_[i] > 0.0) {
      const Vec3 from_point = state_.position[i] - guide_point_;
      const Vec3 aside = from_point - from_point.dot(guide_axis_) * guide_axis_;
      for (int a = 0; a < 3; ++a) rows[a] += guide_[i] * aside[a];
    }
  }
}

// The largest unbalanced force; infinite when any row is not a number.
double RodSolver::measure() const {
  double largest = 0.0;
  double sum = 0.0;
  const std::size_t size = 4 * state_.node_count - 1;
  for (std::size_t row = 0; row < size; ++row) {
    if (held_[row] != 0) continue;
    const double weight = row % 4 == 3 ? kTorqueWeight : 1.0;
    const double value = weight * std::abs(residual_[row]);
    sum += value;
    largest = std::max(largest, value);
  }
  return std::isfinite(sum) ? largest : sum;
}

void RodSolver::assemble() {
  elasticity_.assemble(state_, band_);
  const std::size_t count = state_.node_count;
  for (std::size_t i = 0; i < count; ++i) {
    const double both = mass_[i] + drag_[i];
    for (std::size_t a = 0; a < 3; ++a) band_.row(4 * i + a)[RodBand::kReach] += both;
    band_.row(4 * i + 3)[RodBand::kReach] += twist_drag_[i];
    if (guide_[i] > 0.0) {
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
          const double unit = a == b ? 1.0 : 0.0;
          band_.at(4 * i + a, 4 * i + b) +=
              guide_[i] * (unit - guide_axis_[static_cast<Eigen::Index>(a)] *
                                      guide_axis_[static_cast<Eigen::Index>(b)]);
        }
      }
    }
  }
  contact_.add_to_band(band_);
  const std::size_t size = 4 * count - 1;
  for (std::size_t row = 0; row < size; ++row) {
    change_[row] = -residual_[row];
    if (held_[row] == 0) continue;
    double* entries = band_.row(row);
    std::fill(entries, entries + RodBand::kStride, 0.0);
    entries[RodBand::kReach] = 1.0;
    change_[row] = 0.0;
  }
}

// Moves by the solution, limited in size; returns the factor used.
double RodSolver::apply(double damping) {
  const std::size_t count = state_.node_count;
  double largest = 0.0;
  double largest_turn = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double* d = change_.data() + 4 * i;
    largest = std::max(largest, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (i + 1 < count) largest_turn = std::max(largest_turn, std::abs(d[3]));
  }
  largest = std::sqrt(largest);
  double factor = damping;
  if (largest > settings_.max_move) factor = damping * settings_.max_move / largest;
  if (factor * largest_turn > kMaxTurn) factor = kMaxTurn / largest_turn;
  for (std::size_t i = 0; i < count; ++i) {
    const double* d = change_.data() + 4 * i;
    state_.position.x[i] += factor * d[0];
    state_.position.y[i] += factor * d[1];
    state_.position.z[i] += factor * d[2];
    if (i + 1 < count) state_.twist[i] += factor * d[3];
  }
  return factor;
}

void RodSolver::finish_step() {
  const double rate = 1.0 / settings_.time_step;
  const std::size_t count = state_.node_count;
  double farthest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = state_.position.x[i] - start_.position.x[i];
    const double dy = state_.position.y[i] - start_.position.y[i];
    const double dz = state_.position.z[i] - start_.position.z[i];
    farthest = std::max(farthest, dx * dx + dy * dy + dz * dz);
    state_.velocity.x[i] = rate * dx;
    state_.velocity.y[i] = rate * dy;
    state_.velocity.z[i] = rate * dz;
    state_.twist_rate[i] = rate * (state_.twist[i] - start_.twist[i]);
    // keep the reference directions unit and normal against rounding
    const Vec3 tangent = state_.tangent[i];
    Vec3 reference = state_.reference[i];
    reference -= reference.dot(tangent) * tangent;
    if (i + 1 < count) state_.reference.set(i, reference / reference.norm());
  }
  if (farthest > settings_.impossible_move * settings_.impossible_move) residual_norm_ = HUGE_VAL;
  contact_.store_bristles(state_);
  std::fill_n(motion_.begin(), 4 * count, 0.0);
}

void RodSolver::append_node(const Vec3& axis) {
  const std::size_t old = state_.node_count;  // the new node; the new edge is old - 1
  assert(old < capacity() && old >= 3);
  const std::size_t edge = old - 1;
  const double length = mesh_.edge_length[edge] * elasticity_.stretch(edge - 1);
  state_.position.set(old, state_.position[edge] - length * axis);
  state_.velocity.set(old, state_.velocity[edge]);
  state_.bristle.set(old, Vec3::Zero());

  const Vec3 tangent = -axis;
  const Vec3 last = state_.tangent[edge - 1];
  Vec3 direction = state_.reference[edge - 1];
  direction -= direction.dot(tangent) / (1.0 + last.dot(tangent)) * (last + tangent);
  state_.tangent.set(edge, tangent);
  state_.reference.set(edge, direction);
  state_.reference_twist[edge] = 0.0;
  state_.reference_cosine[edge] = 1.0;
  state_.reference_sine[edge] = 0.0;
  // the same twisting moment on both sides of the old base
  state_.twist[edge] =
      state_.twist[edge - 1] + elasticity_.twist_moment(edge - 1) / mesh_.twisting[edge];
  state_.twist_rate[edge] = state_.twist_rate[edge - 1];
  state_.node_count = old + 1;
}

void RodSolver::remove_node() {
  assert(state_.node_count > 3);
  --state_.node_count;
  // the place of the edge that is gone must not be taken for one in use
  state_.twist[state_.node_count - 1] = 0.0;
  state_.twist_rate[state_.node_count - 1] = 0.0;
}

Vec3 RodSolver::holding_force(std::size_t node) const {
  Vec3 force = -load_[node];
  if (node > 0) force += elasticity_.edge_force(node - 1);
  if (node + 1 < state_.node_count) force -= elasticity_.edge_force(node);
  return force;
}

double RodSolver::holding_moment(std::size_t edge) const { return elasticity_.twist_force(edge); }

std::span<const double> RodSolver::residual_at(const RodState& state) {
  state_ = state;
  evaluate();
  return {residual_.data(), 4 * state_.node_count - 1};
}

const RodBand& RodSolver::matrix_at(const RodState& state) {
  state_ = state;
  evaluate();
  assemble();
  return band_;
}

}  // namespace sim
