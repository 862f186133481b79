"""An oven that answers when it begins to heat, and is hot 1.5 s later."""
import sys
import threading

import rats

oven = rats.Device("oven-1", namespace="https://example.org/ovens#", label="the oven", type="Oven",
                   classes={"Oven": "maestro:Device"},
                   words=[rats.word("hot", "?o - Oven", observable=True)])


@oven.feature("heat", effect="(hot ?self)", cost=2, seconds=1, done_when="(hot ?self)",
              time_limit=30, sentence="{self} heats up")
def heat(call):
    print("HEAT", flush=True)
    threading.Timer(1.5, oven.tell, ("(hot oven-1)",)).start()


oven.run(sys.argv[1], int(sys.argv[2]), sys.argv[3])
