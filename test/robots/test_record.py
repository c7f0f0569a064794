#!/usr/bin/env python3
"""record.launch keeps what replay.launch needs: the same frames give the same polygons once more."""
import os
import sys
import tempfile
import unittest

import numpy as np
import rosbag
import rospy
import rostest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', 'ros'))
from launched import Launched  # noqa: E402
from node_client import FOUND, NodeClient  # noqa: E402

FRAMES = 20


def complete(client):
    return [k for k, a in list(client.answers.items()) if {'floor', 'polygons'} <= set(a) and a['floor'].status == FOUND]


def corners(polygons):
    return [[(p.x, p.y) for p in polygon.boundary.points] for polygon in polygons.polygons]


class RecordTest(unittest.TestCase):
    def record(self, path):
        """Records a simulated Robotino, and returns what the pipeline said meanwhile, by stamp."""
        with Launched('robotino.launch', simulation='true', rviz='false', rate='5'):
            client = NodeClient(outputs=())
            with Launched('record.launch', bag=path):
                client.wait_for(lambda: os.path.exists(path + '.active'), 'the bag', 60.0)
                client.read('floor')
                client.read('polygons')
                client.wait_for(lambda: len(complete(client)) >= FRAMES, 'answers', 90.0)
            return self.answers_of(client)

    def replay(self, path, stamps):
        """What the pipeline says of the same stamps when the bag is played."""
        # The bag holds the floor frame of the first run.
        with Launched('replay.launch', bag=path, rviz='false', rate='0.5', publish_tf='false', output_frame='odom',
                      config=os.path.join(os.path.dirname(os.path.realpath(__file__)), '..', '..', 'config', 'robotino.yaml')):
            client = NodeClient(outputs=())
            client.read('floor')
            client.read('polygons')
            client.wait_for(lambda: len(stamps & set(complete(client))) >= FRAMES // 2, 'answers of the bag', 90.0)
            return self.answers_of(client)

    @staticmethod
    def answers_of(client):
        # Or the next run's would come among them.
        for name in list(client.readers):
            client.stop_reading(name)
        return {stamp: dict(answer) for stamp, answer in client.answers.items()}

    def test_a_recording_gives_the_same_polygons(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'run.bag')
            first = self.record(path)
            with rosbag.Bag(path) as bag:
                self.assertEqual(bag.get_compression_info().compression, 'lz4')
                topics = bag.get_type_and_topic_info().topics
                self.assertLessEqual({'/camera/depth/image_raw', '/camera/depth/camera_info', '/tf', '/tf_static'}, set(topics))
                stamps = {m.header.stamp.to_nsec() for _, m, _ in bag.read_messages('/camera/depth/image_raw')}
            second = self.replay(path, stamps & set(first))
        compared = 0
        for stamp in sorted(set(first) & set(second)):
            before, after = first[stamp], second[stamp]
            if not all({'floor', 'polygons'} <= set(a) and a['floor'].status == FOUND for a in (before, after)):
                continue
            compared += 1
            self.assertAlmostEqual(before['floor'].distance, after['floor'].distance, delta=0.002)
            self.assertEqual(after['polygons'].header.frame_id, 'odom')
            self.assertEqual(len(corners(before['polygons'])), len(corners(after['polygons'])))
            # The first floor has no predecessor, so that the plane differs a little, and with it a cell here and there.
            for ring, again in zip(corners(before['polygons']), corners(after['polygons'])):
                for box in (np.min, np.max):
                    self.assertLess(np.abs(box(ring, 0) - box(again, 0)).max(), 0.06)
        self.assertGreaterEqual(compared, FRAMES // 2)


if __name__ == '__main__':
    rospy.init_node('test_record')
    rostest.rosrun('polygonal_perception', 'test_record', RecordTest, sys.argv)
