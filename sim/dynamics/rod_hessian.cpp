// RodElasticity: the exact second derivatives, and how they fill the band.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "sim/dynamics/rod_bent_node.h"
#include "sim/dynamics/rod_elasticity.h"

namespace sim {
namespace {

// Place of entry (a, b) of a symmetric 3 x 3 matrix among xx xy xz yy yz zz.
constexpr std::size_t kPlace[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
constexpr std::size_t kRow[6] = {0, 0, 0, 1, 1, 2};
constexpr std::size_t kColumn[6] = {0, 1, 2, 1, 2, 2};

}  // namespace

// With g_e = dc/de, g_f = dc/df, T_e = I - te te', chi = 1 + c, tt = (te + tf) / chi and the
// twisting moment M:
//   ee: E'' g_e g_e' - E' ((te g_e' + g_e te') / |e| + c T_e / |e|^2)
//       + GJ/L kb kb' / (4 |e|^2) - M / (4 |e|^2) (kb (te + tt)' + (te + tt) kb')
//   ef: E'' g_e g_f' + E' T_e T_f / (|e| |f|)
//       + GJ/L kb kb' / (4 |e| |f|) + M / (2 |e| |f|) (2 / chi [te]x - kb tt')
void RodElasticity::evaluate_blocks(const RodState& state) {
  const std::size_t count = state.node_count;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double te[3] = {state.tangent.x[i - 1], state.tangent.y[i - 1], state.tangent.z[i - 1]};
    const double tf[3] = {state.tangent.x[i], state.tangent.y[i], state.tangent.z[i]};
    const double kb[3] = {binormal_.x[i], binormal_.y[i], binormal_.z[i]};
    const double c = cosine_[i];
    const double ie = inverse_length_[i - 1];
    const double jf = inverse_length_[i];
    const double ichi = 1.0 / (1.0 + c);
    const double slope = -4.0 * bending_[i] * ichi * ichi;
    const double curve = -2.0 * slope * ichi;
    const double m = moment_[i];
    const double ee = ie * ie;
    const double ff = jf * jf;
    const double ef = ie * jf;

    double ge[3], gf[3], tt[3], we[3], wf[3];
    for (int a = 0; a < 3; ++a) {
      ge[a] = (tf[a] - c * te[a]) * ie;
      gf[a] = (te[a] - c * tf[a]) * jf;
      tt[a] = (te[a] + tf[a]) * ichi;
      we[a] = -0.25 * m * ee * (te[a] + tt[a]);
      wf[a] = -0.25 * m * ff * (tf[a] + tt[a]);
    }
    const double twisting_ee = 0.25 * twisting_[i] * ee;
    const double twisting_ff = 0.25 * twisting_[i] * ff;
    const double twisting_ef = 0.25 * twisting_[i] * ef;
    const double slope_e = slope * ie;
    const double slope_f = slope * jf;
    const double ball_e = slope * c * ee;
    const double ball_f = slope * c * ff;
    const double ball_ef = slope * ef;

    Blocks& blocks = blocks_[i + kPad];
    for (int k = 0; k < 6; ++k) {
      const std::size_t a = kRow[k];
      const std::size_t b = kColumn[k];
      const double unit = a == b ? 1.0 : 0.0;
      blocks.ee[k] = curve * ge[a] * ge[b] - slope_e * (te[a] * ge[b] + ge[a] * te[b]) -
                     ball_e * (unit - te[a] * te[b]) + twisting_ee * kb[a] * kb[b] + kb[a] * we[b] +
                     we[a] * kb[b];
      blocks.ff[k] = curve * gf[a] * gf[b] - slope_f * (tf[a] * gf[b] + gf[a] * tf[b]) -
                     ball_f * (unit - tf[a] * tf[b]) + twisting_ff * kb[a] * kb[b] + kb[a] * wf[b] +
                     wf[a] * kb[b];
    }
    const double half_m = 0.5 * m * ef;
    const double turn = 2.0 * half_m * ichi;
    const double cross[3][3] = {{0.0, -turn * te[2], turn * te[1]},
                                {turn * te[2], 0.0, -turn * te[0]},
                                {-turn * te[1], turn * te[0], 0.0}};
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        const double unit = a == b ? 1.0 : 0.0;
        blocks.ef[3 * a + b] =
            curve * ge[a] * gf[b] +
            ball_ef * (unit - te[a] * te[b] - tf[a] * tf[b] + c * te[a] * tf[b]) +
            twisting_ef * kb[a] * kb[b] - half_m * kb[a] * tt[b] + cross[a][b];
      }
    }
    const double half_e = 0.5 * twisting_[i] * ie;
    const double half_f = 0.5 * twisting_[i] * jf;
    for (int a = 0; a < 3; ++a) {
      blocks.twist_e[a] = half_e * kb[a];
      blocks.twist_f[a] = half_f * kb[a];
    }
    blocks.twisting = twisting_[i];
  }
  blocks_[kPad] = Blocks{};
  blocks_[count - 1 + kPad] = Blocks{};
  blocks_[count + kPad] = Blocks{};
}

