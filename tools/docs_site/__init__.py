"""The parts of the documentation that are generated from the program, its schemas and its source."""
