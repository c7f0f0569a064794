#!/usr/bin/env python3
"""scripts/map_from_bag on bags of a known scene: the map that it makes, and what it says of bags that give none."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy as np
import rospy
import rosunit
import yaml

import recorded_run
import scene

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / 'scripts' / 'map_from_bag'
ENDINGS = ('.geojson', '.pgm', '.yaml', '.png')
CELL, RADIUS, TOLERANCE = 0.05, 0.3, 0.05  # [m] the nodes' defaults
FREE, OCCUPIED, UNSEEN = 254, 0, 205


def distance(box, points):
    """[m] from points to a box, seen from above."""
    return np.hypot(*(np.maximum(np.maximum(box.low[a] - points[..., a], points[..., a] - box.high[a]), 0.0) for a in (0, 1)))


class Map:
    """What was written."""

    def __init__(self, base):
        description = yaml.safe_load(base.with_suffix('.yaml').read_text())
        self.origin, self.resolution = np.array(description['origin'][:2]), description['resolution']
        self.cells = cv2.imread(str(base.with_name(description['image'])), cv2.IMREAD_UNCHANGED)[::-1]
        document = json.loads(base.with_suffix('.geojson').read_text())
        self.frame = document['frame_id']
        self.polygons = [[[tuple(p) for p in ring[:-1]] for ring in f['geometry']['coordinates']] for f in document['features']]

    def at(self, x, y):
        column, row = np.floor((np.array([x, y]) - self.origin) / self.resolution).astype(int)
        return self.cells[row, column]

    def middles(self, value):
        rows, columns = np.nonzero(self.cells == value)
        return np.stack([columns + 0.5, rows + 0.5], -1) * self.resolution + self.origin

    def covers(self, point):
        """Whether a point is in a polygon."""
        return any(sum(scene.inside(point, ring) for ring in rings) % 2 for rings in self.polygons)


class MapFromBagTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_script(self, *words):
        return subprocess.run([sys.executable, str(SCRIPT), *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, check=False, timeout=120)

    def make(self, *words):
        result = self.run_script(*words)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def check_refused(self, bag, text, *words):
        """One sentence, an exit code, and no file."""
        before = sorted(self.folder.rglob('*'))
        result = self.run_script(bag, *words)
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertEqual(result.stdout, '')
        self.assertIn(text, result.stderr)
        self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)
        self.assertEqual(sorted(self.folder.rglob('*')), before)

    def files(self, folder, *names):
        return {name + ending: (folder / (name + ending)).read_bytes() for name in names for ending in ENDINGS}

    def check_map(self, base):
        """Every cell and polygon against the scene."""
        found = Map(base)
        self.assertEqual((found.frame, found.resolution), ('odom', CELL))
        occupied = found.middles(OCCUPIED)
        self.assertGreater(len(occupied), 0)
        # A cell of the frame lies across the map's cells, so that a point may be a cell's diagonal beside its own.
        near = CELL * 2 ** 0.5 + 0.02
        nearest = np.min([distance(box, occupied) for box in recorded_run.STANDING.values()], 0)
        worst = nearest.argmax()
        self.assertLess(nearest[worst], near, 'cell %s is occupied, the nearest box is %.3f m away' % (occupied[worst], nearest[worst]))
        free = found.middles(FREE)
        for name, box in recorded_run.STANDING.items():
            depth_inside = np.min([free[:, a] - box.low[a] for a in (0, 1)] + [box.high[a] - free[:, a] for a in (0, 1)], 0)
            worst = depth_inside.argmax()
            self.assertLess(depth_inside[worst], CELL, 'cell %s is free, which is %.3f m inside of the %s' % (
                free[worst], depth_inside[worst], name))
        # What the robot looked at from the front.
        for name, box in recorded_run.STANDING.items():
            y_low, y_high = max(box.low[1], -1.2), min(box.high[1], 1.2)
            for y in np.arange(y_low + 0.025, y_high, CELL):
                front = np.array([box.low[0], y])
                gap = np.min(np.linalg.norm(occupied - front, axis=1))
                self.assertLess(gap, near, 'the %s has its front at %s, the nearest occupied cell is %.3f m away' % (name, front, gap))
                grown = (front[0] - RADIUS + 0.01, y)
                self.assertTrue(found.covers(grown), '%s is in no polygon, and %.2f m before the %s' % (grown, RADIUS - 0.01, name))
        for x, y in [(1.0, 0.0), (2.2, -0.2), (2.2, 0.1), (3.4, 0.0), (3.0, 1.3), (3.2, -0.9)]:
            self.assertEqual(found.at(x, y), FREE, 'nothing stands at (%.1f, %.1f), and the floor was in view' % (x, y))
        far = RADIUS + 1.5 * CELL + TOLERANCE + near
        for x, y in [(x, y) for x in np.arange(0.0, 4.4, 0.2) for y in np.arange(-2.0, 2.0, 0.2)]:
            gap = min(distance(box, np.array([x, y])) for box in recorded_run.STANDING.values())
            if gap > far:
                self.assertFalse(found.covers((x, y)), '(%.1f, %.1f) is in a polygon, the nearest box is %.2f m away' % (x, y, gap))
        self.assertEqual(found.at(0.0, -5.0), UNSEEN)

    def test_a_map_of_depth_images_and_of_clouds(self):
        depth, cloud = (recorded_run.write(self.folder / (kind + '.bag'), kind=kind) for kind in ('depth', 'cloud'))
        text = self.make(depth, cloud)
        for name in ('depth', 'cloud'):
            with self.subTest(name):
                self.check_map(self.folder / name)
                self.assertGreater(cv2.imread(str(self.folder / (name + '.png'))).shape[1], 400)
        self.assertEqual(text.count('40 answered, 0 refused'), 2, text)
        self.assertEqual([p.name for p in self.folder.iterdir() if p.name.startswith('.')], [])

    def test_side_by_side_is_the_same_as_one_after_the_other(self):
        bags = [recorded_run.write(self.folder / (name + '.bag'), seconds, compression=compression)
                for name, seconds, compression in (('short', 1.5, 'none'), ('long', 3.0, 'bz2'))]
        self.make('--output', self.folder / 'one', *bags)
        self.make('--output', self.folder / 'two', '--jobs', 2, *bags)
        one, two = (self.files(self.folder / folder, 'short', 'long') for folder in ('one', 'two'))
        self.assertEqual([name for name in one if one[name] != two[name]], [])

    def test_frames_that_are_refused_are_told_by_reason(self):
        def change(k, messages):
            for topic, message in messages.items():
                if topic.endswith('image_raw') and k in (20, 21, 30):
                    message.encoding = 'rgb8'
                elif topic.endswith('image_raw') and k == 35:
                    message.header.stamp = rospy.Time()
            return messages
        text = self.make(recorded_run.write(self.folder / 'run.bag', tf_from=0.95, change=change))
        self.assertIn('26 answered, 14 refused', text)
        self.assertIn("1 x no transform from 'camera_depth_optical_frame': header.stamp is 0", text)
        self.assertIn("10 x no transform from 'camera_depth_optical_frame' to 'odom'", text)
        self.assertIn("3 x depth image rejected: encoding is 'rgb8'", text)

    def test_parameters_reach_the_nodes(self):
        bag = recorded_run.write(self.folder / 'run.bag', 0.5)
        (self.folder / 'config.yaml').write_text('robot_radius: 0.1\ngrid_resolution: 0.1\n')
        self.make(bag, '--config', self.folder / 'config.yaml', 'map_size:=4', 'robot_frame:=nobody')
        found = Map(self.folder / 'run')
        self.assertEqual((found.cells.shape, found.resolution), ((40, 40), 0.1))
        self.assertEqual(json.loads((self.folder / 'run.geojson').read_text())['inflation_radius'], 0.1)

    def test_bags_that_give_no_map(self):
        """A sentence each, and the others come to their maps."""
        good = recorded_run.write(self.folder / 'good.bag', 0.5)
        whole = good.read_bytes()
        expected = {'none': 'there is no such file', 'empty': 'it is empty', 'text': 'it cannot be read', 'cut': 'it has no index',
                    'damaged': 'it cannot be read', 'placeless': 'it holds no tf',
                    'blind': 'it has no depth images with camera_info and no organised clouds'}
        paths = {name: self.folder / (name + '.bag') for name in expected}
        for name, content in (('empty', b''), ('text', b'no bag at all'), ('cut', whole[:len(whole) // 2]),
                              ('damaged', whole[:5000] + bytes(1000) + whole[6000:])):
            paths[name].write_bytes(content)
        recorded_run.write(paths['placeless'], 0.5, with_tf=False)
        recorded_run.write(paths['blind'], 0.5, change=lambda *_: {})
        result = self.run_script(*paths.values(), good)
        self.assertEqual(result.returncode, 1)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), len(expected), result.stderr)
        for (name, text), line in zip(expected.items(), lines):
            self.assertIn('%s: %s' % (paths[name], text), line)
        self.assertEqual(len(self.files(self.folder, 'good')), len(ENDINGS))
        self.assertEqual([p.name for p in self.folder.iterdir() if p.suffix != '.bag' and p.stem != 'good'], [])

    def test_a_reader_that_is_not_wanted_any_more_ends_without_a_word(self):
        """At once, too, when it still has the handlers of the process that began it."""
        bag = recorded_run.write(self.folder / 'run.bag', 0.5)
        program = '\n'.join((
            'import pathlib, signal, sys',
            'sys.path.insert(0, sys.argv[1])',
            'from bag_mapping.read_ahead import ReadAhead',
            'signal.signal(signal.SIGTERM, signal.default_int_handler)',
            'for _ in range(300):',
            '    with ReadAhead(pathlib.Path(sys.argv[2]), []): pass'))
        result = subprocess.run([sys.executable, '-c', program, str(SCRIPT.parent), str(bag)], capture_output=True, text=True, timeout=60)
        self.assertEqual((result.returncode, result.stderr), (0, ''))

    def test_what_is_asked_for_and_not_there(self):
        good = recorded_run.write(self.folder / 'good.bag', 0.5)
        self.check_refused(good, "does not lead from 'camera_depth_optical_frame' to 'map'; it knows base_link", 'fixed_frame:=map')
        self.check_refused(good, "it has no camera '/other'; there are: /camera", '--camera', 'other')
        self.check_refused(good, 'robot_radius is 99, accepted is 0 to 5 m', 'robot_radius:=99')

    def test_bad_options(self):
        bag = self.folder / 'run.bag'
        self.check_refused(bag, "no node has a parameter 'robot_raduis'", 'robot_raduis:=0.2')
        self.check_refused(bag, 'none.yaml', '--config', self.folder / 'none.yaml')
        for words in (['--nonsense'], ['--jobs', '-1'], ['robot_radius:=0.2'], ['--image', 'a', '--points', 'b', bag], [bag, bag]):
            result = self.run_script(*words)
            self.assertEqual((result.returncode, result.stdout), (2, ''), words)
            self.assertNotIn('Traceback', result.stderr)


if __name__ == '__main__':
    rosunit.unitrun('polygonal_perception', 'map_from_bag', MapFromBagTest)
