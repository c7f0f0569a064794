#!/usr/bin/env python3
"""Random bytes, and frames whose fields are random, on every input: each good frame between them is answered."""
import random
import sys
import time
import unittest

import rospy
import rostest

import scene
from node_client import FOUND, Clock, NodeClient

SEED = 3
MOST_IN_A_BURST = 8
SIZES = [0, 1, 2, 3, 16, 119, 120, 160, 320, 2560, 65535, 65536, 2 ** 31, 2 ** 32 - 1]
NUMBERS = [0.0, -1.0, 1e-310, 1e300, float('inf'), float('-inf'), float('nan'), 142.0, 80.0]


def random_bytes(kind, rng):
    """A message of this kind that is sent as nothing but noise."""
    class Noise(kind):
        def serialize(self, buff):
            buff.write(rng.getrandbits(8 * size).to_bytes(size, 'little') if size else b'')
    size = rng.choice([0, 1, 3, 4, 11, 12, 13, 16, 17, 64, 400, 4000])
    return Noise()


def spoil(message, rng):
    """Gives some of the fields values of their types that make no sense."""
    for _ in range(rng.randint(1, 3)):
        name = rng.choice([n for n in message.__slots__ if n != 'header'])
        value = getattr(message, name)
        if isinstance(value, bool) or name == 'is_bigendian':
            setattr(message, name, not value)
        elif isinstance(value, int):
            setattr(message, name, rng.choice(SIZES))
        elif isinstance(value, str):
            setattr(message, name, rng.choice(['', '32FC1', '16UC1', 'bgr8', '\x01\x02']))
        elif isinstance(value, bytes):
            setattr(message, name, rng.getrandbits(8 * 4000).to_bytes(4000, 'little')[:rng.randint(0, 4000)])
        elif name in ('K', 'P', 'R'):
            setattr(message, name, [rng.choice(NUMBERS) for _ in value])
        elif name == 'fields' and value:
            field = rng.choice(value)
            field.name = rng.choice(['x', 'y', 'z', 'intensity', ''])
            field.offset, field.datatype, field.count = rng.choice(SIZES), rng.randint(0, 9), rng.choice([0, 1, 2])
        elif name == 'roi':
            value.x_offset, value.width, value.height = (rng.choice(SIZES) for _ in range(3))
    return message


class NoiseTest(unittest.TestCase):
    def test_every_good_frame_is_answered(self):
        depth = rospy.get_param('~input') == 'depth'
        client, clock, camera = NodeClient(depth=depth), Clock(), scene.Camera()
        image = camera.render()
        rng = random.Random(SEED)

        def frame():
            stamp = clock.tick()
            return [camera.info(stamp), camera.image(image, stamp)] if depth else [camera.cloud(image, stamp)]

        good = noise = 0
        end = time.monotonic() + rospy.get_param('~seconds')
        while time.monotonic() < end:
            for _ in range(rng.randint(1, MOST_IN_A_BURST)):
                for publisher, message in zip(client.publishers[::-1] if depth else client.publishers, frame()):
                    publisher.publish(random_bytes(publisher.data_class, rng) if rng.random() < 0.5 else spoil(message, rng))
                    noise += 1
            # The node takes the newest.
            messages = frame()
            client.send(*messages)
            self.assertEqual(client.answer(messages[0].header.stamp)['floor'].status, FOUND, 'after %d messages' % noise)
            good += 1
            client.answers.clear()
        print('%d good frames answered between %d messages of noise' % (good, noise))
        self.assertGreater(good, 0)


if __name__ == '__main__':
    rospy.init_node('test_noise')
    rostest.rosrun('polygonal_perception', 'test_noise', NoiseTest, sys.argv)
