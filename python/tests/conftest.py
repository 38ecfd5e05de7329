"""How the laws are run: the same cases each time, and no limit of time on a machine that does other things too."""

from hypothesis import settings

settings.register_profile("ci", deadline=None, derandomize=True, max_examples=40)
settings.load_profile("ci")
