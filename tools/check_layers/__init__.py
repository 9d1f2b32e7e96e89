"""The layer check: see table.py for what is allowed."""
