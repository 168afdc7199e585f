/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Several vehicles in the same space, for C99: tern::Fleet under C names. tern/fleet.hpp explains every field and
 * answer. */
#ifndef TERN_TERN_FLEET_H
#define TERN_TERN_FLEET_H

#include "tern/tern.h"

#ifdef __cplusplus
#include "tern/fleet.hpp"
typedef tern::FleetRange tern_fleet_range;
typedef tern::FleetSpec tern_fleet_spec;
typedef tern::FleetReport tern_fleet_report;
typedef tern::Neighbour tern_neighbour;
extern "C" {
#else
/* clang-format off */
/* Members by range: tern::FleetRange. m, m/s, ns. */
typedef struct {
  double join, heard, speed; int64_t within, lease;
} tern_fleet_range;
/* A vehicle as a member of a fleet: tern::FleetSpec. m, ns, m/s. */
typedef struct {
  uint16_t id; uint32_t incarnation; uint8_t priority; double radius;
  int64_t clock_error, tick; double speed; tern_fleet_range range;
} tern_fleet_spec;
/* What became of the last plan that was announced: tern::FleetReport. */
typedef struct {
  uint8_t announcement, blocked; /* TERN_ANNOUNCEMENT_..., TERN_FLEET_BLOCK_... */
  uint16_t blocked_by; bool cleared;
} tern_fleet_report;
/* What is known of another member: tern::Neighbour. ns. */
typedef struct {
  uint16_t id; uint32_t incarnation; int64_t heard; uint8_t priority;
  bool has_right_of_way, has_left, ready;
  uint32_t flies, may_fly;
} tern_neighbour;
/* clang-format on */
#endif

/* What became of the last plan that was announced. */
enum {
  TERN_ANNOUNCEMENT_NONE = 0,
  TERN_ANNOUNCEMENT_PROVING = 1,
  TERN_ANNOUNCEMENT_OPEN = 2,
  TERN_ANNOUNCEMENT_TAKEN = 3,
  TERN_ANNOUNCEMENT_DROPPED = 4
};
/* Why a plan was dropped. */
enum {
  TERN_FLEET_BLOCK_NONE = 0,
  TERN_FLEET_BLOCK_SILENT = 1,     /* the member was not heard, or has not heard of this vehicle */
  TERN_FLEET_BLOCK_CONFLICT = 2,   /* not clear of a member that has to give way */
  TERN_FLEET_BLOCK_REFUSED = 3,    /* a member that has the right of way said no */
  TERN_FLEET_BLOCK_UNANSWERED = 4, /* a member that has the right of way said nothing in time */
  TERN_FLEET_BLOCK_RESTARTED = 5,  /* the member was begun or added, or left, in the meantime */
  TERN_FLEET_BLOCK_LATE = 6,       /* advance was called too late, or had too little work */
  TERN_FLEET_BLOCK_STRANGER = 7,   /* not clear of all that a vehicle may do which is no member yet */
  TERN_FLEET_BLOCK_UNHEARD = 8     /* not clear of all that vehicles may do which are too far away to be heard */
};
/* What a packet brought. */
enum {
  TERN_HEARD_NEWS = 0,
  TERN_HEARD_OLD = 1,
  TERN_HEARD_STRANGER = 2,
  TERN_HEARD_SELF = 3,
  TERN_HEARD_DAMAGED = 4,
  TERN_HEARD_OTHER_VERSION = 5,
  TERN_HEARD_TOO_LONG = 6,
  TERN_HEARD_CLOCK_AHEAD = 7
};

/* Size of tern_fleet in words of 64 bits. The core asserts that it suffices. */
#define TERN_FLEET_WORDS                                                                                          \
  ((TERN_MAX_NEIGHBOURS * (TERN_MAX_NEIGHBOURS * 22 + TERN_MAX_SEGMENTS * 208 + 1046) + TERN_MAX_SEGMENTS * 720 + \
    4096) /                                                                                                       \
       8 +                                                                                                        \
   2)

/* One vehicle's part in a fleet: an object of the library in memory of yours, too large for a small stack. It may hold
 * anything before tern_fleet_begin(). Zero it if another call can come first: that call then answers invalid_argument,
 * or does nothing. */
typedef struct {
  uint64_t opaque[TERN_FLEET_WORDS];
} tern_fleet;

/* The functions of tern::Fleet. Null is an invalid argument. Statuses: ok, invalid_argument; of tern_fleet_add() also
 * neighbours_full; of tern_fleet_traffic() and tern_fleet_traffic_of() also tracks_full and track_pieces_full. */
uint8_t tern_fleet_begin(tern_fleet* fleet, const tern_fleet_spec* spec, const tern_trajectory* flown, int64_t now);
uint8_t tern_fleet_add(tern_fleet* fleet, uint16_t id, int64_t now);
uint8_t tern_fleet_remove(tern_fleet* fleet, uint16_t id, int64_t now);
uint8_t tern_fleet_announce(tern_fleet* fleet, const tern_trajectory* plan, int64_t takeover, int64_t now);
void tern_fleet_withdraw(tern_fleet* fleet, int64_t now);
void tern_fleet_leave(tern_fleet* fleet, int64_t now);
/* A TERN_HEARD_... constant. */
uint8_t tern_fleet_receive(tern_fleet* fleet, const uint8_t* packet, int32_t size, int64_t now);
/* The bytes written; 0 at the end of a round. */
int32_t tern_fleet_write(tern_fleet* fleet, uint8_t* packet, int32_t room);
/* `work`: units. A piece that takes more than is left runs to its end. */
void tern_fleet_advance(tern_fleet* fleet, int64_t now, uint32_t work);
void tern_fleet_get_report(const tern_fleet* fleet, tern_fleet_report* report);
/* The plan that is flown, and the one that is announced; null if there is none. Valid until the next call that changes
 * the fleet. */
const tern_trajectory* tern_fleet_flown(const tern_fleet* fleet);
const tern_trajectory* tern_fleet_announced(const tern_fleet* fleet);
int32_t tern_fleet_neighbours(const tern_fleet* fleet);
void tern_fleet_neighbour(const tern_fleet* fleet, int32_t index, tern_neighbour* neighbour);
uint8_t tern_fleet_traffic(const tern_fleet* fleet, int64_t now, tern_track* tracks, int32_t room,
                           tern_track_piece* pieces, int32_t piece_room, int32_t* count);
uint8_t tern_fleet_traffic_of(const tern_fleet* fleet, int32_t index, int64_t now, tern_track* tracks, int32_t room,
                              tern_track_piece* pieces, int32_t piece_room, int32_t* count);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
