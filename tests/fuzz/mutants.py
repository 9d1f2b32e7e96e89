"""Changes bytes the way damage and malice do. The same seed gives the same mutants."""

import random
import re
import struct

NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
NASTY_NUMBERS = [b"0", b"-1", b"1", b"255", b"65535", b"65536", b"2147483647", b"-2147483648", b"4294967295",
                 b"4294967296", b"9007199254740993", b"1e15", b"1e38", b"1e39", b"-1e308", b"1e999", b"nan", b"inf",
                 b"0.0000000000000000000000000000000000000000001"]
NASTY_WORDS = [0, 1, 0x7F, 0x80, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7F800000, 0x7FC00000]


def flip(dice, data):
    for _ in range(dice.choice([1, 1, 2, 4, 16])):
        data[dice.randrange(len(data))] ^= 1 << dice.randrange(8)
    return data


def overwrite(dice, data):
    size = dice.choice([1, 2, 4])
    at = dice.randrange(max(len(data) - size, 1))
    data[at:at + size] = struct.pack("<I", dice.choice(NASTY_WORDS))[:size]
    return data


def cut(dice, data):
    return data[:dice.randrange(len(data))]


def remove(dice, data):
    at = dice.randrange(len(data))
    del data[at:at + dice.choice([1, 2, 4, 16, 256])]
    return data


def insert(dice, data):
    at = dice.randrange(len(data))
    data[at:at] = bytes(dice.randrange(256) for _ in range(dice.choice([1, 2, 4, 16])))
    return data


def repeat(dice, data):
    at = dice.randrange(len(data))
    part = data[at:at + dice.choice([4, 16, 64, 1024])]
    data[at:at] = part * dice.choice([1, 2, 100])
    return data


def move(dice, data):
    size = dice.choice([4, 16, 64])
    here, there = dice.randrange(len(data)), dice.randrange(len(data))
    data[there:there + size] = data[here:here + size]
    return data


def number(dice, data):
    """Replaces a number that is written in digits."""
    window = dice.randrange(len(data))
    found = NUMBER.search(data, window) or NUMBER.search(data)
    if found:
        data[found.start():found.end()] = dice.choice(NASTY_NUMBERS)
    return data


CHANGES = [flip, flip, overwrite, overwrite, cut, remove, insert, repeat, move, number, number, number]


def mutant(seed, data):
    dice = random.Random(seed)
    changed = bytearray(data)
    for _ in range(dice.choice([1, 1, 1, 2, 3])):
        if changed:
            changed = dice.choice(CHANGES)(dice, changed)
    return bytes(changed)


def same_size_mutant(seed, data):
    """Keeps all offsets valid: the changes of a forger who knows the format."""
    dice = random.Random("same size " + seed)
    changed = bytearray(data)
    for _ in range(dice.choice([1, 1, 1, 2, 3])):
        changed = dice.choice([flip, overwrite, overwrite, move])(dice, changed)
    return bytes(changed[:len(data)]) + data[len(changed):]


def glb_mutant(seed, data):
    """Changes one of a GLB's two chunks and corrects the lengths, or changes the file as a whole. Otherwise hardly any
    mutant would get past the header."""
    dice = random.Random("glb " + seed)
    length = struct.unpack_from("<I", data, 12)[0]
    chunks = [data[20:20 + length], data[28 + length:]]
    which = dice.choice([0, 0, 1, 1, None])
    if which is None:
        return mutant(seed, data)
    changed = mutant(seed, chunks[which])
    chunks[which] = changed + (b" " if which == 0 else b"\0") * (-len(changed) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(chunks[0]) + len(chunks[1]))
            + struct.pack("<I4s", len(chunks[0]), b"JSON") + chunks[0]
            + struct.pack("<I4s", len(chunks[1]), b"BIN\0") + chunks[1])
