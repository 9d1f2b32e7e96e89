"""What the pop-ups say: one record a building."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Record:
    """The texts of one building."""

    title: str
    kind: str
    text: str
    hours: str
    floors: int


RECORDS = {
    "gatehouse": Record(
        "Gatehouse", "gate",
        "Two lodges and the porter's room over the arch. Visitors' passes and lost property are "
        "kept in the east lodge.", "06-23", 2),
    "library": Record(
        "Main Library · 总图书馆", "library",
        "Sandstone, 1934, with a portico of six columns. The ground floor holds the stacks and the "
        "periodicals, the upper floor the reading tables and rare books. 藏书二十四万册。",
        "08-22", 2),
    "theatre": Record(
        "Lecture Theatre", "lecture hall",
        "An octagon for 180 listeners. Nine rows rise away from the stage, so every seat sees the "
        "screen.", "08-20", 1),
    "cafeteria": Record(
        "Cafeteria", "dining",
        "Breakfast, lunch and late coffee. The terrace faces the avenue and catches the evening sun.",
        "07-19", 1),
    "admin": Record(
        "Administration", "office",
        "Registrar, bursar and the student office share this three-winged house round a paved court. "
        "Ring at the stone porch.", "09-16", 3),
    "science": Record(
        "Science Block", "laboratory",
        "Four glazed floors of physics and chemistry laboratories. The stair tower is the only "
        "windowless wall on campus.", "07-21", 4),
    "gallery": Record(
        "Art Gallery", "museum",
        "Two rooms under a saw-tooth roof that lets in light from the north only. The exhibition "
        "changes every term.", "10-18", 1),
    "clock-tower": Record(
        "Clock Tower · 钟楼", "landmark",
        "Thirty-three metres to the finial. The clock has shown ten past ten since the works were "
        "taken out for repair.", "closed", 5),
    "dorm": Record(
        "North Dormitory", "residence",
        "A hundred and twelve rooms on four floors in two wings. The balconies look over the lawns "
        "to the clock tower.", "00-24", 4),
    "sports-hall": Record(
        "Sports Hall", "sport",
        "One vaulted hall with three courts, a climbing wall and changing rooms in the low front "
        "building.", "07-22", 1),
    "greenhouse": Record(
        "Greenhouse", "garden",
        "The botanists' glass house. Two long beds hold the teaching collection.", "09-17", 1),
    "observatory": Record(
        "Observatory · Обсерватория", "science",
        "A copper dome over a forty-centimetre refractor, on the highest ground of the campus. "
        "Public evenings on clear Fridays.", "20-24", 2),
    "pavilion": Record(
        "Pond Pavilion", "garden",
        "An open octagon by the water. Small concerts in summer, ducks all year.", "00-24", 1),
}
