"""The buildings, one function each, in files by kind."""
