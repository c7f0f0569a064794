"""A bag's messages from a process of their own: to unpack a compressed cloud takes as long as the nodes take for one."""
import fcntl
import multiprocessing
import signal

from bag_mapping import signals
from bag_mapping.bag_reading import Bag, BagError, Message

F_SETPIPE_SZ, PIPE = 1031, 1 << 20  # Linux; [bytes] in few pieces


def pump(path, topics, pipe, reader):
    """In the process: sends topic and time, and then the message."""
    reader.close()  # it is the other process's: this one would not notice that it has gone
    # Whoever reads ends it.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signals.let_through()
    try:
        with Bag(path) as bag:
            for message in bag.messages(topics):
                pipe.send((message.topic, message.time))
                pipe.send_bytes(message.data)
        pipe.send(None)
    except BagError as error:
        pipe.send(error)
    except BrokenPipeError:
        pass


class ReadAhead:
    """Begins at once, and stays by a message ahead of its reader. To be made before there are threads."""

    def __init__(self, path, topics):
        processes = multiprocessing.get_context('fork')  # newer Pythons would begin anew
        self._pipe, other = processes.Pipe(duplex=False)
        try:
            fcntl.fcntl(other.fileno(), F_SETPIPE_SZ, PIPE)
        except OSError:
            pass  # an administrator may allow less
        self._process = processes.Process(target=pump, args=(path, topics, other, self._pipe), daemon=True)
        with signals.held_back():
            self._process.start()
        other.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._pipe.close()
        self._process.terminate()
        self._process.join()

    def messages(self):
        while True:
            try:
                head = self._pipe.recv()
            except EOFError:
                raise BagError('what reads it has ended without a word')
            if head is None:
                return
            if isinstance(head, BagError):
                raise head
            yield Message(head[0], self._pipe.recv_bytes(), head[1])
