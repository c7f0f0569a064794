"""The maps that a costmap_2d node publishes."""
import numpy as np
from nav_msgs.msg import OccupancyGrid

LETHAL = 100


class Costmap:
    """The maps of a node. They have to be published whole, without updates of parts."""

    def __init__(self, client, topic='/costmap_node/costmap/costmap'):
        self.grids = []
        self.reader = client.listen(topic, OccupancyGrid, self._on_grid)
        client.wait_for(lambda: self.grid is not None, 'a map on ' + topic)

    @property
    def grid(self):
        """The newest."""
        return self.grids[-1] if self.grids else None

    def since(self, stamp):
        return [grid for grid in self.grids if grid.stamp > stamp]

    def _on_grid(self, message):
        self.grids.append(Grid(message))


class Grid:
    """One map."""

    def __init__(self, message):
        info = message.info
        self.stamp, self.resolution = message.header.stamp, info.resolution
        self.origin = np.array([info.origin.position.x, info.origin.position.y])
        rows, columns = np.nonzero(np.array(message.data, np.int8).reshape(info.height, info.width) == LETHAL)
        self.marks = np.stack([columns, rows], -1)  # cells where something stands

    def cells(self, points):
        return np.floor((np.reshape(points, (-1, 2)) - self.origin) / self.resolution).astype(int)

    def are_marked(self, points):
        """For each point whether its cell or a neighbour of this is marked."""
        return (self._distances(points) <= 1).any(1)

    def marks_elsewhere(self, points):
        """The centres of the marks that are at none of the points."""
        return self.centres()[~(self._distances(points) <= 1).any(0)]

    def centres(self):
        return self.origin + (self.marks + 0.5) * self.resolution

    def _distances(self, points):
        """In cells, points x marks."""
        return np.abs(self.cells(points)[:, None] - self.marks[None]).max(-1)

    def __str__(self):
        if len(self.marks) == 0:
            return 'no marks'
        text = ', '.join('(%.2f, %.2f)' % tuple(centre) for centre in self.centres()[:30])
        return '%d marks: %s%s' % (len(self.marks), text, ', ...' if len(self.marks) > 30 else '')
