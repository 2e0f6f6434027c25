"""Spoils decks: bytes, numbers, fields, cards, and parts of other decks, by a seeded generator."""

NUMBERS = """0. -0. 1. -1. .5 -.5 2. 1.E-8 -1.E-8 1.E8 1.E15 1.E-15 1.E30 1.E-30 -1.E30 1.E60
1.E150 1.E-150 1.E300 1.E308 1.E-308 4.9E-324 1.8E308 1.E400 1.E-400 1E9999 NaN Inf -Inf 999.99
999.999 9999999. .0000001 1.E5 100000. 89.9999 90. 90.0001 180. 179.999 1.E-3 3.14159 1.E22 1.-300
9.E15 -999.999 1.E-5 .333333 1.E-310 -1.E-310 2.2E-308 1.E154
1.E-154 1.E200 5.00000001 11.2?1 ?.?? 9?. 1-2-3 0-11-7+""".split()

WORDS = """BODY LINE SIDE PLAN ANGLE SECTION PATCH POINT FAIRED SPLINE BEZIER FAIR RHO TANGENT TANRHO
FOURPT FIVEPT STRAIGHT CIRCLE RADIUS CBEZIER BLEND POINTS NUMBER LENGTH CHORD DEFAULT LIMIT NONE
FLANGE AFT FWD SKIN ARCS STATION LIST BUTTOCK WATERLN OBLIQUE PLANE CHECK SPHERE BOX END MATCH
KNUCKLE DXDY DXDY1 DXDY3 LAST CLOSE SYMMETRY NO YES NOSE TOLER OUTPUT DIGITS PAGE UNITS MM FEET FIE
TITLE BOTH PORT STBD FLAT LINEAR TWIST UNIFORM FREE PARABOLA STA BL WL DUCT SWEEP GRID LATIN
VARY TIED OBJECT MIN MAX NEAR SHOW VOLUME WETTED CENTROID AREA GIRTH WIDTH HEIGHT CLEAR JUMP BREAK
AUDIT PRINTED ROUNDED TRUNCATE UNKNOWN EVEN 1970 DECIMAL CONICS SHIFT EXACT ABOUT BETWEEN ALONG X Y
X1 Y1 S1 X2 Y2 X3 Y3 S3 A B C D E XI YI 3 2 1 0 + *""".split()

PIECES = [b'\0', b'\r', b'\t', b'\x80', b'\xff', b'\xef\xbb\xbf', b'\xc3\xa9', b'\x1b[2J', b'"', b"'",
          b'`', b'$(', b';', b',', b'\n', b'*', b'+', b'-', b'.', b'E', b'\f', b'%n', b'\\', b'\x0b']


def width(line):
    """Columns of a field of this card; none where its fields stand between commas."""
    return None if b',' in line else 8


def split(line):
    """The fields of a card."""
    if width(line) is None:
        return line.split(b',')
    return [line[i:i + 8] for i in range(0, max(len(line), 1), 8)]


def join(fields, line):
    """A card of these fields, as the card they came from has them."""
    if width(line) is None:
        return b','.join(fields)
    return b''.join(field.ljust(8) for field in fields).rstrip()


def number(rng, field):
    """A number near another, or far off, or one of the hard ones."""
    if rng.random() < .35:
        return rng.choice(NUMBERS).encode()
    try:
        value = float(field)
    except ValueError:
        value = rng.uniform(-30., 30.)
    kind = rng.randrange(7)
    if kind == 0:
        value = -value
    elif kind == 1:
        value *= 10.**rng.randint(-6, 6)
    elif kind == 2:
        value += rng.choice([-1., 1.])*10.**rng.randint(-9, 2)
    elif kind == 3:
        value *= rng.uniform(.5, 2.)
    elif kind == 4:
        value = float(round(value))
    elif kind == 5:
        value = rng.uniform(-50., 50.)
    else:
        value *= 1. + rng.choice([-1., 1.])*10.**rng.randint(-15, -1)
    text = ('%.6g' if rng.random() < .8 else '%.17g') % value
    return (text if '.' in text or 'e' in text else text + '.').upper().encode()[:16]


