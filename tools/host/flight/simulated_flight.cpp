// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/simulated_flight.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "flight/flight_state.hpp"
#include "host/flight/assumed_ball.hpp"
#include "host/flight/commit_log.hpp"
#include "host/flight/contact_search.hpp"
#include "host/flight/flight_faults.hpp"
#include "host/flight/flight_recorder.hpp"
#include "host/flight/flight_specs.hpp"
#include "host/flight/flight_tape.hpp"
#include "host/flight/flight_watch.hpp"
#include "host/flight/flown_past.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/gimbal.hpp"
#include "host/flight/mission_watch.hpp"
#include "host/flight/seen_world.hpp"
#include "host/flight/sensor.hpp"
#include "host/flight/threat_watch.hpp"
#include "host/flight/yaw_watch.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"
#include "host/vehicle/vehicle.hpp"
#include "tern/flight.hpp"

namespace tern_host {
namespace {

class Simulation {
 public:
  Simulation(const FlightWorld& world, const FlightOnlooker& onlooker, std::string* record)
      : world_(world),
        onlooker_(onlooker),
        noise_(world.settings.seed),
        memory_(new tern::Workspace),
        planner_(memory_.get(), sizeof *memory_),
        map_spec_(map_spec_of(world)),
        fences_(fences_of(world.fences)),
        spec_(flight_spec_of(world.settings)),
        truth_(world),
        faults_(truth_),
        commands_{[this](auto t) { return past_.holds(t) ? past_.at(t) : flight_.command(t).sample; },
                  [this] { return flight_.rest_position(); }},
        recorder_(truth_),
        tape_(record, frame_bytes(world.settings)),
        things_(world_),
        seen_(truth_, things_),
        sensor_(seen_.world(), world_, map_spec_, map_, noise_, tape_,
                [this](const auto& point, auto t, double room) { return things_.explains(point, t, room); }) {
    start();
  }

  FlightResult fly() {
    const std::int64_t end = nanoseconds(world_.settings.time_limit);
    FlightEnding ending;
    while (time_ <= end && ending.status.empty()) {
      ending = tick();
      if (ending.status.empty()) ending = move_on();
    }
    tape_.finish();
    if (ending.status.empty()) ending = time_is_up();
    FlightResult result = recorder_.finish();
    result.status = ending.status;
    result.reason = ending.reason;
    result.blocked_by = report_.blocked_by;
    result.blocked_at = report_.blocked_at;
    result.blocked_fence = report_.blocked_fence;
    result.looked_in_vain.resize(static_cast<std::size_t>(flight_.looked_in_vain(nullptr, 0)));
    flight_.looked_in_vain(result.looked_in_vain.data(), static_cast<std::int32_t>(result.looked_in_vain.size()));
    const bool is_voxel =
        report_.blocked_by == tern::BlockedBy::kUnseen || report_.blocked_by == tern::BlockedBy::kObstacle;
    if (result.status == "stuck" && is_voxel) {
      result.narrow = narrow_place(map_.safe(), flight_.rest_position(), next_point());
    }
    result.view_wait = static_cast<double>(view_waits_) / world_.settings.tick_hz;
    const WatchCounts& counts = watch_->counts();
    result.mission = mission_->points();
    result.commits = commits_.take();
    result.appeared = faults_.appeared();
    result.contact = contact_;
    result.things = things_.totals();
    if (far_ != nullptr) result.far = far_->totals();
    const FrameWatch& frames = sensor_.watch();
    result.watched = {counts.ticks,  counts.commits, counts.points, frames.seen(),
                      frames.hits(), counts.slivers, counts.snap};
    return result;
  }

 private:
  tern::Vec3 next_point() const {
    for (const MissionPoint& point : mission_->points()) {
      if (point.state == "ahead") return point.position;
    }
    return world_.goal;
  }

  /// Why the last plan led nowhere, if there was none.
  std::string last_plan() const {
    if (report_.plan == tern::Status::kOk || report_.plan == tern::Status::kRunning) return "";
    return std::string("; the last plan: ") + tern::status_name(report_.plan);
  }

