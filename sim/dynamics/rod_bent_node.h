// The bending of a node whose rest shape is bent: kappa = (m2_e + m2_f) . kb / 2 and its
// derivatives by the edges e, f and their twist angles. Formulas: Jawed, Novelia, O'Reilly (2018).
#pragma once

#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "sim/dynamics/rod_state.h"

namespace sim {

class RodBentNode {
 public:
  struct Second {
    Eigen::Matrix3d ee, ef, ff;
    Vec3 e_twist_e, e_twist_f, f_twist_e, f_twist_f;
    double twist_e_twist_e, twist_f_twist_f;
  };

  RodBentNode(const RodState& state, std::size_t i, double inverse_length_e,
              double inverse_length_f)
      : te(state.tangent[i - 1]),
        tf(state.tangent[i]),
        inverse_e(inverse_length_e),
        inverse_f(inverse_length_f) {
    chi = 1.0 + te.dot(tf);
    kb = 2.0 / chi * te.cross(tf);
    tt = (te + tf) / chi;
    set_material(state, i - 1, te, m1e, m2e);
    set_material(state, i, tf, m1f, m2f);
    d2 = (m2e + m2f) / chi;
    kappa = 0.5 * kb.dot(m2e + m2f);
  }

  double value() const { return kappa; }
  Vec3 by_e() const { return inverse_e * (-kappa * tt + tf.cross(d2)); }
  Vec3 by_f() const { return inverse_f * (-kappa * tt - te.cross(d2)); }
  double by_twist_e() const { return -0.5 * kb.dot(m1e); }
  double by_twist_f() const { return -0.5 * kb.dot(m1f); }
  Second second_derivatives() const;

 private:
  static void set_material(const RodState& state, std::size_t edge, const Vec3& tangent, Vec3& m1,
                           Vec3& m2) {
    const Vec3 d1 = state.reference[edge];
    const double c = std::cos(state.twist[edge]);
    const double s = std::sin(state.twist[edge]);
    const Vec3 across = tangent.cross(d1);
    m1 = c * d1 + s * across;
    m2 = c * across - s * d1;
  }

  Vec3 te, tf, kb, tt, d2;      // tangents, curvature binormal, (te + tf) / chi, (m2e + m2f) / chi
  Vec3 m1e, m1f, m2e, m2f;      // material directions
  double inverse_e, inverse_f;  // 1/mm
  double chi = 0.0;
  double kappa = 0.0;
};

}  // namespace sim
