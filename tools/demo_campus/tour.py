"""The ground the first tour crosses off the paths (config/walks); planting keeps it clear."""

TOUR_LEGS = (((0.0, 58.0), (0.0, 30.0)), ((16.0, 50.0), (9.0, 32.0)), ((9.0, 32.0), (9.0, 22.0)))