  void start() {
    spec_.fences = fences_.data();
    spec_.fence_count = static_cast<std::int32_t>(fences_.size());
    map_words_.resize(tern::map_words(map_spec_));
    words_.resize(tern::flight_words(map_spec_.dims));
    const tern::Status bound = map_.bind(map_spec_, map_words_.data(), map_words_.size());
    if (bound != tern::Status::kOk) {
      throw std::runtime_error(world_.name + ": no map can be made of this window and cell");
    }
    tern::FlightRecorder& record = tape_.recorder();
    record.bind(map_spec_, bound);
    check_world(world_, spec_, map_spec_);
    state_what_is_free();
    tern::FlightRefusal refusal;
    const tern::Status begun =
        flight_.start(spec_, map_, planner_, words_.data(), words_.size(), world_.start, 0, &refusal);
    record.start(spec_, world_.start, 0, begun);
    if (begun != tern::Status::kOk) {
      throw std::runtime_error(world_.name + ": the flight cannot begin: " + tern::status_name(begun) +
                               describe_refusal(refusal));
    }
    set_wishes();
    if (world_.settings.far_cell > 0.0) far_ = std::make_unique<FarGuide>(world_);
    vehicle_ = make_vehicle(vehicle_settings_of(world_.settings), setpoint(0.0));
    watch_ = std::make_unique<FlightWatch>(world_, spec_, map_, commands_);
    threats_ = std::make_unique<ThreatWatch>(world_.settings, spec_, map_, watch_->rooms(), commands_,
                                             [this](const auto& place, auto t) { return things_.meets(place, t); });
    mission_ = std::make_unique<MissionWatch>(world_, flight_, commands_.at);
    yaw_watch_ = std::make_unique<YawWatch>(world_.settings, spec_.tick, [this](auto t) { return flight_.yaw(t); });
  }

  /// What an operator knows before the flight.
  void state_what_is_free() {
    tern::FlightRecorder& record = tape_.recorder();
    if (world_.column.radius > 0.0) return void(record.assume_column(world_.column, map_.assume_column(world_.column)));
    for (const AssumedBall& ball : assumed_balls(world_, map_.safe().spec())) {
      record.assume_free(ball.center, ball.radius, map_.assume_free(ball.center, ball.radius));
    }
  }

  /// The mission, or where to land.
  tern::Status set_mission(const std::vector<tern::Via>& mission) {
    const GoalOnGround& on = world_.landing;
    if (on.speed > 0.0) {
      const tern::Status set = flight_.land(world_.goal, on.ground, on.speed);
      tape_.recorder().land(world_.goal, on.ground, on.speed, set);
      return set;
    }
    const auto count = static_cast<std::int32_t>(mission.size());
    const tern::Status set = flight_.set_mission(mission.data(), count, world_.via_policy);
    tape_.recorder().set_mission(mission.data(), count, world_.via_policy, set);
    return set;
  }

  /// The mission, and how to turn on it.
  void set_wishes() {
    const std::vector<tern::Via> mission = mission_of(world_);
    const tern::Status set = set_mission(mission);
    if (set != tern::Status::kOk) {
      throw std::runtime_error(world_.name + ": the mission is refused: " + tern::status_name(set));
    }
    const tern::Vec3& first = mission.front().position;
    const double yaw = std::atan2(first.y - world_.start.y, first.x - world_.start.x);
    gimbal_ = Gimbal(yaw, world_.settings);
    plans_yaw_ = world_.settings.yaw != "gimbal";
    if (!plans_yaw_) return;
    const tern::FlightYaw wish = flight_yaw_of(world_.settings, yaw);
    const tern::Status turned = flight_.set_yaw(wish);
    tape_.recorder().set_yaw(wish, turned);
    if (turned != tern::Status::kOk) throw std::runtime_error(world_.name + ": the yaw is refused");
  }

