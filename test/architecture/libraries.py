"""What a shared library of ours shows to others: symbols of our namespaces."""
import collections
import re
import subprocess

# name: without arguments and what the compiler adds; text: all of it
Symbol = collections.namedtuple('Symbol', 'name text is_strong')

OURS = re.compile(r'(?<![\w:])polygonal_perception::[\w:~]+')
MESSAGE = re.compile(r'polygonal_perception::\w+_(::|$)')  # generated, a template in the header of each message


def without_arguments(text):
    """Template arguments and what follows a function's name."""
    text = text.replace('(anonymous namespace)', 'anonymous').replace('operator()', 'operator_call')
    text = re.sub(r'operator(<<|>>|->|<=|>=|<|>)', 'operator_', text)
    while True:
        shorter = re.sub(r'<[^<>]*>', '', text)
        if shorter == text:
            return text.partition('(')[0]
        text = shorter


def symbols(library):
    output = subprocess.run(['nm', '-D', '--defined-only', '-C', str(library)], check=True, stdout=subprocess.PIPE,
                            universal_newlines=True).stdout
    found = []
    for line in output.splitlines():
        _, kind, text = line.split(None, 2)
        # The last, after a function's result. "X for Y" is what the compiler adds to Y.
        names = OURS.findall(without_arguments(text))
        if names and not MESSAGE.match(names[-1]):
            found.append(Symbol(names[-1].rstrip(':'), text, kind in 'TDBRGSA'))
    return found
