"""A bell that can be rung: a device of your own.

    pip install ./rats-bridge/python        once, in the clone of MAESTRO
    python3 device.py 127.0.0.1 1883 maestro
"""
import sys

import rats

bell = rats.Device(
    "bell-1", namespace="https://example.org/bell#", label="the bell", type="Bell",
    classes={"Bell": "maestro:Device"},
    words=[rats.word("rung", "?bell - Bell", label="rung")])


@bell.feature("ring", effect="(rung ?self)", cost=1, seconds=1, occupies=["clapper"])
def ring(call):
    call.sleep(0.3)  # here it rings; a call that is cancelled ends here
    bell.tell("(rung bell-1)")


if __name__ == "__main__":
    bell.run(sys.argv[1], int(sys.argv[2]), sys.argv[3])
