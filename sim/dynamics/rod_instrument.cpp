#include "sim/dynamics/rod_instrument.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/base/require.h"
#include "sim/dynamics/rod_contact_force.h"
#include "sim/dynamics/rod_solver.h"

namespace sim {
namespace {

constexpr double kGuideStiffness = 500.0;  // N/mm per node, deep in the sheath
constexpr double kStartSpeed = 60.0;       // mm/s with which it is fed to where a trial starts
constexpr double kSettleTime = 0.3;        // s at rest after that
constexpr double kRemovalSlack = 0.25;     // of an edge, so that a trembling hand does not churn

// From 0 at x <= 0 to 1 at x >= 1, with a continuous slope.
double smooth_ramp(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

Vec3 point_along(std::span<const Vec3> path, double distance) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double length = (path[i + 1] - path[i]).norm();
    if (distance <= length) return path[i] + distance / length * (path[i + 1] - path[i]);
    distance -= length;
  }
  throw std::invalid_argument("the start path is shorter than what is inserted");
}

RodMesh mesh_for(const Instrument& instrument, const RodSettings& settings) {
  // enough material behind the instrument's end to fill the sheath when all of it is inserted
  const double extension = settings.sheath_length + 4.0 * settings.element_length;
  return make_rod_mesh(instrument, {.element_length = settings.element_length,
                                    .tip_element_length = settings.tip_element_length,
                                    .tip_mesh_length = settings.tip_mesh_length,
                                    .extension = extension});
}

const Instrument& checked(const Instrument& instrument, const Access& access, double start_inserted,
                          const RodSettings& settings) {
  base::require(std::abs(access.direction.norm() - 1.0) < 1e-6,
                "the access needs a unit direction");
  base::require(std::abs(access.up.norm() - 1.0) < 1e-6, "the access needs a unit up direction");
  base::require(std::abs(access.up.dot(access.direction)) < 1e-6,
                "the access's up must be normal to its direction");
  base::require(start_inserted >= 0.0 && start_inserted <= instrument.length,
                "an instrument can be inserted between nothing and its length");
  base::require(settings.sheath_length >= 4.0 * settings.element_length,
                "the sheath must be at least four elements long");
  return instrument;
}

}  // namespace

class RodInstrument::Implementation {
 public:
  Implementation(const Instrument& instrument, const Access& access, const Wall* wall,
                 double start_inserted, const RodSettings& settings,
                 std::span<const Vec3> start_path)
      : access_(access),
        settings_(settings),
        solver_(mesh_for(checked(instrument, access, start_inserted, settings), settings), settings,
                wall),
        gauge_(solver_.capacity()) {
    solver_.set_guide(access_.position, access_.direction);
    const std::size_t capacity = solver_.capacity();
    nodes_.resize(capacity);
    forces_.resize(capacity);
    tip_forces_.resize(capacity);
    if (start_path.empty()) {
      place(0.0, {});
      feed_to(start_inserted);
    } else {
      place(start_inserted, start_path);
      feed_to(0.0);
    }
  }

  RodStatus step(double handle_axial, double handle_rotation) {
    const double feed = handle_axial - handle_axial_;
    const double turn = handle_rotation - handle_rotation_;
    handle_axial_ = handle_axial;
    handle_rotation_ = handle_rotation;
    return advance(feed, turn);
  }

  const RodSolver& solver() const { return solver_; }
  double inserted() const { return arc(base()) + base_axial_; }
  double handle_force() const { return solver_.holding_force(base()).dot(access_.direction); }
  // angles of the rod are about its tangent, which points out of the vessel at the base
  double handle_torque() const { return -solver_.holding_moment(base() - 1); }
  double contact_force() const { return contact_force_; }
  std::span<const Vec3> nodes() const { return {nodes_.data(), solver_.node_count()}; }
  std::span<const Vec3> forces() const { return {forces_.data(), solver_.node_count()}; }
  std::size_t first_visible() const { return base() - behind_mouth_; }

  void append_state(std::vector<std::byte>& bytes) const {
    append_bytes(solver_.state(), bytes);
    const double own[] = {handle_axial_, handle_rotation_, base_axial_};
    const auto raw = std::as_bytes(std::span<const double>(own));
    bytes.insert(bytes.end(), raw.begin(), raw.end());
  }

 private:
  std::size_t base() const { return solver_.node_count() - 1; }
  double arc(std::size_t node) const { return solver_.mesh().arc[node]; }

  // In the sheath and, beyond the access, along the path.
  void place(double inserted_length, std::span<const Vec3> path) {
    std::size_t count = 1;
    while (arc(count - 1) < settings_.sheath_length + inserted_length) ++count;
    std::vector<Vec3> nodes;
    for (std::size_t i = 0; i < count; ++i) {
      const double beyond = inserted_length - arc(i);
      nodes.push_back(beyond > 0.0 ? point_along(path, beyond)
                                   : Vec3(access_.position + beyond * access_.direction));
    }
    solver_.place(nodes, access_.up);
    base_axial_ = base_place();
    hold_base(true);
    update_sheath();
    observe();
  }

  void feed_to(double inserted_length) {
    const double dt = settings_.time_step;
    const auto feed_steps = static_cast<int>(std::ceil(inserted_length / (kStartSpeed * dt)));
    const auto rest_steps = static_cast<int>(std::ceil(kSettleTime / dt));
    for (int i = 0; i < feed_steps + rest_steps; ++i) {
      const double feed = i < feed_steps ? inserted_length / feed_steps : 0.0;
      base::require(advance(feed, 0.0) == RodStatus::ok,
                    "the start of the trial cannot be reached");
    }
  }

