#include "sim/anatomy/tube.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "sim/anatomy/marching_cubes.h"
#include "sim/anatomy/tube_axis.h"
#include "sim/base/require.h"
#include "sim/contact/distance_grid.h"

namespace sim {
namespace {

constexpr double kPieceLength = 3.0;      // mm: short pieces keep their boxes small
constexpr double kVoxelsPerRadius = 2.0;  // fewer, and the lumen loses its shape
constexpr double kMarginVoxels =
    4.0;  // beyond the wall: what the surface's cubic and gradient read

struct Box {
  Vec3 low, high;
};

Box box_of(const AxisPiece& piece, double margin) {
  const double reach = std::max(piece.radius(0.0), piece.radius(piece.length)) + margin;
  const Vec3 a = piece.point(0.0), b = piece.point(piece.length);
  const double sagitta = piece.curvature * piece.length * piece.length / 8.0;
  const Vec3 around = Vec3::Constant(reach + sagitta);
  return {a.cwiseMin(b) - around, a.cwiseMax(b) + around};
}

// The tube as a volume: distance inside the wall, positive in the lumen; where pieces overlap the
// deepest counts. Far outside it stays at minus the margin.
class TubeVolume {
 public:
  TubeVolume(const TubeAxis& axis, double voxel)
      : axis_(axis), voxel_(voxel), margin_(kMarginVoxels * voxel) {
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
    for (const AxisPiece& piece : axis.pieces) {
      boxes_.push_back(box_of(piece, margin_));
      low = low.cwiseMin(boxes_.back().low);
      high = high.cwiseMax(boxes_.back().high);
    }
    shape_.origin = low;
    shape_.spacing = Vec3::Constant(voxel);
    for (Eigen::Index a = 0; a < 3; ++a) {
      const double cells = std::ceil((high[a] - low[a]) / voxel);
      base::require(cells < 1e5, "the voxel is too small for a tube of this size");
      shape_.size[static_cast<std::size_t>(a)] = static_cast<int>(cells) + 1;
    }
  }

  const VolumeShape& shape() const { return shape_; }

  void fill_slice(int z, std::span<float> values) const {
    std::fill(values.begin(), values.end(), static_cast<float>(-margin_));
    const double height = shape_.origin.z() + z * voxel_;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (height >= boxes_[i].low.z() && height <= boxes_[i].high.z()) add_piece(i, height, values);
    }
  }

 private:
  void add_piece(std::size_t i, double height, std::span<float> values) const {
    const AxisPiece& piece = axis_.pieces[i];
    const auto first = [&](Eigen::Index a) {
      return static_cast<int>(std::ceil((boxes_[i].low[a] - shape_.origin[a]) / voxel_));
    };
    const auto last = [&](Eigen::Index a) {
      return std::min(static_cast<int>((boxes_[i].high[a] - shape_.origin[a]) / voxel_),
                      shape_.size[static_cast<std::size_t>(a)] - 1);
    };
    for (int y = first(1); y <= last(1); ++y) {
      for (int x = first(0); x <= last(0); ++x) {
        const Vec3 p(shape_.origin.x() + x * voxel_, shape_.origin.y() + y * voxel_, height);
        const double s = piece.nearest(p);
        const auto depth = static_cast<float>(piece.radius(s) - (p - piece.point(s)).norm());
        float& value =
            values[static_cast<std::size_t>(x) +
                   static_cast<std::size_t>(y) * static_cast<std::size_t>(shape_.size[0])];
        value = std::max(value, depth);
      }
    }
  }

  const TubeAxis& axis_;
  double voxel_, margin_;
  std::vector<Box> boxes_;
  VolumeShape shape_;
};

// The tube in at most kDisplayTriangles: the same pipeline with larger voxels.
TriangleMesh display_surface(const TubeDescription& tube, double voxel, double smallest_radius) {
  const double largest = smallest_radius / kVoxelsPerRadius;
  TriangleMesh mesh = tube_surface(tube, voxel);
  while (mesh.triangles.size() > kDisplayTriangles) {
    base::require(voxel < largest, "the tube is too long and thin to be drawn");
    // the count goes with the inverse square of the voxel; a little more, so that this ends
    const double excess = static_cast<double>(mesh.triangles.size()) / kDisplayTriangles;
    voxel = std::min(1.02 * voxel * std::sqrt(excess), largest);
    mesh = tube_surface(tube, voxel);
  }
  return mesh;
}

// The grid of the wall: fine enough for the tightest lumen.
double wall_spacing(const TubeAxis& axis) { return std::min(0.5, axis.smallest_radius / 4.0); }

}  // namespace

std::vector<CentrelinePoint> tube_centreline(const TubeDescription& tube, double step) {
  const TubeAxis axis = tube_axis(tube, step);
  std::vector<CentrelinePoint> points;
  for (std::size_t i = 0; i < axis.pieces.size(); ++i) {
    if (axis.piece_start[i] < 0.0) continue;
    points.push_back({axis.pieces[i].point(0.0), axis.pieces[i].radius(0.0), axis.piece_start[i]});
  }
  const AxisPiece& end = axis.pieces.back();
  points.push_back(
      {end.point(end.length), end.radius(end.length), axis.piece_start.back() + end.length});
  points.front().position = tube.access;
  return points;
}

TriangleMesh tube_surface(const TubeDescription& tube, double voxel) {
  const TubeAxis axis = tube_axis(tube, kPieceLength);
  base::require(std::isfinite(voxel) && voxel > 0.0, "the voxel of an anatomy must be positive");
  base::require(kVoxelsPerRadius * voxel <= axis.smallest_radius * (1.0 + 1e-9),
                "the voxel of an anatomy must be at most half of its smallest radius");
  const TubeVolume volume(axis, voxel);
  return marching_cubes(
      volume.shape(), [&](int z, std::span<float> values) { volume.fill_slice(z, values); }, 0.0F);
}

std::unique_ptr<Vessel> build_tube_vessel(const TubeDescription& tube, double voxel) {
  const TubeAxis axis = tube_axis(tube, kPieceLength);
  auto vessel = std::make_unique<Vessel>();
  vessel->id = tube.id;
  vessel->surface = tube_surface(tube, voxel);
  vessel->display_surface = display_surface(tube, voxel, axis.smallest_radius);
  vessel->centreline = tube_centreline(tube, 1.0);
  vessel->access = {tube.access, axis.direction, axis.up};
  DistanceGridOptions options;
  options.spacing = wall_spacing(axis);
  vessel->wall = std::make_unique<DistanceGrid>(vessel->surface, options);
  return vessel;
}

}  // namespace sim
