"""Parameters of the two nodes: from a file, and as roslaunch users write them, name:=value."""
import math
import re
import subprocess

import rosparam
import yaml

from bag_mapping.nodes import program

# Set here: the run would not be what it is with others.
OWN = ('input', 'image_transport', 'output_frame', 'publish_tf', 'lazy', 'sources', 'floor_frame')
LARGEST_MAP = 100.0  # [m]
MOST_CELLS = 3000  # of the map's side


class ParameterError(Exception):
    """What is wrong with a parameter, for the user."""


def table(node):
    """The default of each parameter, by name, as the node's own program prints them."""
    text = subprocess.run([program(node + '_parameters')], stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout
    return {name: value_of(default) for name, default in re.findall(r'^\| `(\w+)` \| \w+ \| (.*?) \|', text, re.MULTILINE)}


def value_of(text):
    """As roslaunch takes it: a number where it is one, or what it means in YAML."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    try:
        value = yaml.safe_load(text)
    except yaml.YAMLError:
        return text
    return '' if value is None else value


def read_config(path):
    try:
        loaded = rosparam.load_file(str(path))
    except (OSError, rosparam.RosParamException, yaml.YAMLError) as error:
        raise ParameterError('%s: %s' % (path, ' '.join(str(error).split())))
    values = {}
    for content, _ in loaded:
        if not isinstance(content, dict):
            raise ParameterError('%s: holds no parameters by name' % path)
        values.update(content)
    return values


class Parameters:
    """What both nodes get."""

    def __init__(self, config, assignments):
        self.tables = {'perception': table('polygonal_perception'), 'map': table('polygon_map')}
        self.given = dict(read_config(config) if config else {}, **{name: value_of(text) for name, text in assignments})
        for name, _ in assignments:
            if name in OWN:
                raise ParameterError('%s is set by map_from_bag itself' % name)
            if not any(name in known for known in self.tables.values()):
                raise ParameterError("no node has a parameter '%s'; doc/map.md and README.md list them" % name)
        for name in OWN:
            self.given.pop(name, None)

    def of(self, node):
        """What was given for a node. What a file has and the perception does not know goes to it all the same: it says so."""
        other = set(self.tables['map']) - set(self.tables['perception'])
        if node == 'perception':
            return {name: value for name, value in self.given.items() if name not in other}
        return {name: value for name, value in self.given.items() if name in self.tables['map']}

    def value(self, name):
        for node in ('map', 'perception'):
            if name in self.tables[node]:
                return self.given.get(name, self.tables[node][name])
        raise KeyError(name)

    def number(self, name):
        value = self.value(name)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ParameterError('%s is %r, accepted is a number' % (name, value))
        return float(value)

    def frames(self):
        """Those that tf has to know, of each image, before a node takes it."""
        names = {self.value('fixed_frame'), self.value('mount_frame'), self.value('up_frame')}
        names.update(box[0] for box in self.value('ignore_boxes'))
        return sorted(names - {'', '(empty)'})

    def reach(self):
        """[m] from a camera to what it can put on the map."""
        ahead, behind, width = (self.number('grid_' + name) for name in ('length', 'behind', 'width'))
        return math.hypot(max(ahead, behind), width / 2)

    def map_size(self, low, high):
        """[m] the side that was given, or one that holds all that cameras between two corners can see; and that whole side."""
        cell = self.number('grid_resolution')
        whole = math.ceil(float(max(high - low)) + 2.0 * (self.reach() + cell))
        if 'map_size' in self.given:
            return self.number('map_size'), whole
        return min(max(whole, 1.0), LARGEST_MAP, MOST_CELLS * cell), whole