  double seconds() const { return seconds_of(time_); }

  /// Where the camera looks now, rad.
  double yaw() const { return plans_yaw_ ? flight_.yaw(time_).angle : gimbal_.yaw(); }

  Setpoint setpoint(double t) const {
    const std::int64_t at = nanoseconds(t);
    const tern::Sample sample = commands_.at(at);
    if (!plans_yaw_) return {sample, gimbal_.yaw() + gimbal_.rate() * (t - seconds()), gimbal_.rate()};
    const auto nose = flight_.yaw(at);
    return {sample, nose.angle, nose.yaw.rate};
  }

  FlightEnding tick() {
    faults_.appear(time_, commands_.at);
    seen_.move_to(time_);
    const Sensor::Frame* const frame = sensor_.take(time_, *vehicle_, yaw(), gimbal_.pitch());
    things_.sense(time_, *vehicle_);
    if (frame != nullptr) {
      std::visit([this](const auto& taken) { things_.see(taken, vehicle_->estimate(), map_); }, *frame);
    }
    const bool skipped = faults_.skips_tick();
    if (!skipped) do_tick();
    const tern::Command command = flight_.command(time_);
    look_at_things(time_);
    recorder_.note(time_, command, *vehicle_, yaw(), report_, skipped);
    if (onlooker_) tell(command);
    gimbal_.turn_to(command);
    if (report_.waits_for_nose) ++view_waits_;
    if (errors().pose_exceeded()) forget_world();
    if (touches()) return contact();
    if (things_.collides(contact_))
      return {"collision", "the body touched a thing that had left its tube, or had none"};
    return skipped ? FlightEnding{} : judge();
  }

  /// What the flight's computer does.
  void do_tick() {
    sensor_.deliver(time_);
    things_.tell(time_, flight_, tape_);
    move_goal();
    lead();
    if (world_.settings.monitor > 0) tape_.note_position(flight_, vehicle_->estimate(), time_);
    watch_->before(time_);
    const tern::Status ticked = flight_.tick(time_, report_);
    past_.note(state());
    tape_.tick(flight_, time_, report_, ticked);
    watch_->look(time_, report_);
    if (!faults_.appeared().empty() || report_.mode == tern::FlightMode::kThreat) threats_->look(time_, report_);
    mission_->look(time_, report_);
    if (plans_yaw_) yaw_watch_->look(time_);
    commits_.look(time_, report_, state());
    things_.note_tick(report_, state().facts.plans.latest().evades);
  }

  void look_at_things(std::int64_t t) {
    if (things_.look(t, *vehicle_, commands_.at(t))) recorder_.note_touch();
  }

  void move_goal() {
    tern::Vec3 goal{};
    if (!faults_.moves_goal(seconds(), goal)) return;
    tape_.recorder().set_goal(goal, flight_.set_goal(goal));
    mission_->move_goal(goal, time_);
  }

  /// A far way gives the flight near goals.
  void lead() {
    if (far_ == nullptr || !far_->tick(vehicle_->estimate(), report_, map_, time_)) return;
    tape_.recorder().set_goal(far_->goal(), flight_.set_goal(far_->goal()));
    mission_->move_goal(far_->goal(), time_);
  }

  /// Poses are off by more than their margin: the map's world is not the true one.
  void forget_world() {
    watch_->forget_world();
    sensor_.forget_world();
  }

  FlightEnding time_is_up() const {
    const std::string limit = "at time_limit, " + brief(world_.settings.time_limit) + " s";
    if (report_.mode == tern::FlightMode::kThreat) return {"threat", "something is in the way " + limit};
    return {"timeout", "still on its way " + limit};
  }

