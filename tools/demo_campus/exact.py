"""Arithmetic whose results are the same on every machine.

IEEE + - * / and sqrt are exact everywhere; the C library's sine and cosine are not (the last bit
differs between CPUs), so they are rounded here, at their only source, far above that last bit.
"""

import math

TRIG_DIGITS = 9


def sin_deg(angle):
    """Sine of an angle in degrees, rounded to TRIG_DIGITS."""
    return round(math.sin(math.radians(angle)), TRIG_DIGITS) + 0.0


def cos_deg(angle):
    """Cosine of an angle in degrees, rounded to TRIG_DIGITS."""
    return round(math.cos(math.radians(angle)), TRIG_DIGITS) + 0.0


def smooth(t):
    """Hermite step of a value clamped to 0..1."""
    t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
    return t * t * (3.0 - 2.0 * t)


class Random:
    """A 32-bit PCG: our own, because random.Random's float helpers may change between versions."""

    def __init__(self, seed):
        self._state = (seed * 2 + 1) & 0xFFFFFFFFFFFFFFFF
        for _ in range(4):
            self.bits()

    def bits(self):
        """32 random bits."""
        old = self._state
        self._state = (old * 6364136223846793005 + 1442695040888963407) & 0xFFFFFFFFFFFFFFFF
        mixed = (((old >> 18) ^ old) >> 27) & 0xFFFFFFFF
        turn = old >> 59
        return ((mixed >> turn) | (mixed << ((-turn) & 31))) & 0xFFFFFFFF

    def unit(self):
        """A number in [0, 1)."""
        return self.bits() / 4294967296.0

    def between(self, low, high):
        """A number in [low, high)."""
        return low + (high - low) * self.unit()

    def below(self, count):
        """An integer in 0..count-1."""
        return self.bits() % count

    def pick(self, items):
        """One of the items."""
        return items[self.below(len(items))]
