#include "sim/contact/distance_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <thread>

#include "sim/base/require.h"
#include "sim/contact/surface_distance.h"

namespace sim {

// Builds the bricks: which ones, what is inside of each, then its points. Every point depends on
// the surface alone, so that the result is the same for any number of threads.
class DistanceGrid::Survey {
 public:
  Survey(DistanceGrid& grid, const TriangleMesh& surface, const DistanceGridOptions& options)
      : grid_(grid), mesh_(surface), distance_(surface), side_(kCells * options.spacing) {
    place_grid();
    choose_bricks(options.max_bytes);
    mark_empty_bricks();
    grid_.points_.resize(grid_.bricks_ * kBrickPoints);
    for_all_bricks([this](std::size_t b) { survey_distances(b); });
    smooth_gradients();
  }

 private:
  std::size_t index_of(int x, int y, int z) const {
    const auto& size = grid_.size_;
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(x);
  }

  std::int32_t brick_at(int x, int y, int z) const {
    const auto& size = grid_.size_;
    if (x < 0 || y < 0 || z < 0 || x >= size[0] || y >= size[1] || z >= size[2]) return kOutside;
    return grid_.index_[index_of(x, y, z)];
  }

  // One brick of room around the band, so that the outermost bricks are empty and outside.
  void place_grid() {
    const Vec3 low = distance_.tree().low(), high = distance_.tree().high();
    const Vec3 room = Vec3::Constant(grid_.band_ + side_);
    grid_.origin_ = low - room;
    const Vec3 bricks = ((high - low + 2.0 * room) / side_).array().ceil();
    base::require(bricks.prod() < 2e8, "the wall grid is too fine for a vessel of this size");
    for (Eigen::Index a = 0; a < 3; ++a) {
      grid_.size_[static_cast<std::size_t>(a)] = static_cast<std::int32_t>(bricks[a]);
    }
    grid_.index_.assign(static_cast<std::size_t>(bricks.prod()), kOutside);
  }

  void choose_bricks(std::size_t max_bytes) {
    mark_around_triangles();
    // a box around a triangle is generous; keep what the band really reaches
    const double reach = grid_.band_ + side_ * std::sqrt(3.0) / 2.0;
    for (int z = 0; z < grid_.size_[2]; ++z) {
      for (int y = 0; y < grid_.size_[1]; ++y) {
        for (int x = 0; x < grid_.size_[0]; ++x) {
          std::int32_t& mark = grid_.index_[index_of(x, y, z)];
          if (mark == kOutside) continue;
          if (distance_.tree().nearest(brick_centre(x, y, z), reach).triangle < 0) {
            mark = kOutside;
            continue;
          }
          mark = static_cast<std::int32_t>(bricks_.size());
          bricks_.push_back({x, y, z});
        }
      }
    }
    grid_.bricks_ = bricks_.size();
    base::require(bricks_.size() * kBrickPoints * sizeof(GridPoint) <= max_bytes,
                  "the wall grid needs more memory than allowed: make its spacing larger");
  }

  void mark_around_triangles() {
    for (const auto& triangle : mesh_.triangles) {
      Vec3 low = mesh_.vertices[static_cast<std::size_t>(triangle[0])], high = low;
      for (const std::int32_t vertex : triangle) {
        low = low.cwiseMin(mesh_.vertices[static_cast<std::size_t>(vertex)]);
        high = high.cwiseMax(mesh_.vertices[static_cast<std::size_t>(vertex)]);
      }
      const Vec3 first = (low - grid_.origin_ - Vec3::Constant(grid_.band_)) / side_;
      const Vec3 last = (high - grid_.origin_ + Vec3::Constant(grid_.band_)) / side_;
      for (int z = static_cast<int>(first.z()); z <= static_cast<int>(last.z()); ++z) {
        for (int y = static_cast<int>(first.y()); y <= static_cast<int>(last.y()); ++y) {
          for (int x = static_cast<int>(first.x()); x <= static_cast<int>(last.x()); ++x) {
            grid_.index_[index_of(x, y, z)] = 0;
          }
        }
      }
    }
  }

