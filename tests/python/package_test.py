# Copyright (c) 2026, the Tern authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans and exports of the Python package: shapes, views, refusals, and agreement with what the arrays say themselves."""
import struct
import unittest

import numpy as np
import tern

LIMITS = tern.Limits((2, 2, 1), (4, 4, 2))


def grid_with_wall(origin=(0.0, 0.0, 0.0)):
    shift = np.array(origin)
    grid = tern.Grid(origin, 0.1, (100, 80, 30), 0.3)
    grid.mark_box(shift + (4, 0, 0), shift + (5, 6, 3))
    grid.inflate()
    return grid


class Plans(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.grid, cls.planner = grid_with_wall(), tern.Planner()
        cls.result = cls.planner.plan(cls.grid, (1, 1, 1), (9, 1, 1), LIMITS)
        cls.plan = cls.result.trajectory

    def test_report_in_words(self):
        report = self.result.report
        self.assertTrue(self.result)
        self.assertEqual((report.status, report.quality, report.goal_missed), ("ok", "optimised", "ok"))
        self.assertGreater(report.stages["search"]["work"], 0)
        self.assertLessEqual(report.stages["search"]["work"], report.stages["search"]["bound"])
        self.assertEqual(report.high_water["segments"], len(self.plan))

    def test_evaluate_takes_numbers_and_arrays(self):
        t = np.array([[0.0, 1.0], [3.0, np.nan]])
        samples = self.plan.evaluate(t)
        self.assertEqual(samples.position.shape, (2, 2, 3))
        np.testing.assert_array_equal(samples.velocity[1, 0], self.plan.evaluate(3.0).velocity)
        np.testing.assert_array_equal(samples.position[1, 1], [1, 1, 1])  # NaN is the beginning
        np.testing.assert_allclose(self.plan.evaluate(1e9).position, [9, 1, 1], atol=1e-9)

    def test_control_points_are_a_view_that_gives_the_curve(self):
        points = self.plan.control_points
        self.assertEqual(points.shape, (len(self.plan), 8, 3))
        self.assertTrue(np.shares_memory(points, self.plan.segments))
        with self.assertRaises(ValueError):
            points[0, 0, 0] = 0.0
        first = self.plan.segments[0]
        binomials = np.array([1, 7, 21, 35, 35, 21, 7, 1])
        middle = self.plan.origin + (binomials[:, None] * first["points"]).sum(axis=0) / 128
        np.testing.assert_allclose(middle, self.plan.evaluate(first["duration"] / 2).position, atol=1e-12)
        self.assertAlmostEqual(self.plan.segments["duration"].sum(), self.plan.duration)

    def test_a_plan_knows_when_it_begins(self):
        begin = 1_700_000_000_123_456_789
        plan = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, begin=begin).trajectory
        self.assertEqual((self.plan.begin, plan.begin), (0, begin))
        self.assertEqual((plan.time_on(begin), plan.time_on(begin + 1_500_000_000)), (0.0, 1.5))
        self.assertEqual(plan.time_on(begin - 250_000_000), -0.25)
        np.testing.assert_array_equal(plan.control_points, self.plan.control_points)

    def test_views_outlive_their_trajectory(self):
        points = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS).trajectory.control_points
        np.testing.assert_array_equal(points, self.plan.control_points)

    def test_replan_continues_to_the_last_bit(self):
        second = self.planner.replan(self.grid, self.plan, 1.25, (9, 2, 1), LIMITS)
        self.assertTrue(second)
        self.assertEqual(second.report.entered, 0.0)
        old, new = self.plan.evaluate(1.25), second.trajectory.evaluate(0.0)
        np.testing.assert_allclose(new.position, old.position, atol=1e-12)
        np.testing.assert_allclose(new.jerk, old.jerk, atol=1e-6)

    def test_rest_is_the_previous_plan(self):
        rest = self.planner.replan(self.grid, self.plan, 1.25, (9, 1, 1), LIMITS, time_weight=0.001)
        self.assertEqual((rest.report.quality, rest.report.entered), ("previous plan", 1.25))
        np.testing.assert_array_equal(rest.trajectory.control_points, self.plan.control_points)
        again = self.planner.replan(self.grid, rest.trajectory, 2.5, (9, 1, 1), LIMITS, time_weight=0.001)
        np.testing.assert_array_equal(again.trajectory.evaluate(3.0).jerk, self.plan.evaluate(3.0).jerk)

    def test_corridor_in_the_world(self):
        for origin in ((0.0, 0.0, 0.0), (100.0, -50.0, 3.0)):
            shift = np.array(origin)
            result = self.planner.plan(grid_with_wall(origin), shift + (1, 1, 1), shift + (9, 1, 1), LIMITS)
            corridor = self.planner.corridor()
            begin = 0.0
            for segment in result.trajectory.segments:
                polyhedron = corridor[segment["polyhedron"]]
                times = begin + np.linspace(0, 1, 20) * segment["duration"]
                position = result.trajectory.evaluate(times[1:-1]).position
                self.assertTrue(np.all(position @ polyhedron.normals.T <= polyhedron.offsets + 1e-6))
                self.assertTrue(np.all(polyhedron.normals @ polyhedron.end <= polyhedron.offsets + 1e-6))
                begin += segment["duration"]
            np.testing.assert_allclose(corridor[-1].end, shift + (9, 1, 1), atol=0.1)

    def test_no_plan_says_why(self):
        result = self.planner.plan(self.grid, (1, 1, 1), (4.5, 1, 1), LIMITS)
        self.assertFalse(result)
        self.assertIsNone(result.trajectory)
        self.assertEqual(result.report.status, "goal_occupied")
        self.assertEqual(result.report.nearest_free.shape, (3,))
        near = self.planner.plan(self.grid, (1, 1, 1), (4.5, 1, 1), LIMITS, goal_mode="nearest")
        self.assertEqual(near.report.goal_missed, "goal_occupied")
        np.testing.assert_allclose(near.trajectory.evaluate(1e9).position, near.report.reachable, atol=1e-9)

    def test_fences_and_vias(self):
        low = tern.Fence.box((-1, -1, -1), (11, 9, 1.4))
        high = tern.Fence.box((2, 6.5, -1), (8, 9, 9), keep_out=True)
        via = tern.Via((2, 3, 1.2), tolerance=0.05)
        plan = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, fences=[low], vias=[via]).trajectory
        path = plan.evaluate(np.linspace(0, plan.duration, 2000)).position
        self.assertLessEqual(path[:, 2].max(), 1.4 + 1e-6)
        self.assertLess(np.linalg.norm(path - via.position, axis=1).min(), 0.06)
        self.assertFalse(self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, fences=[high]))  # shuts the gap

    def test_things_that_move(self):
        alone = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS).trajectory
        place = alone.evaluate(alone.duration / 2).position
        crossing = tern.Track(place - (0, 0, alone.duration / 4), (0, 0, 0.5), radius=0.2, error=0.05)
        result = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, tracks=[crossing])
        self.assertTrue(result)
        times = np.linspace(0, result.trajectory.duration, 1000)
        path = result.trajectory.evaluate(times).position
        there = np.asarray(crossing.position) + times[:, None] * np.asarray(crossing.velocity)
        self.assertGreater(np.linalg.norm(path - there, axis=1).min(), 0.25 + self.grid.radius - 1e-6)
        self.assertEqual(result.report.rest_clear_until, np.inf)
        self.assertIsNone(result.report.track)
        # A box at the goal until 200 s, and another vehicle's plan that ends there.
        parked = tern.Track((9, 1, 1), shape="box", half=(0.5, 0.5, 0.5), until=200 * 10**9, end="gone")
        report = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, tracks=[crossing, parked]).report
        self.assertEqual((report.status, report.track), ("goal_covered", 1))
        self.assertAlmostEqual(report.goal_free, 200.0, delta=0.01)
        other = tern.Track.of(alone, 0.2, error=0.1)
        self.assertEqual((len(other.pieces), other.end), (alone.struct.count, "goes on"))
        report = self.planner.plan(self.grid, (2, 3, 1), (9, 1, 1), LIMITS, tracks=[other], rest_clear=2.0).report
        self.assertEqual((report.status, report.goal_free), ("goal_covered", np.inf))
        report = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, tracks=[tern.Track((0, 0, 0), radius=-1)]).report
        self.assertEqual((report.status, report.field, report.track), ("invalid_argument", "tracks", 0))
        with self.assertRaisesRegex(ValueError, "piece 0 of track 0"):
            bent = tern.Track((0, 0, 0), pieces=[(1.0, [(0, 0, 0)])])
            self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, tracks=[bent])

    def test_fences_for_a_while(self):
        ns = 10**9
        wall = tern.Fence.box((2, 6.5, -1), (8, 9, 9), keep_out=True, begin=0, until=20 * ns, clock_error=1.0)
        result = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, fences=[wall])
        self.assertEqual(result.report.status, "ok")
        self.assertGreater(result.trajectory.duration, 21.0)  # the gap beside the wall is closed until then
        room = tern.Fence.box((-1, -1, -1), (11, 9, 9), begin=-ns, until=ns)
        report = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, fences=[room]).report
        self.assertEqual((report.status, report.fence, report.track), ("goal_covered", 0, None))

    def test_a_fence_that_is_wrong_is_named(self):
        good = tern.Fence.box((-1, -1, -1), (11, 9, 4))
        nan = tern.Fence([(np.nan, 0, 0)], [1.0])
        report = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, fences=[good, nan]).report
        self.assertEqual((report.status, report.field, report.fence), ("non_finite_input", "fences", 1))
        self.assertIsNone(self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, fences=[good]).report.fence)
        empty = tern.Fence([(1, 0, 0), (-1, 0, 0)], [4.0, -6.0], keep_out=True)
        report = self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, fences=[good, good, empty]).report
        self.assertEqual((report.status, report.fence), ("fence_empty", 2))
        with self.assertRaisesRegex(ValueError, "fence 1 has 1 normals and 2 offsets"):
            uneven = tern.Fence([(1, 0, 0)], [1.0, 2.0])
            self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), LIMITS, fences=[good, uneven])

    def test_a_box_on_the_path_is_proven_to_be_there(self):
        grid = grid_with_wall()
        self.assertEqual(tern.clear_until(grid, self.plan, limits=LIMITS), self.plan.duration)
        self.assertEqual(grid.mark_points([self.plan.evaluate(3.0).position, (99, 99, 99)]), 1)
        self.assertLess(tern.clear_until(grid, self.plan), 3.0)

    def test_a_tracking_margin_adds_to_the_radius(self):
        grid = tern.Grid((0, 0, 0), 0.1, (100, 80, 30), 0.25, tracking_margin=0.05)
        grid.mark_box((4, 0, 0), (5, 6, 3))
        grid.inflate()
        plan = self.planner.plan(grid, (1, 1, 1), (9, 1, 1), LIMITS).trajectory
        np.testing.assert_array_equal(plan.control_points, self.plan.control_points)

    def test_a_fine_grid_marks_a_coarse_one(self):
        fine = tern.Grid((0, 0, 0), 1.0, (24, 8, 4), 0.0)
        fine.mark_box((8, 0, 0), (9, 8, 4))   # a wall of one voxel, that leaves most of its cells free
        fine.mark_box((7, 0, 0), (8, 7, 4))   # and one beside it, which parts their neighbours from them
        coarse = tern.Grid((0, 0, 0), 4.0, (6, 2, 1), 0.0)
        with self.assertRaisesRegex(tern.TernError, "not inflated"):
            coarse.mark_grid(fine)
        fine.inflate()
        coarse.mark_grid(fine)
        coarse.inflate()
        report = self.planner.plan(coarse, (2, 2, 2), (22, 2, 2), LIMITS).report
        self.assertEqual(report.status, "no_path")
        with self.assertRaisesRegex(tern.TernError, "cell"):
            fine.mark_grid(coarse)

    def test_refusals(self):
        with self.assertRaises(tern.TernError) as raised:
            tern.Grid((0, 0, 0), -0.1, (10, 10, 10), 0.3)
        self.assertEqual(raised.exception.status, "invalid_argument")
        with self.assertRaises(tern.TernError):
            self.grid.mark_box((0, 0, float("nan")), (1, 1, 1))
        with self.assertRaises(ValueError):
            self.grid.mark_points([1.0, 2.0, 3.0])
        self.assertEqual(self.planner.plan(self.grid, (1, 1, 1), (9, 1, 1), tern.Limits((2, 2, 1), (0, 4, 2))).report.field,
                         "a_max")


