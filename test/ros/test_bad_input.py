#!/usr/bin/env python3
"""Messages that cannot be used: each is refused with a text that says why, counted, and the next good frame is answered."""
import sys
import unittest

import rospy
import rostest
from sensor_msgs.msg import PointField

import scene
from node_client import FOUND, Clock, NodeClient

LARGEST = 2 ** 32 - 1
NAN, INFINITY = float('nan'), float('inf')


def set_to(**values):
    """Spoils a message by other values of its fields; `header_...` are the header's."""
    def spoil(message):
        for name, value in values.items():
            if name.startswith('header_'):
                setattr(message.header, name[len('header_'):], value)
            else:
                setattr(message, name, value)
    return spoil


def field(index, **values):
    def spoil(message):
        set_to(**values)(message.fields[index])
    return spoil


def without_field(name):
    def spoil(message):
        message.fields = [f for f in message.fields if f.name != name]
    return spoil


def cut_to(size):
    def spoil(message):
        message.data = message.data[:size]
    return spoil


def calibration(fx=100.0, fy=100.0, cx=80.0, cy=60.0, projection=True):
    """Intrinsics in P, or in K alone where `projection` is false."""
    def spoil(info):
        info.K = [fx, 0, cx, 0, fy, cy, 0, 0, 1]
        info.P = [fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0] if projection else [0.0] * 12
    return spoil