  RodStatus advance(double feed, double turn) {
    grow_or_shrink(feed);
    solver_.move(base(), feed * access_.direction);
    solver_.turn(base() - 1, -turn);
    update_sheath();
    solver_.contact().reset_wall_time();
    const RodStatus status = solver_.step();
    if (status == RodStatus::ok) observe();
    return status;
  }

  void hold_base(bool held) {
    solver_.hold(base(), held);
    solver_.hold_twist(base() - 1, held);
  }

  // Where the base node is along the access direction, mm.
  double base_place() const {
    return (solver_.position(base()) - access_.position).dot(access_.direction);
  }

  // Keeps the base, once fed, between one edge behind the sheath's rear end and that end.
  void grow_or_shrink(double feed) {
    const double rear = -settings_.sheath_length;
    base_axial_ = base_place() + feed;
    while (base_axial_ > rear && solver_.node_count() < solver_.capacity()) {
      hold_base(false);
      solver_.append_node(access_.direction);
      hold_base(true);
      base_axial_ = base_place() + feed;
    }
    while (solver_.node_count() > kFewestNodes) {
      const double edge = solver_.mesh().edge_length[base() - 1];
      if (base_axial_ + edge * (1.0 + kRemovalSlack) > rear) break;
      hold_base(false);
      solver_.remove_node();
      hold_base(true);
      base_axial_ = base_place() + feed;
    }
  }

  // Guides what is in the sheath, lets the wall act on what is beyond it; both fade towards the
  // mouth, so that nothing jumps when a node passes it.
  void update_sheath() {
    const double length = inserted();
    const double fade = settings_.element_length;
    const std::size_t count = solver_.node_count();
    std::size_t touching = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double beyond = length - arc(i);
      solver_.set_guide_stiffness(i, kGuideStiffness * smooth_ramp(-beyond / fade));
      if (beyond <= 0.0) continue;
      solver_.contact().set_share(i, smooth_ramp(beyond / fade));
      touching = i + 1;
    }
    behind_mouth_ = std::min(touching, count - 1);
    solver_.contact().set_end(touching);
  }

  void observe() {
    const std::size_t count = solver_.node_count();
    const std::span<Vec3> tip_forces(tip_forces_.data(), count);
    solver_.contact().node_forces(tip_forces);
    contact_force_ = gauge_.largest(tip_forces, {solver_.mesh().cell_length.data(), count});
    for (std::size_t i = 0; i < count; ++i) {
      nodes_[count - 1 - i] = solver_.position(i);
      forces_[count - 1 - i] = tip_forces[i];
    }
  }

  static constexpr std::size_t kFewestNodes = 5;

  Access access_;
  RodSettings settings_;
  RodSolver solver_;
  double base_axial_ = 0.0;  // mm of the base along the access direction, negative: in the sheath
  double handle_axial_ = 0.0;
  double handle_rotation_ = 0.0;
  RodContactForce gauge_;
  double contact_force_ = 0.0;
  std::size_t behind_mouth_ = 0;  // the first node from the tip that is at or behind the mouth
  std::vector<Vec3> nodes_, forces_, tip_forces_;
};

RodInstrument::RodInstrument(const Instrument& instrument, const Access& access, const Wall* wall,
                             double start_inserted, const RodSettings& settings,
                             std::span<const Vec3> start_path)
    : implementation_(std::make_unique<Implementation>(instrument, access, wall, start_inserted,
                                                       settings, start_path)) {}

RodInstrument::~RodInstrument() = default;
RodInstrument::RodInstrument(RodInstrument&&) noexcept = default;
RodInstrument& RodInstrument::operator=(RodInstrument&&) noexcept = default;

RodStatus RodInstrument::step(double handle_axial, double handle_rotation) {
  return implementation_->step(handle_axial, handle_rotation);
}

double RodInstrument::inserted_length() const { return implementation_->inserted(); }
double RodInstrument::handle_force() const { return implementation_->handle_force(); }
double RodInstrument::handle_torque() const { return implementation_->handle_torque(); }
double RodInstrument::contact_force() const { return implementation_->contact_force(); }
double RodInstrument::contact_load() const {
  return implementation_->solver().contact().normal_load();
}
int RodInstrument::contact_count() const {
  return implementation_->solver().contact().contact_count();
}
int RodInstrument::iterations() const { return implementation_->solver().iterations(); }
double RodInstrument::residual() const { return implementation_->solver().residual(); }
double RodInstrument::find_contacts_time() const {
  return implementation_->solver().contact().wall_time();
}

Vec3 RodInstrument::tip() const { return implementation_->solver().position(0); }
Vec3 RodInstrument::tip_direction() const { return -implementation_->solver().state().tangent[0]; }
std::span<const Vec3> RodInstrument::nodes() const { return implementation_->nodes(); }
std::span<const Vec3> RodInstrument::node_forces() const { return implementation_->forces(); }
std::size_t RodInstrument::first_visible() const { return implementation_->first_visible(); }

void RodInstrument::append_state(std::vector<std::byte>& bytes) const {
  implementation_->append_state(bytes);
}

}  // namespace sim
