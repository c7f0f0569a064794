#!/usr/bin/env python3
"""Shows polygons and floors in rviz and looks at the pixels."""
import os
import sys
import unittest

import numpy as np
import rospy
import rostest
from geometry_msgs.msg import Point32, Polygon, TransformStamped, Vector3
from std_msgs.msg import Header
from tf2_msgs.msg import TFMessage

from polygonal_perception.msg import FloorPlane, ObstaclePolygon, Plane, PlaneArray, PolygonArray
from virtual_rviz import VirtualRviz, what_is_missing

START = 60.0     # [s] until rviz has subscribed; under a software renderer and a busy machine
DEADLINE = 20.0  # [s] until a message is on the screen
PIXELS = 100     # a metre

# An L with a hole in its upright; around its notch and its hole there is nothing.
L_SHAPE = [(-2, -2), (2, -2), (2, -1), (0, -1), (0, 2), (-2, 2)]
HOLE = [(-1.5, 0), (-1.5, 1), (-0.5, 1), (-0.5, 0)]
SQUARE = [(1, 1), (1.5, 1), (1.5, 1.5), (1, 1.5)]
INSIDE = [(-1.9, 1.9), (-1, -1.5), (1.9, -1.1), (-0.1, 1.9), (-1.6, 0.5), (-0.4, 0.5), (-1, 1.1), (-1, -0.1)]
IN_HOLE = [(-1, 0.5), (-1.4, 0.1), (-0.6, 0.9)]
IN_SQUARE = [(1.25, 1.25), (1.05, 1.45)]
OUTSIDE = [(0.1, -0.9), (1, 0), (1.9, 1.9), (-2.1, 0), (0.1, 1), (0, -2.1)]


def ring(corners, z=0.0):
    return Polygon(points=[Point32(x, y, z) for x, y in corners])


def is_red(pixels):
    return (pixels[..., 0] > 50) & (pixels[..., 1] < 20) & (pixels[..., 2] < 20)


def is_blue(pixels):
    return (pixels[..., 2] > 50) & (pixels[..., 1] < 20) & (pixels[..., 0] < 20)


def is_green(pixels):
    return (pixels[..., 1] > 120) & (pixels[..., 0] < 80) & (pixels[..., 2] < 90)


def is_grey(pixels):
    return (pixels[..., 0] > 40) & (pixels.max(-1) - pixels.min(-1) < 10)


def box_of(mask):
    """First and last column and row of a mask; None where it is empty."""
    rows, columns = np.any(mask, axis=1).nonzero()[0], np.any(mask, axis=0).nonzero()[0]
    return (columns[0], columns[-1], rows[0], rows[-1]) if len(rows) else None


