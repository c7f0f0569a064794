#!/usr/bin/env python3
"""The depth image by compressedDepth; a transport that is not installed, and a topic of another type, are said."""
import struct
import sys
import unittest
import zlib

import numpy as np
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from sensor_msgs.msg import CompressedImage

import scene
from node_client import FOUND, Clock, NodeClient


def png(depth):
    """A PNG of 16-bit grey values."""
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    height, width = depth.shape
    rows = b''.join(b'\0' + row.astype('>u2').tobytes() for row in depth)
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 16, 0, 0, 0, 0)) +
            chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))


class CompressedDepthTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = NodeClient((), depth=True, image='unused')
        for output in ('floor', 'polygons'):
            cls.client.read(output)
        cls.compressed = rospy.Publisher('/camera/depth/image_rect/compressedDepth', CompressedImage, queue_size=10)
        cls.clock = Clock()
        cls.camera = scene.Camera()
        cls.said = {}
        cls.diagnostics = rospy.Subscriber('/diagnostics', DiagnosticArray, cls.keep)

    @classmethod
    def keep(cls, message):
        for status in message.status:
            cls.said[status.name.partition(':')[0]] = status.message

    def image(self, stamp):
        depth = np.round(np.nan_to_num(self.camera.render([scene.Box((1.8, 2.2), (-0.4, 0.1), (0, 0.3))])) * 1000.0)
        message = CompressedImage(format='16UC1; compressedDepth png', data=bytes(12) + png(depth))
        message.header.stamp, message.header.frame_id = stamp, scene.OPTICAL_FRAME
        return message

    def test_frames_come_compressed(self):
        self.client.wait_for(lambda: self.compressed.get_num_connections() > 0, 'the node to read the compressed image')
        stamp = self.clock.tick()
        self.client.send(self.camera.info(stamp))
        self.compressed.publish(self.image(stamp))
        answer = self.client.answer(stamp)
        self.assertEqual(answer['floor'].status, FOUND)
        self.assertAlmostEqual(answer['floor'].distance, self.camera.height, delta=0.002)
        polygon, = answer['polygons'].polygons
        self.assertTrue(scene.inside((1.9, -0.1), [(p.x, p.y) for p in polygon.boundary.points]))

    def wait_for_word(self, node, *texts):
        self.client.wait_for(lambda: all(text in self.said.get(node, '') for text in texts),
                             '%s to say %s; it says %r' % (node, texts, self.said.get(node)))

    def test_a_transport_that_is_not_installed_is_said(self):
        self.wait_for_word('unknown_transport', 'cannot subscribe', 'carrierPigeon')

    def test_a_topic_of_another_type_is_said(self):
        self.wait_for_word('other_type', 'waiting for /camera/depth/image_rect/compressedDepth',
                           'published as sensor_msgs/CompressedImage')
        self.client.wait_for_log('/camera/depth/image_rect/compressedDepth', 'published as sensor_msgs/CompressedImage')


if __name__ == '__main__':
    rospy.init_node('test_compressed_depth')
    rostest.rosrun('polygonal_perception', 'test_compressed_depth', CompressedDepthTest, sys.argv)
