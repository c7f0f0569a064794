"""Tables and a picture of what evaluate_paths has printed: report.py RESULTS.jsonl [PICTURE.png]."""
import collections
import json
import statistics
import sys

OURS, PLAIN = 'this package', 'Minimal Construct, plain'
MADE_UP = ('clutter', 'office')


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


class Group:
    """A method's answers on the scenes of one family and size."""

    def __init__(self):
        self.edges, self.preparation, self.times, self.ratios = [], [], [], []
        self.made, self.all, self.missed, self.invented = 0, 0, 0, 0

    def add(self, row):
        self.edges.append(row['edges'])
        self.preparation.append(row['preparation'])
        self.times += row['milliseconds']
        self.ratios += row['ratios']
        self.missed += row['missed']
        self.invented += row['invented']
        if row['all_graph_edges']:
            self.made += statistics.mean(row['graph_edges'] or [0])
            self.all += row['all_graph_edges']

    def size(self):
        low, high = min(self.edges), max(self.edges)
        return '%d' % low if low == high else '%d to %d' % (low, high)

    def longer(self):
        """[%] In the mean and at most."""
        if not self.ratios:
            return '', ''
        worst = 100.0 * (max(self.ratios) - 1.0)
        return tuple('%.1e' % abs(v) if abs(v) < 1e-3 else '%.2f' % v
                     for v in (100.0 * (statistics.mean(self.ratios) - 1.0), worst))


def number(value):
    return '%.3f' % value if value < 1 else '%.1f' % value if value < 100 else '%.0f' % value


def grouped(rows):
    groups = collections.defaultdict(Group)
    for row in rows:
        key = (row['family'], row['edges'] if row['family'] in MADE_UP else 0, row['method'])
        groups[key].add(row)
    return groups


def table(groups):
    print('| scene | edges | method | queries | median [ms] | 95 % [ms] | taking in [ms] | longer: mean [%] | at most [%] | ways missed | made up '
          '| lines / graph [%] |')
    print('| --- | --: | --- | --: | --: | --: | --: | --: | --: | --: | --: | --: |')
    for (family, _, method), group in sorted(groups.items(), key=lambda item: (item[0][0] not in MADE_UP, item[0][:2])):
        if not group.times:
            continue
        print('| %s | %s | %s | %d | %s | %s | %s | %s | %s | %d | %d | %s |' % (
            family, group.size(), method, len(group.times), number(statistics.median(group.times)), number(percentile(group.times, 0.95)),
            number(statistics.median(group.preparation)), *group.longer(), group.missed, group.invented,
            '%.1f' % (100.0 * group.made / group.all) if group.all and group.made else ''))


def draw(groups, path):
    import matplotlib
    matplotlib.use('Agg')
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(1, len(MADE_UP), figsize=(11, 4.2), sharey=True)
    for axis, family in zip(axes, MADE_UP):
        methods = sorted({method for f, _, method in groups if f == family}, key=lambda m: (m != OURS, m))
        for method in methods:
            points = sorted((edges, group) for (f, edges, m), group in groups.items() if (f, m) == (family, method) and group.times)
            sizes = [edges for edges, _ in points]
            line, = axis.loglog(sizes, [statistics.median(g.times) for _, g in points], marker='o', label=method)
            axis.fill_between(sizes, [percentile(g.times, 0.05) for _, g in points], [percentile(g.times, 0.95) for _, g in points],
                              color=line.get_color(), alpha=0.12)
        axis.set_title('%s: median, and 5 to 95 %%' % family)
        axis.set_xlabel('edges')
        axis.grid(True, which='major', alpha=0.4)
    axes[0].set_ylabel('time of a query [ms]')
    axes[0].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def main(results, picture=None):
    groups = grouped(json.loads(line) for line in open(results))
    table(groups)
    if picture:
        draw(groups, picture)


if __name__ == '__main__':
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