@unittest.skipIf(what_is_missing(), 'not there: ' + what_is_missing())
class DisplaysTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rviz = VirtualRviz(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'displays.rviz'))
        try:
            cls.transforms = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
            cls.transforms.publish(TFMessage(transforms=[cls.camera_pose()]))
            cls.polygons = rospy.Publisher('/test/polygons', PolygonArray, queue_size=1)
            cls.floor = rospy.Publisher('/test/floor', FloorPlane, queue_size=1)
            cls.planes = rospy.Publisher('/test/planes', PlaneArray, queue_size=1)
            cls.rviz.wait_for(lambda: all(p.get_num_connections() > 0 for p in (cls.polygons, cls.floor, cls.planes)),
                              'rviz to subscribe to polygons, floor and planes: are the displays loaded?', START)
        except Exception:
            cls.rviz.close()
            raise

    @classmethod
    def tearDownClass(cls):
        cls.rviz.close()

    @staticmethod
    def camera_pose():
        """An optical frame one metre over the map's origin that looks along the map's x axis."""
        pose = TransformStamped(header=Header(frame_id='map'), child_frame_id='camera')
        pose.transform.translation.z = 1.0
        rotation = pose.transform.rotation
        rotation.x, rotation.y, rotation.z, rotation.w = -0.5, 0.5, -0.5, 0.5
        return pose

    def show(self, publisher, message, condition, what):
        """Publishes a message, waits until the screen looks as it shall, and returns the pixels."""
        screens = [self.rviz.pixels()]

        def looks_so():
            screens.append(self.rviz.pixels())
            # Twice the same: a screen that is being drawn is half the old one.
            return condition(screens[-1]) and np.array_equal(*screens[-2:])
        message.header.stamp = rospy.Time.now()
        publisher.publish(message)
        try:
            self.rviz.wait_for(looks_so, what, DEADLINE)
            return screens[-1]
        except AssertionError as error:
            pixels = screens[-1]
            raise AssertionError('%s; red in %s, blue in %s' % (error, box_of(is_red(pixels)), box_of(is_blue(pixels))))

    def show_polygons(self, polygons, condition, what, status=FloorPlane.FOUND, extent=()):
        array = PolygonArray(header=Header(frame_id='map'), floor_status=status, polygons=polygons, extent=ring(extent))
        return self.show(self.polygons, array, condition, what)

    def show_floor(self, condition, what, status=FloorPlane.FOUND, normal=(0.0, -1.0, 0.0)):
        # x right, y down, z ahead: 1 to 3 m ahead of the camera, and 1 m to each side.
        hull = [Point32(1, 1, 1), Point32(1, 1, 3), Point32(-1, 1, 3), Point32(-1, 1, 1)]
        plane = FloorPlane(header=Header(frame_id='camera'), status=status, normal=Vector3(*normal), distance=1.0,
                           hull=hull)
        return self.show(self.floor, plane, condition, what)

    def show_planes(self, planes, condition, what):
        return self.show(self.planes, PlaneArray(header=Header(frame_id='map'), planes=planes), condition, what)

    def remove_all(self):
        self.show_planes([], lambda p: not is_green(p).any(), 'the planes to go')
        self.show_polygons([], lambda p: not is_red(p).any(), 'the polygons to go')
        self.show_floor(lambda p: not is_blue(p).any(), 'the floor to go', status=FloorPlane.NOT_FOUND)

    def setUp(self):
        self.remove_all()

    @staticmethod
    def at(mask, origin, point):
        return bool(mask[int(round(origin[1] - PIXELS * point[1])), int(round(origin[0] + PIXELS * point[0]))])

    def test_polygons_are_filled_and_their_holes_and_notches_are_not(self):
        polygons = [ObstaclePolygon(boundary=ring(L_SHAPE), holes=[ring(HOLE)]), ObstaclePolygon(boundary=ring(SQUARE))]
        pixels = self.show_polygons(polygons, lambda p: is_red(p).any(), 'red pixels')
        red = is_red(pixels)
        left, right, top, bottom = box_of(red)
        self.assertAlmostEqual(right - left, 4 * PIXELS, delta=2)
        self.assertAlmostEqual(bottom - top, 4 * PIXELS, delta=2)
        origin = (left + right) / 2.0, (top + bottom) / 2.0
        for point in INSIDE + IN_SQUARE:
            self.assertTrue(self.at(red, origin, point), 'no red at %s, which is inside' % (point,))
        for point in IN_HOLE + OUTSIDE:
            self.assertFalse(self.at(red, origin, point), 'red at %s, which is outside' % (point,))
        # L: 16 - 6 - the hole; the square a quarter.
        self.assertAlmostEqual(red.sum() / float(PIXELS ** 2), 16 - 6 - 1 + 0.25, delta=0.1)

    def test_a_malformed_polygon_is_left_out_and_the_others_are_shown(self):
        broken = [ring([(0, 0), (1, 0)]), ring([(-2, -2), (2, -2), (float('nan'), 2)])]
        polygons = [ObstaclePolygon(boundary=boundary) for boundary in broken] + [ObstaclePolygon(boundary=ring(SQUARE))]
        pixels = self.show_polygons(polygons, lambda p: is_red(p).any(), 'red pixels')
        self.assertAlmostEqual(is_red(pixels).sum() / float(PIXELS ** 2), 0.25, delta=0.02)

    def test_polygons_on_a_held_floor_are_paler(self):
        square = [ObstaclePolygon(boundary=ring(SQUARE))]
        pixels = self.show_polygons(square, lambda p: is_red(p).any(), 'red pixels')
        brightness = pixels[is_red(pixels)][:, 0].max()
        self.assertEqual(brightness, 255)
        self.show_polygons(square, lambda p: 60 < p[is_red(p)][:, 0].max(initial=0) < 150, 'paler pixels', FloorPlane.HELD)

    def test_the_extent_is_outlined_and_goes_with_its_message(self):
        # It fits into what the window's panels leave of the picture, which is less on Debian 13.
        extent = [(-2.6, -2.5), (2.6, -2.5), (2.6, 2.5), (-2.6, 2.5)]
        polygons = [ObstaclePolygon(boundary=ring(L_SHAPE))]
        without = self.show_polygons(polygons, lambda p: is_red(p).any(), 'red pixels')
        left, right, top, bottom = box_of(is_red(without))
        origin = (left + right) / 2.0, (top + bottom) / 2.0

        def is_drawn(pixels, point):
            """Whether something grey has come within 3 cm of a point."""
            row, column = int(round(origin[1] - PIXELS * point[1])), int(round(origin[0] + PIXELS * point[0]))
            around = slice(row - 3, row + 4), slice(column - 3, column + 4)
            return bool((is_grey(pixels[around]) & ~is_grey(without[around])).any())

        on_edges = [(0, -2.5), (2.6, 0), (0, 2.5), (-2.6, 0), (2.3, 2.5)]
        # A picture may be taken while it is drawn: every edge is waited for.
        pixels = self.show_polygons(polygons, lambda p: all(is_drawn(p, point) for point in on_edges), 'the extent',
                                    extent=extent)
        for point in [(1, 1), (2.4, 2.2), (-2.4, 0), (2.8, 0)]:
            self.assertFalse(is_drawn(pixels, point), 'something at %s' % (point,))
        self.show_polygons(polygons, lambda p: not any(is_drawn(p, point) for point in on_edges), 'the extent to go')

    def test_an_extent_that_is_not_finite_is_not_drawn(self):
        square = [ObstaclePolygon(boundary=ring(SQUARE))]
        pixels = self.show_polygons(square, lambda p: is_red(p).any(), 'red pixels',
                                    extent=[(-3, -2.5), (3, -2.5), (float('nan'), 2.5)])
        self.assertAlmostEqual(is_red(pixels).sum() / float(PIXELS ** 2), 0.25, delta=0.02)

    def test_the_hull_of_the_floor_lies_where_the_camera_saw_it(self):
        marks = [ObstaclePolygon(boundary=ring(corners)) for corners in
                 ([(-2, -2), (-1.9, -2), (-1.9, -1.9), (-2, -1.9)], [(1.9, 1.9), (2, 1.9), (2, 2), (1.9, 2)])]
        left, right, top, bottom = box_of(is_red(self.show_polygons(marks, lambda p: is_red(p).any(), 'red pixels')))
        origin = (left + right) / 2.0, (top + bottom) / 2.0

        pixels = self.show_floor(lambda p: is_blue(p).any(), 'blue pixels')
        blue_left, blue_right, blue_top, blue_bottom = box_of(is_blue(pixels))
        # The outline adds half of its width on each side.
        self.assertAlmostEqual((blue_left - origin[0]) / PIXELS, 1.0, delta=0.04)
        self.assertAlmostEqual((blue_right - origin[0]) / PIXELS, 3.0, delta=0.04)
        self.assertAlmostEqual((origin[1] - blue_top) / PIXELS, 1.0, delta=0.04)
        self.assertAlmostEqual((origin[1] - blue_bottom) / PIXELS, -1.0, delta=0.04)

    def test_a_plane_is_filled_in_the_colour_of_its_kind_and_a_malformed_one_left_out(self):
        up = Vector3(0, 0, 1)
        corners = [Point32(x, y, 0) for x, y in L_SHAPE]
        planes = [Plane(id=1, normal=up, boundary=corners, kind=Plane.FLOOR),
                  Plane(id=2, normal=Vector3(0, 0, 2), boundary=[Point32(2.1, 1, 0), Point32(2.5, 1, 0), Point32(2.5, 2, 0)],
                        kind=Plane.FLOOR)]
        green = is_green(self.show_planes(planes, lambda p: is_green(p).any(), 'green pixels'))
        left, right, top, bottom = box_of(green)
        self.assertAlmostEqual(right - left, 4 * PIXELS, delta=5)
        origin = (left + right) / 2.0, (top + bottom) / 2.0
        for point in INSIDE:
            self.assertTrue(self.at(green, origin, point), 'no green at %s, which is inside' % (point,))
        for point in OUTSIDE:
            self.assertFalse(self.at(green, origin, point), 'green at %s, which is outside' % (point,))

    def test_a_message_waits_for_its_transform(self):
        array = PolygonArray(header=Header(frame_id='late', stamp=rospy.Time.now()), floor_status=FloorPlane.FOUND,
                             polygons=[ObstaclePolygon(boundary=ring(SQUARE))])
        self.polygons.publish(array)
        # What is published later is on the screen, this is not.
        pixels = self.show_floor(lambda p: is_blue(p).any(), 'blue pixels')
        self.assertFalse(is_red(pixels).any())
        late = TransformStamped(header=Header(frame_id='map'), child_frame_id='late')
        late.transform.rotation.w = 1.0
        self.transforms.publish(TFMessage(transforms=[self.camera_pose(), late]))
        self.rviz.wait_for(lambda: is_red(self.rviz.pixels()).any(), 'red pixels', DEADLINE)

    def test_a_floor_without_a_unit_normal_is_not_drawn(self):
        self.show_floor(lambda p: is_blue(p).any(), 'blue pixels')
        self.show_floor(lambda p: not is_blue(p).any(), 'the floor to go', normal=(0.0, 0.0, 0.0))


if __name__ == '__main__':
    rospy.init_node('test_displays')
    rostest.rosrun('polygonal_perception', 'test_displays', DisplaysTest, sys.argv)