  // Empty bricks that touch form rooms; no wall passes through one, so that a single question
  // tells for the whole room whether it is lumen.
  void mark_empty_bricks() {
    constexpr std::int32_t kUnknown = -3;
    for (std::int32_t& mark : grid_.index_) {
      if (mark == kOutside) mark = kUnknown;
    }
    std::vector<Brick> room;
    for (int z = 0; z < grid_.size_[2]; ++z) {
      for (int y = 0; y < grid_.size_[1]; ++y) {
        for (int x = 0; x < grid_.size_[0]; ++x) {
          if (brick_at(x, y, z) != kUnknown) continue;
          const bool lumen = distance_.facet_distance(brick_centre(x, y, z)) > 0.0;
          const std::int32_t mark = lumen ? kInside : kOutside;
          room.assign(1, {x, y, z});
          grid_.index_[index_of(x, y, z)] = mark;
          while (!room.empty()) {
            const Brick from = room.back();
            room.pop_back();
            for (std::size_t a = 0; a < 3; ++a) {
              for (const int step : {-1, 1}) {
                Brick to = from;
                to[a] += step;
                if (brick_at(to[0], to[1], to[2]) != kUnknown) continue;
                grid_.index_[index_of(to[0], to[1], to[2])] = mark;
                room.push_back(to);
              }
            }
          }
        }
      }
    }
  }

  template <typename Work>
  void for_all_bricks(const Work& work) {
    const std::size_t count = std::max(1U, std::min(std::thread::hardware_concurrency(), 8U));
    std::vector<std::thread> threads;
    for (std::size_t first = 0; first < count; ++first) {
      threads.emplace_back([&, first] {
        for (std::size_t b = first; b < bricks_.size(); b += count) work(b);
      });
    }
    for (std::thread& thread : threads) thread.join();
  }

  // Distances and the surface's own normals at the points of one brick; points shared with a
  // neighbour come out the same in both. Every other point is measured; those between are too,
  // unless they are out of reach of any instrument's surface and the field around them is smooth.
  void survey_distances(std::size_t b) {
    GridPoint* points = &grid_.points_[b * kBrickPoints];
    NearestTriangle close_by;  // each search starts from its neighbour's answer
    const auto measure = [&](int x, int y, int z) {
      const WallSample found = distance_.sample(point_position(b, x, y, z), close_by);
      points[in_brick(x, y, z)] = {
          static_cast<float>(found.distance), static_cast<float>(found.normal.x()),
          static_cast<float>(found.normal.y()), static_cast<float>(found.normal.z())};
    };
    for (int z = 0; z < kPoints; z += 2) {
      for (int y = 0; y < kPoints; y += 2) {
        for (int x = 0; x < kPoints; x += 2) measure(x, y, z);
      }
    }
    for (int z = 0; z < kPoints; ++z) {
      for (int y = 0; y < kPoints; ++y) {
        for (int x = 0; x < kPoints; ++x) {
          if ((x | y | z) % 2 == 0 || predict(points, x, y, z)) continue;
          measure(x, y, z);
        }
      }
    }
  }

  // The point between measured ones: the mean of their distances and their linear predictions,
  // which is right to the third order. False where that is not good enough.
  bool predict(GridPoint* points, int x, int y, int z) const {
    constexpr float kFar = 1.25F;     // mm from the wall; no instrument's surface is that far
    constexpr float kSmooth = 0.25F;  // mm between the predictions: a bend of about a millimetre
    const std::array<int, 3> odd{x % 2, y % 2, z % 2};
    GridPoint sum{};
    float lowest = std::numeric_limits<float>::infinity(), highest = -lowest;
    float corners = 0.0F;
    for (int dz = -odd[2]; dz <= odd[2]; dz += 2) {
      for (int dy = -odd[1]; dy <= odd[1]; dy += 2) {
        for (int dx = -odd[0]; dx <= odd[0]; dx += 2) {
          const GridPoint& corner = points[in_brick(x + dx, y + dy, z + dz)];
          if (std::abs(corner[0]) < kFar) return false;
          const float way =
              -static_cast<float>(grid_.spacing_) *
              (corner[1] * static_cast<float>(dx) + corner[2] * static_cast<float>(dy) +
               corner[3] * static_cast<float>(dz));
          lowest = std::min(lowest, corner[0] + way);
          highest = std::max(highest, corner[0] + way);
          sum[0] += corner[0] + 0.5F * way;
          for (std::size_t k = 1; k < 4; ++k) sum[k] += corner[k];
          corners += 1.0F;
        }
      }
    }
    if (highest - lowest > kSmooth) return false;
    const float length = std::hypot(sum[1], sum[2], sum[3]);
    points[in_brick(x, y, z)] = {sum[0] / corners, sum[1] / length, sum[2] / length,
                                 sum[3] / length};
    return true;
  }

