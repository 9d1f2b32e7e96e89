"""A 5x7 pixel font for signs: seven rows of five bits for each letter."""

_ROWS = {
    "A": "0E11111F111111", "B": "1E11111E11111E", "C": "0E11101010110E", "D": "1E11111111111E",
    "E": "1F10101E10101F", "F": "1F10101E101010", "G": "0E11101713110F", "H": "1111111F111111",
    "I": "0E04040404040E", "J": "0702020202120C", "K": "11121418141211", "L": "1010101010101F",
    "M": "111B1515111111", "N": "11191513111111", "O": "0E11111111110E", "P": "1E11111E101010",
    "Q": "0E11111115120D", "R": "1E11111E141211", "S": "0F10100E01011E", "T": "1F040404040404",
    "U": "1111111111110E", "V": "11111111110A04", "W": "111111151B1111", "X": "11110A040A1111",
    "Y": "11110A04040404", "Z": "1F01020408101F", " ": "00000000000000", "1": "040C040404040E",
    "0": "0E11131519110E", "2": "0E11010608101F", "3": "1E01010E01011E", "4": "02060A121F0202",
    "&": "0C12140815120D", "-": "0000001F000000", "5": "1F101E0101111E",
}
WIDTH, HEIGHT, ADVANCE = 5, 7, 6


def width(text, scale):
    """Width of a line in pixels."""
    return (len(text) * ADVANCE - 1) * scale


def dots(text, scale):
    """The (x, y) pixels of a line of capitals, from its top left corner."""
    for i, letter in enumerate(text):
        rows = bytes.fromhex(_ROWS[letter])
        for y in range(HEIGHT):
            for x in range(WIDTH):
                if rows[y] >> (WIDTH - 1 - x) & 1:
                    for dy in range(scale):
                        for dx in range(scale):
                            yield (i * ADVANCE + x) * scale + dx, y * scale + dy
