#!/usr/bin/env python3
"""Random bytes, and messages whose fields are random, on every input: each good frame between them is answered."""
import random
import struct
import sys
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import Point32, Polygon, TransformStamped
from tf2_msgs.msg import TFMessage

import scene
from garbage import GarbagePublisher, ServersOf, random_bytes
from node_client import Clock
from subjects import subject_of

SEED = 3
MOST_IN_A_BURST = 8
SIZES = [0, 1, 2, 3, 16, 119, 120, 160, 320, 2560, 65535, 65536, 2 ** 31, 2 ** 32 - 1]
NUMBERS = [0.0, -1.0, 1e-310, 1e300, float('inf'), float('-inf'), float('nan'), 142.0, 80.0]
SINGLES = [n for n in NUMBERS if not 1e38 < abs(n) < float('inf')]  # that single precision can hold


def noise(kind, rng):
    """A message of this kind that is sent as nothing but random bytes."""
    class Noise(kind):
        def serialize(self, buff):
            buff.write(content)
    content = random_bytes(rng, rng.choice([0, 1, 3, 4, 11, 12, 13, 16, 17, 64, 400, 4000]))
    if kind is TFMessage:
        # A number of transforms. roscpp makes room for them before it looks whether they are there: more would take all memory.
        content = struct.pack('<I', rng.randrange(1000)) + content
    return Noise()


def spoil_ring(ring, rng):
    ring.points = ring.points[rng.randint(0, 2):] + rng.choice([[], ring.points])
    if ring.points:
        k = rng.randrange(len(ring.points))
        ring.points[k] = Point32(*(rng.choice(SINGLES + [1.5, 3.0]) for _ in range(3)))


def spoil(message, rng):
    """Gives some of the fields values of their types that make no sense."""
    for _ in range(rng.randint(1, 3)):
        name = rng.choice([n for n in message.__slots__ if n != 'header'])
        value = getattr(message, name)
        if isinstance(value, bool) or name == 'is_bigendian':
            setattr(message, name, not value)
        elif name == 'floor_status':
            message.floor_status = rng.randrange(256)
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
        elif name == 'slab_height':
            message.slab_height = rng.choice(SINGLES)
        elif name == 'inflation_radius':
            message.inflation_radius = rng.choice(NUMBERS)
        elif name == 'extent':
            spoil_ring(value, rng)
        elif name == 'polygons':
            for polygon in value:
                polygon.holes = [Polygon(list(polygon.boundary.points)) for _ in range(rng.randint(0, 2))]
                spoil_ring(rng.choice([polygon.boundary, *polygon.holes]), rng)
        elif name == 'info':
            value.width, value.height, value.resolution = rng.choice(SIZES), rng.choice(SIZES), rng.choice(SINGLES)
            value.origin.position.x, value.origin.orientation.z = rng.choice(NUMBERS), rng.choice(NUMBERS)
        elif name == 'roi':
            value.x_offset, value.width, value.height = (rng.choice(SIZES) for _ in range(3))
    return message


def random_transforms(rng, stamp):
    """Of frames that nobody asks for, in circles and with numbers that make no rotation."""
    message = TFMessage()
    for _ in range(rng.randint(0, 5)):
        transform = TransformStamped(child_frame_id=rng.choice(['', '/', 'a', 'b', 'c', 'x' * 10000]))
        transform.header.frame_id = rng.choice(['', '/', 'a', 'b', 'c'])
        transform.header.stamp = stamp + rospy.Duration(rng.uniform(-100.0, 100.0))
        t, r = transform.transform.translation, transform.transform.rotation
        t.x, t.y, t.z, r.x, r.y, r.z, r.w = (rng.choice(NUMBERS) for _ in range(7))
        message.transforms.append(transform)
    return message


class NoiseTest(unittest.TestCase):
    def test_every_good_frame_is_answered(self):
        subject = subject_of(rospy.get_param('~input'))
        client, clock, camera = subject.client, Clock(), scene.Camera()
        rng = random.Random(SEED)
        place = rospy.Publisher('/tf_static', TFMessage, queue_size=10, latch=True)
        place.publish(TFMessage([scene.transform('odom', scene.OPTICAL_FRAME, camera.position, camera.rotation)]))
        tf = rospy.Publisher('/tf', TFMessage, queue_size=10)
        client.wait_for(lambda: place.get_num_connections() > 0 and tf.get_num_connections() > 0, 'the node to listen to tf')
        garbage = [GarbagePublisher(p.resolved_name, p.data_class, rng.getrandbits(32)) for p in [*client.publishers, tf]]
        servers = ServersOf(client.node, client.node + '/' + subject.OUTPUT)

        def frame():
            # Of an image its calibration comes first.
            return subject.messages(clock.tick())[::-1]

        # A map takes on the heights of the first message.
        client.send(*frame())
        good = bad = 0
        end = time.monotonic() + rospy.get_param('~seconds')
        while time.monotonic() < end:
            for _ in range(rng.randint(1, MOST_IN_A_BURST)):
                for publisher, message in zip(client.publishers[::-1], frame()):
                    publisher.publish(noise(publisher.data_class, rng) if rng.random() < 0.5 else spoil(message, rng))
                    bad += 1
            servers.garble(rng)
            tf.publish(noise(TFMessage, rng) if rng.random() < 0.5 else random_transforms(rng, clock.now))
            # The node takes the newest.
            messages = frame()
            client.send(*messages)
            answer = client.answer(messages[0].header.stamp)
            self.assertTrue(subject.is_good(answer), 'after %d messages: %s' % (bad, answer))
            good += 1
            client.answers.clear()
        streams = [stream.connections for stream in garbage]
        print('%d good frames answered between %d messages of noise and %s connections full of garbage' % (good, bad, streams))
        self.assertGreater(min([good, *streams]), 0)


if __name__ == '__main__':
    rospy.init_node('test_noise')
    rostest.rosrun('polygonal_perception', 'test_noise', NoiseTest, sys.argv)
