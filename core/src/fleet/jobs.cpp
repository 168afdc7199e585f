// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "fleet/fleet_memory.hpp"

namespace tern {
namespace {

/// A plan of this vehicle against a plan of the peer, from a time on, ns, for good.
struct Question {
  const Trajectory* plan;
  std::int8_t theirs;
  std::int64_t from;
};

void end(ProofJob& job) {
  job.kind = JobKind::kNone;
  job.runs = false;
  job.peer = 0;
  job.heard = 0;
  job.turn = 0;
}

std::int64_t later(std::int64_t a, std::int64_t b) {
  return a < b ? b : a;
}

/// When the peer may fly this plan for the first time, on this vehicle's clock.
std::int64_t earliest(const FleetMemory& fleet, const PlanName& name) {
  return name.takeover - fleet.spec.clock_error;
}

/// False if nothing is to be proven in this turn.
bool ask(const FleetMemory& fleet, Question& question) {
  const ProofJob& job = fleet.job;
  const Peer& peer = fleet.peers[job.peer];
  const OwnPlan& next = next_plan(fleet);
  if (job.kind == JobKind::kOwn) {
    question = {&next.plan, job.turn == 0 ? peer.flown : peer.held, next.name.takeover};
    if (!peer.link.binds || is_asked(fleet, peer) || question.theirs == kNoPlan) return false;
    if (job.turn == 1) question.from = later(question.from, earliest(fleet, peer.names[peer.held]));
    return true;
  }
  question.theirs = find_plan(peer, peer.state.open);
  question.from = earliest(fleet, peer.names[question.theirs]);
  question.plan = job.turn == 0 ? &fleet.own[fleet.flown].plan : &next.plan;
  if (job.turn == 1) question.from = later(question.from, next.name.takeover);
  return job.turn == 0 || is_open(fleet);
}

/// For how many seconds the end of a plan is to stay clear of a track, so that it does for good: until both rest.
double rest_until_both(const Trajectory& plan, double from, const Track& track) {
  double end = time_on(plan, track.measured);
  for (std::int32_t p = 0; p < track.piece_count; ++p) end += track.pieces[p].duration;
  const double rest = larger(end, from) - duration(plan);
  return 1.0 + larger(rest, 0.0);
}

void begin_proof(FleetMemory& fleet, const Question& question, Work& work) {
  ProofJob& job = fleet.job;
  const Peer& peer = fleet.peers[job.peer];
  const Assembly<kMaxPlanBytes>& theirs = peer.plans[question.theirs];
  read_plan(theirs.bytes, theirs.size, fleet.spec.clock_error, job.pieces, job.track);
  work.spend(plan_work(job.track.piece_count) + ops::kCurve * question.plan->count);
  job.track.radius = 1e-3 * peer.state.radius;
  const double from = larger(time_on(*question.plan, question.from), 0.0);
  TrackGrounds grounds;
  grounds.tracks = &job.track;
  grounds.count = 1;
  grounds.radius = fleet.spec.radius;
  grounds.rest = rest_until_both(*question.plan, from, job.track);
  job.proof.begin_accepted(*question.plan, from, __builtin_inf(), kTrackTolerance, grounds);
  job.runs = true;
}

/// The peer whose announcement is to be judged next; peer_count: none.
std::int32_t next_to_judge(const FleetMemory& fleet, std::int64_t now) {
  for (std::int32_t p = 0; p < fleet.peer_count; ++p) {
    const Peer& peer = fleet.peers[p];
    const bool asks = peer.state.open != 0 && peer.state.open != peer.judged && !peer.state.has_left;
    if (!asks || is_asked(fleet, peer) || !is_resolved(peer)) continue;
    const std::int8_t plan = find_plan(peer, peer.state.open);
    if (plan != kNoPlan && now < peer.names[plan].takeover) return p;
  }
  return fleet.peer_count;
}

/// The peer of which the plan that is announced is to be proven clear next; peer_count: none.
std::int32_t first_unproven(const FleetMemory& fleet) {
  std::int32_t p = 0;
  while (p < fleet.peer_count && fleet.peers[p].proven == next_plan(fleet).name.number) ++p;
  return p;
}

std::int32_t next_to_prove(const FleetMemory& fleet, Work& work) {
  work.spend(ops::kTurn * fleet.peer_count);
  return first_unproven(fleet);
}

/// False if there is nothing to do.
bool pick_job(FleetMemory& fleet, std::int64_t now, Work& work) {
  work.spend(ops::kDot * fleet.peer_count);
  const std::int32_t p = next_to_judge(fleet, now);
  if (p < fleet.peer_count) {
    fleet.job.kind = JobKind::kJudge;
    fleet.job.peer = p;
    return true;
  }
  if (fleet.announcement != Announcement::kProving) return false;
  fleet.job.kind = JobKind::kOwn;
  fleet.job.peer = next_to_prove(fleet, work);
  return true;
}

void answer(FleetMemory& fleet, Consent consent, std::int64_t now) {
  Peer& peer = fleet.peers[fleet.job.peer];
  peer.judged = peer.state.open;
  peer.consent = consent;
  if (consent == Consent::kYes) {
    peer.held = find_plan(peer, peer.judged);
    peer.proven = 0;  // not of this
  }
  end(fleet.job);
  touch(fleet, now);
}

/// The members are done. By range, those that may do anything follow, one by one; then the others are told.
void look_beyond_members(FleetMemory& fleet, std::int64_t now, Work& work) {
  FleetBlock why = FleetBlock::kNone;
  std::uint16_t by = 0;
  if (is_by_range(fleet) && step_alone(fleet, now, work, why, by) == Status::kRunning) return;
  if (why != FleetBlock::kNone) return drop(fleet, why, by, now);
  fleet.announcement = Announcement::kOpen;
  end(fleet.job);
  touch(fleet, now);
}

/// Nothing is left to be proven in this turn: the next turn, the next peer, or the end of the job.
void go_on(FleetMemory& fleet, std::int64_t now, Work& work) {
  ProofJob& job = fleet.job;
  if (++job.turn < 2) return;
  if (job.kind == JobKind::kJudge) return answer(fleet, Consent::kYes, now);
  job.turn = 0;
  fleet.peers[job.peer].proven = next_plan(fleet).name.number;
  job.peer = next_to_prove(fleet, work);
}

void look_at_next(FleetMemory& fleet, std::int64_t now, Work& work) {
  ProofJob& job = fleet.job;
  work.spend(ops::kPiece);
  if (job.kind == JobKind::kOwn) {
    if (job.peer == fleet.peer_count) return look_beyond_members(fleet, now, work);
    const Peer& peer = fleet.peers[job.peer];
    if (peer.link.binds && !is_ready(fleet, peer)) return drop(fleet, FleetBlock::kSilent, peer.id, now);
  }
  Question question{};
  ask(fleet, question) ? begin_proof(fleet, question, work) : go_on(fleet, now, work);
}

void prove_on(FleetMemory& fleet, std::int64_t now, Work& work) {
  ProofJob& job = fleet.job;
  if (job.proof.step(work) == Status::kRunning) return;
  job.runs = false;
  if (job.proof.report().finding == Finding::kNone) return go_on(fleet, now, work);
  if (job.kind == JobKind::kJudge) return answer(fleet, Consent::kNo, now);
  drop(fleet, FleetBlock::kConflict, fleet.peers[job.peer].id, now);
}

}  // namespace

void restart_jobs(FleetMemory& fleet) noexcept {
  end(fleet.job);
}

void restart_jobs_about(FleetMemory& fleet, std::int32_t peer) noexcept {
  ProofJob& job = fleet.job;
  if (job.kind == JobKind::kNone || job.peer != peer) return;
  if (job.kind == JobKind::kJudge) return restart_jobs(fleet);
  job.runs = false;
  job.turn = 0;
}

void prove_again(FleetMemory& fleet, std::int32_t peer) noexcept {
  ProofJob& job = fleet.job;
  fleet.peers[peer].proven = 0;
  restart_jobs_about(fleet, peer);
  // A proof about another member goes on, and then this one has its turn.
  if (job.kind != JobKind::kOwn || job.runs || job.peer <= peer) return;
  job.peer = peer;
  job.turn = 0;
}

void take_out_peer(FleetMemory& fleet, std::int32_t peer) noexcept {
  ProofJob& job = fleet.job;
  const std::int32_t last = --fleet.peer_count;
  restart_jobs_about(fleet, peer);
  if (peer != last) fleet.peers[peer] = fleet.peers[last];
  if (job.kind == JobKind::kOwn && !job.runs) {
    job.peer = first_unproven(fleet);
    job.turn = 0;
  } else if (job.peer == last) {
    job.peer = peer;
  }
}

void work_on_jobs(FleetMemory& fleet, std::int64_t now, Work& work) noexcept {
  while (work.left()) {
    if (fleet.job.kind == JobKind::kNone && !pick_job(fleet, now, work)) return;
    fleet.job.runs ? prove_on(fleet, now, work) : look_at_next(fleet, now, work);
  }
}

}  // namespace tern
