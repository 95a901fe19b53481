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
  const Vec3 tf_d2 = tf.cross(d2);
  const Vec3 te_d2 = te.cross(d2);
  const Eigen::Matrix3d tt_tt = 2.0 * kappa * tt * tt.transpose();

  Second s;
  s.ee = inverse_e * inverse_e *
         (tt_tt - symmetric(tf_d2, tt) - kappa / chi * (unit - te * te.transpose()) +
          0.25 * symmetric(kb, m2e));
  s.ff = inverse_f * inverse_f *
         (tt_tt + symmetric(te_d2, tt) - kappa / chi * (unit - tf * tf.transpose()) +
          0.25 * symmetric(kb, m2f));
  s.ef = inverse_e * inverse_f *
         (tt_tt - kappa / chi * (unit + te * tf.transpose()) - tf_d2 * tt.transpose() +
          tt * te_d2.transpose() - cross_matrix(d2));
  s.e_twist_e = inverse_e * (0.5 * kb.dot(m1e) * tt - tf.cross(m1e) / chi);
  s.e_twist_f = inverse_e * (0.5 * kb.dot(m1f) * tt - tf.cross(m1f) / chi);
  s.f_twist_e = inverse_f * (0.5 * kb.dot(m1e) * tt + te.cross(m1e) / chi);
  s.f_twist_f = inverse_f * (0.5 * kb.dot(m1f) * tt + te.cross(m1f) / chi);
  s.twist_e_twist_e = -0.5 * kb.dot(m2e);
  s.twist_f_twist_f = -0.5 * kb.dot(m2f);
  return s;
}

}  // namespace sim