HEADERS = {
    'an_empty_frame_id': (set_to(header_frame_id=''), 'header.frame_id is empty, accepted is the name of a tf frame'),
    'a_leading_slash': (set_to(header_frame_id='/camera'), "header.frame_id is '/camera', accepted is a name without a"),
    'the_floor_s_frame_id': (set_to(header_frame_id='floor'), "header.frame_id is 'floor', which is floor_frame"),
}
# The images of the camera have 160 x 120 pixels.
CLOUDS = {
    'a_height_of_1': (set_to(height=1), 'height is 1, accepted is an organised cloud'),
    'a_height_of_0': (set_to(height=0), 'height is 0, accepted is an organised cloud'),
    'a_huge_height': (set_to(height=LARGEST), 'height is 4294967295, accepted is 2 to 65535'),
    'a_height_beyond_the_data': (set_to(height=121), 'data has 307200 bytes, accepted is height x row_step = 309760'),
    'a_width_of_0': (set_to(width=0), 'width is 0, accepted is 2 to 65535'),
    'a_width_of_1': (set_to(width=1), 'width is 1, accepted is 2 to 65535'),
    'a_huge_width': (set_to(width=65536), 'width is 65536, accepted is 2 to 65535'),
    # 65536 x 65536 is 0 in 32 bits.
    'sizes_whose_product_overflows': (set_to(width=65536, height=65536, row_step=0), 'width is 65536, accepted is'),
    # 16 x 65535 x 65535 is 68717379600, and 4292870160 in 32 bits.
    'bytes_that_overflow': (set_to(width=65535, height=65535, row_step=16 * 65535),
                            'data has 307200 bytes, accepted is height x row_step = 68717379600'),
    'a_row_step_of_0': (set_to(row_step=0), 'row_step is 0, accepted is at least width x point_step = 2560'),
    'a_row_step_too_small': (set_to(row_step=2559), 'row_step is 2559, accepted is at least width x point_step = 2560'),
    'a_huge_row_step': (set_to(row_step=LARGEST), 'accepted is height x row_step = 515396075400'),
    'a_point_step_of_0': (set_to(point_step=0), "field 'x' at offset 0 does not fit a point_step of 0"),
    'a_point_step_too_small': (set_to(point_step=11), "field 'z' at offset 8 does not fit a point_step of 11"),
    'a_huge_point_step': (set_to(point_step=LARGEST), 'accepted is at least width x point_step = 687194767200'),
    'data_too_short': (cut_to(307199), 'data has 307199 bytes, accepted is height x row_step = 307200'),
    'no_data': (cut_to(0), 'data has 0 bytes, accepted is height x row_step = 307200'),
    'an_offset_past_the_point': (field(1, offset=13), "field 'y' at offset 13 does not fit a point_step of 16"),
    # 4294967295 + 4 is 3 in 32 bits.
    'an_offset_that_overflows': (field(0, offset=LARGEST), "field 'x' at offset 4294967295 does not fit a point_step of"),
    'a_count_of_2': (field(2, count=2), "field 'z' has count 2, accepted is 1"),
    'a_huge_count': (field(2, count=LARGEST), "field 'z' has count 4294967295, accepted is 1"),
    'big_endian': (set_to(is_bigendian=True), 'is_bigendian is true, accepted is false'),
    'no_fields': (set_to(fields=[]), "field 'x' is missing, needed are x, y and z"),
    **{'no_' + name: (without_field(name), "field '%s' is missing, needed are x, y and z" % name) for name in 'xyz'},
    **{'datatype_%d' % t: (field(0, datatype=t), "field 'x' has datatype %d, accepted is FLOAT32 (7)" % t)
       for t in (0, 1, 2, 3, 4, 5, 6, PointField.FLOAT64, 9, 255)},
}
IMAGES = {
    'a_height_of_0': (set_to(height=0), 'height is 0, accepted is 2 to 65535'),
    'a_width_of_0': (set_to(width=0), 'width is 0, accepted is 2 to 65535'),
    'a_width_of_1': (set_to(width=1), 'width is 1, accepted is 2 to 65535'),
    'a_huge_size': (set_to(width=LARGEST, height=LARGEST), 'width is 4294967295, accepted is 2 to 65535'),
    'sizes_whose_product_overflows': (set_to(width=65536, height=65536, step=0), 'width is 65536, accepted is 2 to 65535'),
    'bytes_that_overflow': (set_to(width=65535, height=65535, step=2 * 65535),
                            'data has 38400 bytes, accepted is height x step = 8589672450'),
    'a_step_of_0': (set_to(step=0), 'step is 0, accepted is at least 320'),
    'a_step_too_small': (set_to(step=319), 'step is 319, accepted is at least 320'),
    'a_huge_step': (set_to(step=LARGEST), 'data has 38400 bytes, accepted is height x step = 515396075400'),
    'data_too_short': (cut_to(38399), 'data has 38399 bytes, accepted is height x step = 38400'),
    'no_data': (cut_to(0), 'data has 0 bytes, accepted is height x step = 38400'),
    'data_of_half_the_metres': (set_to(encoding='32FC1'), 'step is 320, accepted is at least 640'),
    'big_endian': (set_to(is_bigendian=1), 'is_bigendian is true, accepted is false'),
    **{'encoding_' + (e or 'empty'): (set_to(encoding=e), "encoding is '%s', accepted are 16UC1 (mm) and 32FC1 (m)" % e)
       for e in ('', 'bgr8', '8UC1', '16SC1', '16UC3', '32FC3', '64FC1', 'mono8', '16uc1', 'compressed; png')},
}
INFOS = {
    'fx_of_0': (calibration(fx=0.0, projection=False), 'camera_info has fx, fy, cx, cy of 0, 100, 80, 60; accepted are finite'),
    'a_negative_fx': (calibration(fx=-1.0), 'camera_info has fx, fy, cx, cy of -1, 100, 80, 60'),
    'fx_of_nan': (calibration(fx=NAN), 'camera_info has fx, fy, cx, cy of nan, 100, 80, 60'),
    'an_infinite_fx': (calibration(fx=INFINITY), 'camera_info has fx, fy, cx, cy of inf, 100, 80, 60'),
    'fy_of_0': (calibration(fy=0.0), 'camera_info has fx, fy, cx, cy of 100, 0, 80, 60'),
    'fy_of_nan': (calibration(fy=NAN), 'camera_info has fx, fy, cx, cy of 100, nan, 80, 60'),
    'cx_of_nan': (calibration(cx=NAN), 'camera_info has fx, fy, cx, cy of 100, 100, nan, 60'),
    'an_infinite_cy': (calibration(cy=-INFINITY), 'camera_info has fx, fy, cx, cy of 100, 100, 80, -inf'),
    'no_calibration': (set_to(K=[0.0] * 9, P=[0.0] * 12), 'camera_info has fx, fy, cx, cy of 0, 0, 0, 0'),
    'another_size': (set_to(width=320, height=240), 'camera_info is for an image of 320x240, the image has 160x120'),
    'a_huge_size': (set_to(width=LARGEST, height=LARGEST), 'camera_info is for an image of 4294967295x4294967295, the'),
    'binning': (set_to(binning_x=2, binning_y=2), 'camera_info is for an image of 80x60, the image has 160x120'),
    'huge_binning': (set_to(binning_x=LARGEST), 'camera_info is for an image of 0x120, the image has 160x120'),
}


class BadInputTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.depth = rospy.get_param('~input') == 'depth'
        cls.client = NodeClient(depth=cls.depth)
        cls.clock = Clock()
        cls.camera = scene.Camera()
        cls.image = cls.camera.render()
        cls.good_frames = 0

    def frame(self, spoil_frame=None, spoil_info=None):
        """A frame's messages, and its stamp."""
        stamp = self.clock.tick()
        messages = [self.camera.image(self.image, stamp), self.camera.info(stamp)] if self.depth else [
            self.camera.cloud(self.image, stamp)]
        for spoil, message in zip((spoil_frame, spoil_info), messages):
            if spoil:
                spoil(message)
        return messages, stamp

    def reports(self, condition, what):
        """The diagnostics' values once something holds of them."""
        status = self.client.wait_for_diagnostics(lambda s: condition({v.key: v.value for v in s.values}), what)
        return {v.key: v.value for v in status.values}

    def answered(self):
        """A good frame has its answer."""
        messages, stamp = self.frame()
        self.client.send(*messages)
        self.assertEqual(self.client.answer(stamp)['floor'].status, FOUND)
        type(self).good_frames += 1

    def check(self, text, **spoil):
        self.answered()
        # A report from before that frame may still be on its way.
        count = int(self.reports(lambda v: int(v['Frames answered']) == self.good_frames, 'the good frame')['Frames rejected'])
        messages, spoilt = self.frame(**spoil)
        self.client.send(*messages)
        values = self.reports(lambda v: int(v['Frames rejected']) > count and text in v['Last rejection'],
                              'a rejection with "%s"' % text)
        self.assertEqual(int(values['Frames rejected']), count + 1)
        self.assertEqual(self.client.answered(spoilt), [], 'the spoilt frame was answered')
        self.answered()

    def test_the_log_has_the_reason(self):
        # It is throttled, so that the frame may have to come again.
        def complained():
            self.client.send(*self.frame(HEADERS['a_leading_slash'][0])[0])
            return any('header.frame_id is' in log.msg for log in self.client.logs)
        self.client.wait_for(complained, 'a complaint in the log')


def add_tests(table, argument):
    for name, (spoil, text) in table.items():
        def test(self, spoil=spoil, text=text):
            self.check(text, **{argument: spoil})
        setattr(BadInputTest, 'test_' + name + ('_in_info' if argument == 'spoil_info' else ''), test)


if __name__ == '__main__':
    rospy.init_node('test_bad_input')
    add_tests(HEADERS, 'spoil_frame')
    if rospy.get_param('~input') == 'depth':
        add_tests(IMAGES, 'spoil_frame')
        add_tests(INFOS, 'spoil_info')
    else:
        add_tests(CLOUDS, 'spoil_frame')
    rostest.rosrun('polygonal_perception', 'test_bad_input', BadInputTest, sys.argv)