  // Replaces the normals by the smoothed gradient of the distances wherever the neighbours are
  // known: central differences along one axis, averaged over the other two with weights 3, 10, 3,
  // which measures the direction of a curved wall to the fourth order.
  void smooth_gradients() {
    std::vector<GridPoint> smoothed = grid_.points_;
    for_all_bricks([&](std::size_t b) {
      Patch patch;
      gather(b, patch);
      for (int z = 0; z < kPoints; ++z) {
        for (int y = 0; y < kPoints; ++y) {
          for (int x = 0; x < kPoints; ++x) {
            const Vec3 gradient = gradient_at(patch, x, y, z);
            const double length = gradient.norm();
            if (!(length > 0.5)) continue;  // unknown neighbours, or the middle of the lumen
            GridPoint& point = smoothed[b * kBrickPoints + in_brick(x, y, z)];
            for (Eigen::Index a = 0; a < 3; ++a) {
              point[static_cast<std::size_t>(a) + 1] = static_cast<float>(gradient[a] / length);
            }
          }
        }
      }
    });
    grid_.points_ = std::move(smoothed);
  }

  using Brick = std::array<int, 3>;
  static constexpr int kPatch = kPoints + 2;
  using Patch = std::array<float, std::size_t{kPatch} * kPatch * kPatch>;

  static std::size_t in_brick(int x, int y, int z) {
    const int index = (z * kPoints + y) * kPoints + x;
    return static_cast<std::size_t>(index);
  }
  static std::size_t in_patch(int x, int y, int z) {
    const int index = ((z + 1) * kPatch + y + 1) * kPatch + x + 1;
    return static_cast<std::size_t>(index);
  }

  // The brick's distances and one layer around it; not a number where no brick is.
  void gather(std::size_t b, Patch& patch) const {
    const Brick& brick = bricks_[b];
    for (int z = -1; z <= kPoints; ++z) {
      for (int y = -1; y <= kPoints; ++y) {
        for (int x = -1; x <= kPoints; ++x) {
          patch[in_patch(x, y, z)] = distance_beside(brick, x, y, z);
        }
      }
    }
  }

  float distance_beside(const Brick& brick, int x, int y, int z) const {
    const auto step = [](int i) { return i < 0 ? -1 : (i > kCells ? 1 : 0); };
    const std::int32_t owner = brick_at(brick[0] + step(x), brick[1] + step(y), brick[2] + step(z));
    if (owner < 0) return std::numeric_limits<float>::quiet_NaN();
    const std::size_t point =
        in_brick(x - kCells * step(x), y - kCells * step(y), z - kCells * step(z));
    return grid_.points_[static_cast<std::size_t>(owner) * kBrickPoints + point][0];
  }

  Vec3 gradient_at(const Patch& patch, int x, int y, int z) const {
    const auto weight_of = [](int i) { return i == 0 ? 10.0 / 16.0 : 3.0 / 16.0; };
    Vec3 sum = Vec3::Zero();
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        const double weight = weight_of(j) * weight_of(k);
        const auto at = [&](int dx, int dy, int dz) {
          return static_cast<double>(patch[in_patch(x + dx, y + dy, z + dz)]);
        };
        sum += weight * Vec3(at(1, j, k) - at(-1, j, k), at(j, 1, k) - at(j, -1, k),
                             at(j, k, 1) - at(j, k, -1));
      }
    }
    return sum / (2.0 * grid_.spacing_);
  }

  Vec3 brick_centre(int x, int y, int z) const {
    return grid_.origin_ + side_ * Vec3(x + 0.5, y + 0.5, z + 0.5);
  }
  Vec3 point_position(std::size_t b, int x, int y, int z) const {
    const Brick& brick = bricks_[b];
    return grid_.origin_ + grid_.spacing_ * Vec3(brick[0] * kCells + x, brick[1] * kCells + y,
                                                 brick[2] * kCells + z);
  }

  DistanceGrid& grid_;
  const TriangleMesh& mesh_;
  SurfaceDistance distance_;
  double side_;  // mm, of a brick
  std::vector<Brick> bricks_;
};

