#include "sim/dynamics/rod_elasticity.h"

#include <cmath>

#include "sim/dynamics/rod_bent_node.h"
namespace sim {
namespace {

// A step in which a reference direction turns further than this needs the exact arc tangent.
constexpr double kSmallSine = 0.05;

// asin(s) for |s| <= kSmallSine; the first term left out is below 1e-13.
inline double small_angle(double s) {
  const double q = s * s;
  return s * (1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * 105.0 / 3456.0))));
}

}  // namespace

RodElasticity::RodElasticity(const RodMesh& mesh, double axial_stiffness)
    : rest_length_(mesh.edge_length),
      bending_(mesh.bending),
      twisting_(mesh.twisting),
      rest_bend_(mesh.rest_bend) {
  const std::size_t capacity = mesh.node_count();
  for (double length : rest_length_) axial_.push_back(axial_stiffness / length);
  for (std::size_t i = 1; i + 1 < capacity; ++i) {
    if (rest_bend_[i] != 0.0) bent_nodes_.push_back(i);
  }
  for (std::vector<double>* array :
       {&length_, &inverse_length_, &tension_, &extra_torque_, &cosine_, &moment_,
        &reference_step_sine_, &reference_step_cosine_}) {
    array->assign(capacity + 1, 0.0);
  }
  for (Vec3Array* array : {&edge_force_, &binormal_, &force_e_, &force_f_}) {
    array->resize(capacity + 1);
  }
  blocks_.resize(capacity + 2 * kPad);
}

void RodElasticity::evaluate(RodState& state) {
  evaluate_edges(state);
  evaluate_nodes(state);
  add_rest_bends(state);

  const std::size_t edges = state.node_count - 1;
  double* __restrict fx = edge_force_.x.data();
  double* __restrict fy = edge_force_.y.data();
  double* __restrict fz = edge_force_.z.data();
  for (std::size_t i = 0; i < edges; ++i) {
    fx[i] = tension_[i] * state.tangent.x[i] + force_f_.x[i] + force_e_.x[i + 1];
    fy[i] = tension_[i] * state.tangent.y[i] + force_f_.y[i] + force_e_.y[i + 1];
    fz[i] = tension_[i] * state.tangent.z[i] + force_f_.z[i] + force_e_.z[i + 1];
  }
}

void RodElasticity::evaluate_edges(RodState& state) {
  const std::size_t edges = state.node_count - 1;
  const double* __restrict px = state.position.x.data();
  const double* __restrict py = state.position.y.data();
  const double* __restrict pz = state.position.z.data();
  double* __restrict tx = state.tangent.x.data();
  double* __restrict ty = state.tangent.y.data();
  double* __restrict tz = state.tangent.z.data();
  double* __restrict rx = state.reference.x.data();
  double* __restrict ry = state.reference.y.data();
  double* __restrict rz = state.reference.z.data();
  double* __restrict length = length_.data();
  double* __restrict inverse = inverse_length_.data();
  double* __restrict tension = tension_.data();
  const double* __restrict rest = rest_length_.data();
  const double* __restrict axial = axial_.data();
#pragma GCC ivdep
  for (std::size_t i = 0; i < edges; ++i) {
    const double ex = px[i + 1] - px[i];
    const double ey = py[i + 1] - py[i];
    const double ez = pz[i + 1] - pz[i];
    const double l = std::sqrt(ex * ex + ey * ey + ez * ez);
    const double il = 1.0 / l;
    const double nx = ex * il;
    const double ny = ey * il;
    const double nz = ez * il;
    // parallel transport of the reference direction from the old tangent to the new one
    const double chi = 1.0 + tx[i] * nx + ty[i] * ny + tz[i] * nz;
    const double factor = (rx[i] * nx + ry[i] * ny + rz[i] * nz) / chi;
    rx[i] -= factor * (tx[i] + nx);
    ry[i] -= factor * (ty[i] + ny);
    rz[i] -= factor * (tz[i] + nz);
    tx[i] = nx;
    ty[i] = ny;
    tz[i] = nz;
    length[i] = l;
    inverse[i] = il;
    tension[i] = axial[i] * (l - rest[i]);
  }
}