// x_i enters with e of node i (+), f of node i (-), e of node i+1 (-), f of node i-1 (+). So with
// S_i = stretch + ff of node i + ee of node i+1 (all that acts on edge i alone) and C_i = ef:
//   (i, i)   = S_{i-1} + S_i - C_i - C_i'
//   (i, i+1) = -S_i + C_i + C_{i+1}
//   (i, i+2) = -C_{i+1}
void RodElasticity::write_rows(const RodState& state, RodBand& band) const {
  const std::size_t count = state.node_count;
  constexpr std::size_t kD = RodBand::kReach;
  double before[6] = {};  // S of edge i - 1
  for (std::size_t i = 0; i < count; ++i) {
    const Blocks& last = blocks_[i - 1 + kPad];
    const Blocks& here = blocks_[i + kPad];
    const Blocks& next = blocks_[i + 1 + kPad];
    double edge[6] = {};
    if (i + 1 < count) {
      const double t[3] = {state.tangent.x[i], state.tangent.y[i], state.tangent.z[i]};
      const double pull = std::max(0.0, tension_[i]) * inverse_length_[i];
      for (int k = 0; k < 6; ++k) {
        const double unit = kRow[k] == kColumn[k] ? pull : 0.0;
        edge[k] = (axial_[i] - pull) * t[kRow[k]] * t[kColumn[k]] + unit + here.ff[k] + next.ee[k];
      }
    }

    double* rows = band.row(4 * i);
    for (std::size_t a = 0; a < 3; ++a) {
      double* d = rows + a * RodBand::kStride + kD - a;  // d[j]: column 4 i + j
      std::fill(d + a - kD, d + a + kD + 1, 0.0);
      for (std::size_t b = 0; b < 3; ++b) {
        const std::size_t k = kPlace[a][b];
        const std::size_t ab = 3 * a + b;
        const std::size_t ba = 3 * b + a;
        d[b - 8] = -last.ef[ba];
        d[b - 4] = -before[k] + here.ef[ba] + last.ef[ba];
        d[b] = before[k] + edge[k] - here.ef[ab] - here.ef[ba];
        d[b + 4] = -edge[k] + here.ef[ab] + next.ef[ab];
        d[b + 8] = -next.ef[ab];
      }
      const double here_e_f = here.twist_e[a] - here.twist_f[a];
      d[3 - 8] = -last.twist_f[a];
      d[3 - 4] = last.twist_f[a] - here_e_f;
      d[3] = here_e_f + next.twist_e[a];
      d[3 + 4] = -next.twist_e[a];
    }
    double* d = rows + 3 * RodBand::kStride + kD - 3;
    std::fill(d + 3 - kD, d + 3 + kD + 1, 0.0);
    for (std::size_t b = 0; b < 3; ++b) {
      d[b - 4] = -here.twist_e[b];
      d[b] = here.twist_e[b] - here.twist_f[b] + next.twist_e[b];
      d[b + 4] = here.twist_f[b] - next.twist_e[b] + next.twist_f[b];
      d[b + 8] = -next.twist_f[b];
    }
    d[3 - 4] = -here.twisting;
    d[3] = here.twisting + next.twisting;
    d[3 + 4] = -next.twisting;
    std::copy(std::begin(edge), std::end(edge), std::begin(before));
  }
}

void RodElasticity::add_rest_bend_blocks(const RodState& state, RodBand& band) const {
  for (std::size_t i : bent_nodes_) {
    if (i + 1 >= state.node_count) break;
    const RodBentNode node(state, i, inverse_length_[i - 1], inverse_length_[i]);
    const double factor = -bending_[i] * rest_bend_[i];
    const RodBentNode::Second second = node.second_derivatives();

    // by x_{i-1}, twist_{i-1}, x_i, twist_i, x_{i+1}
    Eigen::Matrix<double, 11, 11> block;
    block.setZero();
    const Eigen::Matrix3d fe = second.ef.transpose();
    block.block<3, 3>(0, 0) = second.ee;
    block.block<3, 3>(0, 4) = second.ef - second.ee;
    block.block<3, 3>(0, 8) = -second.ef;
    block.block<3, 3>(4, 4) = second.ee - second.ef - fe + second.ff;
    block.block<3, 3>(4, 8) = second.ef - second.ff;
    block.block<3, 3>(8, 8) = second.ff;
    block.block<3, 1>(0, 3) = -second.e_twist_e;
    block.block<3, 1>(0, 7) = -second.e_twist_f;
    block.block<1, 3>(3, 4) = (second.e_twist_e - second.f_twist_e).transpose();
    block.block<3, 1>(4, 7) = second.e_twist_f - second.f_twist_f;
    block.block<1, 3>(3, 8) = second.f_twist_e.transpose();
    block.block<1, 3>(7, 8) = second.f_twist_f.transpose();
    block(3, 3) = second.twist_e_twist_e;
    block(7, 7) = second.twist_f_twist_f;
    const std::size_t first = 4 * (i - 1);
    for (std::size_t a = 0; a < 11; ++a) {
      for (std::size_t b = 0; b < 11; ++b) {
        const auto r = static_cast<Eigen::Index>(std::min(a, b));
        const auto s = static_cast<Eigen::Index>(std::max(a, b));
        band.at(first + a, first + b) += factor * block(r, s);
      }
    }
  }
}

}  // namespace sim