class Exports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.plan = tern.Planner().plan(grid_with_wall(), (1, 1, 1), (9, 1, 1), LIMITS).trajectory
        cls.yaw = tern.plan_yaw(cls.plan, rate_max=1.0)

    def test_yaw_keeps_its_limit_and_follows_the_motion(self):
        angles, rates = self.yaw.evaluate(np.linspace(0, self.yaw.duration, 500))
        self.assertLessEqual(np.abs(rates).max(), 1.0 + 1e-9)
        self.assertEqual(angles.shape, (500,))
        angle, _ = tern.plan_yaw(self.plan, "fixed", heading=0.5).evaluate(1e9)
        self.assertAlmostEqual(float(angle), 0.5)

    def test_setpoint_turns_east_north_up(self):
        sample, setpoint = self.plan.evaluate(2.0), tern.setpoint_ned(self.plan, 2.0, origin=(1, 2, 3))
        x, y, z = sample.position
        np.testing.assert_allclose(setpoint.position, [y - 2, x - 1, 3 - z], atol=1e-6)
        np.testing.assert_allclose(setpoint.velocity, sample.velocity[[1, 0, 2]] * [1, 1, -1], atol=1e-6)
        self.assertTrue(np.isnan(setpoint.yaw) and np.isnan(setpoint.yaw_rate), "no yaw plan")
        self.assertLess(tern.setpoint_error(self.plan, self.yaw).position, 1e-5)

    def test_mavlink_frame_carries_the_setpoint(self):
        frame = tern.mavlink_setpoint(self.plan, 2.0, sequence=257, time_boot_ms=2000, yaw=self.yaw)
        self.assertEqual(frame[:1] + frame[4:5] + frame[7:10], bytes([0xFD, 1, 84, 0, 0]))
        payload = frame[10:10 + frame[1]].ljust(53, b"\0")
        time, *numbers = struct.unpack("<I11f", payload[:48])
        setpoint = tern.setpoint_ned(self.plan, 2.0, self.yaw)
        self.assertEqual((time, frame[58:60]), (2000, b"\0\0"))
        without = tern.mavlink_setpoint(self.plan, 2.0, sequence=0, time_boot_ms=2000)
        self.assertEqual(without[58:60], (3072).to_bytes(2, "little"), "yaw and yaw rate are to be ignored")
        np.testing.assert_array_equal(np.float32(numbers[:9]), np.concatenate(
            [setpoint.position, setpoint.velocity, setpoint.acceleration]))

    def test_crazyflie_pieces_fly_the_plan(self):
        pieces, error = tern.crazyflie_raw(self.plan, self.yaw)
        self.assertGreaterEqual(len(pieces), len(self.plan))
        self.assertEqual(len(pieces.tobytes()), 132 * len(pieces))
        self.assertLess(error.position, 1e-5)
        self.assertTrue(0.0 < error.yaw <= 0.05, error)
        begin = 0.0
        for piece in pieces.astype(float):
            t = 0.4 * piece[32]
            position = [np.polynomial.polynomial.polyval(t, piece[8 * k:8 * k + 8]) for k in range(3)]
            np.testing.assert_allclose(position, self.plan.evaluate(begin + t).position, atol=1e-4)
            begin += piece[32]
        far, error = tern.crazyflie_raw(self.plan, origin=(1e7, 0, 0))
        self.assertGreater(error.position, 0.1)
        data, flown, error = tern.crazyflie_compressed(self.plan)
        self.assertLess(error.position, 1e-3)
        self.assertEqual(data[-1:], b"\0")
        self.assertEqual(tern.clear_until(grid_with_wall(), flown), flown.duration)

    def test_limits_of_autopilots(self):
        self.assertEqual(tern.Limits.from_px4(mpc_xy_vel_max=5.0).v_horizontal, 0.7 * 5.0)
        self.assertEqual(tern.Limits.from_ardupilot(wpnav_speed_m_s=5.0).v_horizontal, 5.0)
        with self.assertRaisesRegex(tern.TernError, "limits_invalid.*v_horizontal"):
            tern.Limits.from_ardupilot(wpnav_speed_m_s=500.0)
        self.assertEqual(tern.Limits.from_ardupilot().j_horizontal, 0.9 * 5.0)
        self.assertAlmostEqual(tern.Limits.from_px4().thrust_max, 2.0 * 9.80665)
        self.assertLess(tern.Limits.from_crazyflie(thrust_base=48000).thrust_max, 1.4 * 9.80665)
        with self.assertRaises(AttributeError):
            tern.Limits.from_px4(mpc_typo=5.0)


unittest.main()
