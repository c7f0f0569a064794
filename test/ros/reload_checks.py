"""A nodelet that comes and goes, is changed and misused, while messages arrive: for each nodelet that reads another's messages."""
import itertools
import threading

import dynamic_reconfigure.client
import rospy

from bad_messages import BAD_VALUES
from manager_client import ManagerClient
from node_client import DEADLINE, Clock


class ReloadChecks:
    """To be mixed into a TestCase, which says what these are."""

    SUBJECT = None  # of subjects.py
    SPOILERS = ()  # of its messages
    CHANGES = ()  # sets of parameters under dynamic_reconfigure, good and bad
    PARAMETERS = ()  # their names, of all

    @classmethod
    def setUpClass(cls):
        cls.lives = rospy.get_param('~lives')
        cls.subject = cls.SUBJECT(outputs=(), runs=False)
        cls.client, cls.clock = cls.subject.client, Clock()
        cls.running = threading.Event()
        cls.running.set()
        cls.sender = threading.Thread(target=cls.send)
        cls.sender.start()

    @classmethod
    def tearDownClass(cls):
        cls.running.clear()
        cls.sender.join()

    @classmethod
    def send(cls):
        """Messages, each third one bad."""
        rate = rospy.Rate(60)
        spoilers = itertools.cycle(cls.SPOILERS)
        for count in itertools.count():
            if not cls.running.is_set():
                return
            stamp = cls.clock.tick()
            messages = cls.subject.messages(stamp)
            if count % 3 == 2:
                next(spoilers)(messages[0])
            cls.send_besides(count, stamp)
            cls.client.send(*messages)
            rate.sleep()

    @classmethod
    def send_besides(cls, count, stamp):
        """What else arrives."""

    def setUp(self):
        self.manager = ManagerClient(self)
        rospy.set_param(self.SUBJECT.NAME, {'tf_timeout': 0.5})

    def tearDown(self):
        self.manager.unload_all()

    def load(self):
        self.manager.load(self.SUBJECT.NAME, self.SUBJECT.NODELET, {})

    def wait_for_answers(self, count=1, what='an answer'):
        """Waits for answers to messages from now on, with a fresh reader: rospy may have missed that the topic was away."""
        output = self.SUBJECT.OUTPUT
        self.client.answers.clear()
        self.client.read(output)
        begin = self.clock.now.to_nsec()
        self.client.wait_for(lambda: sum(k > begin and output in a and self.subject.is_good(a)
                                         for k, a in list(self.client.answers.items())) >= count, what)
        self.client.stop_reading(output)

    def test_every_life_ends_cleanly(self):
        self.client.read('markers')
        for life in range(self.lives):
            self.load()
            if life % 3 == 2:
                # It lives until it has answered; the others end at once.
                self.wait_for_answers(what='an answer in life %d' % life)
            self.manager.unload(self.SUBJECT.NAME)
        self.client.stop_reading('markers')

    def test_reconfigured_all_the_time(self):
        self.load()
        client = dynamic_reconfigure.client.Client(self.SUBJECT.NAME, timeout=DEADLINE)
        hammering, count = threading.Event(), [0]
        hammering.set()

        def hammer():
            while hammering.is_set():
                client.update_configuration(self.CHANGES[count[0] % len(self.CHANGES)])
                count[0] += 1

        thread = threading.Thread(target=hammer)
        thread.start()
        try:
            self.wait_for_answers(60, 'answers between changes')
            self.client.wait_for(lambda: count[0] > 2 * len(self.CHANGES), 'the changes')
        finally:
            hammering.clear()
            thread.join()
            client.close()

    def test_no_parameter_keeps_it_from_starting(self):
        for shift, _ in enumerate(BAD_VALUES):
            rospy.delete_param(self.SUBJECT.NAME)
            values = {name: BAD_VALUES[(i + shift) % len(BAD_VALUES)] for i, name in enumerate(self.PARAMETERS)}
            for name, value in values.items():
                rospy.set_param(self.SUBJECT.NAME + '/' + name, value)
            self.load()
            # Of a frame any text is a name, and of sources any list: then nobody sends what it waits for.
            if 'much' not in (values['fixed_frame'], values['robot_frame']) and not isinstance(values.get('sources'), list):
                self.wait_for_answers(1, 'an answer whatever the parameters: %s' % values)
            self.manager.unload(self.SUBJECT.NAME)
