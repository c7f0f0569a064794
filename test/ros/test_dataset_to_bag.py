#!/usr/bin/env python3
"""Tiny data sets in both forms: what scripts/dataset_to_bag makes of them, read back from the bag."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy as np
import rosbag
import rosunit

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / 'scripts' / 'dataset_to_bag'
IMAGE = '/camera/depth/image_raw'
INFO = '/camera/depth/camera_info'


class DatasetToBagTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.bag = self.folder / 'out.bag'
        # 7 and not 8 wide: a step that is no multiple of four
        self.depth = np.arange(35, dtype=np.uint16).reshape(5, 7) * 1000

    def write_image(self, name, depth):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        self.assertTrue(cv2.imwrite(str(path), depth))

    def write_frames_json(self, sets, **change):
        entries = []
        for k, name in enumerate(sets):
            path = '%s/%d.png' % (name, k)
            self.write_image(path, self.depth + k)
            entry = {'set': name, 'depth': path, 'fx': 10.5, 'fy': 11.5, 'cx': 3.25, 'cy': 2.25, 'units_per_m': 1000}
            entries.append({key: value for key, value in dict(entry, **change).items() if value is not None})
        (self.folder / 'frames.json').write_text(json.dumps(entries))

    def write_depth_txt(self, lines):
        self.write_image('depth/a.png', self.depth)
        (self.folder / 'depth.txt').write_text('\n'.join(lines) + '\n')

    def run_script(self, *options):
        return subprocess.run([sys.executable, str(SCRIPT), str(self.folder), str(self.bag)] + list(options),
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)

    def convert(self, *options):
        """The images and the camera_infos in the bag, in its order."""
        result = self.run_script(*options)
        self.assertEqual(result.returncode, 0, result.stderr)
        images, infos = [], []
        with rosbag.Bag(str(self.bag)) as bag:
            for topic, message, stamp in bag.read_messages():
                self.assertEqual(message.header.stamp, stamp)
                self.assertEqual(message.header.frame_id, 'camera_depth_optical_frame')
                self.assertIn(topic, (IMAGE, INFO))
                (images if topic == IMAGE else infos).append(message)
        self.assertEqual([m.header.stamp for m in images], [m.header.stamp for m in infos])
        return images, infos

    def check_image(self, message, expected):
        self.assertEqual((message.height, message.width, message.step), expected.shape + (2 * expected.shape[1],))
        self.assertEqual((message.encoding, message.is_bigendian), ('16UC1', 0))
        np.testing.assert_array_equal(np.frombuffer(message.data, '<u2').reshape(expected.shape), expected)

    def check_refused(self, text, *options):
        self.bag.write_text('an older bag')
        result = self.run_script(*options)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn(text, result.stderr)
        self.assertNotIn('Traceback', result.stderr)
        self.assertEqual(self.bag.read_text(), 'an older bag')
        self.assertEqual(list(self.folder.glob('*.unfinished')), [])

    def test_frames_json(self):
        self.write_frames_json(['a', 'a', 'b'])
        images, infos = self.convert('--rate', '8')
        self.assertEqual([(m.header.stamp - images[0].header.stamp).to_nsec() for m in images],
                         [0, 125000000, 250000000])
        for k, message in enumerate(images):
            self.check_image(message, self.depth + k)
        for info in infos:
            self.assertEqual((info.height, info.width), self.depth.shape)
            self.assertEqual(list(info.K), [10.5, 0, 3.25, 0, 11.5, 2.25, 0, 0, 1])
            self.assertEqual(list(info.P), [10.5, 0, 3.25, 0, 0, 11.5, 2.25, 0, 0, 0, 1, 0])
            self.assertEqual((info.distortion_model, list(info.D)), ('plumb_bob', [0.0] * 5))

    def test_one_set_alone(self):
        self.write_frames_json(['a', 'b', 'a'])
        images, _ = self.convert('--only', 'a')
        self.assertEqual(len(images), 2)
        self.check_image(images[1], self.depth + 2)

    def test_other_units_become_millimetres_and_what_is_too_far_none(self):
        self.write_frames_json(['a'], units_per_m=500)
        images, _ = self.convert()
        expected = self.depth.astype(int) * 2
        self.assertGreater(expected.max(), 65535)
        self.check_image(images[0], np.where(expected > 65535, 0, expected).astype(np.uint16))

    def test_depth_txt(self):
        self.write_depth_txt(['# stamp path', '1305031453.374112 depth/a.png', '', '1305031453.300001 depth/a.png'])
        images, infos = self.convert()
        self.assertEqual([m.header.stamp.to_nsec() for m in images], [1305031453300001000, 1305031453374112000])
        self.check_image(images[0], np.rint(self.depth / 5.0).astype(np.uint16))
        self.assertEqual(list(infos[0].K), [525, 0, 319.5, 0, 525, 239.5, 0, 0, 1])

    def test_depth_txt_with_other_numbers(self):
        self.write_depth_txt(['1.0 depth/a.png', '3.0 depth/a.png'])
        images, infos = self.convert('--units-per-m', '1000', '--fx', '520.9', '--fy', '521', '--cx', '325.1',
                                     '--cy', '249.7', '--rate', '10')
        self.check_image(images[0], self.depth)
        self.assertEqual(list(infos[0].K), [520.9, 0, 325.1, 0, 521, 249.7, 0, 0, 1])
        self.assertEqual((images[1].header.stamp - images[0].header.stamp).to_nsec(), 100000000)

    def test_says_what_is_wrong(self):
        self.check_refused('neither a frames.json nor a depth.txt')
        self.write_depth_txt(['1.0'])
        self.check_refused('line 1')
        self.write_depth_txt(['1.0 depth/none.png'])
        self.check_refused('none.png: cannot be read')
        self.write_frames_json(['a'], fx=None)
        self.check_refused('frame 0 has no fx')
        self.write_frames_json(['a'])
        self.check_refused("no set 'b'; there are: a", '--only', 'b')
        self.write_image('a/0.png', np.zeros((5, 7), np.uint8))
        self.check_refused('uint8')
        self.check_refused('must be positive', '--rate', '0')


if __name__ == '__main__':
    rosunit.unitrun('polygonal_perception', 'dataset_to_bag', DatasetToBagTest)
