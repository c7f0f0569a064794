"""As much of a C++ file as the architecture's test asks for, without a compiler: so it sees every branch of an #if."""
import re

COMMENTS_AND_STRINGS = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<end>\w*)\(.*?\)(?P=end)"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"\n]+)[>"]', re.MULTILINE)
DIRECTIVE = re.compile(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', re.MULTILINE)
TOKEN = re.compile(r'\[\[.*?\]\]|(?:\w+::)*~?\w+|::|[^\w\s]')
TYPE_KEYWORDS = ('class', 'struct', 'union', 'enum')
EXPORT = 'POLYGONAL_PERCEPTION_EXPORT'
TEXT = '""'


def without_angles(tokens):
    """Without template arguments and parameters."""
    kept, depth = [], 0
    for token in tokens:
        depth -= token == '>' and depth > 0
        if depth == 0 and token not in '<>':
            kept.append(token)
        depth += token == '<'
    return kept


def type_name(statement):
    """The name of the type that this begins to define or declare, or None; that of a specialisation is none."""
    plain = [token for token in without_angles(statement) if token != EXPORT and not token.startswith('[[')]
    keyword = next((k for k, token in enumerate(plain) if token in TYPE_KEYWORDS), None)
    if keyword is None or '(' in plain or '=' in plain:
        return None
    while keyword < len(plain) and plain[keyword] in TYPE_KEYWORDS:
        keyword += 1
    if keyword == len(plain) or not re.fullmatch(r'\w+', plain[keyword]):
        return None
    name = plain[keyword]
    place = statement.index(name, statement.index(next(t for t in statement if t in TYPE_KEYWORDS and t in plain)))
    return None if statement[place + 1:place + 2] == ['<'] else name


def alias_name(statement):
    plain = without_angles(statement)
    if 'using' in plain and '=' in plain:
        return plain[plain.index('using') + 1]
    return plain[-1] if plain[:1] == ['typedef'] else None


def declared_name(statement):
    """The name of the function or variable that this declares."""
    plain = without_angles(statement[statement.index(EXPORT) + 1:])
    for end in ('(', '='):
        if end in plain:
            plain = plain[:plain.index(end)]
    return plain[-1]


class CppSource:
    def __init__(self, path, text):
        """path: relative to the project."""
        self.path = path
        text = COMMENTS_AND_STRINGS.sub(lambda m: m.group() if self._is_included(text, m) else
                                        (TEXT if m.group()[0] in 'R"' else ' '), text)
        self.includes = INCLUDE.findall(text)
        self.namespaces = set()  # that are opened here
        self.types = set()  # at the namespaces' own level; of a .cpp file without those of its unnamed namespaces
        self.exported = set()
        self.outside_namespaces = []  # the beginnings of definitions
        self._scopes = []  # a name; '' = unnamed or extern "C"; None = neither a namespace nor a type
        self._kinds = []
        self._read(TOKEN.findall(DIRECTIVE.sub(' ', text)))

    @staticmethod
    def _is_included(text, match):
        begin = text.rfind('\n', 0, match.start()) + 1
        return match.group()[0] == '"' and INCLUDE.match(text, begin) is not None

    def _read(self, tokens):
        statement = []
        for token in tokens:
            if token == '{':
                self._open(statement)
                statement = []
            elif token == '}':
                if self._scopes:
                    self._scopes.pop()
                    self._kinds.pop()
                statement = []
            elif token == ';':
                self._end(statement)
                statement = []
            else:
                statement.append(token)

    def _push(self, name, kind):
        self._scopes.append(name)
        self._kinds.append(kind)

    def _open(self, statement):
        plain = without_angles(statement)
        if 'namespace' in plain[:2]:
            name = plain[-1] if plain[-1] != 'namespace' else ''
            self._push(name, 'namespace')
            if name:
                self.namespaces.add(self._qualified())
        elif plain[:1] == ['extern'] and len(plain) == 3:  # and a text
            self._push('', 'namespace')
        else:
            name = type_name(statement)
            if set(self._kinds) <= {'namespace'}:
                if not any(self._scopes) and not self._is_main(plain):
                    self.outside_namespaces.append(' '.join(statement[:8]))
                self._add_type(name)
            self._add_export(statement, name)
            self._push(name, 'type' if name else 'other')

    def _end(self, statement):
        if set(self._kinds) <= {'namespace'}:
            self._add_type(alias_name(statement))
        if 'friend' not in statement:
            self._add_export(statement, type_name(statement))

    @staticmethod
    def _is_main(plain):
        return 'main' in plain and plain[plain.index('main') + 1:][:1] == ['(']

    def _qualified(self, *names):
        return '::'.join([scope for scope in self._scopes if scope] + list(names))

    def _add_type(self, name):
        if name and not (self.path.endswith('.cpp') and '' in self._scopes):
            self.types.add(self._qualified(name))

    def _add_export(self, statement, name):
        if EXPORT in statement and 'other' not in self._kinds:
            self.exported.add(self._qualified(name or declared_name(statement)))