void RodElasticity::evaluate_nodes(RodState& state) {
  const std::size_t count = state.node_count;
  const double* __restrict tx = state.tangent.x.data();
  const double* __restrict ty = state.tangent.y.data();
  const double* __restrict tz = state.tangent.z.data();
  const double* __restrict rx = state.reference.x.data();
  const double* __restrict ry = state.reference.y.data();
  const double* __restrict rz = state.reference.z.data();
  const double* __restrict twist = state.twist.data();
  const double* __restrict inverse = inverse_length_.data();
  const double* __restrict bending = bending_.data();
  const double* __restrict twisting = twisting_.data();
  double* __restrict cosine = cosine_.data();
  double* __restrict moment = moment_.data();
  double* __restrict kx = binormal_.x.data();
  double* __restrict ky = binormal_.y.data();
  double* __restrict kz = binormal_.z.data();
  double* __restrict fex = force_e_.x.data();
  double* __restrict fey = force_e_.y.data();
  double* __restrict fez = force_e_.z.data();
  double* __restrict ffx = force_f_.x.data();
  double* __restrict ffy = force_f_.y.data();
  double* __restrict ffz = force_f_.z.data();
  double* __restrict sines = reference_step_sine_.data();
  double* __restrict cosines = reference_step_cosine_.data();
  double* __restrict sum = state.reference_twist.data();
  double* __restrict sum_cosine = state.reference_cosine.data();
  double* __restrict sum_sine = state.reference_sine.data();

  // how far each reference direction stands from its neighbour's, and since the last evaluation
#pragma GCC ivdep
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double c = tx[i - 1] * tx[i] + ty[i - 1] * ty[i] + tz[i - 1] * tz[i];
    const double along = (rx[i - 1] * tx[i] + ry[i - 1] * ty[i] + rz[i - 1] * tz[i]) / (1.0 + c);
    const double ax = rx[i - 1] - along * (tx[i - 1] + tx[i]);
    const double ay = ry[i - 1] - along * (ty[i - 1] + ty[i]);
    const double az = rz[i - 1] - along * (tz[i - 1] + tz[i]);
    const double s = tx[i] * (ay * rz[i] - az * ry[i]) + ty[i] * (az * rx[i] - ax * rz[i]) +
                     tz[i] * (ax * ry[i] - ay * rx[i]);
    const double cc = ax * rx[i] + ay * ry[i] + az * rz[i];
    cosine[i] = c;
    sines[i] = s * sum_cosine[i] - cc * sum_sine[i];
    cosines[i] = cc * sum_cosine[i] + s * sum_sine[i];
    sum_cosine[i] = cc;
    sum_sine[i] = s;
  }
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const bool small = std::abs(sines[i]) <= kSmallSine && cosines[i] > 0.0;
    sum[i] += small ? small_angle(sines[i]) : std::atan2(sines[i], cosines[i]);
  }

  // E' g and the twisting moment's share, by e and by f
#pragma GCC ivdep
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double c = cosine[i];
    const double ichi = 1.0 / (1.0 + c);
    const double m = twisting[i] * (twist[i] - twist[i - 1] + sum[i]);
    const double slope = -4.0 * bending[i] * ichi * ichi;
    kx[i] = 2.0 * ichi * (ty[i - 1] * tz[i] - tz[i - 1] * ty[i]);
    ky[i] = 2.0 * ichi * (tz[i - 1] * tx[i] - tx[i - 1] * tz[i]);
    kz[i] = 2.0 * ichi * (tx[i - 1] * ty[i] - ty[i - 1] * tx[i]);
    const double be = slope * inverse[i - 1];
    const double bf = slope * inverse[i];
    const double me = 0.5 * m * inverse[i - 1];
    const double mf = 0.5 * m * inverse[i];
    fex[i] = be * (tx[i] - c * tx[i - 1]) + me * kx[i];
    fey[i] = be * (ty[i] - c * ty[i - 1]) + me * ky[i];
    fez[i] = be * (tz[i] - c * tz[i - 1]) + me * kz[i];
    ffx[i] = bf * (tx[i - 1] - c * tx[i]) + mf * kx[i];
    ffy[i] = bf * (ty[i - 1] - c * ty[i]) + mf * ky[i];
    ffz[i] = bf * (tz[i - 1] - c * tz[i]) + mf * kz[i];
    moment[i] = m;
  }
  // the ends neither bend nor twist; the base end moves as the rod grows
  force_f_.set(0, Vec3::Zero());
  force_e_.set(count - 1, Vec3::Zero());
  moment[0] = 0.0;
  moment[count - 1] = 0.0;
}

void RodElasticity::add_rest_bends(const RodState& state) {
  for (std::size_t i : bent_nodes_) {
    extra_torque_[i - 1] = 0.0;
    extra_torque_[i] = 0.0;
  }
  for (std::size_t i : bent_nodes_) {
    if (i + 1 >= state.node_count) break;
    const RodBentNode node(state, i, inverse_length_[i - 1], inverse_length_[i]);
    const double factor = -bending_[i] * rest_bend_[i];
    force_e_.set(i, force_e_[i] + factor * node.by_e());
    force_f_.set(i, force_f_[i] + factor * node.by_f());
    extra_torque_[i - 1] += factor * node.by_twist_e();
    extra_torque_[i] += factor * node.by_twist_f();
  }
}

double RodElasticity::energy(const RodState& state) const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < state.node_count; ++i) {
    sum += 0.5 * axial_[i] * (length_[i] - rest_length_[i]) * (length_[i] - rest_length_[i]);
  }
  for (std::size_t i = 1; i + 1 < state.node_count; ++i) {
    const double c = cosine_[i];
    sum += 2.0 * bending_[i] * (1.0 - c) / (1.0 + c);
    sum += 0.5 * moment_[i] * moment_[i] / twisting_[i];
    if (rest_bend_[i] == 0.0) continue;
    const RodBentNode node(state, i, inverse_length_[i - 1], inverse_length_[i]);
    sum += bending_[i] * rest_bend_[i] * (0.5 * rest_bend_[i] - node.value());
  }
  return sum;
}

void RodElasticity::assemble(const RodState& state, RodBand& band) {
  evaluate_blocks(state);
  write_rows(state, band);
  add_rest_bend_blocks(state, band);
}

}  // namespace sim
