#!/usr/bin/env python3
"""Messages that cannot be used: each is refused with a text that says why, counted, and the next good frame is answered.

Those that are only strange are answered, and those in which nothing is seen without a floor of this frame.
"""
import sys
import unittest

import rospy
import rostest

from bad_messages import (CELLS, CLOUDS, EMPTY, EMPTY_IMAGES, HEADERS, IMAGES, INFOS, STRANGE_CELLS, STRANGE_CLOUDS, STRANGE_HEADERS,
                          STRANGE_IMAGES, STRANGE_INFOS)
from node_client import FOUND, Clock
from subjects import subject_of


class BadInputTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.depth = rospy.get_param('~input') == 'depth'
        cls.subject = subject_of(rospy.get_param('~input'))
        cls.client = cls.subject.client
        cls.clock = Clock()
        cls.good_frames = 0
        if cls.depth:
            (image, _), _ = cls.frame()
            cls.client.send(image)
            cls.reports(lambda v: 'no camera_info has come yet on /camera/depth/camera_info' in v['Last rejection'], 'no camera_info')

    @classmethod
    def frame(cls, spoil_frame=None, spoil_info=None):
        """A frame's messages, and its stamp."""
        stamp = cls.clock.tick()
        messages = cls.subject.messages(stamp)
        for spoil, message in zip((spoil_frame, spoil_info), messages):
            if spoil:
                spoil(message)
        return messages, stamp

    @classmethod
    def reports(cls, condition, what):
        """The diagnostics' values once something holds of them."""
        status = cls.client.wait_for_diagnostics(lambda s: condition({v.key: v.value for v in s.values}), what)
        return {v.key: v.value for v in status.values}

    def answer(self, **spoil):
        messages, stamp = self.frame(**spoil)
        self.client.send(*messages)
        type(self).good_frames += 1
        return self.client.answer(stamp)

    def answered(self, **spoil):
        """A good frame has its answer."""
        answer = self.answer(**spoil)
        self.assertTrue(self.subject.is_good(answer), answer)

    def check_empty(self, spoil):
        self.answered()
        self.assertNotEqual(self.answer(spoil_frame=spoil)['floor'].status, FOUND)
        self.answered()

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


def add_tests(table, check):
    for name, row in table.items():
        def test(self, row=row):
            check(self, row)
        assert not hasattr(BadInputTest, 'test_' + name), name
        setattr(BadInputTest, 'test_' + name, test)


def add_bad(table, argument):
    add_tests(table, lambda test, row: test.check(row[1], **{argument: row[0]}))


def add_strange(table, argument):
    add_tests(table, lambda test, spoil: test.answered(**{argument: spoil}))


if __name__ == '__main__':
    rospy.init_node('test_bad_input')
    kind = rospy.get_param('~input')
    if kind == 'cells':
        add_bad({name: row for name, row in HEADERS.items() if name != 'the_floor_s_frame_id'}, 'spoil_frame')
        add_bad(CELLS, 'spoil_frame')
        add_strange(STRANGE_CELLS, 'spoil_frame')
    else:
        add_bad(HEADERS, 'spoil_frame')
        add_strange(STRANGE_HEADERS, 'spoil_frame')
        add_tests(EMPTY, BadInputTest.check_empty)
    if kind == 'depth':
        add_bad(IMAGES, 'spoil_frame')
        add_bad({name + '_in_info': row for name, row in INFOS.items()}, 'spoil_info')
        add_strange(STRANGE_IMAGES, 'spoil_frame')
        add_strange({name + '_in_info': row for name, row in STRANGE_INFOS.items()}, 'spoil_info')
        add_tests(EMPTY_IMAGES, BadInputTest.check_empty)
    elif kind == 'cloud':
        add_bad(CLOUDS, 'spoil_frame')
        add_strange(STRANGE_CLOUDS, 'spoil_frame')
    rostest.rosrun('polygonal_perception', 'test_bad_input', BadInputTest, sys.argv)
