# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flights, rolling maps and sensors of the Python package."""
import unittest

import numpy as np
import tern

LIMITS = tern.Limits((2, 2, 1), (4, 4, 2))


class Flights(unittest.TestCase):
    def test_a_flight_arrives_within_what_it_knows(self):
        rolling_map = tern.RollingMap((-12.8, -7.5, -0.4), 0.2, (128, 75, 20), 0.35)
        with self.assertRaises(tern.TernError) as raised:
            tern.Flight(LIMITS, rolling_map, tern.Planner(), (0, 0, 1.5), t=0)
        self.assertEqual(raised.exception.status, "start_occupied")
        self.assertIn("seen free yet is 0.00 m away, at ", str(raised.exception))
        self.assertIn("it must be 0.35 m", str(raised.exception))
        rolling_map.assume_free((0, 0, 1.5), 6.0)
        with self.assertRaisesRegex(tern.TernError, r"\(flight: fences, fence 0\)"):
            tern.Flight(LIMITS, rolling_map, tern.Planner(), (0, 0, 1.5), t=0, fences=[tern.Fence([(0, 0, 0)], [1])])
        flight = tern.Flight(LIMITS, rolling_map, tern.Planner(), (0, 0, 1.5), t=0)
        flight.set_goal((3.0, 1.0, 1.5))
        now, modes = 0, set()
        while now < 20_000_000_000:
            tick = flight.tick(now)
            modes.add(tick.mode)
            if tick.arrived:
                break
            now += flight.tick_ns
        self.assertTrue(tick.arrived)
        self.assertEqual((tick.blocked_by, tick.blocked_fence), ("nothing", -1))
        self.assertIn("fly", modes)
        np.testing.assert_allclose(flight.command(now).position, [3, 1, 1.5], atol=1e-9)
        with self.assertRaises(tern.TernError) as raised:
            flight.tick(0)
        self.assertEqual(raised.exception.status, "clock_behind")
        flight.set_clock(0)
        self.assertTrue(flight.tick(0).arrived)
        flight.note_position((3.0, 1.0, 1.75), 0)
        tick = flight.tick(flight.tick_ns)
        self.assertAlmostEqual(tick.stray, 0.25)
        self.assertEqual(tick.speed_share, 1.0)  # this map has no tracking margin

    def test_from_the_ground_and_back_to_it(self):
        rolling_map = tern.RollingMap((-12.8, -7.5, -0.6), 0.2, (128, 75, 20), 0.35)
        with self.assertRaises(tern.TernError):
            rolling_map.assume_column((0, 0, 0.05), -1.0, 3.0)
        rolling_map.assume_column((0, 0, 0.05), 1.3, 3.0)
        flight = tern.Flight(LIMITS, rolling_map, tern.Planner(), (0, 0, 0.15), t=0)
        with self.assertRaises(tern.TernError):
            flight.land((0, 0, 0.15), 0.05, 0.0)
        flight.land((0, 0, 0.15), 0.05, 0.5)
        now, highest = 0, 0.0
        while now < 20_000_000_000:
            tick = flight.tick(now)
            highest = max(highest, flight.command(now).position[2])
            if tick.arrived:
                break
            now += flight.tick_ns
        self.assertEqual(tick.reason, "it stands where it was to land")
        self.assertAlmostEqual(highest, 0.8)
        np.testing.assert_allclose(flight.command(now).position, [0, 0, 0.15], atol=1e-9)

    def test_a_far_way_leads_around_a_court(self):
        coarse = tern.Grid((-160, -160, 0), 4.0, (80, 80, 4), 0.0)
        coarse.mark_box((20, -40, 0), (24, 40, 16))
        coarse.mark_box((-20, -40, 0), (24, -36, 16))
        coarse.mark_box((-20, 36, 0), (24, 40, 16))
        coarse.inflate()
        rolling_map = tern.RollingMap((-64, -64, -8), 0.5, (256, 256, 48), 0.5)
        place = (-40.0, 0.0, 6.0)
        rolling_map.assume_free(place, 120.0)
        for ahead in (11.9, 1024.1):  # less than 3 cells, and more than 256
            with self.assertRaises(tern.TernError) as raised:
                tern.FarWay(coarse, tern.Planner(), ahead)
            self.assertEqual(raised.exception.status, "invalid_argument")
        far = tern.FarWay(coarse, tern.Planner(), ahead=60.0)
        self.assertEqual(far.state, "no goal")
        self.assertIsNone(far.tick(place, None, rolling_map, 0))
        limits = tern.Limits((5, 5, 2), (6, 6, 6))
        flight = tern.Flight(limits, rolling_map, tern.Planner(), place, t=0)
        far.set_goal((40, 0, 6))
        self.assertEqual(far.state, "searching")
        now, tick, told, widest = 0, None, 0, 0.0
        while now < 60_000_000_000:
            place = flight.command(now).position
            widest = max(widest, abs(place[1]))
            if tick is not None and tick.arrived and far.is_last:
                break
            near_goal = far.tick(place, tick, rolling_map, now)
            if near_goal is not None:
                told += 1
                flight.set_goal(near_goal)
            tick = flight.tick(now)
            now += flight.tick_ns
        self.assertTrue(tick.arrived)
        self.assertEqual((far.state, far.searches, far.marked), ("leads", 1, 0))
        self.assertLess(far.left, 1.0)
        self.assertGreater(told, 1)
        self.assertGreater(widest, 40.0)
        np.testing.assert_allclose(place, [40, 0, 6], atol=1e-9)

    def test_a_far_way_closes_a_cell_where_the_flight_gave_up(self):
        coarse = tern.Grid((0, 0, 0), 4.0, (32, 32, 4), 0.0)
        coarse.inflate()
        rolling_map = tern.RollingMap((0, 0, 0), 0.5, (128, 128, 32), 0.5)
        far = tern.FarWay(coarse, tern.Planner(), ahead=40.0)
        far.set_goal((122, 62, 6))
        flight = tern.Flight(LIMITS, self.free_map(), tern.Planner(), (0, 0, 1.5), t=0)
        tick = flight.tick(0)
        for reason, marked in (("TERN_FLIGHT_HELD_UP", 0), ("TERN_FLIGHT_NO_PROGRESS", 1)):
            tick.report.mode, tick.report.reason = tern._library.lib.TERN_FLIGHT_REST, getattr(tern._library.lib, reason)
            far.tick((6, 62, 6), tick, rolling_map, 0, work=10**9)
            far.tick((6, 62, 6), tick, rolling_map, 0, work=10**9)
            self.assertEqual(far.marked > 0, marked > 0)

    @staticmethod
    def free_map():
        rolling_map = tern.RollingMap((-12.8, -7.5, -0.4), 0.2, (128, 75, 20), 0.35)
        rolling_map.assume_free((0, 0, 1.5), 6.0)
        return rolling_map

    def test_no_return_is_what_is_stated(self):
        for stated in (0.0, 3.0):
            rolling_map = tern.RollingMap((0, 0, 0), 0.1, (64, 20, 20), 0.2, pixels=4096)
            rolling_map.begin_depth(np.zeros((41, 41)), (20, 20, 20, 20), (1, 1, 1), (0.5, -0.5, 0.5, -0.5), t=0,
                                    no_return=stated)
            rolling_map.finish()
            self.assertEqual(rolling_map.seen((30, 10, 10)), stated > 0.0)

    def test_among_things_that_move(self):
        rolling_map = tern.RollingMap((-12.8, -7.5, -0.4), 0.2, (128, 75, 20), 0.35)
        rolling_map.assume_free((0, 0, 1.5), 6.0)
        flight = tern.Flight(LIMITS, rolling_map, tern.Planner(), (0, 0, 1.5), t=0)
        self.assertIsNone(flight.rest_clear_until())
        # A bird that may do next to nothing comes along the way, 4 m ahead at 1 m/s.
        bird = tern.Track.of_class("bird", (4.0, 0.0, 1.5), velocity=(-1.0, 0.0, 0.0), radius=0.2, error=0.05,
                                   error_growth=0.0, reach=0.0)
        flight.update_track(7, bird)
        flight.tick(0)
        # It is at the vehicle after it has flown 4 m less 0.35 + 0.2 + 0.05 m.
        self.assertAlmostEqual(1e-9 * flight.rest_clear_until(), 3.4, delta=0.02)
        with self.assertRaises(tern.TernError) as raised:
            flight.update_track(7, tern.Track((4.0, 0.0, 1.5), measured=-1))
        self.assertEqual(raised.exception.status, "clock_behind")
        with self.assertRaises(tern.TernError) as raised:
            flight.update_track(8, tern.Track((float("nan"), 0.0, 1.5)))
        self.assertEqual(raised.exception.status, "non_finite_input")
        self.assertIn("track 8", str(raised.exception))
        flight.set_goal((5.0, 0.0, 1.5))
        now, least = 0, 1e9
        while now < 20_000_000_000:
            tick = flight.tick(now)
            here = flight.command(now).position
            least = min(least, np.linalg.norm(here - [4.0 - 1e-9 * now, 0.0, 1.5]))
            if tick.arrived:
                break
            now += flight.tick_ns
        self.assertTrue(tick.arrived)
        self.assertGreaterEqual(least, 0.35 + 0.2 + 0.05 - 1e-6)
        flight.forget_track(7)
        with self.assertRaises(tern.TernError):
            flight.forget_track(7)
        # A truck that stands on the goal is named, while it is there.
        truck = tern.Track.of_class("truck", (5.0, 0.0, 1.5), measured=now)
        self.assertEqual((truck.shape, truck.radius, truck.half[2], truck.reach), ("cylinder", 9.5, 2.0, 28.0))
        flight.update_track(9, truck)
        flight.set_goal((0.0, 0.0, 1.5))
        self.assertEqual({flight.tick(now + k * flight.tick_ns).blocked_by for k in range(1, 300)} - {"nothing"}, {"track"})
        with self.assertRaises(ValueError):
            tern.Track.of_class("boat", (0, 0, 0))

    def test_speed_is_limited_by_what_may_come_from_beyond(self):
        fast = tern.Limits((6, 6, 6), (8, 8, 8))
        person = {"clearance": 0.35, "speed": 3.0, "size": 0.45, "delay": 0.15}
        slow = tern.limit_speed(fast, range=4.0, **person)
        self.assertAlmostEqual(slow.v_max[0] * 3**0.5, 2.66, delta=0.005)  # the table of docs/flight.md
        self.assertEqual(slow.v_max[0], slow.v_max[2])
        self.assertEqual(slow.a_max, fast.a_max)
        self.assertEqual(tern.limit_speed(fast, range=99.0, **person), fast)
        late = tern.limit_speed(fast, range=4.0, tick=50_000_000, **person)
        self.assertLess(late.v_max[0], slow.v_max[0])
        for beyond, status in ((0.5, "limits_invalid"), (0.0, "invalid_argument"), (float("nan"), "non_finite_input")):
            with self.assertRaises(tern.TernError) as raised:
                tern.limit_speed(fast, range=beyond, **person)
            self.assertEqual(raised.exception.status, status)

    def test_a_fence_in_the_way_is_named(self):
        rolling_map = tern.RollingMap((-12.8, -7.5, -0.4), 0.2, (128, 75, 20), 0.35)
        rolling_map.assume_free((0, 0, 1.5), 6.0)
        fences = [tern.Fence.box((20, 20, 20), (21, 21, 21), keep_out=True),
                  tern.Fence.box((2, -20, -20), (2.5, 20, 20), keep_out=True)]
        flight = tern.Flight(LIMITS, rolling_map, tern.Planner(), (0, 0, 1.5), t=0, fences=fences)
        flight.set_goal((2.25, 0.0, 1.5))
        ticks = [flight.tick(k * flight.tick_ns) for k in range(100)]
        self.assertEqual({(tick.blocked_by, tick.blocked_fence) for tick in ticks}, {("fence", 1)})

    def test_a_scan_shows_what_is_free(self):
        rolling_map = tern.RollingMap((-5, -5, -2), 0.2, (50, 50, 20), 0.3, range=4.0, scan_pixel=0.05)
        angle = np.linspace(-0.3, 0.3, 61)
        y, z = (a.ravel() for a in np.meshgrid(np.tan(angle) * 3, np.tan(angle) * 3))
        rolling_map.begin_scan(np.stack([np.full_like(y, 3.0), y, z], axis=1), (0, 0, 0), t=0)
        self.assertTrue(rolling_map.busy)
        rolling_map.finish()
        self.assertFalse(rolling_map.busy)
        self.assertTrue(rolling_map.seen((32, 25, 10)))   # 1.5 m ahead
        self.assertFalse(rolling_map.seen((42, 25, 10)))  # beyond what the scan hit
        with self.assertRaises(tern.TernError):
            rolling_map.begin_scan([(1, 0, 0)], (99, 0, 0), t=1)

    def test_a_beam_says_that_nothing_came_back_or_that_nothing_is_known(self):
        angle = np.linspace(-0.3, 0.3, 61)
        y, z = (a.ravel() for a in np.meshgrid(np.tan(angle), np.tan(angle)))
        directions = np.stack([np.ones_like(y), y, z], axis=1)
        for says, seen in ((np.inf, True), (np.nan, False), (0.05, False)):
            rolling_map = tern.RollingMap((-5, -5, -2), 0.2, (50, 50, 20), 0.3, range=4.0, scan_pixel=0.05)
            ranges = np.full(len(y), np.inf)
            ranges[len(y) // 2] = says  # straight ahead
            rolling_map.begin_beams(directions, ranges, (0, 0, 0), t=0)
            rolling_map.finish()
            self.assertEqual(rolling_map.seen((40, 25, 10)), seen)
        with self.assertRaises(ValueError):
            rolling_map.begin_beams(directions, ranges[1:], (0, 0, 0), t=1)


unittest.main()
