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
      : te_(state.tangent[i - 1]),
        tf_(state.tangent[i]),
        inverse_e_(inverse_length_e),
        inverse_f_(inverse_length_f) {
    chi_ = 1.0 + te_.dot(tf_);
    kb_ = 2.0 / chi_ * te_.cross(tf_);
    tt_ = (te_ + tf_) / chi_;
    set_material(state, i - 1, te_, m1e_, m2e_);
    set_material(state, i, tf_, m1f_, m2f_);
    d2_ = (m2e_ + m2f_) / chi_;
    kappa_ = 0.5 * kb_.dot(m2e_ + m2f_);
  }

  double value() const { return kappa_; }
  Vec3 by_e() const { return inverse_e_ * (-kappa_ * tt_ + tf_.cross(d2_)); }
  Vec3 by_f() const { return inverse_f_ * (-kappa_ * tt_ - te_.cross(d2_)); }
  double by_twist_e() const { return -0.5 * kb_.dot(m1e_); }
  double by_twist_f() const { return -0.5 * kb_.dot(m1f_); }
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

  Vec3 te_, tf_;                  // tangents
  Vec3 kb_, tt_, d2_;             // curvature binormal, (te + tf) / chi, (m2e + m2f) / chi
  Vec3 m1e_, m1f_, m2e_, m2f_;    // material directions
  double inverse_e_, inverse_f_;  // 1/mm
  double chi_ = 0.0;
  double kappa_ = 0.0;
};

}  // namespace sim
