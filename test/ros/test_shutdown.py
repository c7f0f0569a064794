#!/usr/bin/env python3
"""Nodes and managers that are told to end while frames arrive end cleanly, and start again."""
import os
import signal
import subprocess
import sys
import threading
import unittest

import rospy
import rostest

import launched
from node_client import DEADLINE, Clock
from subjects import SUBJECTS

# What a program says that did not end cleanly.
BAD_SIGNS = ('lock_error', 'terminate called', 'Assertion', 'Segmentation', 'Sanitizer', 'pure virtual')


class ShutdownTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.subject = SUBJECTS[rospy.get_param('~subject')](outputs=(), runs=False)
        cls.client, cls.clock = cls.subject.client, Clock()
        arguments = ['__name:=' + cls.subject.NAME[1:], *('%s:=%s' % item for item in cls.subject.REMAPPED.items()),
                     *('_%s:=%s' % item for item in cls.subject.PARAMETERS.items())]
        cls.commands = {
            'node': [launched.program(cls.subject.PROGRAM), *arguments],
            'nodelet': ['rosrun', 'nodelet', 'nodelet', 'standalone', 'polygonal_perception/' + cls.subject.NODELET, *arguments],
        }
        cls.running = threading.Event()
        cls.running.set()
        cls.thread = threading.Thread(target=cls.publish)
        cls.thread.start()

    @classmethod
    def tearDownClass(cls):
        cls.running.clear()
        cls.thread.join()

    @classmethod
    def publish(cls):
        rate = rospy.Rate(100)
        while cls.running.is_set():
            cls.client.send(*cls.subject.messages(cls.clock.tick()))
            rate.sleep()

    def live(self, command, wait_for_answer, end=signal.SIGINT):
        """Starts a program, ends it as roslaunch and Ctrl-C do (or kills it), and checks how it ended."""
        program = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                                   start_new_session=True)
        begin = self.clock.now.to_nsec()
        # A fresh reader, since rospy may have missed that the topic was away for a moment.
        self.client.read(self.subject.OUTPUT)
        try:
            if wait_for_answer:
                self.client.wait_for(lambda: any(k > begin and self.subject.is_good(a)
                                                 for k, a in list(self.client.answers.items())), 'an answer')
            else:
                self.client.wait_for(lambda: self.client.publishers[0].get_num_connections() > 0 or program.poll() is not None,
                                     'the node to subscribe')
        finally:
            os.killpg(program.pid, end)
            try:
                output, _ = program.communicate(timeout=DEADLINE)
            except subprocess.TimeoutExpired:
                os.killpg(program.pid, signal.SIGKILL)
                output, _ = program.communicate()
                self.fail('it did not end:\n' + output)
            self.client.stop_reading(self.subject.OUTPUT)
        self.assertEqual(program.returncode, -signal.SIGKILL if end == signal.SIGKILL else 0, output)
        for sign in BAD_SIGNS:
            self.assertNotIn(sign, output)
        self.client.wait_for(lambda: self.client.publishers[0].get_num_connections() == 0, 'the node to be gone')
        self.client.answers.clear()

    def check(self, hull):
        for life in range(rospy.get_param('~lives')):
            with self.subTest(life=life):
                # Every other life ends as soon as it has subscribed.
                self.live(self.commands[hull], life % 2 == 0)

    def test_another_one_takes_the_place_of_one_that_was_killed(self):
        self.live(self.commands['nodelet'], True, signal.SIGKILL)
        self.live(self.commands['nodelet'], True)

    def test_node(self):
        self.check('node')

    def test_manager(self):
        self.check('nodelet')


if __name__ == '__main__':
    rospy.init_node('test_shutdown')
    rostest.rosrun('polygonal_perception', 'test_shutdown', ShutdownTest, sys.argv)
