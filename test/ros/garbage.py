"""Bytes on the wire that are no ROS, where a test's node listens and where it connects to."""
import random
import socket
import struct
import threading
import xmlrpc.client
import xmlrpc.server

import rosgraph

LOCALHOST = '127.0.0.1'


def random_bytes(rng, size):
    return rng.getrandbits(8 * size).to_bytes(size, 'little') if size else b''


def header(**fields):
    """The header of a TCPROS connection."""
    lines = [('%s=%s' % field).encode() for field in fields.items()]
    body = b''.join(struct.pack('<I', len(line)) + line for line in lines)
    return struct.pack('<I', len(body)) + body


class GarbagePublisher:
    """Claims to publish a topic, and sends those who connect headers that are none, or lengths without a message."""

    def __init__(self, topic, kind, seed):
        self.topic, self.kind, self.rng = topic, kind, random.Random(seed)
        self.connections = 0
        self.listener = socket.create_server((LOCALHOST, 0))
        self.listener.settimeout(0.5)
        server = xmlrpc.server.SimpleXMLRPCServer((LOCALHOST, 0), logRequests=False, allow_none=True)
        server.register_function(self._request_topic, 'requestTopic')
        self.uri = 'http://%s:%d/' % server.server_address
        self.master = rosgraph.Master('/garbage' + topic)
        for work in (server.serve_forever, self._serve):
            threading.Thread(target=work, daemon=True).start()

    def _request_topic(self, *_):
        return 1, '', ['TCPROS', *self.listener.getsockname()]

    def _serve(self):
        while True:
            try:
                connection, _ = self.listener.accept()
            except socket.timeout:
                # roscpp has given up: news of a publisher makes it come again.
                self.master.unregisterPublisher(self.topic, self.uri)
                self.master.registerPublisher(self.topic, self.kind._type, self.uri)
                continue
            self.connections += 1
            with connection:
                try:
                    self._garble(connection)
                except OSError:
                    pass  # it has hung up

    def _garble(self, connection):
        connection.settimeout(5.0)
        connection.recv(65536)
        kind = self.rng.randrange(4)
        if kind == 0:
            connection.sendall(random_bytes(self.rng, self.rng.choice([0, 3, 4, 100, 5000])))
            return
        connection.sendall(header(md5sum=self.kind._md5sum, type=self.kind._type, callerid='/garbage', latching=0))
        # The length of more than a gigabyte, of which roscpp believes none, or of more than will come.
        length = [2 ** 32 - 1, self.rng.randrange(10 ** 9, 2 ** 32), self.rng.randrange(10 ** 4, 10 ** 8)][kind - 1]
        connection.sendall(struct.pack('<I', length) + random_bytes(self.rng, self.rng.randrange(5000)))


class ServersOf:
    """The ports at which a node listens: for roscore's news, and for those who read its topics."""

    def __init__(self, node, topic):
        uri = rosgraph.Master('/garbage').lookupNode(node)
        _, _, (_, host, port) = xmlrpc.client.ServerProxy(uri).requestTopic('/garbage', topic, [['TCPROS']])
        self.addresses = [rosgraph.network.parse_http_host_and_port(uri), (host, port)]

    def garble(self, rng):
        for address in self.addresses:
            with socket.create_connection(address, 5.0) as connection:
                try:
                    connection.sendall(rng.choice([b'', b'POST /RPC2 HTTP/1.1\r\nContent-Length: 99999999\r\n\r\n<', header(topic='x')]) +
                                       random_bytes(rng, rng.randrange(3000)))
                except OSError:
                    pass  # it has hung up
