#include "sim/dynamics/rod_bent_node.h"

namespace sim {
namespace {

Eigen::Matrix3d cross_matrix(const Vec3& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Eigen::Matrix3d symmetric(const Vec3& a, const Vec3& b) {
  return a * b.transpose() + b * a.transpose();
}

}  // namespace

RodBentNode::Second RodBentNode::second_derivatives() const {
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
  const Vec3 tf_d2 = tf_.cross(d2_);
  const Vec3 te_d2 = te_.cross(d2_);
  const Eigen::Matrix3d tt_tt = 2.0 * kappa_ * tt_ * tt_.transpose();

  Second s;
  s.ee = inverse_e_ * inverse_e_ *
         (tt_tt - symmetric(tf_d2, tt_) - kappa_ / chi_ * (unit - te_ * te_.transpose()) +
          0.25 * symmetric(kb_, m2e_));
  s.ff = inverse_f_ * inverse_f_ *
         (tt_tt + symmetric(te_d2, tt_) - kappa_ / chi_ * (unit - tf_ * tf_.transpose()) +
          0.25 * symmetric(kb_, m2f_));
  s.ef = inverse_e_ * inverse_f_ *
         (tt_tt - kappa_ / chi_ * (unit + te_ * tf_.transpose()) - tf_d2 * tt_.transpose() +
          tt_ * te_d2.transpose() - cross_matrix(d2_));
  s.e_twist_e = inverse_e_ * (0.5 * kb_.dot(m1e_) * tt_ - tf_.cross(m1e_) / chi_);
  s.e_twist_f = inverse_e_ * (0.5 * kb_.dot(m1f_) * tt_ - tf_.cross(m1f_) / chi_);
  s.f_twist_e = inverse_f_ * (0.5 * kb_.dot(m1e_) * tt_ + te_.cross(m1e_) / chi_);
  s.f_twist_f = inverse_f_ * (0.5 * kb_.dot(m1f_) * tt_ + te_.cross(m1f_) / chi_);
  s.twist_e_twist_e = -0.5 * kb_.dot(m2e_);
  s.twist_f_twist_f = -0.5 * kb_.dot(m2f_);
  return s;
}

}  // namespace sim