def spoil_field(rng, lines, other):
    """Another number or word in one field, or two fields exchanged."""
    at = rng.randrange(len(lines))
    fields = split(lines[at])
    one = rng.randrange(len(fields) + (rng.random() < .2))
    if one == len(fields):
        fields.append(b'')
    kind = rng.random()
    if kind < .65:
        fields[one] = number(rng, fields[one])
    elif kind < .75:
        fields[one] = rng.choice(WORDS).encode()
    elif kind < .83:
        fields[one] = b''
    elif kind < .92:
        donor = split(rng.choice(lines + other))
        fields[one] = rng.choice(donor)
    else:
        two = rng.randrange(len(fields))
        fields[one], fields[two] = fields[two], fields[one]
    cut = width(lines[at])
    if cut:
        fields = [field[:cut] for field in fields]
    lines[at] = join(fields, lines[at])


def spoil_cards(rng, lines, other):
    """Cards lost, doubled, exchanged, moved, taken from elsewhere, changed in their form."""
    at, to = rng.randrange(len(lines)), rng.randrange(len(lines))
    kind = rng.randrange(8)
    if kind == 0 and len(lines) > 1:
        del lines[at]
    elif kind == 1:
        lines.insert(to, lines[at])
    elif kind == 2:
        lines[at], lines[to] = lines[to], lines[at]
    elif kind == 3:
        lines.insert(to, rng.choice(other))
    elif kind == 4:
        first = rng.randrange(len(other))
        lines[to:to] = other[first:first + rng.randint(1, 6)]
    elif kind == 5:
        lines[at] = b','.join(field.strip() for field in split(lines[at]))
    elif kind == 6:
        del lines[min(at, to):max(at, to) - 1]
    else:
        fields = split(lines[at])
        fields[0] = rng.choice(WORDS).encode()
        lines[at] = join(fields, lines[at])


def spoil_bytes(rng, lines, _):
    """Bytes changed, put in, taken out."""
    at = rng.randrange(len(lines))
    line = bytearray(lines[at])
    where = rng.randrange(len(line) + 1)
    kind = rng.randrange(5)
    if kind == 0 and where < len(line):
        line[where] ^= 1 << rng.randrange(8)
    elif kind == 1:
        line[where:where] = rng.choice(PIECES)
    elif kind == 2:
        del line[where:where + rng.randint(1, 4)]
    elif kind == 3 and where < len(line):
        line[where] = rng.randrange(256)
    else:
        line[where:where] = bytes([rng.choice(b' 0123456789.-+E,')])
    lines[at] = bytes(line)


def spoil_file(rng, lines, _):
    """The whole: line ends, a mark at the start, an end too soon, long lines, many cards."""
    at = rng.randrange(len(lines))
    kind = rng.randrange(8)
    if kind == 0:
        lines[:] = [line + b'\r' for line in lines]
    elif kind == 1:
        lines[0] = b'\xef\xbb\xbf' + lines[0]
    elif kind == 2:
        lines[:] = (b'\n'.join(lines))[:rng.randint(1, 2000)].split(b'\n')
    elif kind == 3:
        lines[at] += rng.choice([b' ', b'0', b',', b'\0', b'9.,'])*rng.choice([80, 1000, 100000])
    elif kind == 4:
        lines[at:at] = [lines[at]]*rng.choice([2, 20, 200])
    elif kind == 5:
        lines[at] = lines[at].lower()
    elif kind == 6:
        lines[at] = b' ' + lines[at]
    else:
        lines[:] = lines[at:] + lines[:at]


def mutant(rng, deck, other):
    """A spoiled deck: a list of cards, changed in a few places, some taken from another."""
    lines = list(deck)
    kinds = [spoil_field]*12 + [spoil_cards]*4 + [spoil_bytes]*2 + [spoil_file]
    for _ in range(1 + min(int(rng.expovariate(1.)), 9)):
        rng.choice(kinds)(rng, lines, other)
        lines = lines or [b'']
    return b'\n'.join(lines) + (b'\n' if rng.random() < .9 else b'')