DistanceGrid::DistanceGrid(const TriangleMesh& surface, const DistanceGridOptions& options)
    : spacing_(options.spacing), band_(options.band) {
  base::require(spacing_ > 0.0 && band_ > 0.0, "spacing and band of a wall grid must be positive");
  Survey(*this, surface, options);
}

std::size_t DistanceGrid::bytes() const {
  return points_.size() * sizeof(GridPoint) + index_.size() * sizeof(index_[0]);
}

void DistanceGrid::sample(std::span<const Vec3> points, std::span<WallSample> samples) const {
  assert(points.size() == samples.size());
  const Eigen::Array3d brick_count(size_[0], size_[1], size_[2]);
  const double per_brick = 1.0 / (kCells * spacing_);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Array3d at = (points[i] - origin_).array() * per_brick;
    WallSample& sample = samples[i];
    sample.normal = Vec3::UnitX();
    // also what is not a number ends here
    if (!((at >= 0.0).all() && (at < brick_count).all())) {
      sample.distance = -kLost;
      continue;
    }
    const Eigen::Array3i brick = at.cast<int>();
    const std::int32_t found =
        index_[(static_cast<std::size_t>(brick[2]) * static_cast<std::size_t>(size_[1]) +
                static_cast<std::size_t>(brick[1])) *
                   static_cast<std::size_t>(size_[0]) +
               static_cast<std::size_t>(brick[0])];
    if (found < 0) {
      sample.distance = found == kInside ? band_ : -kLost;
      continue;
    }
    interpolate((at - brick.cast<double>()) * static_cast<double>(kCells),
                static_cast<std::size_t>(found), sample);
  }
}

// Both from the eight grid points around: the gradient by trilinear weights; the distance as the
// mean of the trilinear value and the points' own linear predictions, weighted likewise. The
// errors of the two are opposite, so that curved walls come out to the fourth order and the
// distance changes the way its gradient says.
void DistanceGrid::interpolate(const Vec3& in_brick, std::size_t brick, WallSample& sample) const {
  const Eigen::Array3i cell = in_brick.array().cast<int>().min(kCells - 1);
  const Eigen::Array3f t = (in_brick.array() - cell.cast<double>()).cast<float>();
  const float half_spacing = 0.5F * static_cast<float>(spacing_);
  const GridPoint* first =
      &points_[brick * kBrickPoints +
               static_cast<std::size_t>((cell[2] * kPoints + cell[1]) * kPoints + cell[0])];
  Eigen::Array4f blend = Eigen::Array4f::Zero();  // interpolated distance and gradient
  Eigen::Array4f terms = Eigen::Array4f::Zero();  // of the distance; their sum counts
  for (int corner = 0; corner < 8; ++corner) {
    const int cx = corner & 1, cy = (corner >> 1) & 1, cz = corner >> 2;
    const Eigen::Array3f away =
        t - Eigen::Array3f(static_cast<float>(cx), static_cast<float>(cy), static_cast<float>(cz));
    const float weight =
        (1.0F - std::abs(away[0])) * (1.0F - std::abs(away[1])) * (1.0F - std::abs(away[2]));
    const GridPoint* point = first + ((cz * kPoints + cy) * kPoints + cx);
    const Eigen::Array4f weighted = weight * Eigen::Map<const Eigen::Array4f>(point->data());
    blend += weighted;
    terms += weighted * Eigen::Array4f(1.0F, half_spacing * away[0], half_spacing * away[1],
                                       half_spacing * away[2]);
  }
  sample.distance = std::min(static_cast<double>(terms.sum()), band_);
  const Vec3 gradient(static_cast<double>(blend[1]), static_cast<double>(blend[2]),
                      static_cast<double>(blend[3]));
  const double length = gradient.norm();
  if (length > 1e-6) sample.normal = gradient / length;  // zero only in the middle of a lumen
}

}  // namespace sim