  FlightEnding judge() const {
    const std::string broken = watch_->broken() + sensor_.watch().broken() + threats_->broken() + mission_->broken() +
                               yaw_watch_->broken() + things_.broken();
    if (!broken.empty()) return {"invariant", broken};
    if (report_.mode != tern::FlightMode::kRest || report_.reason == tern::FlightReason::kNone) return {};
    if (far_ != nullptr && !far_->is_last()) return {};
    const std::string reason = tern::flight_reason_text(report_.reason);
    const bool lands = world_.landing.speed > 0.0;
    const auto end = lands ? tern::FlightReason::kLanded : tern::FlightReason::kArrived;
    if (report_.reason == end) return {"reached", reason};
    return {"stuck", reason + last_plan()};
  }

  FlightErrors errors() const {
    return {recorder_.tracking_max(), world_.settings.tracking_margin, recorder_.pose_max(),
            world_.settings.pose_margin};
  }

  bool touches() const { return recorder_.clearance_now() < world_.settings.body_radius; }

  FlightEnding contact() {
    const tern::Vec3 v = vehicle_->velocity();
    contact_.happened = true;
    contact_.time = seconds();
    contact_.speed = std::hypot(v.x, std::hypot(v.y, v.z));
    contact_.with_appeared = clearance(world_, vehicle_->position()) >= world_.settings.body_radius;
    if (contact_.with_appeared) {
      contact_.appeared_before = seconds() - faults_.appeared().back().time;
      contact_.threat = threats_->meet(time_, faults_.appeared());
    }
    return judge_contact(errors(), contact_);
  }

  /// A flight's state lies in the first of its words.
  const tern::FlightState& state() const { return *reinterpret_cast<const tern::FlightState*>(words_.data()); }

  void tell(const tern::Command& command) {
    onlooker_({time_, report_, command, *vehicle_, yaw(), recorder_.clearance_now(), map_, flight_, planner_, state()});
  }

  /// To the next tick, or until the body touches something.
  FlightEnding move_on() {
    const std::int64_t next = time_ + spec_.tick;
    ContactSearch search(world_.settings, *vehicle_, recorder_.clearance_now());
    things_.hunt(time_, spec_.tick, *vehicle_);
    for (std::int64_t t = time_; t < next;) {
      t = things_.next(t, search.next(t, next));
      vehicle_->fly_to(seconds_of(t), [this](double at) { return setpoint(at); });
      if (t == next) break;
      recorder_.note_clearance(*vehicle_);
      look_at_things(t);
      if (touches()) {
        time_ = t;
        return contact();
      }
      search.at(*vehicle_, recorder_.clearance_now());
    }
    gimbal_.move_on();
    time_ = next;
    return {};
  }

  const FlightWorld& world_;
  const FlightOnlooker& onlooker_;
  Noise noise_;
  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  tern::MapSpec map_spec_;
  std::vector<tern::Fence> fences_;
  tern::FlightSpec spec_;
  std::vector<std::uint64_t> map_words_;
  std::vector<std::uint64_t> words_;
  tern::RollingMap map_;
  tern::Flight flight_;
  FlownPast past_;
  tern::FlightReport report_{};
  FlightWorld truth_;  ///< the world, with what has appeared in it
  FlightFaults faults_;
  FlownCommands commands_;
  std::unique_ptr<Vehicle> vehicle_;
  Gimbal gimbal_;
  FlightRecorder recorder_;
  FlightTape tape_;
  std::unique_ptr<FlightWatch> watch_;
  std::unique_ptr<ThreatWatch> threats_;
  std::unique_ptr<MissionWatch> mission_;
  std::unique_ptr<YawWatch> yaw_watch_;
  ThingsInFlight things_;
  std::unique_ptr<FarGuide> far_;  ///< null: nothing leads the flight
  SeenWorld seen_;
  Sensor sensor_;
  std::int64_t time_ = 0;
  bool plans_yaw_ = false;
  FlightContact contact_;
  CommitLog commits_;
  std::int64_t view_waits_ = 0;  // ticks
};

}  // namespace

FlightResult simulate_flight(const FlightWorld& world, const FlightOnlooker& onlooker, std::string* record) {
  return std::make_unique<Simulation>(world, onlooker, record)->fly();
}

}  // namespace tern_host
