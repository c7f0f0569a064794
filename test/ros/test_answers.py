#!/usr/bin/env python3
"""Every output against the truth of a scene made here. Run with node and nodelet, with clouds and with depth images."""
import sys
import unittest

import numpy as np
import rospy
import rostest

import scene
from node_client import FOUND, OUTPUTS, Clock, NodeClient
from polygonal_perception.msg import Plane

RADIUS, TOLERANCE = 0.30, 0.05
MIN_HEIGHT, MAX_HEIGHT = 0.03, 0.60


class AnswersTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.encoding = rospy.get_param('~encoding')
        cls.client = NodeClient(OUTPUTS, depth=cls.encoding != 'cloud')
        cls.clock = Clock()
        # No side lies on the border of a cell, where a rounding error decides.
        cls.boxes = [scene.Box((1.82, 2.22), (-0.38, 0.12), (0, 0.3)), scene.Box((2.53, 2.72), (0.83, 1.22), (0, 1.5))]
        # A millimetre image is rounded; otherwise only float32 is in the way.
        cls.margin = 0.004 if cls.encoding == '16UC1' else 0.001

    def setUp(self):
        # Each test has a camera of its own, which is no continuation of the last.
        self.assertTrue(self.client.reset().success)

    def ask(self, camera, boxes):
        depth = camera.render(boxes)
        return camera.to_floor(camera.points(depth)), self.send(camera, depth)

    def send(self, camera, depth):
        stamp = self.clock.tick()
        if self.encoding == 'cloud':
            self.client.send(camera.cloud(depth, stamp))
        else:
            # The image first: it has to wait for its calibration.
            self.client.send(camera.image(depth, stamp, self.encoding), camera.info(stamp))
        return self.client.answer(stamp)

    def check(self, camera, boxes):
        points, answer = self.ask(camera, boxes)
        self.check_floor(camera, answer)
        occupied = self.check_grids(points, answer)
        self.check_polygons(occupied, answer)
        self.check_points(points, answer)

    def check_floor(self, camera, answer):
        floor = answer['floor']
        self.assertEqual(floor.status, FOUND)
        normal = np.array([floor.normal.x, floor.normal.y, floor.normal.z])
        np.testing.assert_allclose(normal, camera.floor_normal, atol=2e-3)
        self.assertAlmostEqual(np.linalg.norm(normal), 1.0, places=6)
        self.assertAlmostEqual(floor.distance, camera.height, delta=0.004)
        self.assertEqual(floor.age, 0.0)
        self.assertGreater(floor.sample_count, 50)
        self.assertLess(floor.rms_error, 0.005)
        np.testing.assert_allclose(answer['floor_coefficients'].values, [*normal, floor.distance], atol=1e-6)
        hull = np.array([[p.x, p.y, p.z] for p in floor.hull])
        self.assertGreaterEqual(len(hull), 3)
        np.testing.assert_allclose(hull @ normal + floor.distance, 0.0, atol=1e-5)
        area = sum(np.cross(a, b) for a, b in zip(hull, np.roll(hull, -1, 0))) / 2.0
        self.assertGreater(area @ normal, 0.5, 'the hull must run counter-clockwise')

    def check_grids(self, points, answer):
        grid, inflated = answer['occupancy_grid'], answer['inflated_grid']
        for message in (grid, inflated):
            self.assertEqual((message.info.width, message.info.height), (100, 100))
            self.assertAlmostEqual(message.info.resolution, 0.05, places=6)
            self.assertEqual((message.info.origin.position.x, message.info.origin.position.y), (0.0, -2.5))
            self.assertEqual(message.info.origin.orientation.w, 1.0)
            self.assertLessEqual(set(message.data), {0, 100})
        cells = np.array(grid.data, np.int8).reshape(100, 100) == 100
        # Farther away an error of the plane moves points more.
        margin = self.margin + 0.005
        must, may = scene.occupied_cells(points, grid.info, MIN_HEIGHT, MAX_HEIGHT, margin)
        self.assertFalse((must & ~cells).any(), 'free cells with obstacles in them: %s' % np.argwhere(must & ~cells))
        self.assertFalse((cells & ~may).any(), 'occupied cells without an obstacle: %s' % np.argwhere(cells & ~may))
        expected = scene.inflate(cells, 0.05, RADIUS)
        np.testing.assert_array_equal(np.array(inflated.data, np.int8).reshape(100, 100) == 100, expected)
        self.check_observed(points, cells, answer)
        self.check_scan(points, answer)
        return cells

    def check_observed(self, points, occupied, answer):
        observed = np.array(answer['observed_grid'].data, np.int8).reshape(100, 100)
        np.testing.assert_array_equal(observed == 100, occupied)
        self.assertEqual(answer['observed_grid'].info, answer['occupancy_grid'].info)
        must, may = scene.occupied_cells(points, answer['observed_grid'].info, -MIN_HEIGHT, MIN_HEIGHT, self.margin + 0.005)
        free = observed == 0
        # Near the camera not every row of the image is looked at: a corner of a cell may have been in the others.
        missed = must & ~occupied & ~free
        self.assertLess(np.count_nonzero(missed), 0.02 * np.count_nonzero(must), 'floor that was seen and is not free')
        # Between two that were seen.
        beside = scene.inflate(may, 1.0, 1.5)
        self.assertFalse((free & ~beside).any(), 'free cells where no floor was seen')
        self.check_observed_cells(occupied, free, answer)
        self.assertGreater(np.count_nonzero(free), 500)
        self.assertGreater(np.count_nonzero(observed == -1), 500, 'beside the view and behind obstacles')

    def check_observed_cells(self, occupied, free, answer):
        cells = answer['observed_cells']
        self.assertEqual((cells.floor_status, cells.info), (FOUND, answer['observed_grid'].info))
        self.assertAlmostEqual(cells.slab_height, (MAX_HEIGHT - MIN_HEIGHT) / 8, places=6)
        hit, through, floor = (np.frombuffer(bits, np.uint8).reshape(100, 100) for bits in (cells.hit, cells.free, cells.floor))
        np.testing.assert_array_equal(hit != 0, occupied)
        # What lies between two floor points was not seen itself: it is free, and clears nothing.
        self.assertFalse((floor.astype(bool) & ~occupied & ~free).any())
        self.assertGreater(np.count_nonzero(floor.astype(bool) & free), 0.4 * np.count_nonzero(free))
        # Above most of the floor that is seen the lowest slab was looked through, and behind what stands none.
        self.assertGreater(np.count_nonzero(through[free] & 1), 0.5 * np.count_nonzero(free))
        self.assertGreater(np.count_nonzero(through == 0), 500)

    def check_scan(self, points, answer):
        scan = answer['scan']
        self.assertEqual(scan.header, answer['floor'].header.__class__(scan.header.seq, answer['floor'].header.stamp, 'floor'))
        self.assertEqual((scan.range_min, scan.range_max, scan.time_increment), (0.0, 5.0, 0.0))
        self.assertAlmostEqual(scan.angle_increment, 0.00873, places=6)
        ranges = np.array(scan.ranges)
        self.assertEqual(len(ranges), round((scan.angle_max - scan.angle_min) / scan.angle_increment) + 1)
        known = points[np.isfinite(points).all(-1)]
        standing = known[(known[:, 2] > MIN_HEIGHT + self.margin + 0.005) & (known[:, 2] < MAX_HEIGHT - self.margin - 0.005)]
        nearest = np.full(len(ranges) + 2, np.inf)
        bins = np.round((np.arctan2(standing[:, 1], standing[:, 0]) - scan.angle_min) / scan.angle_increment).astype(int)
        distance = np.hypot(standing[:, 0], standing[:, 1])
        inside = (bins >= 0) & (bins < len(ranges))
        np.minimum.at(nearest, bins[inside] + 1, distance[inside])
        around = np.minimum(np.minimum(nearest[:-2], nearest[2:]), nearest[1:-1])  # what noise puts in the next bin is as good
        ends = np.isfinite(ranges)
        self.assertGreater(np.count_nonzero(ends), 20)
        self.assertGreater((ranges[ends] - around[ends]).min(), -0.02, 'ranges before what stands there')
        seen = nearest[1:-1] < 4.9
        reached = np.minimum(np.minimum(np.r_[np.inf, ranges[:-1]], np.r_[ranges[1:], np.inf]), ranges)[seen]
        self.assertLess(np.nanmax(reached - nearest[1:-1][seen]), 0.02, 'ranges beyond what stands there')
        self.assertFalse((ranges == np.inf)[nearest[1:-1] < 4.9].any(), 'clear through an obstacle')

    def check_polygons(self, occupied, answer):
        message = answer['polygons']
        self.assertEqual(message.floor_status, FOUND)
        self.check_context(message)
        rings = []
        for polygon in message.polygons:
            boundary = [(p.x, p.y) for p in polygon.boundary.points]
            self.assertGreater(scene.signed_area(boundary), 0.0)
            holes = [[(p.x, p.y) for p in hole.points] for hole in polygon.holes]
            for hole in holes:
                self.assertLess(scene.signed_area(hole), 0.0)
            self.assertTrue(all(p.z == 0.0 for ring in [polygon.boundary, *polygon.holes] for p in ring.points))
            rings.append((boundary, holes))

        def covered(point):
            return any(scene.inside(point, b) and not any(scene.inside(point, h) for h in holes) for b, holes in rings)

        # Safe: the robot's centre cannot come that near to an occupied cell without being in a polygon.
        angles = np.linspace(0, 2 * np.pi, 16, endpoint=False)
        for j, i in np.argwhere(occupied):
            for a in angles:
                corner = np.array([(i + (np.cos(a) > 0)) * 0.05, (j + (np.sin(a) > 0)) * 0.05 - 2.5])
                p = corner + (RADIUS - 0.002) * np.array([np.cos(a), np.sin(a)])
                p = np.clip(p, [0.001, -2.499], [4.999, 2.499])
                self.assertTrue(covered(p), '%s is within the radius of cell %s and in no polygon' % (p, (i, j)))
        # Tight: no vertex is far away from all of them.
        centres = (np.argwhere(occupied)[:, ::-1] + 0.5) * 0.05 - [0, 2.5]
        for boundary, _ in rings:
            for vertex in boundary:
                gap = np.maximum(np.abs(centres - vertex) - 0.025, 0.0)
                self.assertLessEqual(np.hypot(*gap.T).min(), RADIUS + 1.5 * 0.05 + TOLERANCE + 1e-6)

    def check_context(self, message):
        """What every array says beside its polygons."""
        self.assertEqual(message.inflation_radius, RADIUS)
        # The grid's rectangle, counter-clockwise.
        self.assertEqual([(p.x, p.y, p.z) for p in message.extent.points],
                         [(0.0, -2.5, 0.0), (5.0, -2.5, 0.0), (5.0, 2.5, 0.0), (0.0, 2.5, 0.0)])

    def check_points(self, points, answer):
        message = answer['obstacle_points']
        self.assertEqual([f.name for f in message.fields], ['x', 'y', 'z'])
        got = np.frombuffer(message.data, np.float32).reshape(-1, 3)
        self.assertEqual(len(got), message.width)
        self.assertEqual(message.height, 1)
        with np.errstate(invalid='ignore'):
            expected = points[(points[..., 2] > MIN_HEIGHT) & (points[..., 2] < MAX_HEIGHT) & (points[..., 0] < 5.0) &
                              (np.abs(points[..., 1]) < 2.5)]
        # Those on the very limits may fall to either side.
        self.assertAlmostEqual(len(got), len(expected), delta=0.05 * len(expected))
        np.testing.assert_allclose(got.mean(0), expected.mean(0), atol=0.02)
        cells = np.floor((got[:, :2] - [0, -2.5]) / 0.05).astype(int)
        grid = np.array(answer['occupancy_grid'].data).reshape(100, 100)
        self.assertTrue((grid[cells[:, 1].clip(0, 99), cells[:, 0].clip(0, 99)] == 100).all())

    def test_a_camera_that_looks_down(self):
        self.check(scene.Camera(height=1.0, pitch=0.5), self.boxes)

    def test_a_tilted_camera(self):
        self.check(scene.Camera(height=0.7, pitch=0.3, roll=0.2), self.boxes)

    def test_an_exactly_level_camera(self):
        self.check(scene.Camera(height=0.5, pitch=0.0), self.boxes)

    def test_a_camera_of_another_size(self):
        self.check(scene.Camera(height=1.0, pitch=0.5, width=320, rows=200, focal_length=290.0), self.boxes)

    def test_an_empty_floor_is_answered_too(self):
        _, answer = self.ask(scene.Camera(), [])
        self.assertEqual(answer['polygons'].floor_status, FOUND)
        self.assertEqual(answer['polygons'].polygons, [])
        self.check_context(answer['polygons'])
        self.assertEqual(set(answer['occupancy_grid'].data), {0})
        self.assertEqual(set(answer['inflated_grid'].data), {0})
        self.assertEqual(answer['obstacle_points'].width, 0)
        actions = {m.ns: m.action for m in answer['markers'].markers}
        self.assertEqual(actions, {'polygons/fill': 2, 'polygons/outline': 2, 'floor/normal': 0, 'floor/hull': 0})

    def test_frames(self):
        _, answer = self.ask(scene.Camera(), self.boxes)
        frames = {name: message.header.frame_id for name, message in answer.items() if name != 'markers'}
        frames.update({m.ns: m.header.frame_id for m in answer['markers'].markers})
        of_input = {'floor', 'floor_coefficients', 'planes', 'samples', 'floor/normal', 'floor/hull'}
        self.assertEqual(frames, {n: scene.OPTICAL_FRAME if n in of_input else 'floor' for n in frames})

    def test_tf(self):
        camera = scene.Camera(height=0.9, pitch=0.35, roll=-0.1)
        _, answer = self.ask(camera, self.boxes)
        stamp = answer['floor'].header.stamp
        found = self.client.wait_for(lambda: [t for t in self.client.transforms if t.header.stamp == stamp], 'tf')
        self.assertEqual([(t.header.frame_id, t.child_frame_id) for t in found], [(scene.OPTICAL_FRAME, 'floor')])
        t, q = found[0].transform.translation, found[0].transform.rotation
        # The floor frame's origin is under the camera.
        np.testing.assert_allclose([t.x, t.y, t.z], -camera.height * camera.floor_normal, atol=0.005)
        x, y, z, w = q.x, q.y, q.z, q.w
        rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                             [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                             [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
        np.testing.assert_allclose(rotation.T, camera.rotation, atol=4e-3)

    def test_planes(self):
        # A box as wide as the view, 0.5 m high: its top is level, its front upright.
        camera = scene.Camera(height=1.2, pitch=0.5)
        box = scene.Box((1.82, 2.62), (-3, 3), (0, 0.5))
        _, answer = self.ask(camera, [box])
        planes, floor = answer['planes'].planes, answer['floor']
        kinds = {Plane.FLOOR: (camera.rotation.T @ [0, 0, 1], camera.height),
                 Plane.HORIZONTAL: (camera.rotation.T @ [0, 0, 1], camera.height - 0.5),
                 Plane.VERTICAL: (camera.rotation.T @ [-1, 0, 0], 1.82)}
        self.assertEqual({p.kind for p in planes}, set(kinds), 'kinds of the planes')
        self.assertEqual(len({p.id for p in planes}), len(planes), 'ids')
        counts = [p.sample_count for p in planes]
        self.assertEqual(counts, sorted(counts, reverse=True), 'largest first')
        for plane in planes:
            normal = np.array([plane.normal.x, plane.normal.y, plane.normal.z])
            expected, distance = kinds[plane.kind]
            np.testing.assert_allclose(normal, expected, atol=5e-3, err_msg='kind %d' % plane.kind)
            self.assertAlmostEqual(plane.distance, distance, delta=0.01, msg='kind %d' % plane.kind)
            self.assertLess(plane.rms_error, 0.01)
            boundary = np.array([[p.x, p.y, p.z] for p in plane.boundary])
            self.assertGreaterEqual(len(boundary), 3)
            np.testing.assert_allclose(boundary @ normal + plane.distance, 0.0, atol=1e-4)
            area = sum(np.cross(a, b) for a, b in zip(boundary, np.roll(boundary, -1, 0))) / 2.0
            self.assertGreater(area @ normal, 0.05, 'counter-clockwise as the sensor sees it')
        # Behind the box the floor goes on: pieces of one plane, which is that of ~floor.
        for plane in planes:
            if plane.kind == Plane.FLOOR:
                self.assertEqual((plane.normal, plane.distance), (floor.normal, floor.distance))
        # The front is seen from edge to edge of the image, and as high as the box.
        front = next(p for p in planes if p.kind == Plane.VERTICAL)
        corners = camera.to_floor(np.array([[p.x, p.y, p.z] for p in front.boundary]))
        self.assertAlmostEqual(corners[:, 2].max(), 0.5, delta=0.03)
        self.assertAlmostEqual(corners[:, 2].min(), 0.0, delta=0.03)
        # And in the next frame each has its id.
        _, later = self.ask(camera, [box])
        self.assertEqual({p.id: p.kind for p in later['planes'].planes}, {p.id: p.kind for p in planes})

    def test_whatever_stands_for_no_return_is_none(self):
        # Lower than an obstacle: points in the camera itself would stand in its own cell.
        camera = scene.Camera(height=0.4, pitch=0.3)
        depth = camera.render(self.boxes)
        depth[np.random.RandomState(1).rand(*depth.shape) < 0.2] = np.nan
        depth[:, :10] = np.nan  # the strip that a stereo camera does not see
        spellings = {'cloud': (np.nan, 0.0, np.inf, -np.inf), '16UC1': (0.0, 65.535),
                     '32FC1': (np.nan, 0.0, np.inf, -np.inf, -1.0)}[self.encoding]
        answers = []
        for none in spellings:
            self.assertTrue(self.client.reset().success)
            answers.append(self.send(camera, np.where(np.isnan(depth), none, depth)))
            self.assertEqual(answers[-1]['floor'].status, FOUND, none)
            self.assertEqual(answers[-1]['floor'].distance, answers[0]['floor'].distance, none)
            self.assertEqual(answers[-1]['occupancy_grid'].data, answers[0]['occupancy_grid'].data, none)
        cells = np.argwhere(np.array(answers[0]['occupancy_grid'].data).reshape(100, 100) == 100)
        self.assertGreater(len(cells), 0)
        self.assertGreater(cells[:, 1].min(), 30, 'nothing stands within 1.5 m')

    def test_markers(self):
        _, answer = self.ask(scene.Camera(), self.boxes)
        markers = {m.ns: m for m in answer['markers'].markers}
        outline = sum(len(r.points) for p in answer['polygons'].polygons for r in [p.boundary, *p.holes])
        self.assertEqual(len(markers['polygons/outline'].points), 2 * outline)
        corners = np.array([[p.x, p.y] for p in markers['polygons/fill'].points]).reshape(-1, 3, 2)
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        area = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]).sum() / 2.0
        expected = sum(scene.signed_area([(q.x, q.y) for q in r.points])
                       for p in answer['polygons'].polygons for r in [p.boundary, *p.holes])
        self.assertAlmostEqual(area, expected, delta=1e-4 * expected)
        start, end = markers['floor/normal'].points
        np.testing.assert_allclose(np.array([end.x, end.y, end.z]) - [start.x, start.y, start.z],
                                   0.5 * scene.Camera().floor_normal, atol=2e-3)
        self.assertEqual(len(markers['floor/hull'].points), len(answer['floor'].hull) + 1)

    def test_samples_image(self):
        camera = scene.Camera()
        _, answer = self.ask(camera, self.boxes)
        image = answer['samples']
        self.assertEqual((image.width, image.height, image.encoding), (camera.width, camera.rows, 'bgr8'))
        pixels = np.frombuffer(image.data, np.uint8).reshape(camera.rows, camera.width, 3).astype(int)
        # The lower left corner shows floor, and the corner pixels are samples.
        blue, green, red = pixels[-1, 0]
        self.assertTrue(green > 150 and green > red + 50 and green > blue + 50, pixels[-1, 0])


if __name__ == '__main__':
    rospy.init_node('test_answers')
    rostest.rosrun('polygonal_perception', 'test_answers', AnswersTest, sys.argv)
